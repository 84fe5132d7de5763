"""What is read back of a run's own pictures and scene: the .blend judged like the layout, and the mask's figures in the report."""

import subprocess
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))

from harness import CliTestCase, needs_blender, no_sandbox  # noqa: E402
from test_pictures import blenders, is_python  # noqa: E402

SMALL = ("--size", "160x90", "--quality", "draft")
MEASURES = ("COL", "OOB", "SUP", "NAV", "ACC", "OPEN")


class ReadBackCase(CliTestCase):
    def make(self, prompt, *options):
        run = self.run_layoutbox("generate", prompt, "-o", self.path("out"), *SMALL, *options)
        self.assertTrue(self.path("out/scene.blend").exists(), str(run))
        return run

    def measured(self, name):
        """Each measure's part and whole."""
        run = self.run_layoutbox("judge", self.path("out") / name, "--json")
        self.assertIn(run.status, (0, 1), str(run))
        measures = run.json()["measures"]
        return {name: (round(measures[name]["part"], 2), measures[name]["whole"]) for name in MEASURES}

    def in_blender(self, *lines):
        """Changes scene.blend as somebody would by hand."""
        blend = str(self.path("out/scene.blend"))
        text = "\n".join(("import bpy", f"bpy.ops.wm.open_mainfile(filepath={blend!r})", *lines,
                          f"bpy.ops.wm.save_as_mainfile(filepath={blend!r})", "import os; os._exit(0)"))  # fmt: skip
        program = next(iter(blenders().values()))
        words = ["-c", text] if is_python(program) else ["--background", "--python-expr", text]
        subprocess.run([program, *words], capture_output=True, timeout=120, check=True)


@needs_blender
class Blend(ReadBackCase):
    def setUp(self):
        super().setUp()
        why = no_sandbox()  # a .blend is somebody's code
        if why:
            self.skipTest(why)

    def check(self, prompt, *options):
        self.make(prompt, *options)
        drawn, placed = self.measured("scene.blend"), self.measured("layout.json")
        for name in MEASURES:  # a solid is drawn up to a millimetre smaller than those that it meets
            self.assertAlmostEqual(drawn[name][0], placed[name][0], delta=0.05, msg=name)
            self.assertEqual(drawn[name][1], placed[name][1], name)

    def test_an_overhead_door_that_stands_open(self):
        self.check("A garage with a car, a workbench under the window, a bicycle, shelves with boxes on them.")

    def test_what_hangs_nearly_down_to_the_floor(self):
        self.check("A living room with a sofa facing a tv stand with a tv on it, a rug, curtains at the window and two armchairs.")

    def test_chairs_under_a_table_below_a_lamp(self):
        self.check("A kitchen with a fridge, a stove, a dining table with six chairs and a pendant lamp over the table.")

    def test_the_pane_behind_what_hangs_on_a_wall_cut_away_is_no_thing(self):
        self.check("A bedroom, 4 x 3 m, with a bed and a poster on the right wall.", "--corner", "SE")
        self.in_blender("assert any(thing.name.startswith('wall behind poster') for thing in bpy.data.objects)")

    def test_an_l_shaped_room(self):
        self.check("An L-shaped living room, 6 x 5 m, with a sofa, a bookshelf, a dining table with four chairs and a floor lamp.")

    def test_what_was_moved_by_hand_is_judged_where_it_is(self):
        self.make("A bedroom with a bed, two nightstands and a lamp on each nightstand.")
        lamps = [o for o in self.read_json("out/layout.json")["objects"] if "lamp" in o["id"]]
        first, second = (lamp["id"] for lamp in lamps[:2])
        before = self.measured("scene.blend")
        # Each on the other's nightstand: held as well as before.
        things = f"a, b = bpy.data.objects[{first!r}], bpy.data.objects[{second!r}]"
        self.in_blender(things, "a.location, b.location = b.location.copy(), a.location.copy()")
        self.assertEqual(self.measured("scene.blend")["SUP"], before["SUP"])
        # In the air it is held by nothing; twice as large the bed overlaps what stands beside it.
        self.in_blender(f"bpy.data.objects[{first!r}].location.z += 0.5", "bpy.data.objects['bed_1'].scale = (2, 2, 1)")
        self.assertLess(self.measured("scene.blend")["SUP"], before["SUP"])
        self.assertGreater(self.measured("scene.blend")["COL"], before["COL"])


@needs_blender
class Mask(ReadBackCase):
    def test_the_report_says_what_the_picture_shows(self):
        self.assert_done(self.make("A bedroom with a bed, a wardrobe, a chair and a picture above the bed.", "--mask"))
        objects = {thing["id"] for thing in self.read_json("out/layout.json")["objects"]}
        sights = self.read_json("out/mask.json")["visibility"]
        report = self.read_json("out/report.json")
        checks = {check["subject"]: check for check in report["checks"] if check["name"] == "visibility"}
        self.assertEqual(set(checks) - {"walls"}, objects - set(sights["leftOut"]))
        for id_, sight in sights["objects"].items():
            self.assertEqual(checks[id_]["passed"], sight["visible"] >= 0.2)
        self.assertTrue(checks["walls"]["passed"])
        self.assertIn("visibility", report["metrics"])
        # The same of a layout and a mask that are there already.
        again = self.run_layoutbox("verify", self.path("out/layout.json"), "--mask", self.path("out/mask.json"), "-o", "-")
        self.assertEqual(again.json()["metrics"]["visibility"], report["metrics"]["visibility"])


if __name__ == "__main__":
    unittest.main()
