#!/usr/bin/env bash
# What takes too long for every change: a full build by clang, everything under the address and undefined-behaviour sanitizers,
# unit tests under the thread sanitizer, long random runs, coverage. Ends like scripts/test.sh with one line of counts.
set -uo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." || exit 3
# shellcheck source=scripts/counting.sh
source scripts/counting.sh

coverage() {
  gcovr --root . --filter src/layoutbox/ --exclude '.*_test\.cc' --object-directory build/coverage --html-details build/coverage/report.html \
    --print-summary
}

if step set-up scripts/setup.sh --nightly; then
  if step build-clang scripts/build.sh --preset clang --tests; then cases clang build/clang; fi
  if step build-sanitized scripts/build.sh --preset debug --tests; then cases sanitized build/debug; fi
  if step build-thread scripts/build.sh --preset thread --tests; then cases thread build/thread -L unit; fi
  if step build scripts/build.sh --tests; then
    # Random tests: a hundred times as many cases as in test.sh, from other seeds (each prints its own).
    for round in 1 2 3; do
      RC_PARAMS="max_success=10000 seed=$RANDOM$RANDOM" LAYOUTBOX_RANDOM_ROUNDS=10000 LAYOUTBOX_RANDOM_SEED=$RANDOM$RANDOM \
        cases "random-$round" build/release -L unit -R '(?i)random|property'
    done
  fi
  if step build-coverage scripts/build.sh --preset coverage --tests; then
    cases covered build/coverage
    step coverage coverage && tail -n 3 build/logs/test-coverage.log
  fi
fi
finished=1
