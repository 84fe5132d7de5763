# Counting of checks and test cases, for test.sh and nightly.sh (sourced at the top of the repository). Whatever happens, the last line
# is "N passed, N failed", and the exit status is 1 where anything failed. Set finished=1 at the end.
# shellcheck shell=bash
logs=build/logs
mkdir -p "$logs"
export LAYOUTBOX_PYTHON=$PWD/build/deps/tools/bin/python # has what the outside scorer needs
export LSAN_OPTIONS="suppressions='$PWD/scripts/leaks.txt':print_suppressions=0"
passed=0 failed=0 skipped=0 finished="" running=""

finish() {
  if [[ $running ]]; then kill "$running" 2>/dev/null; fi
  if [[ ! $finished ]]; then
    echo "stopped before the end"
    ((failed += 1))
  fi
  local closing="$passed passed, $failed failed"
  if ((skipped)); then closing+=", $skipped skipped"; fi
  echo "$closing"
  ((failed == 0)) || exit 1
  exit 0
}
trap finish EXIT
trap 'exit 130' INT TERM HUP

# Runs a command with its output in a log; in the background, so that a signal ends this script at once.
into_log() { # LOG COMMAND…
  "${@:2}" </dev/null >"$1" 2>&1 &
  running=$!
  wait "$running"
  local status=$?
  running=""
  return "$status"
}

# step NAME COMMAND…: one check, its output in a log and shown where it fails.
step() {
  local name=$1 log=$logs/test-$1.log began=$SECONDS
  shift
  if into_log "$log" "$@"; then
    ((passed += 1))
    echo "ok    $name ($((SECONDS - began)) s)"
  else
    ((failed += 1))
    echo "FAIL  $name ($((SECONDS - began)) s)"
    tail -n 60 "$log" | sed 's/^/  | /'
    return 1
  fi
}

# cases NAME BUILD_FOLDER CTEST_OPTION…: the cases of CTest, each counted by itself.
cases() {
  local name=$1 build=$2 log=$logs/test-$1.log junit=$PWD/$logs/test-$1.xml began=$SECONDS counts
  shift 2
  rm -f "$junit"
  # Two more than there are cores: many cases wait for somebody who answers late.
  into_log "$log" ctest --test-dir "$build" --output-junit "$junit" --output-on-failure --no-tests=error -j "$(($(nproc) + 2))" "$@"
  if ! counts=$(python3 scripts/count_cases.py "$junit"); then
    ((failed += 1))
    echo "FAIL  $name: CTest ran nothing"
    tail -n 20 "$log" | sed 's/^/  | /'
    return
  fi
  local good bad left_out
  read -r good bad left_out <<<"$counts"
  ((passed += good, failed += bad, skipped += left_out))
  echo "$( ((bad)) && echo "FAIL " || echo "ok   ") $name: $good passed, $bad failed, $left_out skipped ($((SECONDS - began)) s)"
  python3 scripts/count_cases.py --explain "$junit"
}
