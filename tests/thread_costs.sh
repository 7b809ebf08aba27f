#!/usr/bin/env bash
# What a second thread costs a rock mass: the example collapse-small on one and on two threads.
#   bash tests/thread_costs.sh [PROGRAM] [OPTION OF COLLAPSE...]
# Prints CPU time of both, and fails above 1.2 times the time of one thread, or where the tables differ.
# It is no test of the suite: on a busy machine times vary. Repeat it where it fails.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
program=$(realpath "${1:-$root/build/release/bannwald}")
shift || true
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
"$program" init p --example collapse-small --quiet
# One warm-up, so that the first one does not pay for the reading of files.
"$program" collapse p/scenario.ini --quiet --out warm --threads 1 --set collapse.duration_s=0.5 "$@"
TIMEFORMAT='%U %S %R'
for threads in 1 2; do
    { time "$program" collapse p/scenario.ini --quiet --out "on_$threads" --threads "$threads" "$@" 2>messages; } 2>"times_$threads"
done
diff -r on_1/tables on_2/tables
awk 'FNR == NR { one = $1 + $2; next } {
    two = $1 + $2
    printf "CPU time: %.2f s on one thread, %.2f s on two (%.2f s of them in the kernel): %.2f times; at most 1.2\n",
        one, two, $2, two / one
    exit two > 1.2 * one
}' times_1 times_2
