#!/usr/bin/env bash
# The whole suite again and again: other random input each time (rapidcheck), other order of the tests.
#   bash tests/repeat.sh [TIMES] [OPTION OF CTEST...]     20 times by default; a seed in RC_SEED is used for the first time
# Ends at the first failure and prints the seed with which it comes back.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/bootstrap.sh"

times=${1:-20}
if [ $# -gt 0 ]; then
    shift
fi
install_missing "${packages[@]}"
build release
log=$(mktemp)
trap 'rm -f "$log"' EXIT
for ((i = 1; i <= times; ++i)); do
    seed=${RC_SEED:-$(od -An -N4 -tu4 /dev/urandom | tr -d ' ')}
    unset RC_SEED
    echo "pass $i of $times, seed $seed" >&2
    if ! RC_PARAMS="seed=$seed" run_tests release --schedule-random "$@" >"$log" 2>&1; then
        cat "$log" >&2
        echo "failed in pass $i; repeat it with: RC_SEED=$seed bash tests/repeat.sh 1" >&2
        exit 1
    fi
    tail -n 3 "$log" >&2
done
echo "$times passes without a failure" >&2
