#!/usr/bin/env python3
"""Checks that no folder under src/layoutbox/ includes one above it, or a sibling on its own floor, and that no two types at
file level share a name.

usage: scripts/check_layers.py [SOURCE_FOLDER]      (default: src/layoutbox of this repository)
Prints one line per fault, with the place; exit status 1 where there is any.
"""

import re
import sys
from collections import defaultdict
from pathlib import Path

# From the ground up; the folders of one floor do not know each other.
FLOORS = (
    ("base",),
    ("scene", "chat", "sandbox"),
    ("catalog", "publish"),
    ("plan", "solve", "furnish"),
    ("render", "export", "verify"),
    ("judge", "edit", "dress"),
    ("pipeline",),
    ("experiment", "serve"),
    ("cli",),
)
# The floors inside a folder; what stands in the folder itself is known to all of them.
INNER_FLOORS = {
    "plan": (("words",), ("syntax", "phrases"), ("passes", "room"), ("relations", "reading"), ("offline",), ("edit", "llm")),
}
# Lower floors that a folder may not know either: the verifier judges what these make, so it shares no code with them.
FORBIDDEN = {"verify": {"plan", "solve", "furnish"}}
# Folders behind an interface: besides the folder that holds them, only these make one and hand it on.
BEHIND = {"plan/llm": {"cli", "experiment"}}

INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|<(layoutbox/[^>]+)>)', re.MULTILINE)
# Types that stand at the left margin: what another type holds is told apart by that one's name. A forward declaration is none.
TYPE = re.compile(
    r"^(?:template *<[^>]*>\s*)?(?:struct|class|union|enum(?: +(?:class|struct))?)\s+(?:\[\[[^\]]*\]\]\s*)?([A-Za-z_]\w*)\s*"
    r"(?:final\s*)?(?::[^:;{][^;{]*)?\{",
    re.MULTILINE,
)
ALIAS = re.compile(r"^(?:template *<[^>]*>\s*)?using\s+([A-Za-z_]\w*)\s*=\s*([^;]*);", re.MULTILINE)
FLOOR_OF = {folder: floor for floor, folders in enumerate(FLOORS) for folder in folders}
INNER_FLOOR_OF = {
    f"{folder}/{inner}": floor for folder, floors in INNER_FLOORS.items() for floor, inners in enumerate(floors) for inner in inners
}
GENERATED = "embedded"  # headers that the build makes from data


def inner_fault(inner, other):
    """Why the folder `inner` ("plan/words") may not know `other` of the same folder, or None where it may, or where neither has a floor."""
    floor, floor_of_other = INNER_FLOOR_OF.get(inner), INNER_FLOOR_OF.get(other)
    if inner == other or floor is None or floor_of_other is None or floor_of_other < floor:
        return None
    return f"{other}/ is " + (f"above {inner}/" if floor_of_other > floor else f"on the same floor as {inner}/")


def fault(where, included):
    """Why a file in the folder `where` ("plan/words") may not include "`included`" (a path as written), or None where it may."""
    folder = where.split("/")[0]
    parts = Path(included).parts
    if len(parts) < 3 or parts[0] != "layoutbox" or ".." in parts:
        return "write the path from src/ on: layoutbox/FOLDER/FILE"
    other = parts[1]
    if other == folder:
        return inner_fault(where, "/".join(parts[1:3]))
    if other == GENERATED:
        return None
    if other not in FLOOR_OF:
        return f"{other}/ has no floor; give it one in scripts/check_layers.py"
    if other in FORBIDDEN.get(folder, ()):
        return f"{folder}/ must share no code with {other}/"
    inner = "/".join(parts[1:3])
    if folder not in BEHIND.get(inner, {folder}):
        return f"{inner}/ is made by {' and '.join(sorted(BEHIND[inner]))} alone; use its interface in {other}/"
    if FLOOR_OF[other] > FLOOR_OF[folder]:
        return f"{other}/ is above {folder}/"
    if FLOOR_OF[other] == FLOOR_OF[folder]:
        return f"{other}/ is on the same floor as {folder}/"
    return None


def faults(source):
    """All faults under the folder `source`, as lines "file:line: includes x: why"."""
    for path in sorted(source.rglob("*")):
        if path.suffix not in {".h", ".cc", ".inc"}:
            continue
        inside = path.relative_to(source)
        folder = inside.parts[0]
        if len(inside.parts) < 2 or folder not in FLOOR_OF:
            yield f"{path}: {folder} has no floor; give it one in scripts/check_layers.py"
            continue
        text = path.read_text(encoding="utf-8")
        for match in INCLUDE.finditer(text):
            included = match.group(1) or match.group(2)
            reason = fault(inside.parent.as_posix(), included)
            if reason:
                line = text.count("\n", 0, match.start(match.lastindex)) + 1
                yield f"{path}:{line}: includes {included}: {reason}"


def types_of(text):
    """Name and offset of each type at file level, and whether it is an alias; one that keeps the name of what it stands for is none."""
    for match in TYPE.finditer(text):
        yield match.group(1), match.start(1), False
    for match in ALIAS.finditer(text):
        if re.findall(r"\w+", match.group(2))[-1:] != [match.group(1)]:
            yield match.group(1), match.start(1), True


def shared_names(source):
    """Types of the same name, as lines "file:line: type X is also at …". Aliases (`Json`) may repeat one another, but no type."""
    places = defaultdict(list)
    for path in sorted(source.rglob("*")):
        if path.suffix in {".h", ".cc", ".inc"}:
            text = path.read_text(encoding="utf-8")
            for name, at, alias in types_of(text):
                line = text.count("\n", 0, at) + 1
                places[name].append((f"{path}:{line}", alias))
    for name, found in sorted(places.items()):
        first = next((place for place, alias in found if not alias), None)
        for place, _ in found:
            if first and place != first:
                yield f"{place}: type {name} is also at {first}; give it a name of its own"


def main(arguments):
    source = Path(arguments[0]) if arguments else Path(__file__).resolve().parent.parent / "src" / "layoutbox"
    if not source.is_dir():
        print(f"{source} is no folder", file=sys.stderr)
        return 2
    found = [*faults(source), *shared_names(source)]
    print("\n".join(found) if found else "layers: every include points down, every type has a name of its own")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
