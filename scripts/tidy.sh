#!/usr/bin/env bash
# clang-tidy (.clang-tidy) over all sources, or those that are compiled together with the given ones; clang's own warnings count as faults
# too. Needs a release build.
# usage: scripts/tidy.sh [--without-tests | FILE…]
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
tests=1
[[ ${1:-} == --without-tests ]] && tests="" && shift
# The sources of a folder two dozen at a time, in a quarter of the time: names at file level that shadow each other are seen as well.
cmake --preset release -B build/tidy -DLAYOUTBOX_UNITY=ON >build/logs/tidy.log
commands=build/tidy/compile_commands.json
# The data that sources embed is the release build's, and not looked at.
sed -i "s|$PWD/build/tidy/embedded|$PWD/build/release/embedded|g" $commands
find build/tidy -name 'unity_*.cxx' -exec sed -i '/embedded.*\.cc"$/d' {} +

# What a source is compiled in: a unit of several, else itself.
unit_of() {
  local file
  file=$(realpath "$1")
  grep -rlF --include='unity_*.cxx' "#include \"$file\"" "$PWD/build/tidy" || echo "$file"
}

if (($#)); then
  mapfile -t units < <(for file in "$@"; do unit_of "$file"; done | sort -u)
else
  mapfile -t units < <(sed -nE "s|^ *\"file\": \"($PWD/(build/tidy/)?src/[^\"]*)\",?\$|\1|p" $commands |
    if [[ $tests ]]; then cat; else grep -v '_test\.cc$'; fi | sort -u)
fi
printf '%s\0' "${units[@]}" |
  xargs -0 -P "$(nproc)" -n 1 clang-tidy-16 -p build/tidy --quiet --checks=-bugprone-suspicious-include \
    --extra-arg=-Wno-unknown-warning-option --extra-arg=-Wno-double-promotion 2>/dev/null
