#!/usr/bin/env python3
"""Makes the contact sheets of docs/gallery/: every shape family, and 24 rooms. Needs the built program, a Python with bpy, and Pillow.

usage: build/deps/tools/bin/python scripts/make_gallery.py [families|kinds|rooms]… [--work FOLDER] [--only NAME,NAME] [--quality draft]
"""

import argparse
import json
import os
import subprocess
import sys
from pathlib import Path

from PIL import Image, ImageDraw, ImageFont

ROOT = Path(__file__).resolve().parents[1]
PROGRAM = os.environ.get("LAYOUTBOX_BINARY", str(ROOT / "build/release/src/layoutbox/layoutbox"))
BPY = str(ROOT / "build/deps/bpy/bin/python")
BACKGROUND = (224, 229, 235)

# What stands for a family where its first entry is not its plainest.
FACES = {
    "ball": "exercise_ball",
    "barbell_bench": "weight_bench",
    "bench": "entryway_bench",
    "bin": "trash_can",
    "board": "whiteboard",
    "bowl": "fruit_bowl",
    "box": "food_package",
    "box_container": "crate",
    "cabinet": "sideboard",
    "car_part": "car",
    "chair": "dining_chair",
    "chest_of_drawers": "dresser",
    "counter": "reception_desk",
    "cup": "mug",
    "cushion": "pillow",
    "display_case": "display_cabinet",
    "glass": "wine_glass",
    "flask": "water_bottle",
    "pocket": "personal_item",
    "shoes": "shoe",
    "wood_pile": "firewood",
    "stone": "decorative_stone",
    "kitchen_unit": "counter",
    "picture": "painting",
    "plant": "monstera",
    "pot": "teapot",
    "rack": "clothes_rack",
    "shelf": "bookshelf",
    "sink": "bathroom_vanity",
    "speaker": "floor_speaker",
    "stand": "plant_stand",
    "statue": "sculpture",
    "stool": "bar_stool",
    "swing": "hanging_chair",
    "table": "dining_table",
    "teddy": "teddy_bear",
    "toy_blocks": "building_block",
    "tree": "fiddle_leaf_fig",
}


def prompts(name):
    """(name, prompt) of a file of examples/prompts."""
    lines = (ROOT / "examples/prompts" / name).read_text(encoding="utf-8").splitlines()
    return [(row["id"], row["prompt"]) for row in map(json.loads, lines)]


ROOMS = [(f"prompt {name}", prompt) for name, prompt in prompts("paper.jsonl")[:6]] + prompts("gallery.jsonl")


