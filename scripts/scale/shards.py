"""What the scripts of this folder share: how many shards a file of prompts has, and the making of one of them.

A shard depends on the prompts, their order, the options and the version alone, and appears whole or not at all. So the one unit of work is
"shard k of n": whoever makes it, and how often, the bytes are the same.
"""

from __future__ import annotations

import subprocess
import sys
from argparse import ArgumentParser, Namespace
from pathlib import Path


def arguments(description: str) -> ArgumentParser:
    parser = ArgumentParser(description=description)
    parser.add_argument("prompts", type=Path, help="lines of JSON, as `layoutbox batch` reads them; every machine must see the file")
    parser.add_argument("-o", "--output", type=Path, required=True, help="folder that every machine sees")
    parser.add_argument("--shard-size", type=int, default=1000, help="rooms in a shard (default: 1000)")
    parser.add_argument("--layoutbox", default="layoutbox", help="the program, if it is not on the PATH")
    parser.add_argument("--option", action="append", default=[], help="one more argument of `layoutbox batch`, as --option=--seed=7")
    return parser


def count_shards(given: Namespace) -> int:
    with given.prompts.open("rb") as lines:
        rooms = sum(1 for line in lines if line.strip())
    return -(-rooms // given.shard_size)


def command(given: Namespace, number: int, count: int) -> list[str]:
    """The command that makes shard `number` (from 0) of `count`."""
    share = f"{number + 1}/{count}"
    fixed = ["-o", str(given.output), "--pack", "webdataset", "--shard-size", str(given.shard_size), "--shard", share, "-q", "-j", "1"]
    return [given.layoutbox, "batch", str(given.prompts), *fixed, *given.option]


def make_shard(line: list[str]) -> None:
    """Runs it. Rooms that are not as asked, or that failed, stand in the manifest and are no error (exit status 1)."""
    done = subprocess.run(line, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):
        raise RuntimeError(f"{' '.join(line)}: exit status {done.returncode}\n{done.stderr[-2000:]}")


def report(given: Namespace, count: int) -> int:
    missing = [number for number in range(count) if not (given.output / f"shard-{number:06}.jsonl").exists()]
    print(f"{count - len(missing)} of {count} shards in {given.output}")
    for number in missing:
        print(f"  missing: shard-{number:06}", file=sys.stderr)
    return 1 if missing else 0
