#!/usr/bin/env bash
# Installs what is missing to build and run Layout-in-a-Box, and says what it installs. As root by apt-get; otherwise it prints the
# line that an administrator has to run. What is not a package goes into build/deps/, so nothing outside the repository changes.
# A second run finds everything in place and does nothing.
set -euo pipefail

usage() {
  cat <<'TEXT'
usage: scripts/setup.sh [--build-only | --blender-later | --tests | --scale | --nightly] [--force]
  (no option)      what ./layoutbox needs: compiler, libraries, solver library, Blender
  --build-only     the same without Blender
  --blender-later  the same, but where Blender has to be fetched this is left to a further run
  --tests          also what scripts/test.sh needs
  --scale          also what scripts/scale/ needs: Ray, submitit, PyArrow, in build/deps/scale (start its scripts by the Python there)
  --nightly        also what scripts/nightly.sh needs, that of --tests and --scale
  --force          look again even where nothing changed
Environment: ORTOOLS_ROOT (an OR-Tools of your own), LAYOUTBOX_BLENDER (a Blender of your own).
Exit status: 0 all there, 3 something that is needed is missing (what, and how to get it, is on stderr).
TEXT
}

root=$(cd -P "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
deps=$root/build/deps
log=$root/build/logs/setup.log
ortools_version=$(sed -n 's/^ortools==\([^ ]*\).*/\1/p' "$root/scripts/requirements/solver.txt")
bpy_version=$(sed -n 's/^bpy==\([^ ]*\).*/\1/p' "$root/scripts/requirements/blender.txt")

mode=run force="" later=""
for argument in "$@"; do
  case $argument in
    --build-only) mode=build ;;
    --blender-later) later=1 ;;
    --tests) mode=tests ;;
    --scale) mode=scale ;;
    --nightly) mode=nightly ;;
    --force) force=1 ;;
    -h | --help) usage && exit 0 ;;
    *) usage >&2 && exit 2 ;;
  esac
done

say() { printf 'setup: %s\n' "$*" >&2; }

# Ends with what went wrong; the log's last lines say why.
die() {
  say "$*"
  if [[ -s $log ]]; then
    tail -n 15 "$log" | sed 's/^/  | /' >&2
    say "the whole log: $log"
  fi
  exit 3
}

# Runs a command with its output in the log.
logged() {
  printf '+ %s\n' "$*" >>"$log"
  "$@" </dev/null >>"$log" 2>&1
}

# shellcheck source=scripts/environments.sh
source "$root/scripts/environments.sh"

# ---- what is there ------------------------------------------------------------------------------------------------------------

libraries=""
has_library() {
  [[ $libraries ]] || libraries=$(PATH=$PATH:/sbin:/usr/sbin ldconfig -p 2>/dev/null || true)
  [[ $libraries == *$'\t'"$1 "* ]]
}

is_there() {
  local what=${1#*:} folder folders
  case $1 in
    cmd:*) type -P "$what" >/dev/null ;;
    lib:*) has_library "$what" ;;
    py:*) python3 -c "import $what" 2>/dev/null ;;
    glob:*) compgen -G "$what" >/dev/null ;;
    inc:*)
      IFS=: read -ra folders <<<"/usr/include:/usr/local/include:${CPLUS_INCLUDE_PATH:-}"
      for folder in "${folders[@]}"; do
        [[ -e $folder/$what ]] && return
      done
      return 1
      ;;
  esac
}

# Prints the packages of the given groups that are missing.
missing_packages() {
  local group probe package
  while read -r group probe package; do
    [[ " $* " == *" $group "* ]] || continue
    is_there "$probe" || printf '%s ' "$package"
  done <"$root/scripts/packages.txt"
}

has_solver() {
  local folder
  if [[ ${ORTOOLS_ROOT:-} ]]; then
    for folder in lib lib64 ortools/.libs .; do
      ! compgen -G "$ORTOOLS_ROOT/$folder/libortools.so*" >/dev/null || return 0
    done
    return 1
  else
    [[ -e $deps/ortools/ortools/.libs/libortools.so.9 && -e $deps/ortools-$ortools_version ]]
  fi
}

