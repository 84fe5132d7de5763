"""Two rooms compared by a scripted judge, both ways round; a judge judged by rooms with planted faults; several views at once."""

import base64
import hashlib
import json
import unittest

import model_case
from fault_server import call, completion
from harness import DONE, needs_blender
from test_publish import Server
from test_vision import ROOM


class PairServer(Server):
    """Chooses by `choose(pictures of the first, pictures of the second)`: "first", "second" or "neither"."""

    def __init__(self, choose):
        self.choose, self.counts, self.texts = choose, [], []
        super().__init__(self.say)

    def say(self, _method, _path, _headers, body):
        asked = json.loads(body)
        name = asked["tools"][0]["function"]["name"]
        parts = asked["messages"][-1]["content"]
        self.texts.append(" ".join(part["text"] for part in parts if part["type"] == "text"))
        shown = [base64.b64decode(part["image_url"]["url"].split(",", 1)[1]) for part in parts if part["type"] == "image_url"]
        self.counts.append(len(shown))
        half = len(shown) // 2
        said = {"choose": lambda: {"better": self.choose(shown[:half], shown[half:]), "reason": ""}}.get(
            name, lambda: {"score": 0.5, "answer": "yes", "reason": ""}
        )()
        return 200, "application/json", json.dumps(completion(call(name, said))).encode()


class Pairs(model_case.ModelCase):
    def setUp(self):
        super().setUp()
        self.path("rooms").mkdir()
        for name, room in (("good", ROOM), ("bad", self.changed(0, [9, 3, 0]))):
            self.path(f"rooms/{name}").mkdir()
            self.write_json(f"rooms/{name}/layout.json", room)

    @staticmethod
    def changed(number, place):
        room = json.loads(json.dumps(ROOM))
        room["objects"][number]["pos"] = place
        return room

    def compare(self, choose, *options):
        with PairServer(choose) as server:
            run = self.run_layoutbox("judge", *options, "--json", env=self.environment(server))
            self.assert_status(run, DONE)
            return run.json(), server

    def test_who_sees_sticks_to_it(self):
        seen = {}

        def longest(first, second):  # a picture is better by its bytes, whichever comes first
            keys = [hashlib.sha256(b"".join(side)).hexdigest() for side in (first, second)]
            seen.update(dict.fromkeys(keys))
            return "first" if keys[0] > keys[1] else "second"

        said, server = self.compare(longest, self.path("rooms"), "--pairwise")
        self.assertEqual(server.counts, [2, 2])
        self.assertEqual(len(seen), 2)
        self.assertEqual(said["figures"]["steady"]["value"], 1)
        self.assertEqual(said["figures"]["prefersFirst"]["value"], 0.5)
        self.assertEqual(said["comparisons"][0]["better"], "good")
        self.assertIn(said["comparisons"][0]["winner"], ("good", "bad"))

    def test_who_likes_the_first_contradicts_himself(self):
        said, _ = self.compare(lambda first, second: "first", self.path("rooms"), "--pairwise")
        self.assertEqual(said["figures"]["steady"]["value"], 0)
        self.assertEqual(said["figures"]["prefersFirst"]["value"], 1)
        self.assertEqual(said["figures"]["right"]["value"], 0)
        self.assertIsNone(said["comparisons"][0]["winner"])

    def test_a_judge_is_judged_by_planted_faults(self):
        own = []

        def seeing(first, second):
            own.append((first[0], second[0]))
            sound = max({picture for pair in own for picture in pair}, key=lambda p: sum(p in pair for pair in own))
            return "first" if first[0] == sound else "second"

        # Learns in a first round which picture is always there; the answers of a second one count.
        room = self.path("rooms/good/layout.json")
        self.compare(seeing, room, "--faults", "--no-cache")
        said, _ = self.compare(seeing, room, "--faults", "--no-cache")
        self.assertEqual(said["figures"]["right"]["value"], 1)
        self.assertGreaterEqual(set(said["faults"]), {"turned", "moved into another", "through a wall"})
        blind, _ = self.compare(lambda first, second: "neither", room, "--faults", "--no-cache")
        self.assertEqual(blind["figures"]["right"]["value"], 0)

    @needs_blender
    def test_several_views_at_once(self):
        run_options = [self.path("rooms/good/layout.json"), "--by", "vlm", "--views", "plan,top", "--singles", "1", "--multis", "0"]
        _, server = self.compare(None, *run_options)
        self.assertEqual(set(server.counts), {2})
        self.assertIn("its floor plan, seen from straight above", server.texts[0])


if __name__ == "__main__":
    unittest.main()
