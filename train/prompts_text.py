#!/usr/bin/env python3
"""Prints the room descriptions of this repository, one a line: train/texts/*.txt, the test sentences and the example prompts; and those in
files given as arguments: CSV with a column Description, JSON lines with `prompt`, or text."""

import csv
import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).parent.parent


def lines_of(path):
    if path.suffix == ".csv":
        with path.open(newline="", encoding="utf-8") as file:
            return [row["Description"] for row in csv.DictReader(file)]
    lines = [line for line in path.read_text(encoding="utf-8").splitlines() if line.strip() and not line.startswith("#")]
    if path.suffix == ".jsonl":
        return [prompt for line in lines if (prompt := json.loads(line).get("prompt"))]
    if path.name == "sentences_test.txt":
        return [line.split(" | ")[0] for line in lines]
    return lines


def main():
    paths = sorted((ROOT / "train" / "texts").glob("*.txt")) + [ROOT / "src/layoutbox/plan/offline/sentences_test.txt"]
    paths += sorted((ROOT / "examples" / "prompts").glob("*.jsonl")) + [pathlib.Path(name) for name in sys.argv[1:]]
    for path in paths:
        for line in lines_of(path):
            print(" ".join(line.split()))


if __name__ == "__main__":
    main()
