#!/usr/bin/env python3
"""Answers a second of `layoutbox serve`: clients in a closed loop, each asking for a room of ten things as soon as it has the last one.

    python3 bench/service_bench.py [--binary build/release/src/layoutbox/layoutbox] [--seconds 10] [--clients 8] [--effort 1 10 100]

The service is one of its own, on this machine's loopback, and ends with the run. Where other work shares the machine the clock says little:
the processor time that the service takes for an answer is printed beside it.
"""

from __future__ import annotations

import argparse
import http.client
import json
import os
import statistics
import sys
import tempfile
import threading
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests/serve"))
ROOM = (
    "A bedroom of 5 by 4 m with a double bed against the back wall, two nightstands beside the bed, a lamp on each nightstand, a wardrobe, "
    "a desk under the window with a chair, a rug and a plant in the corner."
)


def processor_seconds(pid: int) -> float:
    fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def ask_on(port: int, bodies: list[bytes], until: float, times: list[float], faults: list[int]) -> None:
    """One client: a connection that is kept, a request after the other."""
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=60)
    number = 0
    while time.perf_counter() < until:
        began = time.perf_counter()
        connection.request("POST", "/api/generate", bodies[number % len(bodies)], {"Content-Type": "application/json"})
        answer = connection.getresponse()
        answer.read()
        times.append(time.perf_counter() - began)
        if answer.status != 200:
            faults.append(answer.status)
        number += 1
    connection.close()


def run(service, effort: int, clients: int, seconds: float) -> str:
    bodies = [json.dumps({"prompt": ROOM, "effort": effort, "seed": seed, "companions": False}).encode() for seed in range(1, 21)]
    times: list[float] = []
    faults: list[int] = []
    used, began = processor_seconds(service.process.pid), time.perf_counter()
    threads = [
        threading.Thread(target=ask_on, args=(service.port, bodies[k:] + bodies[:k], began + seconds, times, faults))
        for k in range(clients)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    took, used = time.perf_counter() - began, processor_seconds(service.process.pid) - used
    milliseconds = sorted(1000 * one for one in times)
    return (
        f"effort {effort:>4}, {clients} clients: {len(times) / took:7.1f} answers/s, median {statistics.median(milliseconds):6.1f} ms, "
        f"p95 {milliseconds[int(0.95 * len(milliseconds))]:6.1f} ms; processor {1000 * used / len(times):5.2f} ms an answer"
        f"{f'; {len(faults)} refused' if faults else ''}"
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--binary", type=Path, default=ROOT / "build/release/src/layoutbox/layoutbox")
    parser.add_argument("--seconds", type=float, default=10)
    parser.add_argument("--clients", type=int, default=8)
    parser.add_argument("--effort", type=int, nargs="+", default=[1, 10, 100])
    options = parser.parse_args()
    os.environ["LAYOUTBOX_BINARY"] = str(options.binary)
    from service import Service  # reads which program from the environment

    with tempfile.TemporaryDirectory() as folder:
        service = Service(folder)
        try:
            count = len(service.post("/api/generate", {"prompt": ROOM, "companions": False}).json()["layouts"][0]["objects"])
            print(f"{count} things; load of the machine {os.getloadavg()[0]:.1f}")
            for effort in options.effort:
                print(run(service, effort, min(options.clients, 64), min(options.seconds, 600)), flush=True)
        finally:
            service.stop()


if __name__ == "__main__":
    main()
