#!/usr/bin/env python3
"""Check the catalogue of furniture: catalog/*.json files that hold "entries" or "rooms".

    check_catalog.py [CATALOG_FOLDER]

Prints one line for each fault and ends with status 1 if there is any. docs/catalog.md says what an entry means.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from pathlib import Path

from catalog_formulas import Size, evaluate, is_linear
from catalog_words import check_like, check_uses, check_words

MOUNTS = {"floor", "wall", "ceiling", "surface", "hung"}
SIDES = {"front", "back", "left", "right"}
KEYS = {
    "id", "name", "synonyms", "kindOf", "traits", "size", "variants", "mount", "usedSides", "hasFront", "backToWall", "thin",
    "lainOn", "topCarries", "clearance", "hangHeight", "spaces", "standsOn", "faces", "beside", "rooms", "shape", "source",
}  # fmt: skip
THIN = 0.03  # m, rugs and mats up to this height collide with nothing
ROOM_SHARE = 0.6  # of a room's floor that its usual furniture may cover
NEIGHBOUR = 5  # how many times larger or smaller a kind may be than the range of what it is a kind of
SLACK = 1e-9  # m


def three(length: float | list[float]) -> list[float]:
    """[least, usual, greatest] of a length."""
    return length if isinstance(length, list) else [length] * 3


def sizes_of(entry: dict) -> Iterator[tuple[str, Size]]:
    """Every size at which the entry's spaces must be right: least, usual and greatest, of itself and of each variant."""
    for words, size in [("", entry["size"])] + [(variant["words"][0], variant["size"]) for variant in entry.get("variants", [])]:
        whole = {side: three(length) for side, length in (entry["size"] | size).items()}
        for k, which in enumerate(("least", "usual", "greatest")):
            yield f"{which} {words}".strip(), {side: lengths[k] for side, lengths in whole.items()}


def check_size(size: dict, what: str) -> Iterator[str]:
    for side, length in size.items():
        lengths = three(length)
        if side not in ("w", "d", "h") or len(lengths) != 3 or not 0 < lengths[0] <= lengths[1] <= lengths[2] <= 20:
            yield f"{what} {side}: expected 0 < least ≤ usual ≤ greatest ≤ 20 metres, found {length}"


def check_space(space: dict, at: str, size: Size) -> Iterator[str]:
    for i in range(space.get("repeat", 1)):
        values = size | {"i": float(i)}
        low, high = ([evaluate(formula, values) for formula in space[corner]] for corner in ("min", "max"))
        box_low, box_high = [-size["w"] / 2, -size["d"] / 2, 0], [size["w"] / 2, size["d"] / 2, size["h"]]
        for axis, a, b, least, most in zip("xyz", low, high, box_low, box_high):
            if not least - SLACK <= a < b <= most + SLACK:
                yield f"space '{space['name']}' {i}, {at} size: {axis} from {a:.3f} to {b:.3f} must lie within {least:.3f} to {most:.3f}"


def check_spaces(entry: dict) -> Iterator[str]:
    of_variants = [space for variant in entry.get("variants", []) for space in variant.get("spaces", [])]
    for space in [*entry.get("spaces", []), *of_variants]:
        try:
            if not all(is_linear(formula) for corner in ("min", "max") for formula in space[corner]):
                yield f"space '{space['name']}': a formula is not linear"
                continue
            for at, size in sizes_of(entry):
                yield from check_space(space, at, size)
        except (ValueError, ZeroDivisionError) as error:
            yield f"space '{space['name']}': {error}"
        if "repeat" in space and "{i}" not in space["name"]:
            yield f"space '{space['name']}' is repeated and needs {{i}} in its name"


def check_supports(entry: dict, ids: dict[str, dict]) -> Iterator[str]:
    """What usually stands on something is smaller than that, in one of the two ways it can lie there."""
    if entry.get("mount") != "surface":
        return
    width, depth = sorted(three(entry["size"][side])[0] for side in "wd")
    for host in (ids[other] for other in entry.get("standsOn", []) if other in ids):
        host_width, host_depth = sorted(three(host["size"][side])[2] for side in "wd")
        if width > host_width + SLACK or depth > host_depth + SLACK:
            yield f"standsOn: the smallest {entry['name']} ({width} × {depth} m) is larger than the largest {host['name']}"
        if not host.get("topCarries") and not any(space.get("carries", True) for space in host.get("spaces", [])):
            yield f"standsOn: {host['name']} carries nothing, on its top or in a space"


