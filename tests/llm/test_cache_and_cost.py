"""Asked before paying: kept answers, limits of money and tokens, the first request on paper."""

import json

import fault_server as fault
import model_case
from fault_server import FaultServer, scene_call
from model_case import KEY, PROMPT, SCENE


class Cache(model_case.ModelCase):
    def test_the_same_question_is_asked_once(self):
        with FaultServer([scene_call(SCENE)]) as server:
            self.assert_done(self.generate(server))
            first = self.read_json("out/layout.json")["objects"]
            url = server.url
        run = self.generate(url, env={"OPENAI_API_KEY": None})  # no server and no key any more
        self.assert_done(run)
        self.assertEqual(self.read_json("out/layout.json")["objects"], first)
        self.assertTrue(self.requests_of_run()[0]["cached"])
        self.assert_no_key(run)

    def test_a_whole_repair_again(self):
        bad = {**SCENE, "constraints": [{"type": "nextTo", "targets": ["ghost"], "relativeTo": ["bed_1"]}]}
        with FaultServer([scene_call(bad), scene_call(SCENE)]) as server:
            self.assert_done(self.generate(server))
            url = server.url
        self.assert_done(self.generate(url))
        self.assertEqual([r["cached"] for r in self.requests_of_run()], [True, True])

    def test_no_cache(self):
        with FaultServer([scene_call(SCENE)]) as server:
            for _ in range(2):
                self.assert_done(self.plan(server, "--no-cache"))
        self.assertEqual(len(server.requests), 2)

    def test_another_model_another_answer(self):
        with FaultServer([scene_call(SCENE)]) as server:
            self.assert_done(self.plan(server, "--model", "a"))
            self.assert_done(self.plan(server, "--model", "b"))
        self.assertEqual(len(server.requests), 2)

    def test_a_broken_file_counts_as_none(self):
        with FaultServer([scene_call(SCENE)]) as server:
            self.assert_done(self.plan(server))
            for path in self.path("cache").rglob("*.json"):
                path.write_text("{", encoding="utf-8")
            self.assert_done(self.plan(server))
        self.assertEqual(len(server.requests), 2)

    def test_only_the_owner_may_read(self):
        with FaultServer([scene_call(SCENE)]) as server:
            self.assert_done(self.plan(server))
        kept = list(self.path("cache/layoutbox/answers").iterdir())
        self.assertEqual(len(kept), 1)
        self.assertEqual(kept[0].stat().st_mode & 0o077, 0)

    def test_the_command(self):
        env = self.environment("http://127.0.0.1:1/v1")
        empty = self.run_layoutbox("cache", "--json", env=env)
        self.assert_done(empty)
        self.assertEqual(empty.json()["answers"], [])
        with FaultServer([scene_call(SCENE)]) as server:
            self.assert_done(self.plan(server, "--model", "some-model"))
        listed = self.run_layoutbox("cache", env=env)
        self.assertIn("some-model", listed.out)
        self.assertEqual(len(self.run_layoutbox("cache", "--json", env=env).json()["answers"]), 1)
        self.assertIn("1 ", self.run_layoutbox("cache", "clear", env=env).out)
        self.assertEqual(self.run_layoutbox("cache", "--json", env=env).json()["answers"], [])
        self.assert_status(self.run_layoutbox("cache", "burn", env=env), 2)


class Cost(model_case.ModelCase):
    """A server that is not this machine, reached through a proxy that is."""

    def paid(self, server, *options, model="gpt-4o"):
        env = {"http_proxy": f"http://127.0.0.1:{server.port}", "NO_PROXY": None}
        return self.generate("http://model.example/v1", "--no-cache", "--model", model, *options, env=env)

    def test_is_counted(self):
        with FaultServer([scene_call(SCENE)]) as server:
            run = self.paid(server)
        self.assert_done(run)
        request = self.requests_of_run()[0]
        self.assertEqual(request["tokens"], {"request": 1000, "response": 200, "estimated": False})
        self.assertAlmostEqual(request["cost"], (1000 * 2.5 + 200 * 10) / 1e6)
        self.assertIn("$0.0045", run.err)

    def test_limit_of_money(self):
        with FaultServer([scene_call(SCENE)]) as server:
            run = self.paid(server, "--max-cost", "0.001")
        self.assert_status(run, 1)
        self.assertIn("--max-cost", run.err)
        self.assertEqual(server.requests, [])

    def test_limit_of_tokens(self):
        with FaultServer([scene_call(SCENE)]) as server:
            run = self.paid(server, "--max-tokens", "50")
        self.assert_status(run, 1)
        self.assertIn("50 tokens", run.err)
        self.assertEqual(server.requests, [])

    def test_a_batch_has_one_purse(self):
        lines = "".join(json.dumps({"id": f"room{i}", "prompt": PROMPT + f" Room {i}."}) + "\n" for i in range(6))
        prompts = self.write_text("prompts.jsonl", lines)
        for jobs in (1, 4):
            with self.subTest(jobs=jobs), FaultServer([scene_call(SCENE)]) as server:
                env = {"http_proxy": f"http://127.0.0.1:{server.port}", "NO_PROXY": None}
                out = self.path(f"batch{jobs}")
                command = ["batch", prompts, "-o", out, "-j", str(jobs), "--planner", "llm", "--model", "gpt-4o", "--no-cache"]
                # An answer costs 0.0045; a question may cost about 0.055.
                run = self.run_layoutbox(
                    *command, "--no-render", "--max-cost", "0.06", env=self.environment("http://model.example/v1", **env)
                )
                self.assert_status(run, 1)
                items = self.read_json(f"batch{jobs}/summary.json")["items"]
                failed = [item for item in items if item["state"] == "failed"]
                self.assertEqual(len(items) - len(failed), len(server.requests))
                self.assertTrue(1 <= len(server.requests) < 6, len(server.requests))
                self.assertTrue(all("limit of $0.06" in item["error"]["message"] for item in failed), failed)

    def test_a_limit_needs_a_price(self):
        with FaultServer([scene_call(SCENE)]) as server:
            run = self.paid(server, "--max-cost", "1", model="unheard-of")
            self.assert_status(run, 2)
            self.assertIn("--prices", run.err)
            prices = self.write_json("prices.json", {"models": {"unheard-of": {"request": 1, "response": 1}}})
            self.assert_done(self.paid(server, "--max-cost", "1", "--prices", prices, model="unheard-of"))

    def test_bad_prices(self):
        with FaultServer([scene_call(SCENE)]) as server:
            run = self.paid(server, "--prices", self.write_json("p.json", {"models": {"x": 3}}))
        self.assert_status(run, 2)
        self.assertIn("p.json", run.err)


class DryRun(model_case.ModelCase):
    def test_prints_and_sends_nothing(self):
        with FaultServer([fault.silence]) as server:
            run = self.generate(server, "--dry-run")
        self.assert_done(run)
        self.assertEqual(server.requests, [])
        self.assertFalse(self.path("out").exists())
        head, _, body = run.out.partition("\n\n")
        self.assertIn(f"POST {server.url}/chat/completions", head)
        self.assertNotIn(KEY, run.out)
        self.assertIn(PROMPT, json.loads(body)["messages"][1]["content"])

    def test_needs_the_model(self):
        self.assert_status(self.run_layoutbox("generate", PROMPT, "--dry-run"), 2)
