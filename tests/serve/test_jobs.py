"""Pictures as jobs: progress, cancelling, and a queue that a killed service does not lose."""

import json
import os
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

from service import BEDROOM, BINARY, Service


def has_blender():
    done = subprocess.run([BINARY, "doctor", "--json"], capture_output=True, text=True, check=False)
    return '"blender"' in done.stdout.lower() and "noBlender" not in done.stdout


class Jobs(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory(prefix="service ")))
        self.service = Service(self.folder)
        self.layout = self.service.post("/api/generate", {"prompt": BEDROOM}).json()["layouts"][0]

    def tearDown(self):
        self.service.stop()

    def start(self, **more):
        answer = self.service.post("/api/jobs", {"kind": "render", "layout": self.layout, "width": 160, "height": 90, **more})
        self.assertEqual(answer.status, 202, str(answer))
        return answer.json()["id"]

    def wait(self, job, states=("done", "failed", "cancelled")):
        until = time.monotonic() + 300
        while time.monotonic() < until:
            now = self.service.get(f"/api/jobs/{job}").json()
            if now["state"] in states:
                return now
            time.sleep(0.1)
        raise AssertionError(now)

    def test_a_picture(self):
        if not has_blender():
            self.skipTest("there is no Blender")
        job = self.start()
        events = self.service.get(f"/api/jobs/{job}/events").body.decode()
        states = [json.loads(line[6:])["state"] for line in events.splitlines() if line.startswith("data: ")]
        self.assertEqual(states[-1], "done", events)
        self.assertIn("running", states)
        self.assertIn("scene.png", self.wait(job)["files"])
        self.assertTrue(self.service.get(f"/api/jobs/{job}/files/scene.png").body.startswith(b"\x89PNG"))
        self.assertEqual(self.service.get(f"/api/jobs/{job}/files/service.db").status, 404)

    def test_cancelled_while_it_waits(self):
        jobs = [self.start() for _ in range(3)]
        answer = self.service.ask("DELETE", f"/api/jobs/{jobs[2]}")
        self.assertEqual(answer.json()["state"], "cancelled", str(answer))

    def test_one_client_does_not_fill_the_queue(self):
        if not has_blender():
            self.skipTest("there is no Blender")
        jobs = [self.start() for _ in range(16)]
        answers = [self.service.post("/api/jobs", {"kind": "render", "layout": self.layout}) for _ in range(4)]
        self.assertEqual(answers[-1].status, 429, str(answers[-1]))
        self.assertIn("yours", answers[-1].json()["message"])
        self.service.ask("DELETE", f"/api/jobs/{jobs[-1]}")
        self.start()

    def test_without_a_blender_it_fails_in_words(self):
        with tempfile.TemporaryDirectory() as folder:
            service = Service(folder, LAYOUTBOX_BLENDER="/no/such/blender")
            self.addCleanup(service.stop)
            own, self.service = self.service, service
            try:
                job = self.wait(self.start())
            finally:
                self.service = own
        self.assertEqual(job["state"], "failed")
        self.assertEqual(job["error"]["code"], "noBlender")

    def test_a_kill_loses_nothing(self):
        jobs = [self.start() for _ in range(3)]
        self.service.kill()
        self.service = Service(self.folder, **({} if has_blender() else {"LAYOUTBOX_BLENDER": os.devnull}))
        for job in jobs:
            self.assertIn(self.wait(job)["state"], ("done", "failed"))

    def test_no_such_job(self):
        self.assertEqual(self.service.get("/api/jobs/0123456789abcdef").status, 404)
