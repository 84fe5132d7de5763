#!/usr/bin/env bash
# Builds the studio's page from web/ into build/page/, where `layoutbox serve` finds it. Does nothing where it is there and nothing changed.
# Fetches what is locked in web/package-lock.json, and a Node.js of its own where the system has none of version 18 or later.
set -euo pipefail

root=$(cd -P "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
page=$root/build/page
log=$root/build/logs/page.log
nodejs=$root/build/deps/nodejs

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

is_fresh && exit 0
mkdir -p "$root/build/logs"
exec 9>"$root/build/.page.lock"
flock 9
is_fresh && exit 0
: >"$log"
if ! [[ $(node --version 2>/dev/null) =~ ^v([0-9]+) ]] || ((BASH_REMATCH[1] < 18)) || ! type -P npm >/dev/null; then
  if [[ ! -x $nodejs/bin/node ]]; then
    say "fetching Node.js, which builds the page"
    logged python3 -m venv "$nodejs" || die "python3 could not make an environment for Node.js"
    logged "$nodejs/bin/python" -m pip install --disable-pip-version-check --no-input --only-binary=:all: --require-hashes \
      -r "$root/scripts/requirements/nodejs.txt" || die "Node.js could not be fetched"
  fi
  PATH=$nodejs/bin:$PATH
fi
if ! cmp -s "$root/web/package-lock.json" "$root/web/node_modules/.locked"; then
  say "fetching what the page is built with (three.js, Preact, esbuild)"
  logged npm ci --prefix "$root/web" --ignore-scripts --no-audit --no-fund || die "the page's libraries could not be fetched"
  cp "$root/web/package-lock.json" "$root/web/node_modules/.locked"
fi
say "building the page"
cd "$root/web"
logged npm run build -- --out "$page" || die "the page could not be built"
touch "$page/app.js"
