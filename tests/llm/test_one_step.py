"""One-step generation by a scripted server: a script that works, one that is no Python, one that raises, rooms that cannot be; cleaning
up, and asking again with what was wrong."""

import json
import unittest

import model_case
from fault_server import FaultServer, call, scripted
from harness import DONE, needs_blender, no_sandbox

GOOD = """
import bpy
def box(name, size, at):
    bpy.ops.mesh.primitive_cube_add(size=1, location=(at[0], at[1], at[2] + size[2] / 2))
    bpy.context.object.name, bpy.context.object.scale = name, size
box("bed_1_frame", (1.6, 2.0, 0.3), (2, 2.4, 0))
box("bed_1_mattress", (1.6, 2.0, 0.2), (2, 2.4, 0.3))
box("desk_1", (1.2, 0.6, 0.75), (0.6, 0.3, 0))
box("back wall", (4, 0.1, 2.6), (2, 3.55, 0))
"""
ANSWERS = {
    "GOOD": GOOD,
    "SYNTAX": "import bpy\nfor x in:\n    pass\n",
    "RAISES": "import bpy\nbpy.ops.mesh.primitive_bed_add()\n",
    "OVERLAP": GOOD.replace('"desk_1", (1.2, 0.6, 0.75), (0.6, 0.3, 0)', '"desk_1", (1.2, 0.6, 0.75), (2, 2, 0)'),
    "OUTSIDE": GOOD.replace('"desk_1", (1.2, 0.6, 0.75), (0.6, 0.3, 0)', '"desk_1", (1.2, 0.6, 0.75), (4, 0.3, 0)'),
    "MENDED": "raise ValueError('not yet')\n",
}
ROW = '{0},"A bedroom of 4 x 3.5 x 2.6 m with a bed and a desk. {0}","eq,1,bed; eq,1,desk",,,\n'


def script_for(request):
    """The script whose word stands in the request; a MENDED one is good the second time."""
    said = json.dumps(request.json()["messages"])
    word = next(word for word in ANSWERS if word + "\\n</request>" in said)
    return call("write_script", {"script": GOOD if word == "MENDED" and "not yet" in said else ANSWERS[word]})


@needs_blender
class OneStep(model_case.ModelCase):
    def setUp(self):
        super().setUp()
        why = no_sandbox()
        if why:
            self.skipTest(why)

    def experiment(self, method, *words):
        table = "ID,Description,ObjCount,ObjAttr,OORel,OARel\n" + "".join(ROW.format(word) for word in words)
        with FaultServer([scripted(script_for)]) as server:
            suite = self.write_text("table.csv", table)
            run = self.run_layoutbox(
                "experiment", suite, "-o", self.path("out"), "--methods", method, "--effort", "10", env=self.environment(server)
            )
            self.assert_status(run, DONE)
            self.assert_no_key(run)
            lines = [json.loads(line) for line in self.path("out/results.jsonl").read_text().splitlines()]
            return {line["scene"]: line for line in lines}, server

    def test_failures_have_their_class(self):
        rooms, server = self.experiment("one-step", "GOOD", "SYNTAX", "RAISES", "OVERLAP", "OUTSIDE")
        self.assertEqual(len(server.requests), 5)
        asked = server.requests[0].last_message()
        self.assertIn("4 x 3.5 x 2.6", asked)
        self.assertIn("desk: ", asked)
        classes = {scene: room["failure"] for scene, room in rooms.items()}
        self.assertEqual(
            classes, {"GOOD": "", "SYNTAX": "syntax", "RAISES": "run-time", "OVERLAP": "collision", "OUTSIDE": "out of bounds"}
        )
        self.assertEqual(rooms["GOOD"]["measures"]["CNT"], [2, 2])
        self.assertEqual(rooms["GOOD"]["objects"], 2)
        self.assertEqual(rooms["RAISES"]["outcome"], "failed")
        self.assertIn("(line 2)", rooms["RAISES"]["error"])
        self.assertIn("out of bounds", self.path("out/report.html").read_text())

    def test_cleaned_up(self):
        rooms, _ = self.experiment("one-step-cleaned", "OVERLAP")
        self.assertEqual(rooms["OVERLAP"]["failure"], "")
        self.assertEqual(rooms["OVERLAP"]["measures"]["COL"][0], 0)

    def test_told_what_failed(self):
        rooms, server = self.experiment("one-step-again", "MENDED")
        self.assertEqual(len(server.requests), 2)
        self.assertIn("ValueError: not yet (line 1)", server.requests[1].last_message())
        self.assertEqual(rooms["MENDED"]["failure"], "")
        self.assertEqual(rooms["MENDED"]["requests"], 2)


if __name__ == "__main__":
    unittest.main()
