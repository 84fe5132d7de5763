#!/usr/bin/env python3
"""What descriptions should be read as, a line of JSON each, for reading_score (docs/reading-measured.md).

usage: reading_targets.py FILE… > targets.jsonl
FILE: annotated prompts (CSV with ID, Description, OORel, OARel) or generated descriptions (JSONL of fresh_rooms.py, whose relations are all
that there are). A line: {"id", "prompt", "exact", "wanted": [{"any": relation types, "subject", "object", "count", "both"}]}.
"""

import csv
import json
import pathlib
import sys

BESIDE = [
    "nextTo",
    "near",
    "touching",
    "leftOf",
    "rightOf",
    "eachSideOf",
    "atHeadOf",
    "inFrontOf",
    "behind",
    "around",
    "alongSide",
    "tuckedUnder",
]
BETWEEN = {
    "next": BESIDE,
    "near": BESIDE + ["atFootOf", "distance"],
    "around": ["around", "surround", "alongSide", "eachSideOf", "inFrontOf"],
    "left": ["leftOf", "eachSideOf", "between"],
    "right": ["rightOf", "eachSideOf", "between"],
    "behind": ["behind"],
    "front": ["inFrontOf", "atFootOf", "facing", "tuckedUnder", "opposite", "alongSide"],
    "foot": ["atFootOf"],
    "across": ["opposite"],
    "far": ["far"],
    "on": ["on", "in", "stacked"],
    "in": ["in", "on"],
    "facing": ["facing", "opposite", "around", "alongSide", "inFrontOf"],
    "above": ["above"],
    "under": ["under", "tuckedUnder"],
    "long_side": ["alongSide"],
    "short_side": ["alongSide"],
    "center": ["on", "centeredOn"],
}
ROOM = {
    "corner": ["corner"],
    "center": ["centerOfRoom"],
    "against": ["againstWall", "centeredOnWall", "underWindow", "sideAgainstWall"],
    "on": ["onWall"],
    "next": ["nextTo", "near", "underWindow", "leftOf", "rightOf", "inFrontOf"],
    "near": ["near", "nextTo", "underWindow", "inFrontOf"],
    "under": ["underWindow", "under"],
    "front": ["inFrontOf", "nextTo", "underWindow"],
    "across": ["opposite"],
    "facing": ["facing"],
}
SAME = {
    "next": "next_to beside adjacent side_by_side against lean_against leaning by alongside touching",
    "around": "surround surrounding",
    "near": "nearby close close_to",
    "across": "opposite",
    "left": "left_side left_region",
    "right": "right_side right_region",
    "behind": "back",
    "front": "in_front",
    "foot": "at_the_foot at_foot",
    "on": "on_top top atop top_region bottom_region mount mounted hang hang_on hang_from from suspend",
    "in": "within inside",
    "facing": "face face_to",
    "above": "over",
    "under": "beneath below underneath under_region",
    "center": "centre middle at_the_center at_the_middle in_the_middle",
    "against": "along leaning lean_against",
}
GENERATED = {
    "on": ["on", "in", "stacked"],
    "nextTo": ["nextTo", "near", "touching", "leftOf", "rightOf", "distance"],
    "leftOf": ["leftOf"],
    "rightOf": ["rightOf"],
    "behind": ["behind"],
    "inFrontOf": ["inFrontOf", "facing", "tuckedUnder", "nextTo"],
    "opposite": ["opposite", "facing", "distance"],
    "around": ["around", "surround", "eachSideOf", "inFrontOf", "alongSide"],
    "sides": ["eachSideOf", "leftOf", "rightOf"],
    "above": ["above"],
    "under": ["under", "on", "centeredOn"],
    "wall": ["againstWall", "centeredOnWall", "sideAgainstWall", "inRegion", "onWall"],
    "corner": ["corner"],
    "window": ["underWindow", "nearWindow", "inFrontOf", "nextTo", "under", "near"],
}
BOTH_WAYS = {"nextTo", "opposite", "under", "next", "near", "across", "far", "facing"}


def kind_of(word, table):
    word = word.strip().lower().replace(" ", "_").replace("-", "_")
    for end in ("_of", "_from", "_to", "_the"):
        word = word.removesuffix(end)
    # The table's own word first: "against" a wall is not "next" to it.
    return word if word in table else next((kind for kind, words in SAME.items() if kind in table and word in words.split()), None)


def annotated_relations(row):
    for entry in filter(None, (e.strip() for e in (row.get("OORel") or "").split(";"))):
        quantifier, count, word, anchor, *things = [part.strip() for part in entry.split(",")]
        kind = kind_of(word, BETWEEN)
        if kind is None or len(things) < 2 or (quantifier == "eq" and count == "0"):
            continue
        at = int(anchor)
        things = [thing.split(":")[0] for thing in things]
        subjects = [thing for i, thing in enumerate(things) if i != at]
        for subject in sorted(set(subjects)):  # a group ("chair:0, chair:1") once
            yield {"any": BETWEEN[kind], "subject": subject, "object": things[at], "count": int(count), "both": kind in BOTH_WAYS}
    for entry in filter(None, (e.strip() for e in (row.get("OARel") or "").split(";"))):
        quantifier, count, word, *things = [part.strip() for part in entry.split(",")]
        kind = kind_of(word, ROOM)
        # What hangs may be known to hang by its kind alone.
        if kind in (None, "on") or len(things) < 2 or (quantifier == "eq" and count == "0"):
            continue
        place = things[1].split(":")[0]
        place = place if place in ("window", "door") else ""
        types = [t for t in ROOM[kind] if place != "door" or t != "underWindow"]
        yield {"any": types, "subject": things[0], "object": place, "count": int(count), "both": False}


def generated_relations(description):
    for truth in description["relations"]:
        place = {"wall": truth["object"], "corner": "", "window": "window"}.get(truth["kind"], truth["object"])
        yield {
            "any": GENERATED[truth["kind"]],
            "subject": truth["subject"],
            "object": place,
            "count": 1,
            "both": truth["kind"] in BOTH_WAYS,
        }


def main():
    for path in map(pathlib.Path, sys.argv[1:]):
        text = path.read_text(encoding="utf-8")
        if path.suffix == ".csv":
            for row in csv.DictReader(text.splitlines(keepends=True)):
                wanted = list(annotated_relations(row))
                print(json.dumps({"id": row["ID"], "prompt": row["Description"], "exact": False, "wanted": wanted}))
        else:
            for description in map(json.loads, text.splitlines()):
                wanted = list(generated_relations(description))
                print(json.dumps({"id": description["id"], "prompt": description["prompt"], "exact": True, "wanted": wanted}))


if __name__ == "__main__":
    main()
