#!/usr/bin/env python3
"""How long furnishing and glTF take: the stages `furnish` and `export` of run.json, medians over runs of one prompt of 20 things.

usage: bench/furnish_bench.py [--runs 15]
"""

import argparse
import json
import os
import statistics
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PROGRAM = os.environ.get("LAYOUTBOX_BINARY", str(ROOT / "build/release/src/layoutbox/layoutbox"))
PROMPT = (
    "A 7 x 6 m living room with a sofa, two armchairs, a coffee table, a rug, a TV stand with a TV, two bookshelves, a floor lamp, "
    "a plant, a dining table with six chairs, a sideboard with a vase on it, and a painting."
)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=15)
    arguments = parser.parse_args()
    times = {}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(arguments.runs):
            words = ["generate", PROMPT, "--no-render", "-o", folder, "--json"]
            made = json.loads(subprocess.run([PROGRAM, *words], check=False, capture_output=True, text=True).stdout)
            for stage in made["stages"]:
                times.setdefault(stage["stage"], []).append(1000 * stage["seconds"])
        glb = Path(folder) / "scene.glb"
        print(f"{made['objects']} things; scene.glb {glb.stat().st_size / 1e6:.2f} MB")
    for stage, values in times.items():
        print(f"{stage}: median {statistics.median(values):.1f} ms, least {min(values):.1f}, most {max(values):.1f}")


if __name__ == "__main__":
    main()
