#!/usr/bin/env python3
"""Divides files of trees: every tenth sentence to NAME_test.trees, the others to NAME_train.trees."""

import pathlib
import sys

for name in sys.argv[1:]:
    path = pathlib.Path(name)
    blocks = path.read_text(encoding="utf-8").strip().split("\n\n")
    for part, chosen in (("train", [b for i, b in enumerate(blocks) if i % 10]), ("test", blocks[::10])):
        path.with_name(f"{path.stem}_{part}.trees").write_text("\n\n".join(chosen) + "\n\n", encoding="utf-8")