def check_neighbours(entry: dict, ids: dict[str, dict]) -> Iterator[str]:
    """A kind is of the same order of size as what it is a kind of, where both stand or hang alike."""
    parent = ids.get(entry.get("kindOf", ""))
    if parent is None or parent.get("mount", "floor") != entry.get("mount", "floor"):
        return

    def sides(thing: dict) -> list[list[float]]:
        return [*sorted((three(thing["size"][side]) for side in "wd"), key=lambda lengths: lengths[1]), three(thing["size"]["h"])]

    for name, own, others in zip(("short side", "long side", "height"), sides(entry), sides(parent)):
        if not others[0] / NEIGHBOUR <= own[1] <= others[2] * NEIGHBOUR:
            yield f"{name} of usually {own[1]} m is far from that of {parent['name']} ({others[0]} to {others[2]} m)"


def check_shape_words(shape: dict, families: dict[str, dict], common: dict[str, dict]) -> Iterator[str]:
    """Words that its family knows, or all do, with values of theirs."""
    known = common | families.get(shape["family"], {}).get("words", {})
    for word, value in shape.get("words", {}).items():
        if word not in known:
            yield f"shapes of the family '{shape['family']}' have no word '{word}'"
        elif value not in known[word].get("values", [value]):
            yield f"{word} is '{value}', none of {', '.join(known[word]['values'])}"


def check_entry(entry: dict, ids: dict[str, dict], rooms: set[str], families: dict[str, dict], words: dict[str, dict]) -> Iterator[str]:
    """Faults of one entry by itself and of the ids that it names."""
    for key in entry.keys() - KEYS:
        yield f"unknown member '{key}'"
    if set(entry["size"]) != {"w", "d", "h"}:
        yield "size: expected w, d and h"
    yield from check_size(entry["size"], "size")
    for variant in entry.get("variants", []):
        yield from check_size(variant["size"], f"variant '{variant['words'][0]}'")
    if entry.get("mount", "floor") not in MOUNTS:
        yield f"mount '{entry['mount']}' is none of {', '.join(sorted(MOUNTS))}"
    for key in ("usedSides", "clearance"):
        if not set(entry.get(key, [])) <= SIDES:
            yield f"{key}: sides are front, back, left, right"
    if families and entry["shape"].get("family") not in families:
        yield f"shape family '{entry['shape'].get('family')}' is unknown: it has no row in catalog/shapes.json"
    elif families:
        yield from check_shape_words(entry["shape"], families, words)
    if entry.get("thin") and three(entry["size"]["h"])[2] > THIN:
        yield f"thin, but up to {three(entry['size']['h'])[2]} m high"
    for key in ("standsOn", "faces", "beside"):
        if len(set(entry.get(key, []))) < len(entry.get(key, [])):
            yield f"{key} names something twice"
        for other in entry.get(key, []):
            if other not in ids:
                yield f"{key}: there is no entry '{other}'"
    for room in entry.get("rooms", []):
        if room not in rooms:
            yield f"rooms: there is no room '{room}'"
    if entry.get("mount") in ("surface", "hung") and not entry.get("standsOn"):
        yield f"mount {entry['mount']}, but standsOn is empty"
    if not entry.get("source"):
        yield "no source"
    yield from check_spaces(entry)
    yield from check_supports(entry, ids)
    yield from check_neighbours(entry, ids)


def check_ancestors(entry: dict, ids: dict[str, dict]) -> Iterator[str]:
    seen, at = {entry["id"]}, entry.get("kindOf")
    while at:
        if at not in ids:
            yield f"kindOf: there is no entry '{at}'"
            return
        if at in seen:
            yield f"kindOf goes round in a circle at '{at}'"
            return
        seen.add(at)
        at = ids[at].get("kindOf")


def check_rooms(rooms: list[dict], ids: dict[str, dict]) -> Iterator[str]:
    for room in rooms:
        for entry, count in room["usual"]:
            if entry not in ids or count < 1:
                yield f"room {room['id']}: '{entry}' × {count} is no entry and count"
        if set(room["size"]) != {"w", "d", "h"} or min(room["size"].values()) <= 0:
            yield f"room {room['id']}: size must have w, d and h above 0"
            continue
        floor = [(ids[entry]["size"], count) for entry, count in room["usual"] if entry in ids and stands_on_floor(ids[entry])]
        share = sum(three(size["w"])[1] * three(size["d"])[1] * count for size, count in floor) / (room["size"]["w"] * room["size"]["d"])
        if share > ROOM_SHARE:
            yield f"room {room['id']}: its usual furniture covers {share:.0%} of the floor"


