#!/usr/bin/env bash
# Formats the C++ of this repository. With --check it changes nothing and fails where something is not formatted.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
case ${1:-} in
  "") options=(-i) ;;
  --check) options=(--dry-run -Werror) ;;
  *) echo "usage: scripts/format.sh [--check]" >&2 && exit 2 ;;
esac
# .inc files are tables that are laid out by hand.
find src include examples cmake fuzz tests train \( -name '*.cc' -o -name '*.h' \) -print0 | sort -z | xargs -0 --no-run-if-empty clang-format-16 --style=file "${options[@]}"
