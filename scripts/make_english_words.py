#!/usr/bin/env python3
"""Writes catalog/words_english.txt from WordNet 3.0's files (Debian: wordnet-base, /usr/share/wordnet).

A line a word, sorted by bytes: the word without spaces, a letter for what it mostly is (t thing, c creature or other body in nature,
p person, o other noun that is a thing in a rarer sense, n other noun, v verb, a adjective, r adverb, k a rare word that may be
such), for verbs and adjectives that are nouns as well a second letter for the noun, and for what is or may be a thing or creature
the words for the more general kinds, the nearest first. Words of the catalogue's own lists need not be here.
"""

import argparse
import collections
import pathlib
import re

ARTIFACT, FOOD, PLANT = 6, 13, 20  # lexicographer files of physical things that stand in rooms
ANIMAL = 5
BODIES = {ANIMAL, 8, FOOD, 17, PLANT}  # animals, parts of them, food, stones, plants: things where a text names or counts one
PERSON = 18
ABSTRACT = {4, 7, 9, 11, 12, 14, 16, 24, 26, 28}  # acts, attributes, cognition, events, feelings, groups, motives, relations, states, times
BODILY_GROUPS = {"collection", "set", "aggregation", "array", "game", "parlorgame", "boardgame", "fleet"}  # have pieces
SHORTEST_ABSTRACT = 6  # the spelling of shorter ones is rather that of another word
SHORTEST_RARE = 4  # shorter ones are rather typing errors
MOST_KINDS = 5
TELL_NOTHING = {"artifact", "chordate", "entity", "instrumentality", "livingthing", "matter", "metatherian", "naturalobject", "object",
                "organism", "part", "physicalentity", "placental", "substance", "thing", "unit", "vertebrate", "whole",
                "vascularplant", "bodypart", "solid", "food", "eutherian"}  # fmt: skip
POS = {"1": "n", "2": "v", "3": "a", "4": "r", "5": "a"}


def read_counts(folder: pathlib.Path) -> dict[tuple[str, str], int]:
    counts: dict[tuple[str, str], int] = collections.Counter()
    for line in (folder / "cntlist.rev").read_text().splitlines():
        key, _, count = line.split()
        lemma, rest = key.split("%")
        counts[lemma, POS[rest[0]]] += int(count)
    return counts


def read_senses(folder: pathlib.Path) -> dict[str, list[int]]:
    senses = {}
    for line in (folder / "index.noun").read_text().splitlines():
        if line.startswith(" "):
            continue
        parts = line.split()
        senses[parts[0]] = [int(p) for p in parts[-int(parts[2]) :]]
    return senses


def read_synsets(folder: pathlib.Path) -> tuple[dict[int, tuple[int, list[str], list[int]]], set[int]]:
    """All senses of nouns, and which of them are names (Heron of Alexandria, Turkey): those are no sense of the word."""
    synsets, names = {}, set()
    for line in (folder / "data.noun").read_text().splitlines():
        if line.startswith(" "):
            continue
        parts = line.split("|")[0].split()
        count = int(parts[3], 16)
        words = [parts[4 + 2 * i].lower() for i in range(count)]
        pointers = parts[4 + 2 * count + 1 :]
        above = [int(pointers[i + 1]) for i in range(0, len(pointers) - 3, 4) if pointers[i] == "@"]
        synsets[int(parts[0])] = (int(parts[1]), words, above)
        if "@i" in pointers:
            names.add(int(parts[0]))
    return synsets, names


def read_pasts(folder: pathlib.Path) -> dict[str, str]:
    """Irregular forms of verbs: "came" of "come"."""
    lines = (line.split() for line in (folder / "verb.exc").read_text().splitlines())
    return {form: base for form, base, *_ in lines if re.fullmatch("[a-z]+", form) and not form.endswith("ing")}


def lemmas(folder: pathlib.Path, part: str) -> set[str]:
    return {line.split()[0] for line in (folder / f"index.{part}").read_text().splitlines() if not line.startswith(" ")}


def thing_sense(lemma: str, senses: dict[str, list[int]], synsets: dict[int, tuple[int, list[str], list[int]]], uses: int) -> int | None:
    """The first usual sense that is a physical thing; food and plants only where they are common words."""
    reach = 2 if uses else 4
    for sense in senses[lemma][:reach]:
        file = synsets[sense][0]
        if file == ARTIFACT or (file in (FOOD, PLANT) and uses):
            return sense
    return None


def noun_letter(lemma: str, senses: dict[str, list[int]], synsets: dict[int, tuple[int, list[str], list[int]]]) -> tuple[str, int | None]:
    """What a noun that is mostly no thing is, and the sense that says so: that of its first two senses which is a body or a person."""
    for sense in senses[lemma][:2]:
        file = synsets[sense][0]
        if file in BODIES:
            return "c", sense
        if file == PERSON:
            return "p", sense
    return "n", None


def rarer_thing(lemma: str, senses: dict[str, list[int]], synsets: dict[int, tuple[int, list[str], list[int]]]) -> int | None:
    """The first of all senses that is made by somebody, or a kind of what is ("tome", a book), though mostly the word says another."""
    for sense in senses[lemma]:
        above: int | None = sense
        while above is not None:
            if synsets[above][0] == ARTIFACT:
                return sense
            above = synsets[above][2][0] if synsets[above][2] else None
    return None


