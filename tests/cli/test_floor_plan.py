"""The floor plan as PDF and PNG: the same page as the SVG, through Cairo."""

import ctypes.util
import io
import re
import struct
import unittest

from harness import DONE, WRONG_INPUT, CliTestCase
from PIL import Image

needs_cairo = unittest.skipUnless(ctypes.util.find_library("cairo"), "the library Cairo is not on this machine")


@needs_cairo
class PlanPages(CliTestCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        run = cls.run_layoutbox("generate", "A bedroom with a bed, a desk and a wardrobe.", "--no-render", "-o", cls.class_folder / "room")
        assert run.status == DONE, run
        cls.layout = cls.class_folder / "room/layout.json"

    def export(self, name, *arguments):
        self.assert_done(self.run_layoutbox("export", self.layout, "-o", self.path(name), *arguments))
        return self.path(name).read_bytes()

    def test_pdf_is_a4_across(self):
        pdf = self.export("plan.pdf")
        self.assertTrue(pdf.startswith(b"%PDF-"))
        self.assertTrue(pdf.rstrip().endswith(b"%%EOF"))
        box = re.search(rb"/MediaBox \[\s*0 0 ([\d.]+) ([\d.]+)", pdf)
        self.assertAlmostEqual(float(box[1]), 297 / 25.4 * 72, delta=0.1)
        self.assertAlmostEqual(float(box[2]), 210 / 25.4 * 72, delta=0.1)
        self.assertEqual(len(re.findall(rb"/Type /Page\b", pdf)), 1)

    def test_png_in_another_resolution(self):
        for dpi, expected in ((100, (1169, 827)), (300, (3508, 2480))):
            self.assertEqual(struct.unpack(">II", self.export("plan.png", "--dpi", str(dpi))[16:24]), expected)
        self.assert_status(self.run_layoutbox("export", self.layout, "-o", self.path("x.png"), "--dpi", "5"), WRONG_INPUT)

    def test_png_has_ink_where_the_walls_are(self):
        with Image.open(io.BytesIO(self.export("plan.png"))) as page:
            self.assertEqual((page.format, page.mode, page.size), ("PNG", "RGB", (2339, 1654)))
            self.assertGreater(len(page.getcolors(1 << 20)), 50)  # lines, fills and smoothed text, not one colour

    def test_format_by_name_beats_the_ending(self):
        self.assertTrue(self.export("plan.out", "--format", "pdf").startswith(b"%PDF-"))
        self.assertTrue(self.export("page.png", "--format", "svg").startswith(b"<?xml"))

    def test_unknown_format(self):
        run = self.run_layoutbox("export", self.layout, "-o", self.path("plan.dwg"))
        self.assert_status(run, WRONG_INPUT)
        self.assertIn("pdf", run.err)
