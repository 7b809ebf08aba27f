#!/usr/bin/env bash
# Tests under the address and undefined-behaviour sanitizers.
#   bash tests/sanitize.sh [ROOM...]      ROOM: config, rockfall, forest, coupling, validation, fuzz, structure or runs; all of them by default
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/bootstrap.sh"

rooms=("$@")
if [ ${#rooms[@]} -eq 0 ]; then
    rooms=(config rockfall forest coupling validation refusals fuzz structure runs)
fi
install_missing "${packages[@]}"
build sanitize "${rooms[@]/%/_tests}"
# Whole published cases and figures of thousands of rocks take minutes under sanitizers; the other tests run all
# of their parts.
run_tests sanitize -R "^($(IFS='|'; echo "${rooms[*]}"))[.]" \
    -E 'ShippedCase|Validate\.(HoldsTheFigures|MovesSomething)|RunOutBehindAWall|CellsAndNoise|StopProbability|Plots|FollowsAGully|OfWheelsSpread|CubeSticksOnAPlane|ComesToRestFlatter|g318_case_trends|^Heaps'
