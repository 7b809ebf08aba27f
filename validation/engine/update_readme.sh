#!/bin/sh
# Writes the tables of verdicts into README.md (one row a case), validation/VERDICTS.md (all figures, and which
# motion model meets what) and config/data/model_verdicts.csv (the latter, by case), from the program's own output:
#   validation/engine/update_readme.sh build/release/bannwald [CASE...]
#   validation/engine/update_readme.sh --from DIR
# With cases only these are run, and what stands there of the others is kept; DIR is what `bannwald validate CASE...
# --out DIR` has written, so that nothing runs twice. The program ends with 5 where a criterion is missed; that is
# no error here.
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
if [ "$1" = --from ]; then
    cp -r "$2" "$folder/results"
else
    bannwald=$1
    shift
    code=0
    "$bannwald" validate "${@:-all}" --quiet --out "$folder/results" > /dev/null || code=$?
    [ "$code" -eq 0 ] || [ "$code" -eq 5 ] || exit "$code"
fi

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
# Which motion model meets what: rows of the cases that were run replace those that stand in the shipped table.
python3 - "$folder/results/models.csv" "$root/config/data/model_verdicts.csv" "$root/validation/VERDICTS.md" \
    "$folder/results/overview.md" <<'PYTHON'
import csv, re, sys
new, shipped, page, overview = sys.argv[1:]
columns = ["case", "model", "quantity", "met", "missed", "independent_met", "independent_missed"]
run = set(re.findall(r"^\| \[([a-z0-9_]+)\]", open(overview, encoding="utf-8").read(), re.M))
text = open(shipped, encoding="utf-8").read().splitlines()
head = [line for line in text if line.startswith("#")]
kept = [row for row in csv.DictReader(line for line in text if not line.startswith("#")) if row["case"] not in run]
rows = kept + [{name: row[name] for name in columns} for row in csv.DictReader(open(new, encoding="utf-8"))]
rows.sort(key=lambda row: row["case"])  # within a case in the order of the program
with open(shipped, "w", encoding="utf-8") as out:
    print(*head, ",".join(columns), *(",".join(row[name] for name in columns) for row in rows), sep="\n", file=out)
models = ["picus", "pir3d", "classical", "rigid"]
quantities = ["stops", "spread", "sideways", "speed", "height", "energy", "rebounds"]
def total(model, quantity, column):
    return sum(int(row[column]) for row in rows if (row["model"], row["quantity"]) == (model, quantity))
def cell(model, quantity):
    met, missed = (total(model, quantity, name) for name in ("independent_met", "independent_missed"))
    others = total(model, quantity, "met") + total(model, quantity, "missed") - met - missed
    judged = f"{met} of {met + missed}" if met + missed else "not judged"
    return judged + (f" (and {total(model, quantity, 'met') - met} of {others})" if others else "")
table = ["| model | " + " | ".join(quantities) + " |", "|---" * (len(quantities) + 1) + "|"]
table += [f"| {model} | " + " | ".join(cell(model, one) for one in quantities) + " |" for model in models]
marks = ["<!-- written by bannwald validate all: models.csv -->", "<!-- end of models.csv -->"]
old = open(page, encoding="utf-8").read()
before, rest = old.split(marks[0])
open(page, "w", encoding="utf-8").write(
    before + "\n".join([marks[0], *table, marks[1]]) + rest.split(marks[1])[1])
PYTHON
replace overview.md "$root/README.md" "| ["
replace summary.md "$root/validation/VERDICTS.md" "**"
