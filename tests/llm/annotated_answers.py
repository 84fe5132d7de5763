"""Answers of a model to an annotated prompt (columns ObjCount, OORel, OARel): the right one, and wrong ones (right_answers.py)."""

import copy
import json
import re
from collections import Counter

# Words of annotations as relations; a word that is not here makes no relation of the answer.
PAIRS = {
    **dict.fromkeys(["next", "next_to", "beside", "adjacent", "by", "side_by_side", "alongside"], "nextTo"),
    **dict.fromkeys(["near", "nearby", "close"], "near"),
    **dict.fromkeys(["on", "on_top", "top"], "on"),
    **dict.fromkeys(["within", "inside", "in"], "in"),
    **dict.fromkeys(["above", "over"], "above"),
    **dict.fromkeys(["under", "beneath", "below", "underneath"], "under"),
    **dict.fromkeys(["face", "facing"], "facing"),
    **dict.fromkeys(["foot", "at_foot", "at_the_foot"], "atFootOf"),
    **dict.fromkeys(["around", "surround"], "around"),
    "left": "leftOf",
    "right": "rightOf",
    "front": "inFrontOf",
    "behind": "behind",
    "far": "far",
}
PLACES = {
    ("against", "wall"): ("againstWall", None),
    ("along", "wall"): ("againstWall", None),
    ("on", "wall"): ("onWall", None),
    ("hang", "ceiling"): ("onCeiling", None),
    ("corner", "room"): ("corner", None),
    ("middle", "room"): ("centerOfRoom", None),
    ("center", "room"): ("centerOfRoom", None),
    ("next", "window"): ("nearWindow", "window1"),
    ("near", "window"): ("nearWindow", "window1"),
    ("by", "window"): ("nearWindow", "window1"),
    ("under", "window"): ("underWindow", "window1"),
    ("next", "door"): ("nearDoor", "door1"),
    ("near", "door"): ("nearDoor", "door1"),
    ("by", "door"): ("nearDoor", "door1"),
}
MOST_OF_A_KIND = 40


def entries(text):
    return [[part.strip() for part in entry.split(",")] for entry in (text or "").split(";") if entry.strip()]


def number_of(quantifier, count):
    return int(count) + (quantifier == "gt")


def snake(word):
    return re.sub(r"[^a-z0-9]+", "_", word.split(":")[0].strip().lower()).strip("_")


def pair_relations(row, ids):
    """OORel: so many times TARGETS relate to ANCHOR."""
    for quantifier, count, word, index, *names in entries(row["OORel"]):
        kind, names = PAIRS.get(word), [snake(name) for name in names]
        at = int(index) if 0 <= int(index) < len(names) else 0
        anchors, others = ids.get(names[at], []), names[:at] + names[at + 1 :]
        if kind is None or not anchors or not all(ids.get(name) for name in others):
            continue
        if len(others) > 1:  # a group about one thing
            targets = [target for name, many in Counter(others).items() for target in ids[name][:many] if target != anchors[0]]
            yield {"type": "around" if kind == "around" else kind, "targets": targets, "relativeTo": [anchors[0]]}
            continue
        targets = ids[others[0]]
        for number in range(min(number_of(quantifier, count), len(targets))):
            anchor = anchors[number * len(anchors) // min(number_of(quantifier, count), len(targets))]
            if targets[number] != anchor:
                yield {"type": "nextTo" if kind == "around" else kind, "targets": [targets[number]], "relativeTo": [anchor]}


def place_relations(row, ids):
    """OARel: so many things at a part of the room."""
    for quantifier, count, word, target, element in entries(row["OARel"]):
        place = snake(element)
        where = place if place in ("wall", "ceiling", "window", "door") else "room"
        kind, reference = PLACES.get((word, where), (None, None))
        if kind is None:
            continue
        for thing in ids.get(snake(target), [])[: number_of(quantifier, count)]:
            yield {"type": kind, "targets": [thing], **({"relativeTo": [reference]} if reference else {})}


def right_answer(row):
    """The annotated scene, as a model would hand it over."""
    ids, furniture = {}, []
    for quantifier, count, word in entries(row["ObjCount"]):
        name = snake(word)
        for _ in range(min(number_of(quantifier, count), MOST_OF_A_KIND)):
            thing = f"{name}_{len(ids.setdefault(name, [])) + 1}"
            ids[name].append(thing)
            furniture.append({"id": thing, "category": name, "name": name.replace("_", " ")})
    constraints, seen = [], set()
    for relation in [*pair_relations(row, ids), *place_relations(row, ids)]:
        key = json.dumps(relation)
        if key not in seen:
            seen.add(key)
            constraints.append({"id": f"m{len(constraints) + 1}", **relation})
    openings = [{"id": "door1", "type": "door"}, {"id": "window1", "type": "window"}]
    return {"metadata": {"roomType": "room"}, "room": {"openings": openings}, "furniture": furniture, "constraints": constraints}


def without(answer, gone):
    """The answer less some things and what is said of them."""
    less = copy.deepcopy(answer)
    less["furniture"] = [item for item in less["furniture"] if item["id"] not in gone]
    for relation in less["constraints"]:
        for key in ("targets", "relativeTo"):
            if key in relation:
                relation[key] = [name for name in relation[key] if name not in gone]
    less["constraints"] = [r for r in less["constraints"] if r["targets"] and r.get("relativeTo", ["any"])]
    return less


def kinds_of(row):
    """How many of each kind, where the annotation says exactly how many."""
    return [(snake(word), int(count)) for quantifier, count, word in entries(row["ObjCount"]) if quantifier == "eq"]


def forgotten(row):
    """Of each kind that there is one of, in turn by the prompt's number: the answer without it."""
    single = [name for name, count in kinds_of(row) if count == 1]
    if not single:
        return None
    return without(right_answer(row), {f"{single[sum(map(ord, row['ID'])) % len(single)]}_1"})


def too_few(row):
    several = [(name, count) for name, count in kinds_of(row) if 1 < count <= MOST_OF_A_KIND]
    if not several:
        return None
    name, count = several[sum(map(ord, row["ID"])) % len(several)]
    return without(right_answer(row), {f"{name}_{count}"})


def too_many(row):
    several = [(name, count) for name, count in kinds_of(row) if 1 < count <= MOST_OF_A_KIND]
    if not several:
        return None
    name, count = several[sum(map(ord, row["ID"])) % len(several)]
    answer = right_answer(row)
    answer["furniture"].append({"id": f"{name}_{count + 1}", "category": name, "name": name.replace("_", " ")})
    return answer
