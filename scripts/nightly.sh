#!/usr/bin/env bash
# What takes too long for every change: a full build by clang, everything under the address and undefined-behaviour sanitizers,
# unit tests under the thread sanitizer, long random runs, fuzzing, coverage. Ends like scripts/test.sh with one line of counts.
set -uo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." || exit 3
# shellcheck source=scripts/counting.sh
source scripts/counting.sh

# Ten minutes of any bytes for each reader; what breaks it stays in build/fuzz/.
# shellcheck disable=SC2317  # step calls it
fuzz() {
  local target=$1 inputs=build/fuzz/inputs/$1
  mkdir -p "$inputs"
  build/fuzz/fuzz/fuzz_"$target" -max_total_time="${LAYOUTBOX_FUZZ_SECONDS:-600}" -timeout=20 -rss_limit_mb=4096 -artifact_prefix="build/fuzz/$target-" \
    "$inputs" fuzz/corpus/"$target"
}

coverage() {
  gcovr --root . --filter src/layoutbox/ --exclude '.*_test\.cc' --object-directory build/coverage --html-details build/coverage/report.html \
    --print-summary
}

if step set-up scripts/setup.sh --nightly; then
  if step build-clang scripts/build.sh --preset clang --tests; then cases clang build/clang; fi
  if step build-sanitized scripts/build.sh --preset debug --tests; then cases sanitized build/debug; fi
  if step build-thread scripts/build.sh --preset thread --tests; then cases thread build/thread -L unit; fi
  if step build scripts/build.sh --tests; then
    step clang-tidy scripts/tidy.sh
    # Many random rooms, from seeds that no other run has seen; each failure names its own.
    seed=$((RANDOM * 32768 + RANDOM))
    echo "random rooms from seed $seed on"
    LAYOUTBOX_RANDOM_SEED=$seed LAYOUTBOX_SEED=$seed LAYOUTBOX_RANDOM_ROUNDS=20000 cases random build/release -R 'Property|Parity' --timeout 7200
    LAYOUTBOX_ALL_ANSWERS=1 cases answers build/release -R test_right_answers --timeout 1800
    LAYOUTBOX_SOAK_SECONDS=600 LAYOUTBOX_REQUEST_SECONDS=300 cases service build/release -R 'serve\.test_(soak|any_request)' --timeout 1800
  fi
  if step build-fuzz scripts/build.sh --preset fuzz; then
    for source in fuzz/fuzz_*.cc; do
      target=$(basename "$source" .cc)
      step "${target/_/-}" fuzz "${target#fuzz_}"
    done
  fi
  if step build-coverage scripts/build.sh --preset coverage --tests; then
    cases covered build/coverage
    step coverage coverage && tail -n 3 build/logs/test-coverage.log
  fi
fi
finished=1
