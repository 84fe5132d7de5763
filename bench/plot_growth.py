#!/usr/bin/env python3
"""Draws how long the first legal layout takes by the number of objects, from the lines that solve_bench --json wrote.

python3 bench/plot_growth.py growth.jsonl docs/solver-growth.svg
"""

from __future__ import annotations

import json
import math
import sys
from pathlib import Path

WIDTH, HEIGHT, LEFT, BOTTOM, TOP, RIGHT = 760, 440, 70, 56, 24, 190
# By family of rooms and solver.
SERIES = {
    ("boxes", "ours"): ("#1b6ca8", "ours, boxes"),
    ("furnished", "ours"): ("#2e8b57", "ours, furnished rooms"),
    ("boxes", "paper"): ("#c0392b", "paper's model, boxes"),
    ("boxes", "paper-boxes"): ("#d98324", "the same, whole boxes"),
    ("boxes", "highs"): ("#6b4f9e", "the same, big M, HiGHS"),
}
OBJECTS = (5, 200)
MILLISECONDS = (0.05, 100_000)


def x_of(objects: float) -> float:
    """Place on the logarithmic axis of objects."""
    low, high = (math.log(value) for value in OBJECTS)
    return LEFT + (math.log(objects) - low) / (high - low) * (WIDTH - LEFT - RIGHT)


def y_of(milliseconds: float) -> float:
    """Place on the logarithmic axis of times."""
    low, high = (math.log(value) for value in MILLISECONDS)
    return HEIGHT - BOTTOM - (math.log(milliseconds) - low) / (high - low) * (HEIGHT - BOTTOM - TOP)


def label(milliseconds: float) -> str:
    """A time in words."""
    return f"{milliseconds:g} ms" if milliseconds < 1000 else f"{milliseconds / 1000:g} s"


def axes() -> list[str]:
    """Grid lines and their labels."""
    parts = []
    for objects in (5, 10, 20, 30, 50, 100, 200):
        x = x_of(objects)
        parts.append(f'<line x1="{x:.1f}" y1="{TOP}" x2="{x:.1f}" y2="{HEIGHT - BOTTOM}" stroke="#ddd"/>')
        parts.append(f'<text x="{x:.1f}" y="{HEIGHT - BOTTOM + 18}" text-anchor="middle">{objects}</text>')
    for power in range(-1, 6):
        y = y_of(10**power)
        parts.append(f'<line x1="{LEFT}" y1="{y:.1f}" x2="{WIDTH - RIGHT}" y2="{y:.1f}" stroke="#ddd"/>')
        parts.append(f'<text x="{LEFT - 8}" y="{y + 4:.1f}" text-anchor="end">{label(10**power)}</text>')
    middle = (LEFT + WIDTH - RIGHT) / 2
    parts.append(f'<text x="{middle:.0f}" y="{HEIGHT - 12}" text-anchor="middle">objects</text>')
    return parts


def most_rooms(rows: list[dict]) -> list[dict]:
    """Of several runs of one case the one with the most rooms."""
    best: dict[tuple[str, str, int], dict] = {}
    for row in rows:
        key = (row["what"], row["who"], row["objects"])
        if key not in best or row["asked"] > best[key]["asked"]:
            best[key] = row
    return list(best.values())


def main() -> None:
    """Reads the lines, writes the picture."""
    source, target = (Path(argument) for argument in sys.argv[1:3])
    rows = most_rooms([json.loads(line) for line in source.read_text(encoding="utf-8").splitlines()])
    parts = axes()
    for rank, (family, (colour, name)) in enumerate(SERIES.items()):
        series = sorted((row["objects"], row["median"], row["p99"]) for row in rows if (row["what"], row["who"]) == family)
        if not series:
            continue
        for column, dashes in ((1, ""), (2, ' stroke-dasharray="5 4"')):
            points = " ".join(f"{x_of(row[0]):.1f},{y_of(max(row[column], MILLISECONDS[0])):.1f}" for row in series)
            parts.append(f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="2"{dashes}/>')
        for row in series:
            parts.append(f'<circle cx="{x_of(row[0]):.1f}" cy="{y_of(max(row[1], MILLISECONDS[0])):.1f}" r="3" fill="{colour}"/>')
        y = TOP + 16 + 22 * rank
        parts.append(
            f'<line x1="{WIDTH - RIGHT + 12}" y1="{y - 4}" x2="{WIDTH - RIGHT + 34}" y2="{y - 4}" stroke="{colour}" stroke-width="2"/>'
        )
        parts.append(f'<text x="{WIDTH - RIGHT + 40}" y="{y}">{name}</text>')
    parts.append(f'<text x="{WIDTH - RIGHT + 12}" y="{TOP + 16 + 22 * len(SERIES)}">dashed: 99th percentile</text>')
    body = "\n".join(parts)
    target.write_text(
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="12">\n'
        f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>\n{body}\n</svg>\n',
        encoding="utf-8",
    )


if __name__ == "__main__":
    main()
