#!/bin/sh
# Writes the validation section of the README anew from the program's own output:
#   coupling/validation/update_readme.sh build/release/bannwald
# The program ends with 5 where a criterion is missed; that is no error here.
set -eu
bannwald=$1
root=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
code=0
"$bannwald" validate all --quiet --out "$folder/results" > /dev/null || code=$?
[ "$code" -eq 0 ] || [ "$code" -eq 5 ] || exit "$code"
awk -v summary="$folder/results/summary.md" '
    /<!-- end of summary.md -->/ { inside = 0 }
    !inside { print }
    /<!-- written by bannwald validate all: summary.md -->/ {
        inside = 1
        while ((getline line < summary) > 0) print line
    }' "$root/README.md" > "$folder/README.md"
cat "$folder/README.md" > "$root/README.md"
