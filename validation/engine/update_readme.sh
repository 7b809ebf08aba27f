#!/bin/sh
# Writes the tables of verdicts into README.md (one row a case) and validation/VERDICTS.md (all figures), from
# the program's own output:
#   validation/engine/update_readme.sh build/release/bannwald [CASE...]
# With cases only these are run, and what stands there of the others is kept. The program ends with 5 where a
# criterion is missed; that is no error here.
set -eu
bannwald=$1
shift
root=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
code=0
"$bannwald" validate "${@:-all}" --quiet --out "$folder/results" > /dev/null || code=$?
[ "$code" -eq 0 ] || [ "$code" -eq 5 ] || exit "$code"

# kept NAME FILE: what stands between the lines of FILE that name the result NAME.
kept() {
    awk -v name="$1" '
        $0 == "<!-- end of " name " -->" { inside = 0 }
        inside { print }
        $0 == "<!-- written by bannwald validate all: " name " -->" { inside = 1 }' "$2"
}

# merged NEW OLD MARK: the pieces of both, each from a line that begins with MARK and names a case, in the
# order of these lines; of a case in both that of NEW.
merged() {
    python3 - "$1" "$2" "$3" <<'PYTHON'
import re, sys
new, old, mark = sys.argv[1:]
def pieces(path):
    head, cases, name = [], {}, None
    for line in open(path, encoding="utf-8"):
        found = re.match(re.escape(mark) + r"([a-z0-9_]+)", line)
        name = found.group(1) if found else name
        (cases.setdefault(name, []) if name else head).append(line)
    return head, cases
head, cases = pieces(new)
cases = {**pieces(old)[1], **cases}
blocks = ["".join(cases[name]).rstrip("\n") for name in sorted(cases)]
print("".join(head) + ("\n\n" if mark == "**" else "\n").join(blocks))
PYTHON
}

# replace NAME FILE MARK: puts the result NAME between the lines of FILE that name it.
replace() {
    kept "$1" "$2" > "$folder/kept"
    merged "$folder/results/$1" "$folder/kept" "$3" > "$folder/merged"
    awk -v name="$1" -v source="$folder/merged" '
        $0 == "<!-- end of " name " -->" { inside = 0 }
        !inside { print }
        $0 == "<!-- written by bannwald validate all: " name " -->" {
            inside = 1
            while ((getline line < source) > 0) print line
        }' "$2" > "$folder/README.md"
    cat "$folder/README.md" > "$2"
}
replace overview.md "$root/README.md" "| ["
replace summary.md "$root/validation/VERDICTS.md" "**"
