"""The repair loop: planted conflicts and a server that follows the first way out, one that never mends, and all that ends the loop."""

import json
import re

import fault_server as fault
import model_case
from conflicts import conflicts
from fault_server import FaultServer, scene_call
from model_case import SCENE

PROMPT = "A bedroom."
PLANTED = dict(conflicts())


def first_way_out(request):
    """A model that does what is suggested first."""
    return fault.call(
        "patch_scene", {"patch": json.loads(re.search(r"^1\. .*?: (\[.*\])$", request.last_message(), re.MULTILINE).group(1))}
    )


class Planted(model_case.ModelCase):
    """Solved within two attempts of repair, however the conflict came about."""

    one_process = True

    def test_there_are_forty(self):
        self.assertGreaterEqual(len(PLANTED), 40)

    def test_first_way_out(self):
        for name, scene in PLANTED.items():
            with self.subTest(name):
                with FaultServer([scene_call(scene), fault.scripted(first_way_out)]) as server:
                    run = self.generate(server, "--no-cache", prompt=PROMPT)
                self.assert_done(run)
                requests = self.requests_of_run()
                self.assertEqual(requests[0]["outcome"], "conflict", name)
                self.assertLessEqual(len(requests), 3)
                self.assertEqual(requests[-1]["outcome"], "solved")
                self.assertEqual(self.read_json("out/layout.json")["status"], "solved")
                self.assertEqual(self.read_json("out/report.json")["metrics"]["collisions"], 0)


class NeverMended(model_case.ModelCase):
    """A model that changes something, but never what matters."""

    def stubborn(self):
        count = iter(range(100))

        def answer(_):
            scene = json.loads(json.dumps(PLANTED["paper"]))
            scene["constraints"][0]["why"] = f"try {next(count)}"
            return fault.call("create_scene", scene)

        return fault.scripted(answer)

    def test_relax(self):
        with FaultServer([self.stubborn()]) as server:
            run = self.generate(server, prompt=PROMPT)
        self.assert_status(run, 1)
        self.assertEqual(len(server.requests), 3)  # the first and two repairs
        layout = self.read_json("out/layout.json")
        self.assertEqual(layout["status"], "relaxed")
        self.assertTrue(layout["relaxed"])
        self.assertEqual(self.read_json("out/report.json")["metrics"]["collisions"], 0)
        self.assertEqual([r["purpose"] for r in self.requests_of_run()], ["first", "conflict", "conflict"])

    def test_what_the_model_is_told(self):
        with FaultServer([self.stubborn()]) as server:
            self.generate(server, prompt=PROMPT)
        told = server.requests[1].last_message()
        self.assertIn("wardrobe_1", told)
        self.assertRegex(told, r"\d\.\d\d m")  # numbers
        self.assertIn("againstWall", told)
        self.assertGreaterEqual(len(re.findall(r"^\d\. ", told, re.MULTILINE)), 2)

    def test_as_the_paper_does(self):
        with FaultServer([self.stubborn()]) as server:
            run = self.generate(server, "--paper-retries", prompt=PROMPT)
        self.assert_status(run, 1)
        self.assertEqual(len(server.requests), 2)
        self.assertNotIn("wardrobe", server.requests[1].last_message())
        layout = self.read_json("out/layout.json")
        self.assertEqual(layout["status"], "fallback")
        self.assertEqual([item["pos"][:2] for item in layout["objects"]], [[1, 1], [1, 1]])

    def test_original_takes_the_models_positions(self):
        scene = json.loads(json.dumps(PLANTED["paper"]))
        scene["furniture"][0]["xform"] = {"pos": [1.2, 2.3, 0], "rot": [0, 0, 0]}
        with FaultServer([scene_call(scene)]) as server:
            run = self.generate(server, "--on-conflict", "original", "--repair-attempts", "0", prompt=PROMPT)
        self.assert_status(run, 1)
        self.assertEqual(self.read_json("out/layout.json")["objects"][0]["pos"][:2], [1.2, 2.3])

    def test_fail(self):
        with FaultServer([self.stubborn()]) as server:
            run = self.generate(server, "--on-conflict", "fail", prompt=PROMPT)
        self.assert_status(run, 1)
        self.assertFalse(self.path("out/layout.json").exists())
        self.assertEqual(len(self.requests_of_run()), 3)

    def test_the_same_scene_twice_ends_it(self):
        with FaultServer([scene_call(PLANTED["paper"])]) as server:
            self.assert_status(self.generate(server, prompt=PROMPT), 1)
        self.assertEqual(len(server.requests), 2)
        self.assertEqual(self.requests_of_run()[-1]["outcome"], "same as before")

    def test_a_server_that_dies_in_between(self):
        with FaultServer([scene_call(PLANTED["paper"]), fault.status(401)]) as server:
            run = self.generate(server, prompt=PROMPT)
        self.assert_status(run, 1)
        self.assertEqual(self.read_json("out/layout.json")["status"], "relaxed")


