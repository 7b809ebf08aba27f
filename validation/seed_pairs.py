#!/usr/bin/env python3
"""Do two seeds give the same answer, and do 90 % intervals hold what they say?

Runs the study of tests/runs/regime_study (four regimes, wind, snow, bark beetles) once for each seed, and prints

- verdicts by pairs of seeds. A pair contradicts itself where one page says that a regime keeps the protection asked
  for and the other that it does not, or where both name a cheapest regime, not the same one, and neither page calls
  the other's regime undecided or no dearer beyond chance.
- coverage: of the 90 % intervals of regimes_by_year.csv, over all seeds, regimes, climates, years and figures, the
  share that holds the mean of all other seeds' replicates (of 20 seeds 19 times as many). Intervals of no width or
  unknown, and figures that all seeds have at one value, are left out and counted.

    validation/seed_pairs.py --program build/release/bannwald --work /tmp/pairs [--pairs 10] [--replicates 16] ...

Finished runs in the folder are used again, so that the same call goes on after an interruption.
"""

import argparse
import collections
import csv
import json
import pathlib
import shutil
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent
STUDY = ROOT / "tests/runs/regime_study"


def cut_off(grid, first, end):
    """Sets all but the columns from the first to before the end to 0 and returns the values that are left."""
    lines = grid.read_text().splitlines()
    cut = [line if i < 6 else " ".join(cell if first <= k < end else "0" for k, cell in enumerate(line.split()))
           for i, line in enumerate(lines)]
    grid.write_text("\n".join(cut) + "\n")
    return {cell for line in cut[6:] for cell in line.split()}


def make_project(program, folder, columns):
    """The example's ground and climate with the inventory and regimes of the study; forest and sources in so many columns."""
    if not folder.exists():
        subprocess.run([program, "init", folder, "--example", "regimes-small"], check=True, capture_output=True)
        for file in STUDY.iterdir():
            shutil.copy(file, folder)
        if columns:
            kept = cut_off(folder / "stands.asc", *columns)
            cut_off(folder / "source.asc", 2 * columns[0], 2 * columns[1])  # cells of 5 m
            for name in ("stand_records.csv", "stand_dbh.csv", "stand_saplings.csv", "profile.csv"):
                rows = (folder / name).read_text().splitlines()
                named = [row for row in rows if not row.split(",")[0].isdigit() or row.split(",")[0] in kept]
                (folder / name).write_text("\n".join(named) + "\n")


def run(args, seed, out):
    if not (out / "summary.json").exists():
        settings = {"run.replicates": args.replicates, "run.years": args.years, "run.rockfall_every": args.every,
                    "release.rocks": args.rocks, "output.geopackage": "no", "output.living_trees_alone": "no", "output.map_years": "0", "output.tree_list_years": "0"}
        if args.diameters:  # no profile of effective stems is known for rocks of 2 m and more
            settings |= {"release.diameter_classes_m": args.diameters, "stands.target_profile": ""}
        if args.climates == 1:
            settings["climate.variants"] = ""
        command = [args.program, "run", args.work / "project" / "scenario.ini", "--out", out, "--seed", str(seed),
                   "--quiet"]
        for key, value in settings.items():
            command += ["--set", f"{key}={value}"]
        subprocess.run(command, check=True, capture_output=True)
        shutil.rmtree(out / "rasters", ignore_errors=True)
    return out


def table(out, name):
    with open(out / "tables" / name, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def verdict(out):
    """Regime -> keeps (yes, no, undecided) over all climates and targets, the cheapest that keeps, the page's words."""
    keeps, values = {}, collections.defaultdict(list)
    for row in table(out, "decision.csv"):
        keeps.setdefault(row["regime"], []).append(row["keeps"])
        values[row["regime"]].append(float(row["present_value_eur_pha"]))
    together = {regime: "no" if "no" in each else "yes" if set(each) == {"yes"} else "undecided"
                for regime, each in keeps.items()}
    keeping = [regime for regime, answer in together.items() if answer == "yes"]
    cheapest = max(keeping, key=lambda regime: sum(values[regime]), default=None)
    return together, cheapest, " ".join(json.loads((out / "summary.json").read_text())["verdict"])


def contradiction(one, other):
    for regime in one[0]:
        if {one[0][regime], other[0][regime]} == {"yes", "no"}:
            return f"{regime} keeps and does not keep"
    if one[1] and other[1] and one[1] != other[1]:
        for (keeps, _, words), named in ((one, other[1]), (other, one[1])):
            doubt = keeps[named] == "undecided" or (f"Regime {named} keeps it too; that it costs" in words)
            if doubt:
                return None
        return f"cheapest {one[1]} and {other[1]}"
    return None


def intervals(out):
    key = ("regime", "climate", "target_id", "quantity", "year")
    return {tuple(row[k] for k in key): row for row in table(out, "regimes_by_year.csv")}


def coverage(outs):
    held, all_of, left_out = collections.Counter(), collections.Counter(), 0
    tables = [intervals(out) for out in outs]
    for key in tables[0]:
        rows = [one[key] for one in tables if key in one]
        means = [float(row["mean"]) for row in rows]
        for row in rows:
            known = bool(row["mean_low_90"]) and float(row["mean_low_90"]) < float(row["mean_high_90"])
            if not known or len(rows) < len(tables) or max(means) == min(means):
                left_out += 1
                continue
            others = (sum(means) - float(row["mean"])) / (len(means) - 1)
            all_of[key[3]] += 1
            held[key[3]] += float(row["mean_low_90"]) <= others <= float(row["mean_high_90"])
    return held, all_of, left_out


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/bannwald")
    parser.add_argument("--work", type=pathlib.Path, required=True)
    parser.add_argument("--pairs", type=int, default=10)
    parser.add_argument("--replicates", type=int, default=20)
    parser.add_argument("--years", type=int, default=40)
    parser.add_argument("--every", type=int, default=1, help="years between two years with rocks")
    parser.add_argument("--rocks", type=int, default=250)
    parser.add_argument("--climates", type=int, default=2, choices=(1, 2))
    parser.add_argument("--columns", type=int, nargs=2, metavar=("FIRST", "END"),
                        help="columns of the stand map with forest and sources; none: all")
    parser.add_argument("--diameters", help="of the rocks, three classes in m, such as 2.0,2.4,2.8")
    args = parser.parse_args()
    args.program = args.program.resolve()
    args.work.mkdir(parents=True, exist_ok=True)
    make_project(args.program, args.work / "project", args.columns)

    outs = [run(args, 100 + k, args.work / f"seed_{k}") for k in range(2 * args.pairs)]
    verdicts = [verdict(out) for out in outs]
    contradictions = 0
    for k in range(args.pairs):
        one, other = verdicts[2 * k], verdicts[2 * k + 1]
        found = contradiction(one, other)
        contradictions += found is not None
        print(f"pair {k + 1}: cheapest {one[1]} / {other[1]}; "
              + ", ".join(f"{r} {one[0][r]} / {other[0][r]}" for r in one[0]) + f"; {found or 'no contradiction'}")
    print(f"{contradictions} of {args.pairs} pairs contradict themselves")

    held, all_of, left_out = coverage(outs)
    for quantity in sorted(all_of):
        print(f"{quantity}: {100.0 * held[quantity] / all_of[quantity]:.1f} % of {all_of[quantity]}")
    print(f"all: {100.0 * held.total() / all_of.total():.1f} % of {all_of.total()} intervals; {left_out} left out")


if __name__ == "__main__":
    main()
