#!/usr/bin/env bash
# Sets up, builds and runs every test: unit tests, whole-program tests, and the checks of the sources. .ci/run adds clang-tidy.
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
lint_shell() { shellcheck -x layoutbox .ci/run scripts/*.sh; }

if step set-up scripts/setup.sh --tests; then
  step layers scripts/check_layers.py
  step format scripts/format.sh --check
  step lint-python lint_python
  step lint-shell lint_shell
  step page scripts/page.sh --check
  if step build scripts/build.sh --tests; then
    cases tests build/release
    if [[ $tidy ]]; then step clang-tidy scripts/tidy.sh --without-tests; fi
  fi
fi
finished=1
