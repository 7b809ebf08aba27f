#!/usr/bin/env bash
# The tests whose names begin with Long: large examples through archives, more surveys behind walls, cases of
# validation with many rocks, changed files of all cases, calibrations from one kind of observation, worst years of many
# stands. About 20 minutes.
#   bash tests/long.sh
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/bootstrap.sh"

install_missing "${packages[@]}"
mapfile -t rooms < <(cd "$root/tests" && grep -rlE --include="*.cpp" "\bLong[A-Z][A-Za-z]*," . |
    cut -d / -f 2 | sort -u)
if [ ${#rooms[@]} -eq 0 ]; then
    echo "no test has a name that begins with Long" >&2
    exit 1
fi
build release "${rooms[@]/%/_tests}" bannwald
failed=0
for room in "${rooms[@]}"; do
    "$root/build/release/tests/${room}_tests" --gtest_filter='Long*' || failed=1
done
exit $failed
