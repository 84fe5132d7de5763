"""The same scene from servers of every form that is spoken."""

import json

import fault_server as fault
import model_case
from fault_server import FaultServer
from model_case import KEY, SCENE


def message(blocks, reason="tool_use"):
    usage = {"input_tokens": 1000, "output_tokens": 200}
    return fault.raw(200, json.dumps({"type": "message", "role": "assistant", "content": blocks, "stop_reason": reason, "usage": usage}))


def scene_use(scene):
    return message([{"type": "text", "text": "Here."}, {"type": "tool_use", "id": "t", "name": "create_scene", "input": scene}])


def streamed(scene, piece=9):
    text = json.dumps(scene)
    block = {"type": "tool_use", "id": "t", "name": "create_scene", "input": {}}
    start = {"type": "content_block_start", "index": 0, "content_block": block}
    events = [{"type": "message_start", "message": {"usage": {"input_tokens": 5, "output_tokens": 1}}}, start]
    for at in range(0, len(text), piece):
        delta = {"type": "input_json_delta", "partial_json": text[at : at + piece]}
        events.append({"type": "content_block_delta", "index": 0, "delta": delta})
    events.append({"type": "message_delta", "delta": {"stop_reason": "tool_use"}, "usage": {"output_tokens": 9}})
    events.append({"type": "message_stop"})
    body = "".join(f"event: {event['type']}\ndata: {json.dumps(event)}\n\n" for event in events)
    return fault.raw(200, body, "text/event-stream")


def error(status, kind, text):
    return fault.raw(status, json.dumps({"type": "error", "error": {"type": kind, "message": text}}))


class Anthropic(model_case.ModelCase):
    def ask(self, behaviours, *options, env=None):
        with FaultServer(behaviours) as server:
            here = {"ANTHROPIC_BASE_URL": server.url.removesuffix("/v1"), "ANTHROPIC_API_KEY": KEY, "OPENAI_API_KEY": None}
            run = self.plan("http://127.0.0.1:9/v1", "--provider", "anthropic", *options, env={**here, **(env or {})})
            self.assert_no_key(run)
            return run, server.requests

    def test_a_scene(self):
        run, requests = self.ask([scene_use(SCENE)])
        self.assert_done(run)
        self.assertEqual(len(self.read_json("scene.json")["furniture"]), 3)
        self.assertEqual(requests[0].target, "/v1/messages")
        self.assertEqual(requests[0].headers["x-api-key"], KEY)
        self.assertEqual(requests[0].headers["anthropic-version"], "2023-06-01")
        self.assertNotIn("authorization", requests[0].headers)
        body = requests[0].json()
        self.assertEqual([one["role"] for one in body["messages"]], ["user"])
        self.assertEqual(body["tool_choice"], {"type": "tool", "name": "create_scene"})
        self.assertIn("againstWall", body["system"])

    def test_a_stream(self):
        self.assert_done(self.ask([streamed(SCENE)], "--stream")[0])

    def test_busy_then_well(self):
        run, requests = self.ask([error(529, "overloaded_error", "Overloaded"), scene_use(SCENE)])
        self.assert_done(run)
        self.assertEqual(len(requests), 2)

    def test_a_parameter_it_does_not_take(self):
        run, requests = self.ask([error(400, "invalid_request_error", "temperature is not supported for this model"), scene_use(SCENE)])
        self.assert_done(run)
        self.assertIn("temperature", requests[0].json())
        self.assertNotIn("temperature", requests[1].json())

    def test_words_instead_of_a_call(self):
        words = [{"type": "text", "text": "Gladly!"}]
        run, requests = self.ask([message(words, "end_turn"), message([{"type": "text", "text": json.dumps(SCENE)}])])
        self.assert_done(run)
        self.assertNotIn("tools", requests[1].json())
        self.assertIn("JSON Schema", requests[1].json()["system"])

    def test_a_refusal_and_a_wrong_key(self):
        run, _ = self.ask([message([], "refusal")])
        self.assert_status(run, 1)
        run, _ = self.ask([error(401, "authentication_error", "invalid x-api-key")])
        self.assert_status(run, 3)
        self.assertIn("ANTHROPIC_API_KEY", run.err)

    def test_it_needs_a_key_and_a_name_that_is_known(self):
        run, _ = self.ask([scene_use(SCENE)], "--base-url", "https://api.anthropic.com", env={"ANTHROPIC_API_KEY": None})
        self.assert_status(run, 3)
        self.assertIn("ANTHROPIC_API_KEY", run.err)
        run = self.plan("http://127.0.0.1:9/v1", "--provider", "nobody")
        self.assert_status(run, 2)
        self.assertIn("openai, anthropic", run.err)


