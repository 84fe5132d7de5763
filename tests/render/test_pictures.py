"""The script in the real Blender, at low resolution: is the room in the picture, whole, bright and hidden by nothing?"""

import json
import os
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))

import rooms  # noqa: E402
from gif import read_gif  # noqa: E402
from harness import DEPS, CliTestCase, needs_blender  # noqa: E402
from png import read_png  # noqa: E402

SIZE = (480, 270)


def is_python(program):
    return Path(program).name.startswith("python")


def blenders():
    """Every Blender of this machine by a name for messages."""
    found = {}
    named = os.environ.get("LAYOUTBOX_BLENDER")
    if named:
        found["LAYOUTBOX_BLENDER"] = named
    if shutil.which("blender"):
        found["blender on the PATH"] = shutil.which("blender")
    for folder in sorted(DEPS.glob("bpy*"), reverse=True):  # bpy, and bpy-4.5 and the like where somebody made them
        if (folder / "bin/python").exists():
            found[f"build/deps/{folder.name}"] = str(folder / "bin/python")
    return found


def version_of(program):
    """A Blender's version, as "4.5", or None where it does not start."""
    words = ["-c", "import bpy; print('Blender', bpy.app.version_string)"] if is_python(program) else ["--version"]
    try:
        done = subprocess.run([program, *words], capture_output=True, text=True, timeout=60, check=False)
    except (OSError, subprocess.TimeoutExpired):
        return None
    lines = [line for line in done.stdout.splitlines() if line.startswith("Blender ")]
    return ".".join(lines[0].split()[1].split(".")[:2]) if lines else None


