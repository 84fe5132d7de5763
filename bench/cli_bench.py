#!/usr/bin/env python3
"""Whole-process times of the program: start, and text to layout, glTF and floor plan.

    python3 bench/cli_bench.py [--binary build/release/src/layoutbox/layoutbox] [--runs 20] [--cpu 0]

Every figure is the wall time of one process, start included, on one core. The runs of all cases are interleaved, so that a slow
moment of the machine hits all of them alike.
"""

from __future__ import annotations

import argparse
import json
import os
import statistics
import subprocess
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def cases(folder: Path) -> dict[str, list[str]]:
    """Name → arguments of each case."""
    prompts = (ROOT / "examples/prompts/paper.jsonl").read_text(encoding="utf-8").splitlines()
    table = {"start (--version)": ["--version"]}
    for line in prompts:
        entry = json.loads(line)
        output = folder / entry["id"]
        table[f"prompt {entry['id']}"] = ["generate", entry["prompt"], "--no-render", "-q", "-o", str(output)]
    return table


def wall_time(command: list[str]) -> float:
    """Seconds that one run takes."""
    started = time.perf_counter()
    subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    return time.perf_counter() - started


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--binary", type=Path, default=ROOT / "build/release/src/layoutbox/layoutbox")
    parser.add_argument("--runs", type=int, default=20)
    parser.add_argument("--cpu", type=int, default=0, help="the core to run on")
    options = parser.parse_args()
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {options.cpu})
    with tempfile.TemporaryDirectory() as folder:
        table = cases(Path(folder))
        times: dict[str, list[float]] = {name: [] for name in table}
        for run in range(options.runs + 1):
            for name, arguments in table.items():
                seconds = wall_time([str(options.binary), *arguments])
                if run > 0:  # the first run warms the disk cache
                    times[name].append(seconds)
    print(f"{'case':<22}{'median':>9}{'least':>9}{'most':>9}  ms")
    for name, values in times.items():
        figures = (statistics.median(values), min(values), max(values))
        print(f"{name:<22}" + "".join(f"{figure * 1000:>9.1f}" for figure in figures))


if __name__ == "__main__":
    main()