class SaidBack(model_case.ModelCase):
    """A server that says the key back."""

    def scene_named(self, name):
        return {**SCENE, "furniture": [{**SCENE["furniture"][0], "name": name}, *SCENE["furniture"][1:]]}

    def test_in_a_name(self):
        escaped = "".join(f"\\u{ord(sign):04x}" for sign in KEY)
        arguments = json.dumps(self.scene_named("NAME")).replace("NAME", escaped)
        for behaviour in (fault.scene_call(self.scene_named(KEY)), fault.answer(fault.call("create_scene", arguments), "tool_calls")):
            with FaultServer([behaviour]) as server:
                run = self.generate(server, "--no-cache")
                self.assert_done(run)
                self.assert_no_key(run)

    def assert_nothing_of_it(self, text):
        """Neither the key nor a good part of it, whatever stands between its letters."""
        bare = "".join(filter(str.isalnum, text))
        self.assertNotIn("".join(filter(str.isalnum, KEY))[:13], bare, text)

    def test_cut_by_the_length_of_a_message(self):
        words = "x" * 240 + " " + KEY
        for body in (json.dumps({"error": {"message": words}}), json.dumps({"error": {"message": words}}).replace("-", "\\u002d")):
            with FaultServer([fault.raw(400, body)]) as server:
                run = self.plan(server)
            self.assert_nothing_of_it(run.err + run.out)

    def test_split_by_signs(self):
        for words in ("-".join(KEY), " ".join(KEY), "\n".join(KEY), ".\n".join(KEY[i : i + 5] for i in range(0, len(KEY), 5))):
            with FaultServer([fault.status(401, f"no, {words} is wrong")]) as server:
                run = self.plan(server)
            self.assertIn("no, [key] is wrong", run.err)
            self.assert_nothing_of_it(run.err + run.out)

    def test_in_pieces_of_a_stream(self):
        data = fault.events(fault.call("create_scene", self.scene_named(KEY)), piece=3)
        with FaultServer([fault.stream(data, 1000)]) as server:
            run = self.generate(server, "--stream")
            self.assert_done(run)
            self.assert_no_key(run)
        for kept in self.folder.rglob("*"):
            if kept.is_file():
                self.assertNotIn(b"delta", kept.read_bytes(), f"{kept}: the stream as it came")


class UsersPrices(model_case.ModelCase):
    def test_a_file_of_the_users_own(self):
        file = self.path("config") / "layoutbox/prices.json"
        file.parent.mkdir(parents=True)
        file.write_text(json.dumps({"models": {"unheard-of": {"request": 10, "response": 10, "asOf": "2026-11"}}}))
        with FaultServer([fault.scene_call(SCENE)]) as server:  # not this machine, reached through a proxy that is
            env = {"http_proxy": f"http://127.0.0.1:{server.port}", "NO_PROXY": None, "XDG_CONFIG_HOME": self.path("config")}
            command = ["--no-cache", "--model", "unheard-of", "--max-cost", "1"]
            run = self.generate("http://model.example/v1", *command, env=env)
            self.assert_done(run)
            self.assertIn("$0.0120 at prices of 2026-11", run.err)
            file.write_text("{")
            run = self.generate("http://model.example/v1", *command, env=env)
            self.assert_status(run, 2)
            self.assertIn("prices.json", run.err)
