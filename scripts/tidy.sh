#!/usr/bin/env bash
# clang-tidy (.clang-tidy) over all sources, or the given ones; clang's own warnings count as faults too. Needs a release build.
# usage: scripts/tidy.sh [FILE…]
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
files=("$@")
if ((${#files[@]} == 0)); then
  mapfile -t files < <(find src -name '*.cc' | sort)
fi
# How each source is compiled by itself, whatever the release build compiles together; the data that it embeds is the release build's.
cmake --preset release -B build/tidy -DLAYOUTBOX_UNITY=OFF >build/logs/tidy.log
sed -i "s|$PWD/build/tidy/embedded|$PWD/build/release/embedded|g" build/tidy/compile_commands.json
printf '%s\0' "${files[@]}" |
  xargs -0 -P "$(nproc)" -n 1 clang-tidy-16 -p build/tidy --quiet --extra-arg=-Wno-unknown-warning-option --extra-arg=-Wno-double-promotion 2>/dev/null
