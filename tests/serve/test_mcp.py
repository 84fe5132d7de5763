"""`layoutbox mcp` speaks the Model Context Protocol over stdio."""

import base64
import json
import subprocess
import unittest

from service import BEDROOM, BINARY


class Mcp(unittest.TestCase):
    def setUp(self):
        self.process = subprocess.Popen([BINARY, "mcp"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, encoding="utf-8")
        self.number = 0
        hello = self.ask("initialize", protocolVersion="2025-06-18", capabilities={}, clientInfo={"name": "test", "version": "1"})
        self.assertEqual(hello["result"]["serverInfo"]["name"], "layoutbox")
        self.send({"jsonrpc": "2.0", "method": "notifications/initialized"})

    def tearDown(self):
        self.process.stdin.close()
        self.assertEqual(self.process.wait(30), 0)
        self.process.stdout.close()

    def send(self, message):
        self.process.stdin.write((message if isinstance(message, str) else json.dumps(message)) + "\n")
        self.process.stdin.flush()

    def ask(self, method, **parameters):
        self.number += 1
        self.send({"jsonrpc": "2.0", "id": self.number, "method": method, "params": parameters})
        answer = json.loads(self.process.stdout.readline())
        self.assertEqual(answer["id"], self.number)
        return answer

    def call(self, name, **arguments):
        return self.ask("tools/call", name=name, arguments=arguments)["result"]

    def test_every_tool_says_what_it_takes(self):
        tools = {tool["name"]: tool for tool in self.ask("tools/list")["result"]["tools"]}
        self.assertIn("prompt", tools["generate_room"]["inputSchema"]["properties"])
        self.assertNotIn("$ref", json.dumps(tools))

    def test_a_room_is_made_changed_and_looked_at(self):
        made = json.loads(self.call("generate_room", prompt=BEDROOM)["content"][0]["text"])
        edited = json.loads(self.call("edit_room", layout=made["layouts"][0], text="remove the desk")["content"][0]["text"])
        self.assertNotIn("desk_1", {item["id"] for item in edited["layout"]["objects"]})
        picture = self.call("look_at_room", layout=edited["layout"], format="png")
        if picture.get("isError"):
            self.skipTest("the library Cairo is missing")
        self.assertTrue(base64.b64decode(picture["content"][0]["data"]).startswith(b"\x89PNG"))

    def test_a_conflict_is_explained(self):
        scene = {
            "room": {"dims": {"w": 2, "d": 2, "h": 2.5}, "openings": []},
            "furniture": [{"id": f"bed_{i}", "category": "bed", "dims": {"w": 1.6, "d": 2, "h": 0.5}} for i in (1, 2)],
        }
        answer = self.call("solve_scene", scene=scene, onConflict="fail")
        self.assertTrue(answer["isError"])
        self.assertIn("bed", answer["content"][0]["text"])

    def test_mistakes_are_answered(self):
        self.assertEqual(self.ask("no/such/method")["error"]["code"], -32601)
        self.assertEqual(self.ask("tools/call", name="paint")["error"]["code"], -32602)
        self.assertTrue(self.call("generate_room", prompt=7)["isError"])
        self.send("{")
        self.assertEqual(json.loads(self.process.stdout.readline())["error"]["code"], -32700)
        self.assertEqual(self.ask("ping")["result"], {})
