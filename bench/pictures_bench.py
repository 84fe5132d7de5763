#!/usr/bin/env python3
"""Many pictures by one running Blender: how long a batch takes, what of it is Blender's own time, how much memory Blender needs.

usage: bench/pictures_bench.py [--rooms 100] [--size 960x540] [--quality draft] [--device cpu|gpu]

The rooms are those of examples/prompts with one seed after another. The claim to hold it against, on a machine with a graphics card:

    bench/pictures_bench.py --size 1920x1080 --quality preview --device gpu

Needs the built program and a Blender (docs/render.md). Where there is no graphics card that Cycles can use, the processor draws.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PROGRAM = os.environ.get("LAYOUTBOX_BINARY", str(ROOT / "build/release/src/layoutbox/layoutbox"))


def rows(count):
    """So many lines for `layoutbox batch`."""
    examples = [ROOT / "examples/prompts" / name for name in ("paper.jsonl", "gallery.jsonl")]
    prompts = [json.loads(line)["prompt"] for path in examples for line in path.read_text(encoding="utf-8").splitlines()]
    return [{"id": f"room-{n + 1:03}", "prompt": prompts[n % len(prompts)], "seed": 1 + n // len(prompts)} for n in range(count)]


def descendants(process):
    """Ids of the processes that a process started, and theirs."""
    try:
        children = Path(f"/proc/{process}/task/{process}/children").read_text(encoding="ascii").split()
    except OSError:
        return []
    return [pid for child in children for pid in (child, *descendants(child))]


def resident_mb(process):
    try:
        pages = int(Path(f"/proc/{process}/statm").read_text(encoding="ascii").split()[1])
    except (OSError, IndexError, ValueError):
        return 0.0
    return pages * os.sysconf("SC_PAGE_SIZE") / 1e6


class Memory(threading.Thread):
    """Watches what runs under a process: the most that one of them held, by the second."""

    def __init__(self, process):
        super().__init__(daemon=True)
        self.process, self.samples, self.blenders = process, [], set()

    def run(self):
        while self.process.poll() is None:
            held = {pid: resident_mb(pid) for pid in descendants(self.process.pid)}
            if held:
                pid = max(held, key=held.get)
                self.samples.append(held[pid])
                self.blenders.add(pid)
            time.sleep(0.5)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rooms", type=int, default=100)
    parser.add_argument("--size", default="960x540")
    parser.add_argument("--quality", default="draft")
    parser.add_argument("--device", choices=("cpu", "gpu"), default="cpu")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        table = folder / "rooms.jsonl"
        table.write_text("".join(json.dumps(row) + "\n" for row in rows(arguments.rooms)), encoding="utf-8")
        command = [PROGRAM, "batch", str(table), "-o", str(folder / "out"), "-j", "1", "--quality", arguments.quality,
                   "--size", arguments.size, "-q"]  # fmt: skip
        started = time.perf_counter()
        environment = {**os.environ, "LAYOUTBOX_DEVICE": arguments.device}
        process = subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        memory = Memory(process)
        memory.start()
        process.wait()
        memory.join()
        seconds = time.perf_counter() - started
        pictures = list((folder / "out").glob("*/scene.png"))
        runs = [json.loads(path.read_text(encoding="utf-8")) for path in (folder / "out").glob("*/run.json")]
    blender = sum(stage["seconds"] for run in runs for stage in run["stages"] if stage["stage"] == "render")
    print(f"{len(pictures)} of {arguments.rooms} pictures, {arguments.size}, {arguments.quality}, {arguments.device}: {seconds:.1f} s, "
          f"of which Blender {blender:.1f} s")  # fmt: skip
    print(f"{seconds / max(blender, 0.001):.3f} times Blender's own time; {seconds / max(1, len(pictures)):.2f} s a room")
    tenth = len(memory.samples) // 10 + 1
    print(f"memory of Blender: at most {max(memory.samples):.0f} MB, {max(memory.samples[:tenth]):.0f} in the first tenth of the time, "
          f"{max(memory.samples[-tenth:]):.0f} in the last; {len(memory.blenders)} processes")  # fmt: skip
    return 0 if len(pictures) == arguments.rooms else 1


if __name__ == "__main__":
    sys.exit(main())
