"""The main job: text in, files out. All without Blender; pictures are tests/render."""

import json
import signal
import time
import xml.etree.ElementTree as ET

from harness import DONE, INTERRUPTED, NOT_AS_ASKED, SHARED, SOURCE, WRONG_SURROUNDINGS, CliTestCase, needs_shared

PROMPTS = {
    entry["id"]: entry["prompt"]
    for entry in map(json.loads, (SOURCE / "examples/prompts/paper.jsonl").read_text(encoding="utf-8").splitlines())
}
CONFLICT = (
    "A bedroom (3 x 3 x 2.5 m). The bed is 2 m wide and stands against the back wall. "
    "The wardrobe is 2.4 m wide and stands against the back wall."
)
FILES = {"scene.json", "layout.json", "floorplan.svg", "scene.glb", "blender.py", "report.json", "run.json"}


def by_category(layout):
    counts = {}
    for item in layout["objects"]:
        counts[item["category"]] = counts.get(item["category"], 0) + 1
    return counts


class PaperPrompts(CliTestCase):
    """Each prompt of the paper gives what it asks for, and our own verifier agrees."""

    def generate(self, number, status=DONE):
        run = self.run_layoutbox("generate", PROMPTS[number], "--no-render", "-o", self.path("out"))
        self.assert_status(run, status)
        self.assertEqual(FILES, {path.name for path in self.path("out").iterdir()})
        report = self.read_json("out/report.json")
        self.assertTrue(report["passed"], json.dumps([c for c in report["checks"] if not c["passed"]], indent=1))
        self.assert_valid_gltf(self.path("out/scene.glb"))
        ET.parse(self.path("out/floorplan.svg"))
        compile(self.path("out/blender.py").read_text(encoding="utf-8"), "blender.py", "exec")
        return self.read_json("out/layout.json")

    def test_prompt_1(self):
        layout = self.generate("1")
        asked = {**layout, "objects": [item for item in layout["objects"] if item.get("origin", "asked") == "asked"]}
        self.assertEqual(by_category(asked), {"bed": 1, "desk": 1, "lamp": 1})
        self.assertEqual(layout["room"]["polygon"], [[0, 0], [4, 0], [4, 2], [0, 2]])
        self.assertEqual(layout["room"]["height"], 3)

    def test_prompt_2(self):
        layout = self.generate("2")
        objects = {item["category"]: item for item in layout["objects"]}
        lamp = next(item for item in layout["objects"] if "lamp" in item["category"])
        self.assertEqual(lamp["supportedBy"], objects["desk"]["id"])
        bed = objects["bed"]
        wide = bed["size"][0] if bed["rotation"] in (0, 180) else bed["size"][1]
        self.assertAlmostEqual(bed["pos"][0] - wide / 2, 0, delta=0.02)

    def test_prompt_3(self):
        layout = self.generate("3")
        self.assertEqual(len([o for o in layout["objects"] if o["origin"] != "added"]), 4)

    def test_prompt_4(self):
        layout = self.generate("4")
        counts = by_category(layout)
        self.assertEqual(sum(n for category, n in counts.items() if category.endswith("chair")), 6)
        table = next(item for item in layout["objects"] if item["category"] == "dining_table")
        self.assertAlmostEqual(table["pos"][0], 1.8, delta=0.1)
        self.assertAlmostEqual(table["pos"][1], 1.8, delta=0.1)

    def test_prompt_5(self):
        layout = self.generate("5")
        bed = next(item for item in layout["objects"] if item["category"] == "bed")
        self.assertAlmostEqual(bed["pos"][0], 2.0, delta=0.006)
        self.assertEqual(bed["rotation"], 0)

    def test_prompt_7(self):
        layout = self.generate("7")
        self.assertEqual(sum(1 for item in layout["objects"] if item.get("origin", "asked") == "asked"), 3)


