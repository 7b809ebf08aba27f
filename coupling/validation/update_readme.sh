#!/bin/sh
# Writes the tables of verdicts into README.md (one row a case) and validation/README.md (all figures), from
# the program's own output:
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

# replace NAME FILE: puts the result NAME between the lines of FILE that name it.
replace() {
    awk -v name="$1" -v source="$folder/results/$1" '
        $0 == "<!-- end of " name " -->" { inside = 0 }
        !inside { print }
        $0 == "<!-- written by bannwald validate all: " name " -->" {
            inside = 1
            while ((getline line < source) > 0) print line
        }' "$2" > "$folder/README.md"
    cat "$folder/README.md" > "$2"
}
replace overview.md "$root/README.md"
replace summary.md "$root/validation/README.md"