has_private_bpy() { has_environment bpy blender.txt; }

# A Blender of the user's own: the same places, in the same order, as the program looks at.
own_blender() {
  if [[ ${LAYOUTBOX_BLENDER:-} ]]; then
    printf '%s (LAYOUTBOX_BLENDER)' "$LAYOUTBOX_BLENDER"
  elif type -P blender >/dev/null; then
    type -P blender
  elif python3 -c 'import importlib.util, sys; sys.exit(importlib.util.find_spec("bpy") is None)' 2>/dev/null; then
    printf 'bpy of %s' "$(type -P python3)"
  else
    return 1
  fi
}

# The wheel wants Python 3.11 on x86_64; Debian 12 has that Python, newer systems do not.
bpy_fits() {
  [[ $(uname -m) == x86_64 ]] || return 1
  type -P python3.11 >/dev/null || grep -qs 'VERSION_CODENAME=bookworm' /etc/os-release
}

wants_blender() { [[ $mode != build ]]; }
wants_scale() { [[ $mode == scale || $mode == nightly ]]; }
wants_tests() { [[ $mode == tests || $mode == nightly ]]; }

has_python_tools() { has_environment tools tests.txt; }
has_mocks() {
  has_environment mocks-python mocks.txt && has_node && [[ -d $deps/mocks-node/node_modules ]] &&
    cmp -s "$deps/mocks-node/package-lock.json" "$root/tests/llm/mocks/package-lock.json"
}
has_gltf_validator() { [[ -d $deps/node/node_modules/gltf-validator ]] && cmp -s "$deps/node/package-lock.json" "$root/tests/tools/package-lock.json"; }
has_three() { [[ -d $deps/three/node_modules/three ]] && cmp -s "$deps/three/package-lock.json" "$root/tests/render/three/package-lock.json"; }

# ---- installing packages --------------------------------------------------------------------------------------------------------

apt_line() { printf 'sudo apt-get update && sudo apt-get install -y --no-install-recommends %s' "$*"; }

# Installs packages as root. Fails where it may not or cannot.
install_packages() {
  [[ $(id -u) == 0 ]] && type -P apt-get >/dev/null || return 1
  say "installing by apt-get: $*"
  # The list of packages may never have been read, or be too old to fetch from; a source that fails need not matter.
  logged apt-get update || true
  logged env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=600 install -y --no-install-recommends "$@"
}

require_packages() {
  local missing
  missing=$(missing_packages "$@")
  [[ $missing ]] || return 0
  # shellcheck disable=SC2086  # a list of words
  install_packages $missing && missing=$(missing_packages "$@")
  [[ $missing ]] || return 0
  if [[ $(id -u) != 0 ]] && type -P apt-get >/dev/null; then
    # One line for everything, what only pictures need included, so that it has to be asked for once.
    wants_blender && missing+=$(blender_packages)
    say "these packages are missing and only an administrator can install them. Run this, then the same command again:"
    say "  $(apt_line "${missing% }")"
    exit 3
  fi
  die "these packages are still missing (names of Debian 12): $missing"
}

# The packages that a Blender still needs.
blender_packages() {
  local packages
  packages=$(missing_packages picture sandbox)
  if ! own_blender >/dev/null; then
    if bpy_fits; then packages+=$(missing_packages bpy); else packages+="blender "; fi
  fi
  printf '%s' "$packages"
}

# ---- what is not a package --------------------------------------------------------------------------------------------------------