def run(*words):
    subprocess.run([str(word) for word in words], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


class Blender:
    """One Blender for all pictures (blender/serve.py)."""

    def __init__(self, work):
        home = work / "home"
        home.mkdir(parents=True, exist_ok=True)
        environment = {**os.environ, "HOME": str(home), "TMPDIR": str(home)}
        self.process = subprocess.Popen([BPY, str(ROOT / "blender/serve.py")], env=environment, text=True, stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, stderr=subprocess.STDOUT)  # fmt: skip

    def draw(self, script, folder):
        self.process.stdin.write(json.dumps({"script": str(script), "words": [str(folder), "--no-blend"]}) + "\n")
        self.process.stdin.flush()
        for line in self.process.stdout:
            if line.startswith("layoutbox: failed"):
                raise RuntimeError(line)
            if line.startswith("layoutbox: done"):
                return
        raise RuntimeError("Blender went down")


def entries():
    found = {}
    for path in sorted((ROOT / "catalog").glob("*.json")):
        data = json.loads(path.read_text(encoding="utf-8"))
        if isinstance(data, dict) and "entries" in data:
            found.update({entry["id"]: entry for entry in data["entries"]})
    return found


def usual_size(entry):
    return [value[1] if isinstance(value, list) else value for value in (entry["size"][side] for side in "wdh")]


def alone(entry, work):
    """A layout with nothing but one thing, standing on the floor of a room that is hardly larger."""
    w, d, h = usual_size(entry)
    x, y = w + 0.3 * max(w, d), d + 0.3 * max(w, d)
    corners = [[0, 0], [x, 0], [x, y], [0, y]]
    walls = [{"id": f"wall{i + 1}", "start": corners[i], "end": corners[(i + 1) % 4], "thickness": 0.05} for i in range(4)]
    thing = {"id": "thing_1", "category": entry["id"], "name": entry["name"], "size": [w, d, h], "pos": [x / 2, y / 2, 0], "rotation": 0,
             "mount": entry.get("mount", "floor"), "supportedBy": "floor"}  # fmt: skip
    room = {"polygon": corners, "height": h + 0.1, "walls": walls, "openings": []}
    layout = {"format": "layoutbox/layout@1", "status": "solved",
              "room": room, "objects": [thing], "relations": [], "relaxed": [], "conflicts": [],
              "score": {"total": 1, "terms": {}},
              "stats": {"solver": "hand", "seed": 1, "seconds": 0, "proven": False}}  # fmt: skip
    path = work / "layout.json"
    path.write_text(json.dumps(layout), encoding="utf-8")
    return path


# Only the thing on a plain ground, seen from nearer the floor than a room.
ON_PLAIN_GROUND = """
WALLS.clear()
OPENINGS.clear()
SHELL[:] = [row for row in SHELL if row["kind"] == "floor"]
for row in SHELL:
    row["parts"] = [("plain ground", number) for _, number in row["parts"]]
MATERIALS["plain ground"] = {**PLAIN, "color": (0.80, 0.80, 0.79)}
USUAL_CAMERA.update(azimuth=32.0, elevation=32.0)
"""


def tile_of(entry, blender, work, quality):
    folder = work / "tiles" / entry["id"]
    folder.mkdir(parents=True, exist_ok=True)
    picture = folder / "scene.png"
    run(PROGRAM, "render", alone(entry, folder), "-o", folder, "--no-render", "--size", "320x280", "--quality", quality)
    script = folder / "blender.py"
    text = script.read_text(encoding="utf-8")
    script.write_text(text.replace('\nif __name__ == "__main__":', ON_PLAIN_GROUND + '\nif __name__ == "__main__":'), encoding="utf-8")
    blender.draw(script, folder)
    return picture


def wanted(arguments, *names):
    return not arguments.only or any(word in names for word in arguments.only.split(","))


def font(size):
    for name in ("DejaVuSans.ttf", "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"):
        try:
            return ImageFont.truetype(name, size)
        except OSError:
            continue
    return ImageFont.load_default(size)


def sheet(pictures, columns, tile, path, text_size=13):
    """Pictures with their names under them, in rows."""
    strip = text_size + 8
    rows = -(-len(pictures) // columns)
    page = Image.new("RGB", (columns * tile[0], rows * (tile[1] + strip)), BACKGROUND)
    draw = ImageDraw.Draw(page)
    for number, (name, picture) in enumerate(pictures):
        x, y = number % columns * tile[0], number // columns * (tile[1] + strip)
        with Image.open(picture) as image:
            page.paste(image.convert("RGB").resize(tile, Image.Resampling.LANCZOS), (x, y))
        draw.text((x + tile[0] / 2, y + tile[1] + strip / 2 - 2), name, fill=(50, 55, 60), font=font(text_size), anchor="mm")
    path.parent.mkdir(parents=True, exist_ok=True)
    page.save(path, quality=82, optimize=True)
    print(f"{path}: {len(pictures)} pictures, {path.stat().st_size // 1024} kB")


def families(blender, arguments):
    by_family = {}
    for entry in entries().values():
        by_family.setdefault(entry["shape"]["family"], []).append(entry)
    chosen = []
    for family, kinds in sorted(by_family.items()):
        names = {kind["id"]: kind for kind in kinds}
        chosen.append((family, names.get(FACES.get(family, family), names.get(family, kinds[0]))))
    pictures = [(family.replace("_", " "), tile_of(entry, blender, arguments.work, arguments.quality or "preview"))
                for family, entry in chosen if wanted(arguments, family)]  # fmt: skip
    sheet(pictures, 12, (160, 140), arguments.output / "families.jpg", 12)


def kinds(blender, arguments):
    """Every entry of the catalogue: for looking, not kept in the repository."""
    chosen = [entry for entry in entries().values() if wanted(arguments, entry["id"], entry["shape"]["family"])]
    pictures = [(entry["id"].replace("_", " "), tile_of(entry, blender, arguments.work, "draft")) for entry in chosen]
    for page in range(0, len(pictures), 120):
        sheet(pictures[page : page + 120], 12, (160, 140), arguments.work / f"kinds-{page // 120 + 1}.jpg", 12)


def rooms(blender, arguments):
    pictures = []
    for number, (name, prompt) in enumerate(ROOMS, 1):
        if not wanted(arguments, name):
            continue
        folder = arguments.work / f"room-{number:02}"
        words = ["--size", arguments.size, "--quality", arguments.quality or "preview"]
        subprocess.run([PROGRAM, "generate", prompt, "-o", folder, "--no-render", *words], check=False, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)  # fmt: skip
        blender.draw(folder / "blender.py", folder)
        pictures.append((name, folder / "scene.png"))
        print(f"{name}: {folder}", flush=True)
    sheet(pictures, 4, (480, 360), arguments.output / "rooms.jpg")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", nargs="*", default=["families", "rooms"])
    parser.add_argument("--work", type=Path, default=Path("build/gallery"))
    parser.add_argument("--output", type=Path, help="of the sheets: docs/gallery, where all is drawn; the work folder with --only")
    parser.add_argument("--only", default="")
    parser.add_argument("--quality", default="")
    parser.add_argument("--size", default="840x630")
    arguments = parser.parse_args()
    arguments.work = arguments.work.resolve()
    arguments.output = arguments.output or (arguments.work if arguments.only else ROOT / "docs/gallery")
    blender = Blender(arguments.work)
    for what in arguments.what:
        {"families": families, "kinds": kinds, "rooms": rooms}[what](blender, arguments)
    blender.process.stdin.close()
    blender.process.wait(timeout=30)


if __name__ == "__main__":
    sys.exit(main())
