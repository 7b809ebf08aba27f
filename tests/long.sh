#!/usr/bin/env bash
# The tests whose names begin with Long: large examples through archives, more surveys behind walls, cases of
# validation with many rocks, changed files of all cases. About 15 minutes.
#   bash tests/long.sh
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/bootstrap.sh"

install_missing "${packages[@]}"
rooms=(rockfall runs fuzz)
build release "${rooms[@]/%/_tests}" bannwald
failed=0
for room in "${rooms[@]}"; do
    "$root/build/release/tests/${room}_tests" --gtest_filter='Long*' || failed=1
done
exit $failed