fetch_solver() {
  local machine folder=$deps/ortools-$ortools_version work
  machine=$(uname -m)
  if [[ ${ORTOOLS_ROOT:-} ]]; then
    die "ORTOOLS_ROOT=$ORTOOLS_ROOT has no libortools.so in lib/, lib64/ or ortools/.libs/; correct it or unset it"
  fi
  if [[ $machine != x86_64 ]]; then
    die "the solver library OR-Tools $ortools_version can be fetched for x86_64 only, this machine is $machine:" \
      "install OR-Tools' C++ release and set ORTOOLS_ROOT to its folder"
  fi
  say "fetching the solver library OR-Tools $ortools_version (30 MB)"
  work=$deps/ortools.part
  rm -rf "$work"
  mkdir "$work"
  make_environment "$work/pip" python3 || die "python3 could not make an environment for pip"
  logged "$work/pip/bin/python" -m pip download --disable-pip-version-check --no-input --no-deps --require-hashes --only-binary=:all: \
    --implementation cp --python-version 3.11 --platform manylinux_2_27_x86_64 --dest "$work" -r "$root/scripts/requirements/solver.txt" ||
    die "the solver library could not be fetched"
  logged "$work/pip/bin/python" -m zipfile -e "$work"/ortools-*.whl "$work/wheel" || die "the solver library's wheel could not be unpacked"
  # Of the wheel only the shared libraries are kept; they find each other by their relative places.
  mkdir -p "$work/kept/ortools"
  mv "$work/wheel/ortools/.libs" "$work/kept/ortools/.libs"
  mv "$work/wheel/ortools.libs" "$work"/wheel/ortools-*.dist-info/licenses "$work/kept/"
  logged python3 -c 'import ctypes, sys; ctypes.CDLL(sys.argv[1]).SolveCpInterruptible' "$work/kept/ortools/.libs/libortools.so.9" ||
    die "the solver library does not load on this machine"
  rm -rf "$folder"
  mv "$work/kept" "$folder"
  [[ -L $deps/ortools ]] || rm -rf "$deps/ortools"
  ln -sfn "ortools-$ortools_version" "$deps/ortools"
  rm -rf "$work"
}

# Blender as a Python module, without root. Fails where it cannot be had.
fetch_bpy() {
  local missing
  bpy_fits && type -P python3.11 >/dev/null || return 1
  missing=$(missing_packages bpy)
  # shellcheck disable=SC2086  # a list of words
  [[ ! $missing ]] || install_packages $missing || return 1
  say "fetching Blender $bpy_version as a Python module (370 MB; this takes a few minutes)"
  if make_environment "$deps/bpy" python3.11 && install_requirements "$deps/bpy" blender.txt && logged "$deps/bpy/bin/python" -c 'import bpy'; then
    return 0
  fi
  rm -rf "$deps/bpy" # rather none than half a one
  return 1
}

set_up_blender() {
  local missing
  missing=$(missing_packages picture sandbox)
  # shellcheck disable=SC2086  # a list of words
  [[ ! $missing ]] || install_packages $missing || true
  [[ ! $(missing_packages sandbox) ]] || say "code that a model wrote runs in a sandbox only: $(apt_line "$(missing_packages sandbox)")"
  if own_blender >/dev/null || has_private_bpy || fetch_bpy || install_packages blender; then
    [[ ! $(missing_packages picture) ]] || say "quick pictures (--quality draft) need OpenGL: $(apt_line "$(missing_packages picture)")"
    return 0
  fi
  say "no Blender could be had: pictures will be missing (--no-render leaves them out without a word); all else works."
  missing=$(blender_packages)
  [[ ! $missing ]] || say "to get pictures: $(apt_line "${missing% }") and then scripts/setup.sh again"
  return 1
}

