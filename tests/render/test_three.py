"""scene.glb in a second program: three.js in a headless Chromium draws it as a room that one looks into."""

import json
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))

import rooms  # noqa: E402
import view_in_three  # noqa: E402
from harness import CliTestCase  # noqa: E402
from png import read_png  # noqa: E402

SIZE = (480, 270)
LACKS = view_in_three.missing()


@unittest.skipIf(LACKS, f"not looked at: {LACKS}")
class Three(CliTestCase):
    def test_bedroom(self):
        layout = self.write_json("layout.json", rooms.BEDROOM)
        self.assert_done(self.run_layoutbox("export", layout, "-o", self.path("room.glb")))
        nodes, triangles = view_in_three.draw(self.path("room.glb"), self.path("room.png"), size=SIZE)
        data = self.path("room.glb").read_bytes()
        document = json.loads(data[20 : 20 + int.from_bytes(data[12:16], "little")])
        self.assertGreaterEqual(nodes, len(document["nodes"]))
        self.assertGreater(triangles, 1000)
        _, _, rows = read_png(self.path("room.png"))
        picture = [row[: SIZE[0]] for row in rows[: SIZE[1]]]
        background = picture[2][2]
        self.assertGreater(min(background[:3]), 180)
        room = [pixel[:3] for row in picture for pixel in row if max(abs(a - b) for a, b in zip(pixel, background, strict=True)) > 6]
        self.assertTrue(0.15 < len(room) / (SIZE[0] * SIZE[1]) < 0.7, len(room))
        # the floor is seen before the front and right walls: under the picture's middle there is no wall paint
        below = [picture[y][SIZE[0] // 2][:3] for y in range(int(SIZE[1] * 0.62), int(SIZE[1] * 0.86))]
        warm = sum(1 for r, g, b in below if r > b + 25)
        self.assertGreater(warm, 0.6 * len(below), f"no boards of the floor: {below}")


if __name__ == "__main__":
    unittest.main()
