"""packaging/layoutbox.service: systemd takes it, and its ExecStart line works behind the walls that it asks for.

The walls are built by bubblewrap, as no systemd runs where tests do: a read-only system, no homes, a /tmp of its own, bare devices, a user
who is nobody, no capabilities, no environment but what systemd gives. What needs a kernel filter (address families) or a control group
(memory, tasks) is not tried here.
"""

import json
import os
import re
import shlex
import shutil
import signal
import subprocess
import tempfile
import unittest
import urllib.request
from pathlib import Path

from service import BEDROOM, BINARY

ROOT = Path(os.environ.get("LAYOUTBOX_SOURCE", Path(__file__).resolve().parent.parent.parent))
UNIT = ROOT / "packaging/layoutbox.service"
PROGRAM = "/opt/layoutbox/bin/layoutbox"
STATE = "/var/lib/layoutbox"
NOBODY = "65534"
WALLS = {
    "ProtectSystem": ["--ro-bind", "/", "/", "--proc", "/proc"],
    "PrivateDevices": ["--dev", "/dev"],
    "ProtectHome": ["--tmpfs", "/home", "--tmpfs", "/root", "--tmpfs", "/run/user"],
    "PrivateTmp": ["--tmpfs", "/tmp", "--tmpfs", "/var/tmp"],
    "DynamicUser": ["--unshare-user", "--uid", NOBODY, "--gid", NOBODY],
    "CapabilityBoundingSet": ["--cap-drop", "ALL"],
}


def settings() -> dict[str, str]:
    lines = (line.split("=", 1) for line in UNIT.read_text().splitlines() if "=" in line and not line.startswith("#"))
    return dict(lines)


def program() -> str:
    return os.path.realpath(shutil.which(BINARY) or BINARY)


def works(command: list[str]) -> bool:
    return shutil.which(command[0]) is not None and subprocess.run(command, capture_output=True).returncode == 0


class Unit(unittest.TestCase):
    @unittest.skipUnless(shutil.which("systemd-analyze"), "there is no systemd-analyze")
    def test_systemd_takes_it(self):
        with tempfile.TemporaryDirectory() as folder:
            unit = Path(folder, UNIT.name)
            text = UNIT.read_text().replace(PROGRAM, program())
            unit.write_text(re.sub(r"(?m)^Documentation=.*$", f"Documentation=file:{ROOT}/README.md", text))
            told = subprocess.run(["systemd-analyze", "verify", unit], capture_output=True, text=True)
        self.assertEqual((told.returncode, told.stdout + told.stderr), (0, ""))

    def walled(self, state: str) -> list[str]:
        """The ExecStart line with the walls that the unit asks for around it."""
        given = settings()
        walls = [part for key, parts in WALLS.items() if key in given for part in parts]
        inside = ["--tmpfs", "/opt", "--ro-bind", program(), PROGRAM, "--tmpfs", "/var/lib", "--bind", state, STATE]
        line = shlex.split(given["ExecStart"].replace("${STATE_DIRECTORY}", STATE).replace("--port 8080", "--port 0"))
        environment = ["--clearenv", "--setenv", "PATH", "/usr/bin:/bin", "--setenv", "STATE_DIRECTORY", STATE, "--chdir", "/"]
        return ["bwrap", "--die-with-parent", "--new-session", *walls, *inside, *environment, *line]

    def served(self, state: str, work):
        """What `work` makes of the service's address; the service is ended as the unit says and ends well."""
        service = subprocess.Popen(self.walled(state), stderr=subprocess.PIPE, text=True)
        try:
            told = ""
            for line in service.stderr:
                told += line
                if found := re.search(r"http://\S+?/", line):
                    break
            else:
                self.fail(told)
            answer = work(found.group(0))
            children = Path(f"/proc/{service.pid}/task/{service.pid}/children").read_text().split()
            os.kill(int(children[0]), getattr(signal, settings()["KillSignal"]))
            self.assertEqual(service.wait(int(settings()["TimeoutStopSec"])), 0)
            return answer
        finally:
            service.kill()
            service.wait()
            service.stderr.close()

    @unittest.skipUnless(
        works(["bwrap", "--ro-bind", "/", "/", "--unshare-user", "true"]), "there is no bubblewrap, or it may not build walls"
    )
    def test_its_line_works_behind_its_walls(self):
        self.assertEqual([key for key in WALLS if key not in settings()], [])

        def ask(address, path, body=None):
            request = urllib.request.Request(
                address + path, json.dumps(body).encode() if body else None, {"Content-Type": "application/json"}
            )
            with urllib.request.urlopen(request, timeout=60) as answer:
                return answer.read()

        def keep(address):
            page = ask(address, "")
            if b"left out" not in page:  # nothing but the program is there: what is served is in it
                self.assertIn(b"app.js", page)
                self.assertGreater(len(ask(address, "app.js")), 100_000)
            layout = json.loads(ask(address, "api/generate", {"prompt": BEDROOM}))["layouts"][0]
            return json.loads(ask(address, "api/rooms", {"name": "Kept", "layout": layout}))["id"]

        with tempfile.TemporaryDirectory() as state:
            os.chmod(state, 0o777)
            kept = self.served(state, keep)
            self.assertEqual([path.name for path in Path(state).glob("*.db")], ["service.db"])
            rooms = self.served(state, lambda address: json.loads(ask(address, "api/rooms"))["rooms"])
        self.assertEqual([room["id"] for room in rooms], [kept])


if __name__ == "__main__":
    unittest.main()
