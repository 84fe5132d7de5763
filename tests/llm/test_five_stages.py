"""All five stages of the paper in one command, every answer by a scripted server: it plans, writes Blender's script (badly at first), and
judges a picture that it fetches from where it was published. And the program's own script where the model's never works."""

import io
import json
import unittest
import urllib.request

import model_case
from harness import DONE, needs_blender, no_sandbox
from test_publish import SECRETS, Folder, Server

try:
    from PIL import Image
except ImportError:
    Image = None

SCRIPT = """
import bpy, math
def box(name, size, at):
    bpy.ops.mesh.primitive_cube_add(size=1, location=(at[0], at[1], at[2] + size[2] / 2))
    bpy.context.object.name, bpy.context.object.scale = name, size
box("floor", (4, 3.5, 0.02), (2, 1.75, -0.02))
box("bed_1", (1.6, 2.0, 0.5), (2, 2.4, 0))
camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
camera.location, camera.rotation_euler = (5, -2, 6), (math.radians(40), 0, math.radians(35))
bpy.context.scene.collection.objects.link(camera)
sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
sun.data.energy = 3
bpy.context.scene.collection.objects.link(sun)
"""
SMALL = ["--size", "320x180", "--quality", "draft"]


class Everything(Server):
    """Answers by the function that is offered; `scripts` in their order, the last one again and again."""

    def __init__(self, scripts):
        self.scripts, self.asked, self.pictures = list(scripts), [], []
        super().__init__(self.say)

    def say(self, _method, _path, _headers, body):
        asked = json.loads(body)
        name = asked["tools"][0]["function"]["name"]
        self.asked.append((name, asked))
        if name == "create_scene":
            said = model_case.SCENE
        elif name == "write_script":
            said = {"script": self.scripts.pop(0) if len(self.scripts) > 1 else self.scripts[0]}
        else:
            url = next(part["image_url"]["url"] for part in asked["messages"][-1]["content"] if part["type"] == "image_url")
            with urllib.request.urlopen(url, timeout=20) as response:
                self.pictures.append(response.read())
            said = {"score": 0.75, "reason": ""} if name == "score" else {"answer": "yes", "reason": ""}
        call = {"id": "c", "type": "function", "function": {"name": name, "arguments": json.dumps(said)}}
        message = {"role": "assistant", "content": None, "tool_calls": [call]}
        reply = {"choices": [{"index": 0, "finish_reason": "tool_calls", "message": message}]}
        return 200, "application/json", json.dumps(reply).encode()


@needs_blender
@unittest.skipIf(Image is None, "no Pillow")
class FiveStages(model_case.ModelCase):
    def setUp(self):
        super().setUp()
        why = no_sandbox()
        if why:
            self.skipTest(why)

    def make(self, server, *options, env=None):
        arguments = ["generate", model_case.PROMPT, "-o", self.path("out"), *SMALL, *model_case.QUICK, "--script", "llm", *options]
        run = self.run_layoutbox(*arguments, env=self.environment(server, **(env or {})))
        self.assert_status(run, DONE)
        self.assert_no_key(run)
        return run

    def test_one_command(self):
        with Everything(["import bpy\nbed = bpy.data.objects['bed_1']\n", SCRIPT]) as server, Folder() as folder:
            env = {"LAYOUTBOX_PUT_URL": folder.address + "/rooms", "LAYOUTBOX_PUT_HEADER": SECRETS["LAYOUTBOX_PUT_HEADER"]}
            run = self.make(server, "--planner", "llm", "--vlm", "--publish", "put", env=env)
        self.assertIn("script 1 of the model failed (run-time)", run.err)
        scripts = [asked for name, asked in server.asked if name == "write_script"]
        self.assertEqual(len(scripts), 2)
        self.assertIn("bed_1", scripts[0]["messages"][1]["content"])
        self.assertIn("KeyError", scripts[1]["messages"][-1]["content"])
        self.assertIn("Written by a language model", self.path("out/blender.py").read_text())
        picture = self.path("out/scene.png").read_bytes()
        self.assertEqual(Image.open(io.BytesIO(picture)).size, (320, 180))
        self.assertTrue(server.pictures)
        self.assertEqual(set(server.pictures), {picture})
        answers = self.read_json("out/answers.json")
        self.assertEqual(answers["figures"]["meanScore"], 0.75)
        self.assertTrue(answers["rooms"][0]["questions"])

    def test_relations_are_read_back_from_the_blend(self):
        """Each relation of a question has its verdict in the .blend that was written, which agrees with the layout's."""
        with Everything([SCRIPT]) as server, Folder() as folder:
            env = {"LAYOUTBOX_PUT_URL": folder.address + "/rooms", "LAYOUTBOX_PUT_HEADER": SECRETS["LAYOUTBOX_PUT_HEADER"]}
            arguments = ["generate", model_case.PROMPT, "-o", self.path("out"), *SMALL, "--vlm", "--publish", "put"]
            run = self.run_layoutbox(*arguments, env=self.environment(server, **env))
            self.assert_status(run, DONE)
        hops = [hop for q in self.read_json("out/answers.json")["rooms"][0]["questions"] for hop in q["hops"]]
        self.assertTrue(hops)
        self.assertEqual([hop["inBlend"]["holds"] for hop in hops], [hop["holds"] for hop in hops])
        self.assertIn(f"relations that the .blend has alike  {len(hops)} of {len(hops)}", run.err)
        # In another room's .blend they are not so.
        other = self.run_layoutbox("generate", "A kitchen with a table.", "-o", self.path("other"), *SMALL)
        self.assertIn(other.status, (0, 1))
        layout, blend = self.path("out/layout.json"), self.path("other/scene.blend")
        again = self.run_layoutbox("judge", layout, "--questions", "--blend", blend, "--json").json()
        self.assertFalse(any(hop["inBlend"]["holds"] for q in again["rooms"][0]["questions"] for hop in q["hops"]))

    def test_the_template_where_no_script_works(self):
        with Everything(["for x in\n"]) as server:
            run = self.make(server, "--max-attempts", "2")
        self.assertIn("(syntax)", run.err)
        self.assertIn("the program's own", run.err)
        self.assertEqual(len(server.asked), 2)
        self.assertNotIn("Written by a language model", self.path("out/blender.py").read_text())
        self.assertEqual(Image.open(io.BytesIO(self.path("out/scene.png").read_bytes())).size, (320, 180))


if __name__ == "__main__":
    unittest.main()
