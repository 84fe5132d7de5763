"""What words the catalogue has for things: those of its entries, words_kinds.json and words_uses.json (check_catalog.py)."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path


def key_of(word: str) -> str:
    """The program reads words without regard to what separates them."""
    return "".join(c for c in word.lower() if c.isalnum())


def check_words(things: list[dict]) -> Iterator[str]:
    """Every id, name and synonym names one thing only."""
    owner: dict[str, str] = {}
    for thing in things:
        own = {key_of(word): word for word in (thing["id"].replace("_", " "), thing["name"].lower())}
        for word in [*sorted(own.values()), *thing.get("synonyms", [])]:
            key = key_of(word)
            if word in thing.get("synonyms", []) and word != word.lower():
                yield f"{thing['id']}: synonym '{word}' is not in lower case"
            if owner.get(key) == thing["id"]:
                yield f"{thing['id']}: '{word}' is there twice (the id and the name are words too)"
            elif key in owner:
                yield f"{thing['id']}: '{word}' already names {owner[key]}"
            owner.setdefault(key, thing["id"])


def check_like(folder: Path, ids: dict[str, dict]) -> Iterator[str]:
    """What words_kinds.json names is there, and no word of its list has an entry of its own."""
    path = folder / "words_kinds.json"
    if not path.exists():
        return
    data = json.loads(path.read_text(encoding="utf-8"))
    words = {word for entry in ids.values() for word in [entry["id"].replace("_", " "), entry["name"], *entry.get("synonyms", [])]}
    for entry, like in data["like"].items():
        if entry not in ids:
            yield f"words_kinds like: there is no entry '{entry}'"
        yield from (f"words_kinds like: '{word}' has an entry" for word in like if word in words)
    for named in [*data["kinds"].values(), *data["modifiers"].values(), *data["heads"].values()]:
        if named and named not in ids:
            yield f"words_kinds: there is no entry '{named}'"


def check_uses(folder: Path, ids: dict[str, dict], rooms: set[str]) -> Iterator[str]:
    """What words_uses.json brings in are things, in rooms that there are; words_kinds.json's `kept_in` and `general` likewise."""
    if not (folder / "words_uses.json").exists():
        return
    words = {key_of(word) for entry in ids.values() for word in [entry["id"], entry["name"], *entry.get("synonyms", [])]}
    for use in json.loads((folder / "words_uses.json").read_text(encoding="utf-8"))["uses"]:
        for thing in [use["is"], *use.get("rooms", {}).values()]:
            if key_of(thing) not in words:
                yield f"words_uses: '{thing}' is no thing"
        yield from (f"words_uses: there is no room '{room}'" for room in use.get("rooms", {}) if room not in rooms)
    kinds = json.loads((folder / "words_kinds.json").read_text(encoding="utf-8"))
    kept = [row.split(">")[-1] for rows in kinds["kept_in"].values() for row in rows.split()]
    places = ("on_wall", "on_floor", "on_ceiling", "on_thing", "between_seats", "around_bed", "set_in")
    placed = [named for place in places for row in kinds[place].items() for named in row]
    for named in [*kept, *placed, *(kind for some in kinds["general"].values() for kind in some)]:
        if named not in ids:
            yield f"words_kinds: there is no entry '{named}'"
