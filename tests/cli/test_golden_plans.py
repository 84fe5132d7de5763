"""Floor plans of five fixed layouts against pictures that were looked at.

Small pictures in greys: fonts differ a little from machine to machine, furniture and walls do not. After a change that is meant,
LAYOUTBOX_GOLDEN=write python3 tests/run_case.py tests/cli/test_golden_plans.py GoldenPlans.test_each writes them anew; look at each.
"""

import ctypes.util
import io
import json
import os
import unittest
from pathlib import Path

from harness import CliTestCase

try:
    from PIL import Image, ImageChops
except ImportError:
    Image = None

FOLDER = Path(__file__).resolve().parent / "golden_plans"
NAMES = sorted(path.stem for path in FOLDER.glob("*.json"))
DPI = "72"


def difference(one, other):
    """The share of the page that is clearly lighter or darker, looked at from some way off."""
    size = (one.width // 3, one.height // 3)
    small = [picture.convert("L").resize(size, Image.Resampling.BOX) for picture in (one, other)]
    shades = ImageChops.difference(*small).histogram()
    return sum(shades[40:]) / (size[0] * size[1])


@unittest.skipUnless(Image and ctypes.util.find_library("cairo"), "Pillow or the library Cairo is not on this machine")
class GoldenPlans(CliTestCase):
    MOST = 0.0012

    def drawn(self, name):
        out = self.path(f"{name}.png")
        self.assert_done(self.run_layoutbox("export", FOLDER / f"{name}.json", "-o", out, "--dpi", DPI))
        return Image.open(io.BytesIO(out.read_bytes()))

    def golden(self, name):
        return Image.open(FOLDER / f"{name}.png")

    def test_each(self):
        self.assertEqual(len(NAMES), 5)
        for name in NAMES:
            with self.subTest(name):
                picture = self.drawn(name)
                if os.environ.get("LAYOUTBOX_GOLDEN") == "write":
                    picture.convert("L").quantize(16).save(FOLDER / f"{name}.png", optimize=True)
                self.assertEqual(picture.size, self.golden(name).size)
                self.assertLess(difference(picture, self.golden(name)), self.MOST)

    def test_a_thing_that_moves_is_seen(self):
        text = (FOLDER / "bedroom.json").read_text(encoding="utf-8")
        moved = self.write_text("moved.json", self.with_wardrobe_moved(text))
        out = self.path("moved.png")
        self.assert_done(self.run_layoutbox("export", moved, "-o", out, "--dpi", DPI))
        self.assertGreater(difference(Image.open(out), self.golden("bedroom")), self.MOST)

    def with_wardrobe_moved(self, text):
        layout = json.loads(text)
        wardrobe = next(one for one in layout["objects"] if one["category"] == "wardrobe")
        wardrobe["pos"][1] += 0.4
        return json.dumps(layout)
