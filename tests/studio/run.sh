#!/usr/bin/env bash
# Runs one file of browser tests; 77 where there is no browser or no built page.
set -euo pipefail
root=$(cd -P "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.." && pwd)
deps=$root/build/deps
logged() { "$@"; }
# shellcheck source=scripts/environments.sh
source "$root/scripts/environments.sh"
use_node

skip() { echo "$*" && exit 77; }
[[ ${LAYOUTBOX_CHROMIUM:-} ]] || type -P chromium >/dev/null || type -P google-chrome >/dev/null || skip "there is no Chromium"
[[ -e $root/build/page/index.html && -d $root/web/node_modules/playwright-core ]] || skip "the page is not built: scripts/page.sh"
exec node --test "$@"
