#!/bin/sh
# Prints the instructions of one ground impact, counted by callgrind: the difference between 3000 rocks and
# none, over the number of impacts. Stable to a thousandth where times vary by a quarter.
#
#   tests/benchmarks/count_instructions.sh BUILD_FOLDER
set -eu

programs=${1:?usage: count_instructions.sh BUILD_FOLDER}/tests/benchmarks
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

"$programs/benchmarks" --write "$work/terrain"

# Instructions and impacts of a run.
instructions() {
    valgrind --tool=callgrind --callgrind-out-file=/dev/null \
        "$programs/impacts_counted" "$1" "$work/terrain" "$2" 2>&1 >"$work/impacts" |
        sed -n 's/.*Collected : //p'
}

for cover in bare forest; do
    none=$(instructions "$cover" 0)
    all=$(instructions "$cover" 3000)
    impacts=$(cat "$work/impacts")
    echo "$cover: $(((all - none) / impacts)) instructions per impact ($impacts impacts)"
done
