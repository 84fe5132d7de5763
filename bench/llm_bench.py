#!/usr/bin/env python3
"""What the program itself takes between an answer of a model and the next question.

    python3 bench/llm_bench.py [--binary build/release/src/layoutbox/layoutbox] [--runs 10]

A server on this machine answers at once, with a scene of which one relation is wrong. From the moment its answer is sent to the moment
the next question is whole, everything is ours: reading, mending, validating, comparing with the text, writing the question, and the way
there and back on the loopback. The first question of a process comes later, by the time it takes to load libcurl; that is shown by itself.
"""

from __future__ import annotations

import argparse
import json
import os
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
    sent: list[float] = []
    reply = raw(200, json.dumps(completion(call("create_scene", SCENE))))

    def behave(connection, request) -> bool:
        reply(connection, request)
        sent.append(time.monotonic())
        return True

    between, first = [], []
    text = "A large bedroom with " + ", ".join(f"a {name}" for name in NAMES) + "."
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(options.runs):
            sent.clear()
            with FaultServer([behave]) as server:
                env = {**os.environ, "OPENAI_BASE_URL": server.url, "NO_PROXY": "127.0.0.1", "XDG_CACHE_HOME": folder}
                command = [
                    str(options.binary),
                    "plan",
                    text,
                    "--planner",
                    "llm",
                    "--no-cache",
                    "--attempt-pause",
                    "0",
                    "-o",
                    f"{folder}/s.json",
                ]
                started = time.monotonic()
                subprocess.run(command, env=env, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
                first.append(server.requests[0].arrived - started)
                between += [request.arrived - at for request, at in zip(server.requests[1:], sent, strict=False)]
    print(f"{'':<28}{'median':>9}{'least':>9}{'most':>9}  ms")
    for name, values in (("answer to next question", between), ("start to first question", first)):
        print(f"{name:<28}" + "".join(f"{figure * 1000:>9.1f}" for figure in (statistics.median(values), min(values), max(values))))


if __name__ == "__main__":
    main()
