#!/usr/bin/env bash
# Builds the studio's page from web/ into build/page/, where `layoutbox serve` finds it. Does nothing where it is there and nothing changed.
# `--check` also runs the type check and the unit tests of its sources.
# Fetches what is locked in web/package-lock.json, and a Node.js of its own where the system has none of version 20 or later.
set -euo pipefail

root=$(cd -P "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
page=$root/build/page
log=$root/build/logs/page.log
deps=$root/build/deps

say() { printf 'page: %s\n' "$*" >&2; }

die() {
  say "$*; the service runs without its page. The log: $log"
  tail -n 5 "$log" | sed 's/^/  | /' >&2
  exit 3
}

logged() { "$@" </dev/null >>"$log" 2>&1; }

is_fresh() {
  [[ -e $page/app.js ]] && [[ ! $(find "$root/web" "$root/schema" -path "$root/web/node_modules" -prune -o -newer "$page/app.js" -type f -print -quit) ]]
}

# shellcheck source=scripts/environments.sh
source "$root/scripts/environments.sh"

check=""
if [[ ${1:-} == --check ]]; then check=1; fi
if [[ ! $check ]] && is_fresh; then exit 0; fi
mkdir -p "$root/build/logs"
exec 9>"$root/build/.page.lock"
flock 9
if [[ ! $check ]] && is_fresh; then exit 0; fi
: >"$log"
if ! has_node; then
  say "fetching Node.js, which builds the page"
  fetch_node || die "Node.js could not be fetched"
fi
use_node
if ! cmp -s "$root/web/package-lock.json" "$root/web/node_modules/.locked"; then
  say "fetching what the page is built with (three.js, Preact, esbuild)"
  logged npm ci --prefix "$root/web" --ignore-scripts --no-audit --no-fund || die "the page's libraries could not be fetched"
  cp "$root/web/package-lock.json" "$root/web/node_modules/.locked"
fi
say "building the page"
cd "$root/web"
if [[ $check ]]; then
  npm run --silent check
  npm run --silent test
fi
logged npm run build -- --out "$page" || die "the page could not be built"
touch "$page/app.js"