class Invalid(model_case.ModelCase):
    """Answers that do not validate take attempts too."""

    BAD = staticmethod(scene_call({**SCENE, "constraints": [{"type": "nextTo", "targets": ["ghost_1"], "relativeTo": ["bed_1"]}]}))

    def test_the_validators_own_errors_go_back(self):
        with FaultServer([self.BAD, scene_call(SCENE)]) as server:
            self.assert_done(self.generate(server))
        told = server.requests[1].last_message()
        self.assertIn("/constraints/0/targets/0", told)
        self.assertIn("ghost_1", told)
        self.assertEqual([r["purpose"] for r in self.requests_of_run()], ["first", "faults"])

    def test_five_in_all(self):
        with FaultServer([fault.content("no")]) as server:
            run = self.generate(server)
        self.assert_status(run, 1)
        self.assertEqual(len(server.requests), 5)
        self.assertIn("no usable scene", run.err)
        self.assertEqual(len(self.requests_of_run()), 5)

    def test_what_can_be_used_is_used_in_the_end(self):
        with FaultServer([self.BAD]) as server:
            run = self.generate(server, "--max-attempts", "2")
        self.assert_done(run)
        self.assertEqual(len(self.read_json("out/layout.json")["objects"]), 3)

    def test_an_earlier_run_is_left_alone(self):
        with FaultServer([scene_call(SCENE)]) as server:
            self.assert_done(self.generate(server))
        before = {path.name: path.read_bytes() for path in self.path("out").iterdir()}
        with FaultServer([fault.content("no")]) as server:
            self.assert_status(self.generate(server, "--no-cache"), 1)
        self.assertEqual(before, {path.name: path.read_bytes() for path in self.path("out").iterdir()})


class PictureFails(model_case.ModelCase):
    """A script or a picture that fails goes back as a note; the rest of the attempts serve that."""

    def test_note(self):
        blender = self.write_text(
            "blender", "#!/bin/sh\ncase $* in *--version*) echo 'Blender 4.2.0';; *) echo 'Error: boom'; exit 1;; esac\n"
        )
        blender.chmod(0o755)
        arguments = ["generate", model_case.PROMPT, "--planner", "llm", "-o", self.path("out"), *model_case.QUICK]
        other = {**SCENE, "furniture": [*SCENE["furniture"][:2], {**SCENE["furniture"][2], "name": "floor lamp"}]}
        with FaultServer([scene_call(SCENE), scene_call(other)]) as server:
            run = self.run_layoutbox(*arguments, env=self.environment(server, LAYOUTBOX_BLENDER=blender))
        self.assert_status(run, 3)
        self.assertIn("picture failed", server.requests[1].last_message())
        self.assertEqual(len(server.requests), 3)  # the third gives the second's scene again


class Editing(model_case.ModelCase):
    """A change in words that a model reads: the rest stays where it is."""

    @staticmethod
    def moves_the_desk(request):
        scene = json.loads(request.json()["messages"][0]["content"].split("The scene:\n")[1])
        scene["constraints"] = [c for c in scene.get("constraints", []) if c["targets"] != ["desk_1"]]
        scene["constraints"].append({"type": "againstWall", "targets": ["desk_1"], "relativeTo": "wall2"})
        return fault.call("create_scene", scene)

    def test_a_desk_is_moved(self):
        text = "A bedroom of 5 x 4 x 2.6 m with a bed against the back wall and a desk against the left wall."
        self.assert_done(self.run_layoutbox("generate", text, "--no-render", "-o", self.path("out")))
        before = {item["id"]: item for item in self.read_json("out/layout.json")["objects"]}
        edit = ["edit", self.path("out/layout.json"), "put the desk on the other side", "-o", self.path("edited.json"), "--planner", "llm"]
        with FaultServer([fault.scripted(self.moves_the_desk)]) as server:
            run = self.run_layoutbox(*edit, env=self.environment(server))
        self.assert_done(run)
        self.assertIn("desk_1", run.out)
        after = {item["id"]: item for item in self.read_json("edited.json")["objects"]}
        self.assertEqual(after["bed_1"]["pos"], before["bed_1"]["pos"])
        self.assertGreater(after["desk_1"]["pos"][0], 4)
        self.assertIn("put the desk on the other side", server.requests[0].last_message())


class TextAndModel(model_case.ModelCase):
    """What the text says outright is compared with the model's scene."""

    TEXT = "A bedroom of 4 x 3 m with a bed, two nightstands and a lamp. The bed is 1.4 m wide and stands against the left wall."
    FORGETS = {
        "room": {"dims": {"w": 5, "d": 3, "h": 2.6}},
        "furniture": [
            {"id": "bed_1", "category": "bed", "dims": {"w": 1.8, "d": 2, "h": 0.6}},
            *({"id": f"nightstand_{i}", "category": "nightstand"} for i in (1, 2, 3)),
            {"id": "chair_1", "category": "chair"},
        ],
        "constraints": [{"type": "againstWall", "targets": ["bed_1"], "relativeTo": ["wall3"]}],
    }

    def scene_of(self, *options):
        with FaultServer([scene_call(self.FORGETS)]) as server:
            self.assert_done(self.plan(server, *options, prompt=self.TEXT))
        self.assertEqual(len(server.requests), 1)  # caught here, nothing is asked again
        return self.read_json("scene.json")

    def test_the_text_is_trusted(self):
        scene = self.scene_of()
        counts = [item["category"] for item in scene["furniture"]]
        # The chair is like nothing in the text, and may be what the text calls a lamp: that is listed, and nothing is added.
        self.assertEqual((counts.count("nightstand"), counts.count("lamp"), counts.count("chair")), (2, 0, 1))
        self.assertEqual(scene["room"]["polygon"][2], [4, 3])
        self.assertAlmostEqual(scene["furniture"][0]["dims"]["w"], 1.4)
        walls = [
            c["relativeTo"]
            for c in scene["constraints"]
            if c["type"] == "againstWall" and c["targets"] == ["bed_1"] and not c.get("assumed")
        ]
        self.assertEqual(walls, ["wall4"])
        notes = json.dumps([note for note in scene["notes"] if note["code"] == "text-differs"])
        for word in ("lamp", "nightstand", "chair", "size", "room"):
            self.assertIn(word, notes)

    def test_the_model_is_trusted(self):
        scene = self.scene_of("--trust", "model")
        counts = [item["category"] for item in scene["furniture"]]
        self.assertEqual((counts.count("nightstand"), counts.count("lamp")), (3, 0))
        self.assertIn("text-differs", json.dumps(scene["notes"]))
