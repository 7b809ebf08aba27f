#!/bin/sh
# Counts the instructions of one ground impact by callgrind: the difference between 2000 rocks and none, over the number of
# impacts. Stable to a thousandth where times vary by a quarter. Fails where they are more than instructions.csv allows: who
# makes an impact dearer says so there, with the reason in the commit; who makes it cheaper writes the lower count.
#
#   tests/benchmarks/count_instructions.sh BUILD_FOLDER [COMPILER]
set -eu

folder=$(dirname "$0")
programs=${1:?usage: count_instructions.sh BUILD_FOLDER [COMPILER]}/tests/benchmarks
if ! command -v valgrind >/dev/null; then
    echo "valgrind is not installed: nothing was counted"
    exit 77
fi
recorded=$(sed -n 's/^# Counted with \(.*\)[.]$/\1/p' "$folder/instructions.csv")
if [ -n "${2:-}" ] && [ "$2" != "$recorded" ]; then
    echo "built by $2, counts are recorded for $recorded: nothing was counted"
    exit 77
fi
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

"$programs/benchmarks" --write "$work/terrain"

# Instructions of a run; its impacts go to a file. The C library is kept from choosing code by the processor.
instructions() {
    GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX512F,-AVX2,-ERMS,-FSRM \
        valgrind --tool=callgrind --callgrind-out-file=/dev/null \
        "$programs/impacts_counted" "$1" "$work/terrain" "$2" 2>&1 >"$work/impacts" |
        sed -n 's/.*Collected : //p'
}

status=0
for cover in bare forest pairs; do
    none=$(instructions "$cover" 0)
    all=$(instructions "$cover" 2000)
    impacts=$(cat "$work/impacts")
    allowed=$(sed -n "s/^$cover,//p" "$folder/instructions.csv")
    awk -v cover="$cover" -v count="$((all - none))" -v impacts="$impacts" -v allowed="$allowed" 'BEGIN {
        each = count / impacts
        verdict = each > 1.001 * allowed ? "MORE than recorded" : each < 0.999 * allowed ? "less: write it down" : "as recorded"
        printf "%s: %.1f instructions per impact (%d impacts), recorded %.1f: %s\n", cover, each, impacts, allowed, verdict
        exit each > 1.001 * allowed
    }' || status=1
done
exit $status
