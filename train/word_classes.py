#!/usr/bin/env python3
"""Writes what the parser knows of English words: "word bits", a line a word (the bits: src/layoutbox/plan/syntax/sentence.h).

usage: word_classes.py [--wordnet FOLDER] > words
Parts of speech and senses are WordNet 3.0's; classes of words used alike come from the vectors of spaCy's en_core_web_md by k-means.
"""

import argparse
import collections
import pathlib
import sys

import numpy
from teach import load

NAMES = (("n", "noun"), ("v", "verb"), ("a", "adj"), ("r", "adv"))
COARSE, FINE = 63, 16


def counts(folder):
    """Uses of (lemma, part of speech, lexicographer's file) in the counted texts."""
    result = collections.Counter()
    for line in (folder / "cntlist.rev").read_text().splitlines():
        key, _, count = line.split()
        lemma, rest = key.split("%")
        kind, file = rest.split(":")[:2]
        result[lemma, "nvara"[int(kind) - 1], int(file)] += int(count)
    return result


def first_files(folder, name):
    """Lemma to the lexicographer's files of its senses, the usual ones first."""
    files = {}
    for line in (folder / f"data.{name}").read_text().splitlines():
        if not line.startswith(" "):
            files[line[:8]] = int(line[9:11])
    result = {}
    for line in (folder / f"index.{name}").read_text().splitlines():
        if not line.startswith(" "):
            parts = line.split()
            if parts[0].isalpha():
                result[parts[0]] = [files[offset] for offset in parts[-int(parts[2]) :]]
    return result


def irregular(folder, name):
    result = collections.defaultdict(set)
    for line in (folder / f"{name}.exc").read_text().splitlines():
        form, *lemmas = line.split()
        for lemma in lemmas:
            result[lemma].add(form)
    return result


def plural(word):
    if word.endswith(("s", "x", "z", "ch", "sh")):
        return word + "es"
    return word[:-1] + "ies" if word.endswith("y") and word[-2:-1] not in "aeiou" else word + "s"


def verb_forms(word, irregulars):
    yield plural(word)
    stem = word[:-1] if word.endswith("e") and not word.endswith("ee") else word
    vowels = "aeiou"
    if len(word) > 2 and word[-1] not in vowels + "wxy" and word[-2] in vowels and word[-3] not in vowels:
        yield word + word[-1] + "ing"
        yield word + word[-1] + "ed"
    yield stem + "ing"
    yield (word[:-1] + "ied" if word.endswith("y") and word[-2:-1] not in vowels else stem + "ed")
    yield from irregulars[word]


def words_of_wordnet(folder):
    """Word to uses by part of speech, and the senses of noun and verb."""
    used = counts(folder)
    known = collections.defaultdict(lambda: {"uses": collections.Counter(), "noun": 0, "verb": 0})
    for letter, name in NAMES:
        forms = irregular(folder, name)
        for lemma, files in first_files(folder, name).items():
            uses = sum(count for file in set(files) for count in [used[lemma, letter, file]])
            words = {lemma: 0.5 + uses}
            if letter == "n":
                words.update(dict.fromkeys({plural(lemma), *forms[lemma]}, 0.5 + uses))
            elif letter == "v":
                words.update(dict.fromkeys(verb_forms(lemma, forms), 0.5 + uses))
            for word, weight in words.items():
                entry = known[word]
                entry["uses"][letter] += weight
                if name in ("noun", "verb") and (word == lemma or not entry[name]):
                    best = max(set(files), key=lambda file: (used[lemma, letter, file], -files.index(file)))
                    entry[name] = best + 1 - (3 if name == "noun" else 29)
    return known


def means(points, number, rounds=25):
    random = numpy.random.default_rng(7)
    number = min(number, len(points))
    centers = points[random.choice(len(points), number, replace=False)]
    for _ in range(rounds):
        best = numpy.argmax(points @ centers.T, axis=1)
        sums = numpy.zeros_like(centers)
        numpy.add.at(sums, best, points)
        lengths = numpy.linalg.norm(sums, axis=1, keepdims=True)
        centers = numpy.where(lengths > 0, sums / numpy.maximum(lengths, 1e-9), centers)
    return numpy.argmax(points @ centers.T, axis=1)


def groups(vectors):
    """Row of the vector table to its class: the coarse one (1 to 63) in the upper six bits of ten."""
    points = vectors / numpy.maximum(numpy.linalg.norm(vectors, axis=1, keepdims=True), 1e-9)
    coarse = means(points, COARSE)
    result = numpy.zeros(len(points), dtype=int)
    for group in range(COARSE):
        rows = numpy.flatnonzero(coarse == group)
        if len(rows):
            result[rows] = (group + 1) * FINE + means(points[rows], FINE)
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--wordnet", type=pathlib.Path, default=pathlib.Path("/usr/share/wordnet"))
    parser.add_argument("--extra", type=pathlib.Path, nargs="*", default=[], help="trees whose words are wanted as well")
    options = parser.parse_args()
    nlp = load()
    vectors = nlp.vocab.vectors
    group_of = groups(vectors.data)
    known = words_of_wordnet(options.wordnet)
    wanted = set(known)
    for path in options.extra:
        wanted |= {line.split("\t")[0] for line in path.read_text().splitlines() if "\t" in line}
    for word in sorted(wanted):
        row = vectors.find(key=nlp.vocab.strings.add(word)) if word.isalpha() else -1
        if row < 0 and word not in known:
            continue
        if row < 0 and sum(known[word]["uses"].values()) < 1:
            continue  # an inflected form that nobody uses
        bits = int(group_of[row]) << 15 if row >= 0 else 0
        if word in known:
            entry = known[word]
            letters = "nvar"
            uses = entry["uses"]
            bits |= sum(1 << letters.index(letter) for letter in uses)
            bits |= letters.index(max(letters, key=lambda letter: uses[letter])) << 4
            bits |= max(0, entry["noun"]) << 6 | max(0, entry["verb"]) << 11
        sys.stdout.write(f"{word} {bits}\n")


if __name__ == "__main__":
    main()
