#!/usr/bin/env python3
"""Whether the parser connects who stands where in descriptions of fresh_rooms.py: the share of facts whose place hangs on the thing itself
or on the verb of which it is subject or object. Sentences with "it" are left out.

usage: attachments.py TOKENS_PROGRAM DESCRIPTIONS.jsonl [--wrong]
"""

import argparse
import collections
import json
import pathlib
import subprocess

BETWEEN = {"pobj", "prep", "advmod", "pcomp", "dobj", "agent", "appos", "npadvmod"}  # arcs from a place's noun up to what stands there
RELATIONAL = {
    "left",
    "right",
    "side",
    "sides",
    "top",
    "front",
    "corner",
    "middle",
    "center",
    "foot",
    "head",
    "end",
    "edge",
    "next",
    "near",
    "close",
}
TAKES = {"nsubj", "nsubjpass", "dobj", "attr", "pobj", "conj", "appos"}
WORD_OF = {"room": "corner"}


def parse(program, text):
    output = subprocess.run([program, "--parse"], input=text, stdout=subprocess.PIPE, check=True, text=True).stdout
    for block in output.strip().split("\n\n"):
        rows = [line.split("\t") for line in block.split("\n")]
        yield [(word, tag, int(head) - 1, arc) for word, tag, head, arc, _ in rows]


def is_word(word, name):
    return word in {name, name + "s", name + "es", name[:-1] + "ves"}


def host_of(rows, place):
    """What a place's noun is said of: the first noun or verb above it that is no part of the place."""
    at = place
    while rows[at][2] >= 0 and (rows[at][3] in BETWEEN or rows[at][0] in RELATIONAL) and at != rows[at][2]:
        at = rows[at][2]
        word, tag = rows[at][0], rows[at][1]
        if (tag.startswith("NN") and word not in RELATIONAL) or tag.startswith("VB"):
            return at
    return at


def first_of_list(rows, place):
    while rows[place][3] == "conj" and rows[rows[place][2]][1].startswith("NN"):
        place = rows[place][2]
    return place


def connected(rows, subject, place):
    """Up from the place, or from what stands on it: "The desk holds a lamp and a book"."""
    if any(reaches(rows, one, other) for one in (subject, first_of_list(rows, subject)) for other in (place, first_of_list(rows, place))):
        return True
    verb = rows[first_of_list(rows, subject)][2]
    return rows[first_of_list(rows, subject)][3] == "dobj" and rows[place][2] == verb and rows[place][3] == "nsubj"


def reaches(rows, subject, place):
    host = host_of(rows, place)
    for _ in range(3):
        if host == subject:
            return True
        if any(row[2] == host and row[3] in TAKES and i == subject for i, row in enumerate(rows)):
            return True
        if rows[host][3] in {"acl", "relcl", "advcl", "xcomp", "ccomp", "conj"} and rows[host][2] >= 0:
            if rows[host][2] == subject:
                return True
            host = rows[host][2] if rows[host][3] in {"xcomp", "relcl"} else host
    return False


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("descriptions", type=pathlib.Path)
    parser.add_argument("--wrong", action="store_true", help="print the sentences")
    options = parser.parse_args()
    right, known = collections.Counter(), collections.Counter()
    for line in options.descriptions.read_text().splitlines():
        description = json.loads(line)
        sentences = list(parse(options.program, description["prompt"].replace("\n", " ; ")))
        for fact in description["relations"]:
            if not fact["said"]:
                continue
            name, other = fact["subject"].split()[-1], WORD_OF.get(fact["object"], fact["object"].split()[-1])
            other = "wall" if fact["kind"] == "wall" else other
            answers = []
            for rows in sentences:
                subjects = [i for i, row in enumerate(rows) if is_word(row[0], name)]
                places = [i for i, row in enumerate(rows) if is_word(row[0], other)]
                if subjects and places and all(row[0] not in {"it", "them"} for row in rows):
                    answers.append((any(connected(rows, s, p) for s in subjects for p in places), rows))
            if answers:
                known[description["style"]] += 1
                right[description["style"]] += any(ok for ok, _ in answers)
                if options.wrong and not any(ok for ok, _ in answers):
                    rows = answers[0][1]
                    print(fact["subject"], fact["kind"], fact["object"] + ":", " ".join(f"{w}/{t}:{a}>{rows[h][0]}" for w, t, h, a in rows))
    for style in sorted(known):
        print(f"{style:14} {100 * right[style] / known[style]:5.1f} % of {known[style]}")
    print(f"{'all':14} {100 * sum(right.values()) / sum(known.values()):5.1f} % of {sum(known.values())}")


if __name__ == "__main__":
    main()
