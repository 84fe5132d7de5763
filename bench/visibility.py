#!/usr/bin/env python3
"""How much of each thing the picture shows: generates rooms, casts a ray a pixel (blender.py --mask), and counts.

usage: bench/visibility.py [PROMPTS.jsonl…] [--seeds 3]

Counts things on the floor that are not under, in or tucked under another. Needs the built program and a Python with bpy; no graphics card.
"""

import argparse
import json
import math
import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PROGRAM = os.environ.get("LAYOUTBOX_BINARY", str(ROOT / "build/release/src/layoutbox/layoutbox"))
BPY = str(ROOT / "build/deps/bpy/bin/python")
LEAST = 0.2


def footprint(thing):
    """Corners of a thing in the plan."""
    turn = math.radians(thing["rotation"])
    w, d, _ = thing["size"]
    corners = ((-w / 2, -d / 2), (w / 2, -d / 2), (w / 2, d / 2), (-w / 2, d / 2))
    cos, sin = math.cos(turn), math.sin(turn)
    return [(thing["pos"][0] + cos * x - sin * y, thing["pos"][1] + sin * x + cos * y) for x, y in corners]


def covers(other, x, y):
    turn = math.radians(other["rotation"])
    dx, dy = x - other["pos"][0], y - other["pos"][1]
    u, v = math.cos(turn) * dx + math.sin(turn) * dy, -math.sin(turn) * dx + math.cos(turn) * dy
    return abs(u) < other["size"][0] / 2 and abs(v) < other["size"][1] / 2


def is_tucked(thing, things):
    """True where a tenth or more of a thing's footprint lies in that of something else that is higher than a rug."""
    (ax, ay), (bx, by), _, (dx, dy) = footprint(thing)
    points = [((i + 0.5) / 10, (j + 0.5) / 10) for i in range(10) for j in range(10)]
    places = [(ax + s * (bx - ax) + t * (dx - ax), ay + s * (by - ay) + t * (dy - ay)) for s, t in points]
    others = [other for other in things if other is not thing and other["pos"][2] + other["size"][2] > 0.03]
    return sum(any(covers(other, x, y) for other in others) for x, y in places) >= 10


def draw(prompt, seed, folder):
    words = ["--seed", str(seed), "--no-render", "--size", "480x270", "-o", str(folder)]
    made = subprocess.run([PROGRAM, "generate", prompt, *words], check=False, capture_output=True, text=True)
    if made.returncode not in (0, 1):
        raise RuntimeError(made.stderr)
    home = {**os.environ, "HOME": str(folder), "TMPDIR": str(folder)}
    command = [BPY, str(folder / "blender.py"), str(folder), "--mask", "--no-picture", "--no-blend"]
    subprocess.run(command, check=True, env=home, capture_output=True)
    seen = json.loads((folder / "mask.json").read_text(encoding="utf-8"))["visibility"]
    return json.loads((folder / "layout.json").read_text(encoding="utf-8")), seen


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    examples = [ROOT / "examples/prompts" / name for name in ("paper.jsonl", "gallery.jsonl")]
    parser.add_argument("prompts", nargs="*", type=Path, default=examples)
    parser.add_argument("--seeds", type=int, default=1)
    arguments = parser.parse_args()
    rows = [json.loads(line) for path in arguments.prompts for line in path.read_text(encoding="utf-8").splitlines()]
    rooms = shown = counted = behind_walls = 0
    for row in rows:
        for seed in range(1, arguments.seeds + 1):
            with tempfile.TemporaryDirectory() as folder:
                layout, seen = draw(row["prompt"], seed, Path(folder))
            rooms += 1
            behind_walls += seen["behindWalls"]
            for thing in layout["objects"]:
                if thing["supportedBy"] != "floor" or is_tucked(thing, layout["objects"]) or thing["id"] in seen["leftOut"]:
                    continue
                counted += 1
                share = seen["objects"].get(thing["id"], {"visible": 0})
                shown += share["visible"] >= LEAST
                if share["visible"] < LEAST:
                    print(f"{row['id']} seed {seed}: {thing['id']} {share['visible']:.0%} behind {share.get('behind')}")
    print(f"{rooms} rooms: {shown} of {counted} things on the floor ({shown / max(1, counted):.1%}) at least {LEAST:.0%} visible; "
          f"{behind_walls} pixels behind walls")  # fmt: skip


if __name__ == "__main__":
    sys.exit(main())