class Outputs(CliTestCase):
    def generate(self, *arguments, status=DONE):
        run = self.run_layoutbox("generate", "A bedroom with a bed and a desk.", "-o", self.path("out"), *arguments)
        self.assert_status(run, status)
        return run

    def test_same_seed_same_bytes(self):
        self.generate("--no-render", "--seed", "7")
        first = {name: self.path(f"out/{name}").read_bytes() for name in ("scene.json", "floorplan.svg", "scene.glb", "blender.py")}
        first_layout = self.read_json("out/layout.json")
        self.generate("--no-render", "--seed", "7")
        for name, content in first.items():
            self.assertEqual(self.path(f"out/{name}").read_bytes(), content, name)
        second_layout = self.read_json("out/layout.json")
        first_layout["stats"].pop("seconds")
        second_layout["stats"].pop("seconds")
        self.assertEqual(first_layout, second_layout)

    def test_stages_by_hand_give_what_generate_gives(self):
        self.generate("--no-render", "--companions", "off")
        for command in (
            ["plan", "A bedroom with a bed and a desk.", "--companions", "off", "-o", self.path("scene.json")],
            ["solve", self.path("scene.json"), "-o", self.path("layout.json")],
            ["verify", self.path("layout.json"), "-o", self.path("report.json")],
            ["export", self.path("layout.json"), "-o", self.path("room.svg")],
            ["export", self.path("layout.json"), "-o", self.path("room.glb")],
            ["render", self.path("layout.json"), "--no-render", "-o", self.path("render")],
        ):
            self.assert_done(self.run_layoutbox(*command))
        self.assertEqual(self.read_json("layout.json")["objects"], self.read_json("out/layout.json")["objects"])
        self.assertEqual(self.path("room.svg").read_bytes(), self.path("out/floorplan.svg").read_bytes())
        self.assertEqual(self.path("room.glb").read_bytes(), self.path("out/scene.glb").read_bytes())
        self.assertEqual(self.path("render/blender.py").read_bytes(), self.path("out/blender.py").read_bytes())

    def test_finished_rooms_are_dressed(self):
        self.generate("--no-render")
        ids = {
            "scene": {o["id"] for o in self.read_json("out/scene.json")["furniture"]},
            "layout": {o["id"] for o in self.read_json("out/layout.json")["objects"]},
        }
        self.assertEqual(ids["scene"], ids["layout"])
        self.assertTrue({"curtain_1", "painting_1"} <= ids["layout"], ids["layout"])
        self.assert_done(self.run_layoutbox("solve", self.path("out/scene.json"), "-o", self.path("again.json")))
        self.assertEqual({o["id"] for o in self.read_json("again.json")["objects"]}, ids["layout"])
        self.assert_done(self.run_layoutbox("verify", self.path("again.json")))
        self.generate("--no-render", "--companions", "off")
        self.assertEqual({o["id"] for o in self.read_json("out/layout.json")["objects"]}, {"bed_1", "desk_1"})

    def test_own_files_validate(self):
        self.generate("--no-render")
        for name in ("scene.json", "layout.json"):
            self.assert_done(self.run_layoutbox("validate", self.path(f"out/{name}")))

    def test_json_is_all_there_is_on_stdout(self):
        run = self.generate("--no-render", "--json")
        self.assertEqual(set(run.json()["files"]), FILES)
        self.assertTrue(run.json()["asAsked"])

    def test_error_in_json(self):
        run = self.run_layoutbox("generate", "", "--json", "-o", self.path("none"))
        self.assert_status(run, 2)
        self.assertEqual(set(run.json()), {"code", "message", "pointer", "hint"})
        self.assertEqual(run.json()["code"], "empty")

    def test_quiet_says_nothing(self):
        self.assertEqual(self.generate("--no-render", "-q").err, "")

    def test_a_line_per_stage(self):
        stages = [line.split()[0] for line in self.generate("--no-render").err.splitlines()]
        self.assertEqual(stages, ["plan", "solve", "dress", "furnish", "export", "verify"])

    def test_prompt_from_stdin(self):
        run = self.run_layoutbox("generate", "-", "--no-render", "-o", self.path("out"), stdin="A bedroom with a bed.")
        self.assert_done(run)

    def test_no_blender_writes_all_else_first(self):
        env = {"LAYOUTBOX_BLENDER": "/nowhere/blender"}
        run = self.run_layoutbox("generate", "A bedroom with a bed.", "-o", self.path("out"), env=env)
        self.assert_status(run, WRONG_SURROUNDINGS)
        self.assertIn("/nowhere/blender", run.err)
        self.assertEqual(FILES, {path.name for path in self.path("out").iterdir()})

    def test_earlier_picture_does_not_stay_beside_a_new_room(self):
        self.generate("--no-render")
        self.path("out/scene.png").write_bytes(b"an earlier picture")
        self.path("out/mine.txt").write_text("the user's own", encoding="utf-8")
        self.generate("--no-render")
        self.assertFalse(self.path("out/scene.png").exists())
        self.assertTrue(self.path("out/mine.txt").exists())

    def test_failed_prompt_leaves_an_earlier_run_alone(self):
        self.generate("--no-render")
        before = {path.name: path.read_bytes() for path in self.path("out").iterdir()}
        self.assert_status(self.run_layoutbox("generate", "", "-o", self.path("out")), 2)
        self.assertEqual(before, {path.name: path.read_bytes() for path in self.path("out").iterdir()})

    def test_what_was_not_understood_is_listed(self):
        run = self.run_layoutbox("generate", "A bedroom with a bed and a frobnicator.", "--no-render", "-o", self.path("out"))
        notes = json.dumps(self.read_json("out/run.json")["notes"]) + run.err
        self.assertIn("frobnicator", notes)

    def test_conflict_is_named_and_relaxed(self):
        run = self.run_layoutbox("generate", CONFLICT, "--no-render", "-o", self.path("out"))
        self.assert_status(run, NOT_AS_ASKED)
        layout = self.read_json("out/layout.json")
        self.assertEqual(layout["status"], "relaxed")
        self.assertTrue(layout["relaxed"] and layout["conflicts"])
        self.assertIn("back wall", layout["conflicts"][0]["sentence"])
        self.assertEqual(self.read_json("out/report.json")["metrics"]["collisions"], 0)

    def test_conflict_fails_when_asked_to(self):
        run = self.run_layoutbox("generate", CONFLICT, "--no-render", "--on-conflict", "fail", "-o", self.path("out"))
        self.assert_status(run, NOT_AS_ASKED)
        self.assertIn("wall", run.err)
        self.assertFalse(self.path("out/layout.json").exists())

    def test_missing_solver_library_is_named_by_doctor(self):
        run = self.run_layoutbox("doctor", env={"ORTOOLS_ROOT": "/nowhere/ortools"})
        self.assert_status(run, WRONG_SURROUNDINGS)
        self.assertIn("MISSING CP-SAT", run.out)
        self.assertIn("/nowhere/ortools", run.out)

    def test_two_runs_into_one_folder(self):
        self.path("out").mkdir()
        first = self.start("generate", "-", "--no-render", "-o", self.path("out"), stdin=-1, stdout=-1, stderr=-1)
        self.addCleanup(first.communicate)
        # The first run holds no lock while it waits for its prompt: take the folder's lock as a run in progress does.
        import fcntl
        import os

        descriptor = os.open(self.path("out"), os.O_RDONLY)
        self.addCleanup(os.close, descriptor)
        fcntl.flock(descriptor, fcntl.LOCK_EX)
        run = self.run_layoutbox("generate", "A bedroom with a bed.", "--no-render", "-o", self.path("out"))
        self.assert_status(run, WRONG_SURROUNDINGS)
        self.assertIn("another run", run.err)
        self.assertEqual(list(self.path("out").iterdir()), [])

    def test_interrupt_keeps_what_is_finished(self):
        """A Blender that never ends, and Ctrl-C."""
        fake = self.write_text("blender", "#!/bin/sh\ncase $* in *--version*) echo 'Blender 4.2.0';; *) sleep 60;; esac\n")
        fake.chmod(0o755)
        process = self.start("generate", "A bedroom with a bed.", "-o", self.path("out"), env={"LAYOUTBOX_BLENDER": fake}, stderr=-1)
        deadline = time.monotonic() + 20
        while not self.path("out/report.json").exists() and time.monotonic() < deadline:
            time.sleep(0.02)
        time.sleep(0.3)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=10)
        self.assertEqual(process.returncode, INTERRUPTED)
        self.assertEqual(FILES, {path.name for path in self.path("out").iterdir()})