def stands_on_floor(entry: dict) -> bool:
    return entry.get("mount", "floor") == "floor" and not entry.get("thin")


SOLIDS = {
    "box": 6, "rounded": 7, "cushion": 7, "ball": 6, "can": 5, "cone": 6, "rod": 7, "beam": 8, "tube": 7, "ring": 5, "turned": 8, "oval": 9,
    "prism": 8, "prism_x": 8, "prism_y": 8, "waves": 7, "light": 4,
}  # fmt: skip


def check_model_line(line: str, surfaces: set[str]) -> Iterator[str]:
    """One solid of a model (docs/furnish.md)."""
    words = line.split()
    count = int(words.pop(0)[:-1]) if words[0].endswith("*") else 1
    solid, surface, *rest = words
    numbers = [word for word in rest if not word.startswith("/")]
    if len(numbers) < SOLIDS.get(solid, 10**6):
        yield f"'{line}' is no solid with all its numbers"
    if surface.split(":")[-1].split("#")[0] not in surfaces:
        yield f"'{line}' is of no known surface"
    for number in numbers:
        for i in {0, count - 1}:
            evaluate(number, {"w": 1.0, "d": 1.0, "h": 1.0, "i": float(i)})


def check_models(folder: Path, entries: list[dict]) -> Iterator[str]:
    """Shapes that are written down: each is named by an entry, and each of their lines can be drawn."""
    if not (folder / "models.json").exists():
        return
    models = json.loads((folder / "models.json").read_text(encoding="utf-8"))["models"]
    surfaces = {surface["name"] for surface in json.loads((folder / "materials.json").read_text(encoding="utf-8"))["surfaces"]}
    named = {entry["shape"].get("words", {}).get("model"): entry["id"] for entry in entries if entry["shape"]["family"] == "modeled"}
    for name, owner in named.items():
        if name not in models:
            yield f"{owner}: there is no model '{name}'"
    for name, lines in models.items():
        if name not in named:
            yield f"model {name}: no entry names it"
        for line in lines:
            try:
                yield from (f"model {name}: {fault}" for fault in check_model_line(line, surfaces))
            except (ValueError, SyntaxError, ZeroDivisionError) as error:
                yield f"model {name}: '{line}': {error}"


def check_groups(folder: Path, ids: dict[str, dict]) -> Iterator[str]:
    """What hangs over what, what rugs lie under and what stands by doors are kinds that there are."""
    path = folder / "groups.json"
    if not path.exists():
        return
    groups = json.loads(path.read_text(encoding="utf-8"))
    rows = groups.get("hangs", []) + groups.get("lies", [])
    named = [kind for row in rows for kind in [row["is"], *row["over"]]] + groups.get("by_door", [])
    named += [kind for row in groups.get("contents", []) for kinds in [*row["has"], row.get("without", [])] for kind in kinds]
    yield from (f"groups.json: there is no entry '{kind}'" for kind in named if kind not in ids)
    yield from (f"groups.json: mount '{row['mount']}'" for row in rows if row.get("mount", "wall") not in MOUNTS)


def check(folder: Path) -> tuple[list[str], int]:
    """All faults of the catalogue in a folder, and the number of its entries."""
    entries, rooms, families, words = [], [], {}, {}
    for path in sorted(folder.glob("*.json")):
        data = json.loads(path.read_text(encoding="utf-8"))
        if isinstance(data, dict):
            entries += data.get("entries", [])
            rooms += data.get("rooms", [])
            families |= data.get("families", {})
            words |= data.get("words", {}) if "families" in data else {}
    ids = {entry["id"]: entry for entry in entries}
    room_ids = {room["id"] for room in rooms}
    faults = list(check_like(folder, ids)) + list(check_words(entries)) + list(check_words(rooms)) + list(check_rooms(rooms, ids))
    faults += [*check_models(folder, entries), *check_uses(folder, ids, room_ids), *check_groups(folder, ids)]
    for entry in entries:
        own = [*check_entry(entry, ids, room_ids, families, words), *check_ancestors(entry, ids)]
        faults += [f"{entry['id']}: {fault}" for fault in own]
    return faults, len(entries)


def main() -> int:
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent.parent / "catalog"
    faults, count = check(folder)
    for fault in faults:
        print(fault)
    print(f"{count} entries, {len(faults)} faults")
    return 1 if faults or not count else 0


if __name__ == "__main__":
    sys.exit(main())
