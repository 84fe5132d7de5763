#!/usr/bin/env bash
# clang-tidy (.clang-tidy) over all sources, or the given ones; clang's own warnings count as faults too. Needs a release build.
# usage: scripts/tidy.sh [--without-tests | FILE…]
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
tests=1
[[ ${1:-} == --without-tests ]] && tests="" && shift
files=("$@") unity=OFF
((${#files[@]})) || unity=ON # all at once: the sources of a folder two dozen at a time, in a quarter of the time
cmake --preset release -B build/tidy -DLAYOUTBOX_UNITY=$unity >build/logs/tidy.log
commands=build/tidy/compile_commands.json
# The data that sources embed is the release build's, and not looked at.
sed -i "s|$PWD/build/tidy/embedded|$PWD/build/release/embedded|g" $commands
find build/tidy -name 'unity_*.cxx' -exec sed -i '/embedded.*\.cc"$/d' {} +
if ((${#files[@]} == 0)); then
  mapfile -t files < <(sed -nE "s|^ *\"file\": \"($PWD/(build/tidy/)?src/[^\"]*)\",?\$|\1|p" $commands |
    if [[ $tests ]]; then cat; else grep -v '_test\.cc$'; fi | sort -u)
fi
printf '%s\0' "${files[@]}" |
  xargs -0 -P "$(nproc)" -n 1 clang-tidy-16 -p build/tidy --quiet --checks=-bugprone-suspicious-include \
    --extra-arg=-Wno-unknown-warning-option --extra-arg=-Wno-double-promotion 2>/dev/null
