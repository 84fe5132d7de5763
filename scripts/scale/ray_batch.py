#!/usr/bin/env python3
"""Many rooms on a Ray cluster: a shard a task, made by actors that Ray Data spreads over the nodes.

    ray_batch.py prompts.jsonl -o /shared/rooms --address auto

A task that is lost with its worker is made again by another. Needs ray[data].
"""

import sys

import ray
import shards


class ShardMaker:
    """An actor; one core each."""

    def __call__(self, row: dict) -> dict:
        shards.make_shard(list(row["command"]))
        return {"number": row["number"]}


def main() -> int:
    parser = shards.arguments(__doc__.splitlines()[0])
    parser.add_argument("--address", help="of the cluster: auto, or ray://HOST:PORT (default: a cluster of this machine alone)")
    parser.add_argument("--actors", type=int, help="how many at a time (default: one for each core of the cluster)")
    given = parser.parse_args()
    given.output.mkdir(parents=True, exist_ok=True)
    given.prompts, given.output = given.prompts.resolve(), given.output.resolve()
    here = str(shards.Path(__file__).resolve().parent)
    ray.init(address=given.address, runtime_env={"env_vars": {"PYTHONPATH": here}}, log_to_driver=False)
    count = shards.count_shards(given)
    actors = min(given.actors or int(ray.cluster_resources().get("CPU", 1)), count)
    context = ray.data.DataContext.get_current()
    context.enable_progress_bars = False
    context.max_errored_blocks = 0
    rows = [{"number": number, "command": shards.command(given, number, count)} for number in range(count)]
    tasks = ray.data.from_items(rows, override_num_blocks=count)
    tasks.map(ShardMaker, concurrency=actors, num_cpus=1, max_restarts=-1, max_task_retries=-1).materialize()
    return shards.report(given, count)


if __name__ == "__main__":
    sys.exit(main())
