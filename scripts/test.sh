#!/usr/bin/env bash
# Sets up, builds and runs every test: unit tests (some of them by sanitizers too), whole-program tests, and the checks of the sources.
# .ci/run adds clang-tidy.
# Ends with one line, "N passed, N failed" (", N skipped"), and fails where anything failed. Logs are under build/logs/.
set -uo pipefail

usage() {
  cat <<'TEXT'
usage: scripts/test.sh [--tidy]
  --tidy   then clang-tidy over all sources but the tests' (scripts/tidy.sh; scripts/nightly.sh looks at these as well), five minutes more
TEXT
}

tidy=""
case ${1:-} in
  "") ;;
  --tidy) tidy=1 ;;
  -h | --help) usage && exit 0 ;;
  *) usage >&2 && exit 2 ;;
esac

cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." || exit 3
# shellcheck source=scripts/counting.sh
source scripts/counting.sh

lint_python() { build/deps/tools/bin/ruff check --quiet .; }
# All inputs of a fuzz target's corpus, and two seconds of what is made from them; what breaks it stays in build/debug/.
replay() { (cd build/debug && "fuzz/fuzz_replay_$1" "../../fuzz/corpus/$1" 2); }
lint_shell() { shellcheck -x layoutbox .ci/run scripts/*.sh; }

if step set-up scripts/setup.sh --tests; then
  step layers scripts/check_layers.py
  step format scripts/format.sh --check
  step lint-python lint_python
  step lint-shell lint_shell
  step page scripts/page.sh --check
  if step build scripts/build.sh --tests; then
    cases tests build/release
    # What is read from others again, under the address and undefined-behaviour sanitizers; scripts/nightly.sh does so with everything.
    if step build-sanitized scripts/build.sh --preset debug --tests {base,scene,chat}_test fuzz_replay_read_{scene,layout}; then
      for folder in base scene chat; do step "sanitized-$folder" "build/debug/src/layoutbox/${folder}_test"; done
      for reader in read_scene read_layout; do step "sanitized-$reader" replay "$reader"; done
    fi
    if [[ $tidy ]]; then step clang-tidy scripts/tidy.sh --without-tests; fi
  fi
fi
finished=1
