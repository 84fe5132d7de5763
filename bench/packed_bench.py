#!/usr/bin/env python3
"""Many rooms packed into shards: rooms a second, processor time a room, and memory as the run goes on.

    python3 bench/packed_bench.py [--rooms 20000] [--jobs 2] [--binary A --binary B] [--rounds 1] [--prompts-only FILE]

Seven kinds of room, three to eight pieces of furniture each, the same for everybody. Several binaries take turns over the same rooms, so
that a slow moment of the machine hits all alike; --rounds repeats that. Memory is read once a second, and reported at the rooms that
--at names.
"""

from __future__ import annotations

import argparse
import json
import os
import random
import re
import statistics
import subprocess
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
ROOMS = {
    "bedroom": (
        "a double bed",
        "two nightstands",
        "a wardrobe",
        "a dresser",
        "a desk",
        "a desk chair",
        "an armchair",
        "a floor lamp",
        "a rug",
    ),
    "living room": ("a sofa", "a coffee table", "a TV stand", "two armchairs", "a bookshelf", "a floor lamp", "a side table", "a plant"),
    "study": ("a desk", "an office chair", "a bookshelf", "a filing cabinet", "an armchair", "a floor lamp", "a plant", "a side table"),
    "dining room": ("a dining table", "six dining chairs", "a sideboard", "a cabinet", "a plant", "a floor lamp", "a rug"),
    "kitchen": ("a fridge", "a stove", "a sink", "a dining table", "four chairs", "a cabinet", "a shelf", "a plant"),
    "bathroom": ("a bathtub", "a toilet", "a washbasin", "a shower", "a cabinet", "a laundry basket", "a stool", "a shelf"),
    "office": ("two desks", "two office chairs", "a filing cabinet", "a bookshelf", "a printer", "a plant", "a meeting table", "a sofa"),
}
PLACES = ("against the back wall", "in a corner", "against the left wall", "by the window", "")


def pieces(thing: str) -> int:
    """How many pieces of furniture a phrase names."""
    return {"two": 2, "four": 4, "six": 6}.get(thing.split()[0], 1)


def prompts(count: int) -> list[str]:
    """Lines of a batch file, each with a seed of its own."""
    lines = []
    for number in range(count):
        dice = random.Random(number)
        kind = list(ROOMS)[number % len(ROOMS)]
        most = dice.randint(3, 8)
        things: list[str] = []
        for thing in dice.sample(ROOMS[kind], len(ROOMS[kind])):
            if sum(map(pieces, [*things, thing])) <= most:
                things.append(thing)
        things[0] = f"{things[0]} {dice.choice(PLACES)}".strip()
        named = " and ".join(filter(None, (", ".join(things[:-1]), things[-1])))
        text = f"A {kind} with {named}.".replace("A office", "An office")
        lines.append(json.dumps({"id": f"room-{number:06}", "prompt": text, "seed": number + 1}))
    return lines


def resident(pid: int) -> float:
    """Resident memory in MB."""
    try:
        return int(re.search(r"VmRSS:\s+(\d+)", Path(f"/proc/{pid}/status").read_text(encoding="ascii"))[1]) / 1024
    except (OSError, TypeError):
        return 0.0


def run(binary: Path, file: Path, folder: Path, options: argparse.Namespace) -> dict:
    """One whole batch, watched."""
    command = [str(binary), "batch", str(file), "-o", str(folder), "--pack", "webdataset", "--shard-size", str(options.shard_size)]
    began, before = time.perf_counter(), os.times()
    seen: list[tuple[int, float]] = []
    with subprocess.Popen([*command, "-j", str(options.jobs), "-q"], stdout=subprocess.DEVNULL) as process:
        while process.poll() is None:
            made = sum(path.read_bytes().count(b"\n") for path in folder.glob("shard-*.times.jsonl"))
            seen.append((made, resident(process.pid)))
            time.sleep(options.every)
    after = os.times()
    processor = after.children_user + after.children_system - before.children_user - before.children_system
    return {"seconds": time.perf_counter() - began, "processor": processor, "memory": seen, "status": process.returncode}


def memory_in_words(seen: list[tuple[int, float]], at: list[int]) -> str:
    """Resident memory when so many rooms were finished, and the most."""
    parts = []
    for rooms in at:
        later = [size for made, size in seen if made >= rooms and size > 0]
        if later:
            parts.append(f"{later[0]:.0f} MB at {rooms}")
    return "; ".join([*parts, f"at most {max(size for _, size in seen):.0f} MB"])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--binary", type=Path, action="append")
    parser.add_argument("--rooms", type=int, default=2000)
    parser.add_argument("--rounds", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--shard-size", type=int, default=1000)
    parser.add_argument("--every", type=float, default=1.0, help="seconds between looks at the memory")
    parser.add_argument("--at", type=int, action="append", help="rooms at which to say what memory is used")
    parser.add_argument("--keep", type=Path, help="a folder for the shards (one binary, one round)")
    parser.add_argument("--prompts-only", type=Path, help="write the batch file and stop")
    options = parser.parse_args()
    lines = "\n".join(prompts(options.rooms)) + "\n"
    if options.prompts_only:
        options.prompts_only.write_text(lines, encoding="utf-8")
        return
    binaries = options.binary or [ROOT / "build/release/src/layoutbox/layoutbox"]
    spent: dict[Path, list[float]] = {binary: [] for binary in binaries}
    for _ in range(options.rounds):
        for binary in binaries:
            with tempfile.TemporaryDirectory() as scratch:
                file = Path(scratch) / "prompts.jsonl"
                file.write_text(lines, encoding="utf-8")
                one = run(binary, file, options.keep or Path(scratch) / "rooms", options)
            spent[binary].append(1000 * one["processor"] / options.rooms)
            rate = options.rooms / one["seconds"]
            memory = memory_in_words(one["memory"], options.at or [])
            spent_words = f"{rate:.1f} rooms a second by the clock, {spent[binary][-1]:.2f} ms of processor a room"
            print(f"{binary}: {spent_words}, {memory}, status {one['status']}", flush=True)
    for binary, values in spent.items():
        print(f"{binary}: {statistics.median(values):.2f} ms of processor a room (median of {len(values)}, least {min(values):.2f})")


if __name__ == "__main__":
    main()
