"""A service under full load that is killed at random, and its Blender too: nothing is lost, nothing grows, every job ends."""

import json
import os
import random
import signal
import tempfile
import threading
import time
import unittest
from http.client import HTTPException
from pathlib import Path

from service import BEDROOM, Service

SECONDS = float(os.environ.get("LAYOUTBOX_SOAK_SECONDS", "60"))
CLIENTS = 4
LONGEST_WAIT = 300
GROWTH = 30_000  # kB: what the allocator may keep more at the end of the calm part than in its middle
PROMPTS = (BEDROOM, "A living room with a sofa facing the TV and two armchairs.", "A bathroom with a bathtub, a toilet and a sink.")


def children(pid):
    """Processes that one of ours has started."""
    try:
        lists = [path.read_text() for path in Path(f"/proc/{pid}/task").glob("*/children")]
    except OSError:
        return []
    return [int(child) for text in lists for child in text.split()]


def memory(pid):
    """Resident kB."""
    for line in Path(f"/proc/{pid}/status").read_text().splitlines():
        if line.startswith("VmRSS:"):
            return int(line.split()[1])
    return 0


class Client(threading.Thread):
    """Asks for one thing after the other; what was promised to it is in `rooms` and `jobs`."""

    def __init__(self, soak, number):
        super().__init__(daemon=True)
        self.soak, self.chance = soak, random.Random(number)
        self.rooms, self.jobs, self.answers, self.faults = {}, [], 0, []

    def run(self):
        layout = None
        while not self.soak.over.is_set():
            try:
                layout = self.step(layout)
            except (OSError, HTTPException, json.JSONDecodeError):
                time.sleep(0.05)  # it is being killed just now

    def ask(self, method, path, body=None):
        answer = self.soak.service.ask(method, path, body)
        self.answers += 1
        if answer.status == 429:
            time.sleep(0.1)
        elif answer.status >= 500 and answer.status != 503:
            self.faults.append(str(answer))
        return answer

    def step(self, layout):
        what = self.chance.random()
        if layout is None or what < 0.5:
            body = {"prompt": self.chance.choice(PROMPTS), "effort": 1, "seed": self.chance.randrange(1000)}
            answer = self.ask("POST", "/api/generate", body)
            return answer.json()["layouts"][0] if answer.status == 200 else layout
        if what < 0.8:
            thing = self.chance.choice(layout["objects"])
            place = [thing["pos"][0] + self.chance.uniform(-0.5, 0.5), thing["pos"][1]]
            self.ask("POST", "/api/drag", {"layout": layout, "id": thing["id"], "pos": place})
        elif what < 0.9:
            answer = self.ask("POST", "/api/rooms", {"name": "soak", "layout": layout})
            if answer.status == 201:
                self.rooms[answer.json()["id"]] = layout
        elif len(self.jobs) < SECONDS / 10:
            answer = self.ask("POST", "/api/jobs", {"kind": "render", "layout": layout, "width": 64, "height": 64})
            if answer.status == 202:
                self.jobs.append(answer.json()["id"])
                if self.chance.random() < 0.3:
                    self.ask("DELETE", f"/api/jobs/{self.jobs[-1]}")
        return layout


class Soak(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory(prefix="soak ")))
        self.over = threading.Event()
        self.service = Service(self.folder)
        self.seen = set()

    def tearDown(self):
        self.over.set()
        self.service.stop()

    def note_children(self):
        self.seen.update(children(self.service.process.pid))

    def rest(self, seconds):
        until = time.monotonic() + seconds
        while time.monotonic() < until:
            self.note_children()
            time.sleep(0.1)

    def calm_part(self, seconds):
        """Half a warm-up, then no growth."""
        self.rest(seconds / 2)
        before = memory(self.service.process.pid)
        self.rest(seconds / 2)
        self.assertLess(memory(self.service.process.pid) - before, GROWTH)

    def wild_part(self, seconds):
        chance = random.Random(18)
        until = time.monotonic() + seconds
        while time.monotonic() < until:
            self.rest(chance.uniform(1, 4))
            blenders = children(self.service.process.pid)
            if blenders and chance.random() < 0.5:
                os.kill(chance.choice(blenders), signal.SIGKILL)
            else:
                port = self.service.port
                self.service.kill()
                self.service = Service(self.folder, port=port)

    def test_nothing_is_lost(self):
        clients = [Client(self, number) for number in range(CLIENTS)]
        for client in clients:
            client.start()
        self.calm_part(SECONDS / 3)
        self.wild_part(SECONDS * 2 / 3)
        self.over.set()
        for client in clients:
            client.join(60)
            self.assertFalse(client.is_alive())
            self.assertEqual(client.faults, [])
        self.assertGreater(sum(client.answers for client in clients), SECONDS)
        for client in clients:
            for room, layout in client.rooms.items():
                self.assertEqual(self.service.get(f"/api/rooms/{room}").json()["layout"], layout)
        self.wait_for([job for client in clients for job in client.jobs])
        self.service.stop()
        self.service = Service(self.folder)  # for tearDown, and because it must start again
        self.all_ended()

    def wait_for(self, jobs):
        until = time.monotonic() + LONGEST_WAIT
        for job in jobs:
            while (state := self.service.get(f"/api/jobs/{job}").json()["state"]) in ("waiting", "running"):
                self.assertLess(time.monotonic(), until, f"{job} is {state}")
                time.sleep(0.1)

    def all_ended(self):
        until = time.monotonic() + 30
        while left := [pid for pid in self.seen if self.is_alive(pid)]:
            self.assertLess(time.monotonic(), until, f"left over: {left}")
            time.sleep(0.1)

    @staticmethod
    def is_alive(pid):
        try:
            return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
        except OSError:
            return False
