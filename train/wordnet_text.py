#!/usr/bin/env python3
"""Writes WordNet's example sentences and definitions as lines of text: FOLDER/examples.txt and glosses.txt (those of artifacts first)."""

import argparse
import pathlib
import random
import re

ARTIFACT = 6  # lexicographer file


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--wordnet", type=pathlib.Path, default=pathlib.Path("/usr/share/wordnet"))
    parser.add_argument("--output", type=pathlib.Path, required=True)
    parser.add_argument("--examples", type=int, default=12500)
    parser.add_argument("--glosses", type=int, default=2000)
    options = parser.parse_args()
    r = random.Random(1)
    examples, glosses = [], []
    for name in ("noun", "verb", "adj", "adv"):
        for line in (options.wordnet / f"data.{name}").read_text().splitlines():
            if line.startswith("  "):
                continue
            gloss = line.split(" | ", 1)[1].strip()
            for example in re.findall(r'"([^"]+)"', gloss):
                if len(example.split()) >= 3:
                    examples.append(example + ("." if r.random() < 0.7 and example[-1].isalnum() else ""))
            plain = re.sub(r'[;,]?\s*"[^"]*"( *- *[A-Z][^;]*)?', "", gloss).strip(" ;")
            for part in plain.split("; "):
                part = re.sub(r"^\([^)]*\)\s*", "", part)
                if len(part.split()) >= 3:
                    glosses.append((0 if int(line.split()[1]) == ARTIFACT else r.random(), part))
    r.shuffle(examples)
    glosses = [part for _, part in sorted(glosses)][: 3 * options.glosses]
    r.shuffle(glosses)
    (options.output / "examples.txt").write_text("\n".join(examples[: options.examples]) + "\n")
    (options.output / "glosses.txt").write_text("\n".join(glosses[: options.glosses]) + "\n")


if __name__ == "__main__":
    main()