def is_abstract(lemma: str, senses: dict[str, list[int]], synsets: dict[int, tuple[int, list[str], list[int]]]) -> bool:
    """Whether a rare noun is nothing bodily in any of its senses: groups of people, feelings, acts, times, states."""
    return len(lemma) >= SHORTEST_ABSTRACT and all(
        synsets[sense][0] in ABSTRACT and not BODILY_GROUPS & set(kinds(sense, synsets)) for sense in senses[lemma]
    )


def kinds(sense: int, synsets: dict[int, tuple[int, list[str], list[int]]]) -> list[str]:
    """The words for the more general kinds of a sense, the nearest first, by the first of several kinds each."""
    found: list[str] = []
    while synsets[sense][2] and len(found) < MOST_KINDS:
        sense = synsets[sense][2][0]
        found += [word for word in [re.sub(r"[_'-]", "", synsets[sense][1][0])] if word not in TELL_NOTHING]
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--wordnet", type=pathlib.Path, default=pathlib.Path("/usr/share/wordnet"))
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path(__file__).parent.parent / "catalog" / "words_english.txt")
    options = parser.parse_args()
    counts, (synsets, names) = read_counts(options.wordnet), read_synsets(options.wordnet)
    all_senses = read_senses(options.wordnet)
    senses = {lemma: kept for lemma, listed in all_senses.items() if (kept := [sense for sense in listed if sense not in names])}
    parts = {letter: lemmas(options.wordnet, name) for letter, name in (("n", "noun"), ("v", "verb"), ("a", "adj"), ("r", "adv"))}
    parts["n"] &= senses.keys()
    lines, abstract = {}, set()
    for lemma in sorted(set().union(*parts.values())):
        if not re.fullmatch(r"[a-z]+([_-][a-z]+){0,2}", lemma):
            continue
        uses = {letter: counts.get((lemma, letter), 0) for letter, words in parts.items() if lemma in words}
        best = max(uses, key=lambda letter: (uses[letter], "ranv".index(letter)))
        compound = "_" in lemma or "-" in lemma
        thing = thing_sense(lemma, senses, synsets, uses.get("n", 0)) if "n" in uses else None
        key = re.sub(r"[_-]", "", lemma)
        if thing is not None and (3 * uses["n"] >= uses[best] or uses[best] < 5):
            lines[key] = " ".join(["t", *kinds(thing, synsets)])
            continue
        letter, sense = noun_letter(lemma, senses, synsets) if "n" in uses else ("", None)
        if letter == "n" and not compound and (rarer := rarer_thing(lemma, senses, synsets)) is not None:
            letter, sense = "o", rarer
        elif letter in ("c", "p") and uses["n"] == 0 and (compound or (letter == "c" and synsets[sense][0] != ANIMAL)):
            letter = ""  # names of species, offices and peoples
        if best == "n" and letter in ("c", "p") and (not compound or uses["n"] > 0):
            lines.setdefault(key, " ".join([letter, *(kinds(sense, synsets) if letter == "c" else [])]))
        elif not compound and uses[best] > (1 if best == "n" else 0) and not (best == "r" and lemma.endswith("ly")):
            if best == "n":
                lines.setdefault(lemma, " ".join(["o", *kinds(sense, synsets)]) if letter == "o" else "n")
            elif thing is not None or letter in ("c", "o"):
                lines.setdefault(lemma, " ".join([best + ("t" if thing is not None else letter), *kinds(thing or sense, synsets)]))
            else:
                lines.setdefault(lemma, best + letter)
        elif best == "n" and uses.keys() == {"n"} and not compound and is_abstract(lemma, senses, synsets):
            lines.setdefault(lemma, "n")  # "clientele"
            abstract.add(lemma)
        elif uses.keys() == {"r"} and not compound and not lemma.endswith("ly") and lemma[:-1] not in parts["n"] | parts["v"]:
            lines.setdefault(lemma, "r")  # "amidships"; not "needs"
        elif (
            "n" in uses
            and not compound
            and len(lemma) >= SHORTEST_RARE
            and (letter == "o" or (sense is not None and synsets[sense][0] in BODIES))
        ):
            above = kinds(sense, synsets)
            if "taxonomicgroup" not in above:
                lines.setdefault(lemma, " ".join(["k", *above]))
    for lemma, listed in all_senses.items():  # "for Otis" is for somebody, whatever genus or pastry is called so
        kind = lines.get(lemma, "k").split()
        somebody = any(sense in names and synsets[sense][0] == PERSON for sense in listed[:2])
        if somebody and (kind[0] == "k" or lemma in abstract or "group" in kind):
            lines[lemma] = "p"
    for form, base in read_pasts(options.wordnet).items():
        if counts.get((base, "v"), 0) > 0:
            lines.setdefault(form, "v")
    options.output.write_text("".join(f"{word} {what}\n" for word, what in sorted(lines.items())))


if __name__ == "__main__":
    main()
