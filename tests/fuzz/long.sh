#!/usr/bin/env bash
# Changes the inputs of every reader at random, under the address and undefined-behaviour sanitizers.
#   bash tests/fuzz/long.sh [INPUTS [SEED]]     INPUTS in all (100000), shared evenly among the files; SEED: 1
# Prints the figures by file, worst last. A failure says how to repeat it. Takes about half an hour on two cores.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../bootstrap.sh"

inputs=${1:-100000}
seed=${2:-1}
install_missing "${packages[@]}"
build sanitize fuzz_tests
program="$root/build/sanitize/tests/fuzz_tests"
logs=$(mktemp -d)
trap 'rm -rf "$logs"' EXIT

"$program" --gtest_list_tests --gtest_filter='*EveryReader*' | sed -n 's/^  \([^ ]*\).*/\1/p' >"$logs/names"
files=$(wc -l <"$logs/names")
export BANNWALD_FUZZ_SEED=$seed
export BANNWALD_FUZZ_INPUTS=$(((inputs + files - 1) / files))
export BANNWALD_FUZZ_FIRST=0
export BANNWALD_FUZZ_FIGURES="$logs/figures.csv"

# Each file in a process of its own: one that ends its process takes no other along.
change_share() {
    local failed=0 name
    while read -r name; do
        "$program" --gtest_filter="*Fuzz/EveryReader.$name" --gtest_brief=1 >"$logs/out.$1" 2>&1 || {
            failed=1
            cat "$logs/out.$1" >&2
        }
    done < <(awk -v n="$2" -v i="$1" 'NR % n == i' "$logs/names")
    return $failed
}

shares=$(nproc)
processes=()
for ((share = 0; share < shares; ++share)); do
    change_share "$share" "$shares" &
    processes+=($!)
done
failed=0
for process in "${processes[@]}"; do
    wait "$process" || failed=1
done
echo "file, inputs, refused, longest [s of CPU], memory at most [MB]"
sort -t, -k4,4n "$logs/figures.csv"
awk -F, '{n += $2; r += $3; if ($4 > t) t = $4; if ($5 > m) m = $5}
    END {printf "all: %d files, %d inputs, %d refused, longest %.2f s, memory at most %.0f MB\n", NR, n, r, t, m}' \
    "$logs/figures.csv"
exit $failed
