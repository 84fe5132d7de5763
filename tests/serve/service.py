"""A running `layoutbox serve` on a free port, with a folder of its own, and calls to it."""

import http.client
import json
import os
import re
import signal
import subprocess
import tempfile
import unittest
from pathlib import Path

BINARY = os.environ.get("LAYOUTBOX_BINARY", "layoutbox")
BEDROOM = (
    "A bedroom (4 x 3.5 m) with a bed against the left wall, a nightstand beside the bed with a lamp on it, and a desk under the window."
)


class Answer:
    def __init__(self, status, headers, body):
        self.status, self.headers, self.body = status, headers, body

    def json(self):
        return json.loads(self.body)

    def __str__(self):
        return f"{self.status}: {self.body[:300]!r}"


class Service:
    """Starts in `folder`; stop() ends it as Ctrl-C does, kill() as a power cut."""

    def __init__(self, folder, *options, port=0, **environment):
        command = [BINARY, "serve", "--port", str(port), "--folder", str(folder), *options]
        self.process = subprocess.Popen(command, stderr=subprocess.PIPE, text=True, env={**os.environ, **environment})
        self.port = None
        for line in self.process.stderr:
            if found := re.search(r"http://[^:]+:(\d+)/", line):
                self.port = int(found.group(1))
                break
        if self.port is None:
            self.process.stderr.close()
            raise AssertionError(f"the service ended with {self.process.wait()}")

    def ask(self, method, path, body=None, headers=None, host=None):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=120)
        given = {"Host": host or f"127.0.0.1:{self.port}", **(headers or {})}
        if body is not None:
            given.setdefault("Content-Type", "application/json")
            body = body if isinstance(body, bytes) else json.dumps(body).encode()
        connection.request(method, path, body=body, headers=given)
        answer = connection.getresponse()
        try:
            return Answer(answer.status, answer.headers, answer.read())
        finally:
            connection.close()

    def get(self, path, **more):
        return self.ask("GET", path, **more)

    def post(self, path, body, **more):
        return self.ask("POST", path, body, **more)

    def stop(self):
        self.process.send_signal(signal.SIGINT)
        return self.finish()

    def kill(self):
        self.process.kill()
        return self.finish()

    def finish(self):
        try:
            return self.process.wait(30)
        finally:
            self.process.stderr.close()


class ServiceCase(unittest.TestCase):
    """One service for all tests of a class."""

    options, environment = (), {}

    @classmethod
    def setUpClass(cls):
        cls.folder = Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="service ")))
        cls.service = Service(cls.folder / "data", *cls.options, **cls.environment)
        cls.addClassCleanup(cls.service.stop)

    def assert_status(self, answer, status):
        self.assertEqual(answer.status, status, str(answer))
        return answer

    def room(self, prompt=BEDROOM, **more):
        return self.assert_status(self.service.post("/api/generate", {"prompt": prompt, **more}), 200).json()
