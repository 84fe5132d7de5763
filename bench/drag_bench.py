#!/usr/bin/env python3
"""A thing of fifty in the hand: from each request of `POST /api/drag` to its answer, as the studio asks while a hand moves.

    python3 bench/drag_bench.py [--binary build/release/src/layoutbox/layoutbox] [--objects 50] [--things 8] [--steps 40]

Rooms of tables with chairs around them and what stands along the walls; one thing after the other is drawn across the room in steps of
5 cm, the others giving way, over one connection, a request as soon as the last one is answered. The service is one of its own. Where other
work shares the machine the clock says little: the processor time that the service takes for an answer is printed beside it.
"""

from __future__ import annotations

import argparse
import http.client
import json
import math
import os
import sys
import tempfile
import time
from pathlib import Path

from service_bench import ROOT, processor_seconds

sys.path.insert(0, str(ROOT / "tests/serve"))


def prompt_for(objects: int) -> str:
    """A room of so many things: seven a table with its chairs, the rest along the walls."""
    tables = max(1, (objects - 2) // 7)
    rest = max(0, objects - 7 * tables)
    along = ", ".join(["a sideboard against the left wall", "a plant in the corner", *["a bookshelf against the right wall"] * 9][:rest])
    side = math.ceil(math.sqrt(tables)) * 3 + 3
    return f"A restaurant of {side} by {side} m with {tables} dining tables, six chairs around each table{', ' + along if along else ''}."


def places(layout: dict, thing: dict, steps: int) -> list[list[float]]:
    """From where it stands towards the middle of the room and beyond, 5 cm a step."""
    xs, ys = zip(*layout["room"]["polygon"])
    x, y = thing["pos"][:2]
    dx, dy = (min(xs) + max(xs)) / 2 - x, (min(ys) + max(ys)) / 2 - y
    length = math.hypot(dx, dy) or 1
    return [[round(x + 0.05 * k * dx / length, 3), round(y + 0.05 * k * dy / length, 3)] for k in range(1, steps + 1)]


def at(share: float, times: list[float]) -> float:
    return sorted(times)[min(len(times) - 1, int(share * len(times)))]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--binary", type=Path, default=ROOT / "build/release/src/layoutbox/layoutbox")
    parser.add_argument("--objects", type=int, default=50)
    parser.add_argument("--things", type=int, default=8)
    parser.add_argument("--steps", type=int, default=40)
    options = parser.parse_args()
    os.environ["LAYOUTBOX_BINARY"] = str(options.binary)
    from service import Service  # reads which program from the environment

    with tempfile.TemporaryDirectory() as folder:
        service = Service(folder)
        try:
            asked = {"prompt": prompt_for(options.objects), "companions": False}
            layout = service.post("/api/generate", asked).json()["layouts"][0]
            things = [thing for thing in layout["objects"] if thing["supportedBy"] == "floor"]
            things = things[:: max(1, len(things) // options.things)][: options.things]
            connection = http.client.HTTPConnection("127.0.0.1", service.port, timeout=60)
            legal: list[float] = []
            refused: list[float] = []
            used = processor_seconds(service.process.pid)
            for thing in things:
                for place in places(layout, thing, options.steps):
                    body = json.dumps({"layout": layout, "id": thing["id"], "pos": place, "snap": True, "locked": []}).encode()
                    began = time.perf_counter()
                    connection.request("POST", "/api/drag", body, {"Content-Type": "application/json"})
                    text = connection.getresponse().read()
                    took = 1000 * (time.perf_counter() - began)
                    (legal if json.loads(text)["legal"] else refused).append(took)
            used = processor_seconds(service.process.pid) - used
            each = 1000 * used / (len(legal) + len(refused))
            print(f"{len(layout['objects'])} things, load of the machine {os.getloadavg()[0]:.1f}; processor {each:.1f} ms an answer")
            for name, times in (("it can stand there", legal), ("it cannot", refused), ("all", legal + refused)):
                if times:
                    figures = f"p50 {at(0.5, times):5.1f} ms, p95 {at(0.95, times):5.1f} ms, most {max(times):5.1f} ms"
                    print(f"{name:>18}: {len(times):4} answers, {figures}")
        finally:
            service.stop()


if __name__ == "__main__":
    main()