@needs_shared
class Variants(CliTestCase):
    """Each of several layouts has the files of a room, under names of its own."""

    EACH = ("layout.json", "floorplan.svg", "scene.glb", "blender.py", "report.json")
    PIXEL = "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGP4DwABAQEAsTj2FAAAAABJRU5ErkJggg=="

    def fake_blender(self):
        """Draws one white pixel, whatever the room."""
        body = f"echo {self.PIXEL} | base64 -d > \"$out/scene.png\"; echo blend > \"$out/scene.blend\""
        begin = "#!/bin/sh\ncase \"$*\" in *--version*) echo 'Blender 4.2.0'; exit 0;; esac\n"
        fake = self.write_text("blender", begin + f'while [ "$1" != -- ]; do shift; done; out=$2\n{body}\n')
        fake.chmod(0o755)
        return {"LAYOUTBOX_BLENDER": fake}

    def numbered(self, name, number):
        stem, dot, end = name.partition(".")
        return f"{stem}-{number}{dot}{end}"

    def test_each_is_exported_verified_and_drawn(self):
        prompt = "A study with a desk and a bookshelf."
        run = self.run_layoutbox("generate", prompt, "--variants", "3", "-o", self.path("out"), env=self.fake_blender())
        self.assert_done(run)
        expected = {"scene.json", "run.json"}
        for name in (*self.EACH, "scene.png", "scene.blend"):
            expected |= {name, self.numbered(name, 2), self.numbered(name, 3)}
        self.assertEqual({path.name for path in self.path("out").iterdir()}, expected)
        self.assertEqual(set(self.read_json("out/run.json")["files"]), expected - {"run.json"})
        self.assert_valid_gltf(*(self.path(f"out/scene-{number}.glb") for number in (2, 3)))
        for number in (2, 3):
            self.assertTrue(self.read_json(f"out/report-{number}.json")["passed"])
            exported = self.path(f"again-{number}.glb")
            self.assert_done(self.run_layoutbox("export", self.path(f"out/layout-{number}.json"), "-o", exported))
            self.assertEqual(exported.read_bytes(), self.path(f"out/scene-{number}.glb").read_bytes())

    def test_a_later_run_without_them_leaves_none(self):
        prompt = "A study with a desk and a bookshelf."
        self.assert_done(self.run_layoutbox("generate", prompt, "--variants", "2", "--no-render", "-o", self.path("out")))
        self.assert_done(self.run_layoutbox("generate", prompt, "--no-render", "-o", self.path("out")))
        self.assertEqual({path.name for path in self.path("out").iterdir()}, {"scene.json", "run.json", *self.EACH})


@needs_shared
class PaperFiles(CliTestCase):
    def test_scene_in_the_papers_form(self):
        file = SHARED / "data/paper/example/scene-as-the-paper-writes-it.json"
        run = self.run_layoutbox("solve", file, "-v", "-o", self.path("layout.json"))
        self.assert_done(run)
        self.assert_done(self.run_layoutbox("verify", self.path("layout.json")))

    def test_layout_by_hand(self):
        self.assert_done(self.run_layoutbox("verify", SHARED / "data/paper/example/1/layout.json"))
