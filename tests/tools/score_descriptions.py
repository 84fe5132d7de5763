#!/usr/bin/env python3
"""How much of generated descriptions the planner understands: precision and recall of things and relations, by manner of writing.

usage: score_descriptions.py LAYOUTBOX DESCRIPTIONS.jsonl [--misses FILE] [--least PERCENT]
DESCRIPTIONS is what train/fresh_rooms.py writes: prompts with the scenes that they were made from. Each is planned with `layoutbox plan`;
nothing is solved. --least: exit status 1 if precision or recall of the relations is below.
"""

import argparse
import collections
import json
import pathlib
import subprocess
import sys
import tempfile

# Relations that say what the text says; the first is the usual one.
ACCEPTED = {
    "on": {"on", "in", "stacked"},
    "nextTo": {"nextTo", "near", "touching", "leftOf", "rightOf", "distance"},
    "leftOf": {"leftOf"},
    "rightOf": {"rightOf"},
    "behind": {"behind"},
    "inFrontOf": {"inFrontOf", "facing", "tuckedUnder", "nextTo"},
    "opposite": {"opposite", "facing", "distance"},
    "around": {"around", "surround", "eachSideOf", "inFrontOf", "alongSide"},
    "sides": {"eachSideOf", "leftOf", "rightOf"},
    "above": {"above"},
    "under": {"under", "on", "centeredOn"},
    "wall": {"againstWall", "centeredOnWall", "sideAgainstWall", "inRegion", "onWall"},
    "corner": {"corner"},
    "window": {"underWindow", "nearWindow", "inFrontOf", "nextTo", "under", "near"},
}
BOTH_WAYS = {"nextTo", "opposite", "under"}
WALLS = {"left": "wall4", "right": "wall2", "back": "wall3", "front": "wall1"}
# What says how a group stands in itself, or how a thing is held: neither right nor wrong here.
ASIDE = {
    "row",
    "grid",
    "column",
    "sameOrientation",
    "onWall",
    "onCeiling",
    "pairedWith",
    "parallel",
    "evenlySpaced",
    "facing",
    "distance",
    "align",
}


def plan(program, prompt, folder):
    path = folder / "scene.json"
    path.unlink(missing_ok=True)
    subprocess.run([program, "plan", prompt, "-o", str(path)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    return json.loads(path.read_text()) if path.exists() else {"furniture": [], "constraints": []}


def asked(entry):
    return not entry.get("assumed") and entry.get("origin", "asked") == "asked"


def name_of(piece, names):
    """The thing of the truth that a piece of furniture is, by its name, its category or the end of its name; else its own name."""
    own = [piece.get("name", "").lower(), piece["category"].replace("_", " ").lower()]
    for word in own:
        if word in names:
            return word
    ends = [name for name in names if any(word.endswith(" " + name) or name.endswith(" " + word) for word in own if word)]
    return max(ends, key=len) if ends else own[0]


def references(constraint, names, pieces):
    others = constraint.get("relativeTo", [])
    others = [others] if isinstance(others, str) else others
    return [names[other] if other in pieces else other for other in others]


class Tally(collections.Counter):
    def rate(self, right, all_):
        return 100.0 * self[right] / self[all_] if self[all_] else 100.0


def holds(truth, type_, subject, others, room):
    if type_ not in ACCEPTED[truth["kind"]]:
        return False
    if truth["kind"] == "wall":
        return subject == truth["subject"] and (WALLS[truth["object"]] in others or type_ == "inRegion")
    if truth["kind"] == "corner":
        return subject == truth["subject"]
    if truth["kind"] == "window":
        return subject == truth["subject"] and (not others or any(other in room["windows"] or "window" in other for other in others))
    if subject == truth["subject"] and truth["object"] in others:
        return True
    return truth["kind"] in BOTH_WAYS and subject == truth["object"] and truth["subject"] in others


def score(description, scene, tally, misses):
    objects = description["objects"]
    pieces = {piece["id"]: piece for piece in scene["furniture"]}
    names = {id_: name_of(piece, objects) for id_, piece in pieces.items()}
    found = collections.Counter(names[id_] for id_, piece in pieces.items() if asked(piece))
    for name, count in objects.items():
        tally["things"] += count
        tally["things found"] += min(count, found[name])
        if found[name] != count:
            misses.append(f"{description['id']}: {count} {name}, found {found[name]}")
    tally["things made"] += sum(found.values())
    tally["things right"] += sum(min(count, objects.get(name, 0)) for name, count in found.items())
    openings = scene.get("room", {}).get("openings") or []
    room = {"windows": {opening["id"] for opening in openings if opening.get("type") == "window"}}
    made = [
        (c["type"], target, names.get(target, target), references(c, names, pieces), c)
        for c in scene["constraints"]
        for target in c["targets"]
    ]
    for truth in description["relations"]:
        tally["relations"] += 1
        fits = [entry for entry in made if holds(truth, entry[0], entry[2], entry[3], room)]
        members = {entry[1] for entry in fits if entry[2] == truth["subject"]}
        met = (
            len(members) >= objects[truth["subject"]]
            or (len(members) >= 1 and truth["kind"] in BOTH_WAYS)
            or any(entry[2] == truth["object"] for entry in fits)
        )
        tally["relations found"] += met
        if not met:
            misses.append(
                f"{description['id']}: {truth['subject']} {truth['kind']} {truth['object']}" + ("" if truth["said"] else " (follows)")
            )
    for type_, _, subject, others, constraint in made:
        if not asked(constraint) or type_ in ASIDE:
            continue
        tally["relations made"] += 1
        right = any(holds(truth, type_, subject, others, room) for truth in description["relations"])
        tally["relations right"] += right
        if not right:
            misses.append(f"{description['id']}: wrong: {subject} {type_} {', '.join(others)} ({constraint.get('why', '')})")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("descriptions", type=pathlib.Path)
    parser.add_argument("--misses", type=pathlib.Path)
    parser.add_argument("--least", type=float, default=0)
    options = parser.parse_args()
    tallies, lines = collections.defaultdict(Tally), []
    with tempfile.TemporaryDirectory() as folder:
        for line in options.descriptions.read_text().splitlines():
            description = json.loads(line)
            misses = []
            one = Tally()
            score(description, plan(options.program, description["prompt"], pathlib.Path(folder)), one, misses)
            tallies[description["style"]].update(one)
            tallies["all"].update(one)
            if misses:
                lines += [description["prompt"], *(f"    {miss}" for miss in misses)]
    if options.misses:
        options.misses.write_text("\n".join(lines) + "\n")
    for style in [*sorted(set(tallies) - {"all"}), "all"]:
        tally = tallies[style]
        rates = [f"{style:14}"]
        for what in ("things", "relations"):
            recall, precision = tally.rate(f"{what} found", what), tally.rate(f"{what} right", f"{what} made")
            rates.append(f"{what}: recall {recall:5.1f} precision {precision:5.1f}")
        print("   ".join(rates))
    total = tallies["all"]
    return min(total.rate("relations found", "relations"), total.rate("relations right", "relations made")) < options.least


if __name__ == "__main__":
    sys.exit(main())
