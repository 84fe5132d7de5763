#!/usr/bin/env bash
# Sets up, configures and builds, with progress on stderr and everything else in a log under build/logs/.
set -euo pipefail

usage() {
  cat <<'TEXT'
usage: scripts/build.sh [--preset NAME] [--tests] [--define NAME=VALUE]… [TARGET…]
  --preset NAME  one of CMakePresets.json (default: release)
  --tests        with the tests, and what scripts/test.sh needs
TEXT
}

root=$(cd -P "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
preset=release tests="" blender="" targets=() defines=()
while (($#)); do
  case $1 in
    --preset) preset=$2 && shift 2 ;;
    --define) defines+=("-D$2") && shift 2 ;;
    --tests) tests=1 && shift ;;
    -h | --help) usage && exit 0 ;;
    -*) usage >&2 && exit 2 ;;
    *) targets+=("$1") && shift ;;
  esac
done
build=$root/build/$preset
log=$root/build/logs/build-$preset.log
mkdir -p "$build" "$root/build/logs"

say() { printf 'build: %s\n' "$*" >&2; }

die() {
  say "$*"
  # The first error says most; what other compilers still printed afterwards hides it.
  { grep -m 1 -A 30 '^FAILED: ' "$log" || tail -n 30 "$log"; } | sed 's/^/  | /' >&2
  say "the whole log: $log"
  exit 3
}

# How long it will still take, by the steps done so far: nothing where that is soon, or where too little is done to say.
time_to_go() {
  local done=$1 all=$2 seconds=$3 left
  ((left = done > 0 ? seconds * (all - done) / done : 0, 20 * done >= all && left > 20)) || return 0
  if ((left < 90)); then printf ', some %d s to go' $((left / 10 * 10)); else printf ', some %d min to go' $(((left + 30) / 60)); fi
}

# Reads Ninja's output; shows how far it is: one changing line on a terminal, a line every tenth elsewhere.
show_progress() {
  local line share last=-1 unit='\n' step=10 began=$SECONDS
  if [[ -t 2 ]]; then unit='    \r' step=1; fi
  while IFS= read -r line; do
    printf '%s\n' "$line" >&3
    [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]] || continue
    ((share = 100 * BASH_REMATCH[1] / BASH_REMATCH[2], share -= share % step, BASH_REMATCH[2] > 3)) || continue
    ((share > last)) || continue
    last=$share
    # shellcheck disable=SC2059  # the unit is an escape
    printf "build: %3d %% (step %d of %d%s)$unit" "$share" "${BASH_REMATCH[1]}" "${BASH_REMATCH[2]}" \
      "$(time_to_go "${BASH_REMATCH[1]}" "${BASH_REMATCH[2]}" $((SECONDS - began)))" >&2
  done 3>>"$log"
  if [[ -t 2 ]] && ((last >= 0)); then printf '\n' >&2; fi
}

exec 8>"$build/.lock"
if ! flock -n 8; then
  say "another build is running; waiting for it"
  flock 8
fi
start_stamp=$build/start.stamp
touch "$start_stamp"
: >"$log"

# A build folder that came from somewhere else cannot be used.
if [[ -e $build/CMakeCache.txt ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$build/CMakeCache.txt"; then
  say "build/$preset was made in another folder; starting afresh"
  find "$build" -mindepth 1 -maxdepth 1 ! -name .lock ! -name start.stamp -exec rm -rf {} +
fi
if [[ ! -e $build/build.ninja ]]; then
  say "first build here: this sets up what is missing and compiles for a few minutes; later runs start at once"
fi
if [[ $tests ]]; then
  "$root/scripts/setup.sh" --tests 8>&-
  defines+=(-DLAYOUTBOX_TESTS=ON)
else
  "$root/scripts/setup.sh" --blender-later 8>&-
  # Blender is fetched while the compiler runs; what that says is shown when both are done.
  "$root/scripts/setup.sh" >"$root/build/logs/blender.log" 2>&1 8>&- &
  blender=$!
  [[ -e $build/CMakeCache.txt ]] || defines+=(-DLAYOUTBOX_TESTS=OFF)
fi

# Objects that another checkout of the same sources compiled can be used again.
export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=time_macros NINJA_STATUS='[%f/%t] '
cd "$root"
# A first build compiles every source: several at a time take a third of the work.
[[ -e $build/CMakeCache.txt ]] || defines=(-DLAYOUTBOX_UNITY=ON "${defines[@]}")
if [[ ! -e $build/build.ninja || ${#defines[@]} -gt 0 ]]; then
  cmake --preset "$preset" "${defines[@]}" >>"$log" 2>&1 8>&- || die "CMake could not configure the build"
fi
ninja -C "$build" -j "$(nproc)" "${targets[@]}" 2>&1 8>&- | show_progress || die "the build failed"
if [[ $blender ]]; then
  if kill -0 "$blender" 2>/dev/null; then say "built; Blender is still being fetched for the pictures"; fi
  wait "$blender" || true # without Blender all else works, and the log says what is missing
  cat "$root/build/logs/blender.log" >&2
fi
touch -r "$start_stamp" "$build/built.stamp"
