# shellcheck shell=bash
# Private environments under build/deps/, Python's and Node.js's. Sourced by scripts that have $root, $deps and logged COMMAND….
: "${root:?}" "${deps:?}"

# One is whole when it holds the requirements it was made from.
has_environment() { [[ -x $deps/$1/bin/python ]] && cmp -s "$deps/$1/requirements.txt" "$root/scripts/requirements/$2"; }

make_environment() { # FOLDER PYTHON
  rm -rf "$1"
  logged "$2" -m venv "$1"
}

install_requirements() { # FOLDER REQUIREMENTS
  logged "$1/bin/python" -m pip install --disable-pip-version-check --no-input --no-compile --only-binary=:all: --require-hashes \
    -r "$root/scripts/requirements/$2" && cp "$root/scripts/requirements/$2" "$1/requirements.txt"
}

has_system_node() { [[ $(node --version 2>/dev/null) =~ ^v([0-9]+) ]] && ((BASH_REMATCH[1] >= 20)) && type -P npm >/dev/null; }

# Node.js 20 or later with npm: the system's, else a private one.
has_node() { has_system_node || has_environment nodejs nodejs.txt; }

fetch_node() { make_environment "$deps/nodejs" python3 && install_requirements "$deps/nodejs" nodejs.txt; }

# Puts the one that there is first on the PATH.
use_node() { has_system_node || PATH=$deps/nodejs/bin:$PATH; }
