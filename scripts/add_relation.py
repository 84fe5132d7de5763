#!/usr/bin/env python3
"""Writes what follows from the row of a new relation (docs/add-a-relation.md), next to a relation that it is like.

usage: scripts/add_relation.py NAME --like NAME --sentence TEXT [--parameters "max=0.1"] [--arity kOne] [--kinds kObject] [--say PHRASE]…

The table's row, the row of traits, the name in the schema and the phrases are whole; the two functions are there as what stops the build
and the page's row with two empty cells, which a test refuses, until what only a person knows is written. Prints what is left to write.
"""

from __future__ import annotations

import argparse
import json
import re
import sys
from pathlib import Path

TABLE = "src/layoutbox/scene/relation_list.inc"
TRAITS = "src/layoutbox/scene/relation_traits.cc"
SCHEMA = "schema/scene.schema.json"
PHRASES = "catalog/relation_phrases.json"
PAGE = "docs/relations.md"


class Refused(Exception):
    pass


def pascal(name: str) -> str:
    return name[0].upper() + name[1:]


def after(text: str, pattern: str, insertion: str, where: str) -> str:
    """The text with something behind the one place that the pattern matches."""
    found = list(re.finditer(pattern, text, re.MULTILINE | re.DOTALL))
    if len(found) != 1:
        raise Refused(f"{where}: {len(found)} places are like {pattern!r}, not one")
    return text[: found[0].end()] + insertion + text[found[0].end() :]


def block_end(text: str, begin: int) -> int:
    """Behind the brace that closes the first one from `begin`."""
    depth = 0
    for at in range(begin, len(text)):
        depth += {"{": 1, "}": -1}.get(text[at], 0)
        if depth == 0 and text[at] == "}":
            return at + 1
    raise Refused("a brace is never closed")


class Relation:
    def __init__(self, root: Path, options: argparse.Namespace):
        self.root, self.options = root, options
        self.changed: dict[str, str] = {}
        self.left: list[str] = []

    def read(self, path: str) -> str:
        return self.changed.get(path) or (self.root / path).read_text(encoding="utf-8")

    def write_table(self) -> None:
        name, like = self.options.name, self.options.like
        text = self.read(TABLE)
        if f'"{name}"' in text:
            raise Refused(f"{TABLE}: there is a relation {name} already")
        row = re.search(rf'^LAYOUTBOX_RELATION\(\w+, "{like}", (\w+), .*$', text, re.MULTILINE)
        if not row:
            raise Refused(f"{TABLE}: there is no relation {like} to stand behind")
        o = self.options
        new = f'\nLAYOUTBOX_RELATION({pascal(name)}, "{name}", {row[1]}, {o.arity}, {o.kinds}, "{o.parameters}", "{o.sentence}")'
        self.changed[TABLE] = text[: row.end()] + new + text[row.end() :]

    def write_traits(self) -> None:
        text = self.read(TRAITS)
        row = re.search(rf"\{{\.type = R::k{pascal(self.options.like)}\b", text)
        if not row:
            raise Refused(f"{TRAITS}: no row of {self.options.like}")
        end = text.index(",", block_end(text, row.start()) - 1) + 1
        self.changed[TRAITS] = text[:end] + f"\n    {{.type = R::k{pascal(self.options.name)}}}," + text[end:]

    def write_schema(self) -> None:
        text = self.read(SCHEMA)
        begin = text.index('"relationType"')
        end = text.index("]", begin)
        names = after(text[begin:end], rf'"{self.options.like}"', f', "{self.options.name}"', SCHEMA)
        self.changed[SCHEMA] = text[:begin] + names + text[end:]

    def write_phrases(self) -> None:
        if not self.options.say:
            return
        text = self.read(PHRASES)
        begin = text.find(f'"{self.options.like}":')
        if begin < 0:
            raise Refused(f"{PHRASES}: {self.options.like} has no words to stand behind")
        end = block_end(text, begin)
        said = json.dumps({"phrases": self.options.say}, ensure_ascii=False)
        self.changed[PHRASES] = text[:end] + f',\n    "{self.options.name}": {said}' + text[end:]
        json.loads(self.changed[PHRASES])

    def write_page(self) -> None:
        o = self.options
        row = f"\n| `{o.name}` | {o.parameters} |  | {o.sentence} |  |"
        self.changed[PAGE] = after(self.read(PAGE), rf"^\| `{o.like}` \|[^\n]*", row, PAGE)
        self.left.append(f"{PAGE}: when {o.name} holds, and an example")

    def write_function(self, folder: str, head: str, what: str) -> None:
        """A function that stops the build, behind that of the like."""
        for path in sorted((self.root / folder).glob("*.cc")):
            inside = path.relative_to(self.root).as_posix()
            text = self.read(inside)
            begin = text.find(head.format(pascal(self.options.like)))
            if begin < 0:
                continue
            end = block_end(text, begin)
            stub = f"\n\n{head.format(pascal(self.options.name))} {{\n#error \"{what.format(self.options.name)}\"\n}}"
            self.changed[inside] = text[:end] + stub + text[end:]
            self.left.append(f"{inside}:{text.count(chr(10), 0, end) + 3}: {what.format(self.options.name)}")
            return
        raise Refused(f"{folder}: no function of {self.options.like}")

    def write_all(self) -> None:
        self.write_table()
        self.write_traits()
        self.write_schema()
        self.write_phrases()
        self.write_function("src/layoutbox/solve/compile", "void compile_{}(Compilation& c)", "what the solver makes true of {}")
        self.write_function("src/layoutbox/verify/relations", "Finding check_{}(const RelationCase& c)", "what the verifier measures of {}")
        self.write_page()
        for kind in ("limits", "examples"):
            files = sorted((self.root / "tests/relations").glob(f"*_{kind}.cc"))
            like = next((one.name for one in files if f'"{self.options.like}"' in one.read_text("utf-8")), "…")
            self.left.append(f"tests/relations/{like}: its {kind[:-1]}")
        if self.options.say:
            self.left.append("src/layoutbox/plan/offline/sentences_test.txt: a sentence that says it")
        for path, text in self.changed.items():
            (self.root / path).write_text(text, encoding="utf-8")


def main(arguments: list[str]) -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n", 1)[0])
    parser.add_argument("name", help="as in JSON: backToBack")
    parser.add_argument("--like", required=True, help="the relation that it stands behind, of the same group")
    parser.add_argument("--sentence", required=True)
    parser.add_argument("--parameters", default="")
    parser.add_argument("--arity", default="kOne")
    parser.add_argument("--kinds", default="kObject")
    parser.add_argument("--say", action="append", default=[], help="words between target and reference; may be repeated")
    parser.add_argument("--root", type=Path, default=Path(__file__).resolve().parent.parent, help=argparse.SUPPRESS)
    options = parser.parse_args(arguments)
    if not re.fullmatch(r"[a-z][A-Za-z]*", options.name):
        parser.error(f"{options.name} is no name: write it as backToBack")
    relation = Relation(options.root, options)
    try:
        relation.write_all()
    except Refused as why:
        print(f"add_relation: {why}; nothing is written", file=sys.stderr)
        return 1
    print(f"written: {', '.join(relation.changed)}\nleft to write:")
    print("\n".join(f"  {one}" for one in relation.left))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
