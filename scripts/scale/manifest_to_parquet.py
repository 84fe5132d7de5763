#!/usr/bin/env python3
"""The manifests of all shards of a folder as one Parquet table, a row a room: manifest_to_parquet.py ROOMS manifest.parquet

Needs pyarrow. What has members of its own (held, relaxed, checks, metrics, error) is kept as JSON text.
"""

import json
import sys
from pathlib import Path

import pyarrow
import pyarrow.parquet

SCHEMA = pyarrow.schema(
    [
        *((name, pyarrow.string()) for name in ("id", "key", "prompt", "state", "made", "hash", "shard")),
        *((name, pyarrow.int64()) for name in ("seed", "objects", "offset", "bytes")),
        ("stoppedByClock", pyarrow.bool_()),
        *((name, pyarrow.string()) for name in ("held", "relaxed", "checks", "metrics", "error")),
    ]
)


def cell(row: dict, field: pyarrow.Field) -> object:
    value = row.get(field.name)
    if field.name == "stoppedByClock":
        return bool(value)
    return json.dumps(value, ensure_ascii=False) if isinstance(value, dict | list) else value


def main(folder: str, target: str) -> int:
    with pyarrow.parquet.ParquetWriter(target, SCHEMA) as writer:
        for manifest in sorted(Path(folder).glob("shard-[0-9]*.jsonl")):
            if manifest.name.endswith(".times.jsonl"):
                continue
            rows = [json.loads(line) for line in manifest.read_text(encoding="utf-8").splitlines()]
            columns = [pyarrow.array([cell(row, field) for row in rows], field.type) for field in SCHEMA]
            writer.write_table(pyarrow.Table.from_arrays(columns, schema=SCHEMA))
    return 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
