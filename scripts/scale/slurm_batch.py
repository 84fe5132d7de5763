#!/usr/bin/env python3
"""Many rooms as a Slurm array: a shard a job, by submitit.

    slurm_batch.py prompts.jsonl -o /shared/rooms --jobs 200 --partition cpu

Run again after a failure, it makes what is missing: shards that are there are kept. Needs submitit.
"""

import sys

import cloudpickle
import shards
import submitit


def main() -> int:
    parser = shards.arguments(__doc__.splitlines()[0])
    parser.add_argument("--jobs", type=int, default=100, help="jobs at a time (default: 100)")
    parser.add_argument("--partition", help="Slurm's partition")
    parser.add_argument("--minutes", type=int, default=60, help="time limit of a job (default: 60)")
    parser.add_argument("--local", action="store_true", help="on this machine, without Slurm")
    given = parser.parse_args()
    given.output.mkdir(parents=True, exist_ok=True)
    given.prompts, given.output = given.prompts.resolve(), given.output.resolve()
    cloudpickle.register_pickle_by_value(shards)  # a job knows nothing of this folder
    logs = given.output / ".submitit"
    executor = submitit.AutoExecutor(folder=logs, cluster="local" if given.local else None)
    executor.update_parameters(timeout_min=given.minutes, cpus_per_task=1)
    if not given.local:
        executor.update_parameters(slurm_array_parallelism=given.jobs, slurm_partition=given.partition, slurm_mem="1GB")
    count = shards.count_shards(given)
    missing = [number for number in range(count) if not (given.output / f"shard-{number:06}.jsonl").exists()]
    lines = [shards.command(given, number, count) for number in missing]
    width = given.jobs if given.local else max(len(lines), 1)
    for begin in range(0, len(lines), width):  # submitit's local executor starts all at once
        for job in executor.map_array(shards.make_shard, lines[begin : begin + width]):
            error = job.exception()
            if error:
                print(error, file=sys.stderr)
    return shards.report(given, count)


if __name__ == "__main__":
    sys.exit(main())