class PictureCase(CliTestCase):
    def make_script(self, layout, quality="preview"):
        path = self.write_json("layout.json", layout)
        size = f"{SIZE[0]}x{SIZE[1]}"
        options = ("--no-render", "--size", size, "--quality", quality, "--corner", "SE")
        self.assert_done(self.run_layoutbox("render", path, "-o", self.folder, *options))
        return self.path("blender.py")

    def run_script(self, script, folder, *words, program=None):
        program = program or next(iter(blenders().values()))
        start = [program] if is_python(program) else [program, "-b", "-noaudio", "--factory-startup", "--python-exit-code", "3", "--python"]
        command = [*start, script, *([] if is_python(program) else ["--"]), folder, *words]
        home = self.class_folder / "home"
        environment = {**os.environ, "HOME": str(home), "TMPDIR": str(home), "XDG_CACHE_HOME": str(home)}
        pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT}
        done = subprocess.run([str(c) for c in command], env=environment, text=True, timeout=600, check=False, **pipes)
        self.assertEqual(done.returncode, 0, done.stdout[-3000:])
        return done.stdout

    def picture_of(self, layout):
        """(rows of pixels, rows of the mask, the mask's index)."""
        self.run_script(self.make_script(layout), self.folder, "--mask", "--no-blend")
        index = self.read_json("mask.json")
        width, height, mask = read_png(self.path("mask.png"))
        self.assertEqual((width, height), SIZE)
        width, height, picture = read_png(self.path("scene.png"))
        self.assertEqual((width, height), SIZE)
        return picture, mask, index

    def assert_framed(self, mask):
        """The room is whole in the picture, with a margin, and fills it in one direction."""
        black = (0, 0, 0)
        columns = [x for x in range(SIZE[0]) if any(row[x] != black for row in mask)]
        lines = [y for y in range(SIZE[1]) if any(pixel != black for pixel in mask[y])]
        margins = (columns[0], SIZE[0] - 1 - columns[-1], lines[0], SIZE[1] - 1 - lines[-1])
        self.assertGreater(min(margins), 3, f"margins left, right, top, bottom: {margins}")
        self.assertLess(min(margins), 0.08 * SIZE[1], f"the room is small in the picture: {margins}")

    def assert_well_lit(self, picture, mask):
        """A plain light background; hardly anything black or burnt out; a wide range of tones."""
        corners = [picture[y][x] for y in (2, SIZE[1] - 3) for x in (2, SIZE[0] - 3)]
        for corner in corners:
            self.assertGreater(min(corner), 180, f"the background's corners: {corners}")
            self.assertLess(max(abs(a - b) for a, b in zip(corner, corners[0], strict=True)), 4, f"the background's corners: {corners}")
        room = [pixel for row, ids in zip(picture, mask, strict=True) for pixel, id_ in zip(row, ids, strict=True) if id_ != (0, 0, 0)]
        grey = sorted(0.3 * r + 0.6 * g + 0.1 * b for r, g, b in room)
        dark = sum(1 for v in grey if v < 12) / len(grey)
        burnt = sum(1 for v in grey if v > 253) / len(grey)
        self.assertLess(dark, 0.03, "black pixels")
        self.assertLess(burnt, 0.02, "white pixels")
        self.assertGreater(grey[len(grey) // 2], 90, "the middle tone")
        self.assertGreater(grey[int(0.98 * len(grey))] - grey[int(0.02 * len(grey))], 60, "the range of tones")

    def assert_nothing_hidden(self, layout, index):
        seen = index["visibility"]
        self.assertEqual(seen["behindWalls"], 0, "pixels of floor or furniture behind walls")
        self.assertGreaterEqual(seen["floor"]["seen"], 0.6 * seen["floor"]["free"], seen["floor"])
        for thing in layout["objects"]:
            if thing["id"] in seen["leftOut"]:
                continue
            shares = seen["objects"][thing["id"]]
            if thing["mount"] == "floor":
                self.assertGreaterEqual(shares["visible"], 0.2, f"{thing['id']}: {shares}")


@needs_blender
class Pictures(PictureCase):
    def check(self, layout):
        picture, mask, index = self.picture_of(layout)
        self.assert_framed(mask)
        self.assert_well_lit(picture, mask)
        self.assert_nothing_hidden(layout, index)
        return mask, index

    def test_bedroom(self):
        mask, index = self.check(rooms.BEDROOM)
        ids = {thing["id"] for thing in index["things"]}
        self.assertIn("picture_1", ids)
        self.assertIn("wall3", ids)
        self.assertNotIn("wall1", ids, "faces the camera: cut away")
        self.assertNotIn("ceiling", ids)
        self.assertIn("curtain_1", index["visibility"]["leftOut"], "hangs on a wall that is cut away and would hide the room")
        colors = {pixel for row in mask for pixel in row}
        for thing in index["things"]:
            if thing["kind"] == "object":
                self.assertIn(tuple(thing["color"]), colors, thing["id"])

    def test_what_hangs_at_a_cut_wall_goes_with_what_it_carries(self):
        _, _, index = self.picture_of(rooms.SHELVES)
        self.assertEqual(set(index["visibility"]["leftOut"]), {"wall_shelf_1", "vase_1"}, "only the deep shelf hides the room")

    def test_smallest_room(self):
        self.check(rooms.SMALLEST)

    def test_largest_room(self):
        self.check(rooms.LARGEST)

    def test_high_room(self):
        self.check(rooms.HIGH)

    def test_room_with_an_inner_corner(self):
        self.check(rooms.L_SHAPED)

    def test_render_command_writes_picture_and_blend(self):
        layout = self.write_json("layout.json", rooms.SMALLEST)
        self.assert_done(self.run_layoutbox("render", layout, "-o", self.path("out"), "--size", "160x90", "--quality", "draft"))
        self.assertEqual(read_png(self.path("out") / "scene.png")[:2], (160, 90))
        names = sorted(path.name for path in self.path("out").iterdir())
        self.assertEqual(names, ["blender.py", "scene.blend", "scene.png"])


@needs_blender
class Views(PictureCase):
    """Every view shows the room; inside ones fill the picture with it; the overlay changes the picture only where there are words."""

    def test_all_views_and_overlay(self):
        layout = self.write_json("layout.json", rooms.BEDROOM)
        words = ["--views", "top,iso,front,eye,door", "--overlay", "--size", "240x136", "--quality", "draft"]
        self.assert_done(self.run_layoutbox("render", layout, "-o", self.folder, *words))
        pictures = {}
        for view in ("-top", "", "-front", "-eye", "-door", "-overlay"):
            width, height, pictures[view] = read_png(self.path(f"scene{view}.png"))
            self.assertEqual((width, height), (240, 136), view)
        background = pictures[""][3][3]
        for view in ("-top", "", "-front"):
            corners = [pictures[view][y][x] for x, y in ((3, 3), (236, 3), (3, 132), (236, 132))]
            self.assertLess(max(abs(a - b) for corner in corners for a, b in zip(corner, background, strict=True)), 8, f"{view}: framed")
        for view in ("-eye", "-door"):
            flat = [pixel for row in pictures[view] for pixel in row]
            empty = sum(1 for pixel in flat if max(abs(a - b) for a, b in zip(pixel, background, strict=True)) < 3) / len(flat)
            self.assertLess(empty, 0.15, f"{view} shows what is behind the walls")
            grey = sorted(sum(pixel) / 3 for pixel in flat)
            self.assertGreater(grey[len(grey) // 2], 70, f"{view} is dark")
        # the overlay lies over the first view
        pairs = [(a, b) for one, two in zip(pictures["-top"], pictures["-overlay"], strict=True) for a, b in zip(one, two, strict=True)]
        changed = sum(1 for a, b in pairs if max(abs(x - y) for x, y in zip(a, b, strict=True)) > 40) / len(pairs)
        self.assertTrue(0.01 < changed < 0.6, changed)

    def test_a_room_without_a_door_is_seen_from_inside_too(self):
        layout = {**rooms.BEDROOM, "room": {**rooms.BEDROOM["room"], "openings": []}}
        words = ["--views", "door", "--size", "96x54", "--quality", "draft"]
        self.assert_done(self.run_layoutbox("render", self.write_json("layout.json", layout), "-o", self.folder, *words))
        self.assertTrue(self.path("scene-door.png").exists())
        self.assertFalse(self.path("scene.png").exists())


@needs_blender
class Turntable(PictureCase):
    """The camera goes round the room: as many frames as the table says, each another."""

    def test_gif(self):
        layout = self.write_json("layout.json", rooms.SMALLEST)
        self.assert_done(self.run_layoutbox("render", layout, "-o", self.folder, "--no-render", "--size", "128x72", "--quality", "draft"))
        script = self.path("blender.py")
        text = script.read_text(encoding="utf-8")
        self.assertIn('"frames": 36', text)
        script.write_text(text.replace('"frames": 36', '"frames": 4'), encoding="utf-8")
        self.run_script(script, self.folder, "--no-picture", "--no-blend", "--turntable=gif")
        width, height, frames = read_gif(self.path("scene-turntable.gif"))
        self.assertEqual((width, height, len(frames)), (128, 72, 4))
        self.assertEqual({delay for delay, _ in frames}, {150}, "once round in six seconds")
        for number, (_, rows) in enumerate(frames):
            other = frames[(number + 1) % 4][1]
            changed = sum(a != b for one, two in zip(rows, other, strict=True) for a, b in zip(one, two, strict=True)) / (128 * 72)
            self.assertGreater(changed, 0.05, f"frame {number} and the next one look alike")
        edge = {pixel for _, rows in frames for pixel in [*rows[0], *rows[-1], *(row[0] for row in rows), *(row[-1] for row in rows)]}
        self.assertEqual(len(edge), 1, f"grain or flicker in the background: {edge}")


@needs_blender
class EveryBlender(PictureCase):
    """The same file runs in each Blender that is here, from a folder of its own and beside itself."""

    def check_version(self, version):
        program = next((program for program in blenders().values() if version_of(program) == version), None)
        if program is None:
            self.skipTest(f"no Blender {version} here (docs/render.md says how to get one)")
        folder = self.path(f"by {version}")
        folder.mkdir()
        output = self.run_script(self.make_script(rooms.BEDROOM, "draft"), folder, program=program)
        self.assertIn(f"layoutbox: blender {version}", output)
        self.assertNotIn("layoutbox: note:", output)
        self.assertEqual(read_png(folder / "scene.png")[:2], SIZE)
        self.assertGreater((folder / "scene.blend").stat().st_size, 10_000)

    def test_script_runs_in_3_4(self):
        self.check_version("3.4")

    def test_script_runs_in_4_2(self):
        self.check_version("4.2")

    def test_script_runs_in_4_5(self):
        self.check_version("4.5")

    def test_script_runs_in_5_0(self):
        self.check_version("5.0")

    def test_writes_beside_itself_without_a_folder(self):
        script = self.make_script(rooms.SMALLEST, "draft")
        program = next(iter(blenders().values()))
        start = [program] if is_python(program) else [program, "-b", "-noaudio", "--python"]
        subprocess.run([*start, str(script)], cwd="/", stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=300, check=True)
        self.assertTrue(self.path("scene.png").exists() and self.path("scene.blend").exists())

    def test_tables_can_be_changed_by_hand(self):
        script = self.make_script(rooms.SMALLEST, "draft")
        text = script.read_text(encoding="utf-8")
        self.assertIn('"azimuth": 45.0', text)
        script.write_text(text.replace('"azimuth": 45.0', '"azimuth": -45.0'), encoding="utf-8")
        self.run_script(script, self.folder, "--mask", "--no-blend", "--no-picture")
        ids = {thing["id"] for thing in json.loads(self.path("mask.json").read_text())["things"]}
        self.assertIn("wall2", ids, "now seen from the front left: the right wall stays")
        self.assertNotIn("wall4", ids)


if __name__ == "__main__":
    unittest.main()
