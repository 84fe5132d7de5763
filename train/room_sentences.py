#!/usr/bin/env python3
"""Writes sentences about random rooms with exact trees, for syntax_train.

usage: room_sentences.py NUMBER SEED [--styles a,b] [--text] [--list]
The trees follow the labels of spaCy's English models, but for two things. Where the verb is left out, what stands for it is the first
thing that is left: in "Place A against X and B against Y" B is `conj` of "place", and "against" hangs on B.
What "there is" says takes the places that follow: in "There is a lamp on the desk" "on" hangs on the lamp.
"""

import argparse
import random

from room_styles import STYLES
from tree_text import text, trees


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("number", type=int)
    parser.add_argument("seed", type=int)
    parser.add_argument("--styles", help="only these, divided by commas; with a - before them: all but these")
    parser.add_argument("--text", action="store_true", help="write text instead of trees")
    options = parser.parse_args()
    names = sorted(STYLES)
    if options.styles and options.styles.startswith("-"):
        names = [name for name in names if name not in options.styles[1:].split(",")]
    elif options.styles:
        names = options.styles.split(",")
    r = random.Random(options.seed)
    weights = [STYLES[name][1] for name in names]
    written = 0
    while written < options.number:
        name = r.choices(names, weights)[0]
        for root in STYLES[name][0](r):
            print(f"{name}: {text(root)}" if options.text else trees(root), end="\n" if options.text else "")
            written += 1


if __name__ == "__main__":
    main()
