"""glTF files as other programs read them: the official validator on the whole catalogue and on meshes of the user's own; sizes of files."""

import base64
import json
import math
import struct

from harness import DONE, SOURCE, WRONG_INPUT, CliTestCase

CUBE = """mtllib cube.mtl
usemtl paint
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
vt 0 0
vt 1 0
vt 1 1
f -8/1 -5/2 -6/3 -7/1
f 5/1 6/2 7/3 8/1
f 1/1 2/2 6/3 5/1
f 3/1 4/2 8/3 7/1
f 2/1 3/2 7/3 6/1
f 4/1 1/2 5/3 8/1
"""
# A PNG of one white pixel.
PIXEL = base64.b64decode("iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVQI12P4//8/AAX+Av7czFnnAAAAAElFTkSuQmCC")


def layout_of(objects, side, height=4.0, **wall):
    corners = [[0, 0], [side, 0], [side, side], [0, side]]
    walls = [{"id": f"wall{i + 1}", "start": corners[i], "end": corners[(i + 1) % 4], "thickness": 0.1} for i in range(4)]
    walls[2].update(wall)
    return {
        "format": "layoutbox/layout@1",
        "prompt": "",
        "roomType": "bedroom",
        "status": "solved",
        "room": {"polygon": corners, "height": height, "walls": walls, "openings": []},
        "objects": objects,
        "relations": [],
        "relaxed": [],
        "conflicts": [],
        "score": {"total": 1, "terms": {}},
        "stats": {"solver": "hand", "seed": 1, "seconds": 0, "proven": False},
    }


def placed(name, category, size, x, y, **more):
    thing = {"id": name, "category": category, "name": category, "attributes": [], "size": size, "pos": [x, y, 0], "rotation": 0}
    return {**thing, "mount": "floor", "supportedBy": "floor", **more}


def every_entry_at(which):
    """Each entry at its least (0), usual (1) or greatest (2) size, on a place of its own."""
    things = []
    for file in sorted((SOURCE / "catalog").glob("*.json")):
        for entry in json.loads(file.read_text(encoding="utf-8")).get("entries", []):
            sides = [entry["size"][axis] for axis in "wdh"]
            things.append((entry["id"], [side[which] if isinstance(side, list) else side for side in sides]))
    columns = math.ceil(math.sqrt(len(things)))
    step = 99 / columns
    return [
        placed(f"{category}_{i}", category, size, (i % columns + 0.5) * step, (i // columns + 0.5) * step)
        for i, (category, size) in enumerate(things)
    ]


class WholeCatalogue(CliTestCase):
    def export(self, which, detail):
        layout = self.write_json("layout.json", layout_of(every_entry_at(which), 100, 10.0))
        glb = self.path(f"{detail}-{which}.glb")
        self.assert_done(self.run_layoutbox("export", layout, "-o", glb, "--detail", detail))
        return glb

    def test_every_entry_is_valid_at_its_least_usual_and_greatest_size(self):
        self.assert_valid_gltf(*(self.export(which, "usual") for which in range(3)))

    def test_every_entry_is_valid_in_low_and_in_high_detail(self):
        self.assert_valid_gltf(*(self.export(1, detail) for detail in ("low", "high")))

    def test_an_unknown_level_of_detail_is_an_error(self):
        layout = self.write_json("layout.json", layout_of([], 4))
        run = self.run_layoutbox("export", layout, "-o", self.path("x.glb"), "--detail", "finest")
        self.assert_status(run, WRONG_INPUT)
        self.assertIn("low, usual or high", run.err)


class Rooms(CliTestCase):
    def test_a_full_room_is_small_and_low_detail_smaller(self):
        prompt = (
            "A living room with a corner sofa, two armchairs, a coffee table, four books and a vase on the coffee table, a TV stand "
            "with a TV, two bookshelves, a dining table with six chairs, six plates on the dining table, a chandelier, a rug, four "
            "pictures, two floor lamps, curtains and four plants."
        )
        run = self.run_layoutbox("generate", prompt, "--no-render", "-o", self.path("room"))
        self.assertIn(run.status, (0, 1), run)
        self.assertGreater(len(self.read_json("room/layout.json")["objects"]), 30)
        self.assert_valid_gltf(self.path("room/scene.glb"))
        usual = self.path("room/scene.glb").stat().st_size
        self.assertLess(usual, 3_000_000)
        low = self.path("low.glb")
        self.assert_done(self.run_layoutbox("export", self.path("room/layout.json"), "-o", low, "--detail", "low"))
        self.assertLess(low.stat().st_size, 0.75 * usual)


class OwnMeshes(CliTestCase):
    def setUp(self):
        super().setUp()
        self.write_text("cube.obj", CUBE)
        self.write_text("cube.mtl", "newmtl paint\nKd 0.5 0.5 1\nmap_Kd paint.png\n")
        self.path("paint.png").write_bytes(PIXEL)

    def export(self, **wall):
        thing = placed("box_1", "box", [1, 1, 1], 2, 2, mesh="cube.obj")
        layout = self.write_json("layout.json", layout_of([thing], 4, **wall))
        return self.run_layoutbox("export", layout, "-o", self.path("own.glb"))

    def test_an_object_and_a_wall(self):
        self.assert_done(self.export(mesh="cube.obj"))
        self.assert_valid_gltf(self.path("own.glb"))
        data = self.path("own.glb").read_bytes()
        document = json.loads(data[20 : 20 + struct.unpack("<I", data[12:16])[0]])
        self.assertIn("cube.obj#paint", [material["name"] for material in document["materials"]])
        wall = next(node for node in document["nodes"] if node["name"] == "wall3")
        bounds = document["accessors"][document["meshes"][wall["mesh"]]["primitives"][0]["attributes"]["POSITION"]]
        self.assertEqual([round(high - low, 3) for low, high in zip(bounds["min"], bounds["max"], strict=True)], [4.0, 4.0, 0.1])

    def test_a_walls_mesh_that_cannot_be_had_is_an_error_with_its_name(self):
        for mesh in ("none.glb", "../cube.obj", "paint.png"):
            run = self.export(mesh=mesh)
            self.assertNotEqual(run.status, DONE, mesh)
            self.assertIn('the wall "wall3"', run.err)
            self.assertIn(mesh, run.err)
            self.assertFalse(self.path("own.glb").exists())