fetch_test_tools() {
  if ! has_python_tools; then
    say "fetching the Python tools of the tests"
    if ! make_environment "$deps/tools" python3 || ! install_requirements "$deps/tools" tests.txt; then
      die "the Python tools of the tests could not be fetched"
    fi
  fi
  if ! has_gltf_validator; then
    say "fetching the official glTF validator"
    mkdir -p "$deps/node"
    cp "$root"/tests/tools/package*.json "$deps/node/"
    logged npm ci --prefix "$deps/node" --ignore-scripts --no-audit --no-fund || die "the glTF validator could not be fetched"
  fi
  if ! has_three; then
    say "fetching three.js"
    mkdir -p "$deps/three"
    cp "$root"/tests/render/three/package*.json "$deps/three/"
    logged npm ci --prefix "$(readlink -f "$deps/three")" --ignore-scripts --no-audit --no-fund || die "three.js could not be fetched"
  fi
  if ! has_mocks; then
    say "fetching mock servers of language models"
    if ! make_environment "$deps/mocks-python" python3 || ! install_requirements "$deps/mocks-python" mocks.txt; then
      die "the mock server llmock could not be fetched"
    fi
    has_node || fetch_node || die "Node.js for the mock server aimock could not be fetched"
    mkdir -p "$deps/mocks-node"
    cp "$root"/tests/llm/mocks/package*.json "$deps/mocks-node/"
    logged npm ci --prefix "$(readlink -f "$deps/mocks-node")" --ignore-scripts --no-audit --no-fund || die "the mock server aimock could not be fetched"
  fi
  # Only one test wants it, and its wheels fit one kind of machine.
  if ! has_environment store store.txt; then
    say "fetching a store of Amazon's form (moto)"
    if ! make_environment "$deps/store" python3 || ! install_requirements "$deps/store" store.txt; then
      say "it could not be fetched; what uploads to one is not tested"
    fi
  fi
}

fetch_scale() {
  has_environment scale scale.txt && return
  say "fetching Ray, submitit and PyArrow (170 MB)"
  if make_environment "$deps/scale" python3 && install_requirements "$deps/scale" scale.txt; then return; fi
  rm -rf "$deps/scale" # rather none than half a one
  [[ $mode == nightly ]] || die "Ray, submitit and PyArrow could not be fetched; their wheels are those of Python 3.11 on x86_64"
  say "they could not be fetched; scripts/scale/ is not tested"
}

# ---- the run ----------------------------------------------------------------------------------------------------------------------

groups=(build)
if wants_tests; then groups+=(tests); fi
if [[ $mode == nightly ]]; then groups+=(nightly); fi

fingerprint() {
  cat "$root"/scripts/{setup,environments}.sh "$root"/scripts/packages.txt "$root"/scripts/requirements/*.txt "$root"/tests/tools/package*.json "$root"/tests/render/three/package*.json "$root"/tests/llm/mocks/package*.json |
    cat - <(printf '%s\n' "$root" "${ORTOOLS_ROOT:-}" "${LAYOUTBOX_BLENDER:-}") | sha256sum | cut -d' ' -f1
}

# Everything that was set up is still there, and was set up from what is asked for now.
is_complete() {
  [[ -e $deps/$mode.stamp && $(<"$deps/$mode.stamp") == "$(fingerprint)" ]] || return 1
  [[ ! $(missing_packages "${groups[@]}") ]] && has_solver || return 1
  if wants_blender; then has_private_bpy || own_blender >/dev/null || return 1; fi
  [[ $mode != scale ]] || has_environment scale scale.txt || return 1
  ! wants_tests || { has_python_tools && has_gltf_validator && has_three && has_mocks; }
}

mkdir -p "$deps" "$root/build/logs"
exec 9>"$deps/.lock"
if ! flock -n 9; then
  say "another set-up is running; waiting for it"
  flock 9
fi
if [[ ! $force ]] && is_complete; then exit 0; fi
: >"$log"
if ! has_solver && [[ ! ${ORTOOLS_ROOT:-} ]]; then groups+=(fetch); fi
if wants_blender && ! own_blender >/dev/null && ! has_private_bpy && bpy_fits; then groups+=(fetch); fi
if wants_tests || wants_scale; then groups+=(fetch); fi
require_packages "${groups[@]}"
has_solver || fetch_solver
if wants_tests; then fetch_test_tools; fi
if wants_scale; then fetch_scale; fi
if [[ $later ]] && ! own_blender >/dev/null && ! has_private_bpy; then
  say "Blender $bpy_version (370 MB) is fetched while the program is compiled"
  exit 0
fi
if wants_blender && ! set_up_blender; then
  rm -f "$deps/$mode.stamp" # so that the next run looks again
  exit 0
fi
fingerprint >"$deps/$mode.stamp"
say "everything is in place"
