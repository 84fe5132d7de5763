#!/usr/bin/env python3
"""What the program itself takes between an answer of a model and the next question.

    python3 bench/llm_bench.py [--binary build/release/src/layoutbox/layoutbox] [--runs 10]

A server on this machine answers at once, with a scene of which one relation is wrong, so that the model is asked again. Runs of five
questions are compared with runs of one, by processor time, which other work on the machine does not lengthen: a further question takes
reading, mending, validating, comparing with the text, writing the question, and the way there and back. The first question of a process
comes later, by the time it takes to load libcurl; that is shown by itself.
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests/llm"))

from fault_server import FaultServer, call, completion, raw  # noqa: E402

NAMES = ["bed", "desk", "lamp", "wardrobe", "chair", "bookshelf", "rug", "plant", "mirror", "dresser"]
SCENE = {
    "metadata": {"roomType": "bedroom"},
    "room": {"dims": {"w": 6, "d": 5, "h": 2.6}},
    "furniture": [{"id": f"{name}_1", "category": name, "name": name} for name in NAMES],
    "constraints": [{"type": "againstWall", "targets": [f"{name}_1"], "relativeTo": ["wall3"]} for name in NAMES[:4]]
    + [{"type": "nextTo", "targets": ["ghost"], "relativeTo": ["bed_1"]}],
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--binary", type=Path, default=ROOT / "build/release/src/layoutbox/layoutbox")
    parser.add_argument("--runs", type=int, default=10)
    options = parser.parse_args()
    server_answers = raw(200, json.dumps(completion(call("create_scene", SCENE))))
    text = "A large bedroom with " + ", ".join(f"a {name}" for name in NAMES) + "."
    cpu: dict[int, list[float]] = {1: [], 5: []}
    first: list[float] = []
    with tempfile.TemporaryDirectory() as folder, FaultServer([server_answers]) as server:
        env = {**os.environ, "OPENAI_BASE_URL": server.url, "NO_PROXY": "127.0.0.1", "XDG_CACHE_HOME": folder}
        command = [str(options.binary), "plan", text, "--planner", "llm", "--no-cache", "--attempt-pause", "0", "-o", f"{folder}/s.json"]
        for _ in range(options.runs):
            for attempts, times in cpu.items():
                asked = len(server.requests)
                before, started = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
                subprocess.run(
                    [*command, "--max-attempts", str(attempts)], env=env, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False
                )
                after = resource.getrusage(resource.RUSAGE_CHILDREN)
                times.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
                first.append(server.requests[asked].arrived - started)
    each = (statistics.median(cpu[5]) - statistics.median(cpu[1])) / 4
    print(f"processor time of a further question and its answer: {each * 1000:.1f} ms")
    print(f"start to first question, by the clock: {statistics.median(first) * 1000:.0f} ms (least {min(first) * 1000:.0f})")


if __name__ == "__main__":
    main()
