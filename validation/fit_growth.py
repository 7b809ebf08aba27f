#!/usr/bin/env python3
"""Fits growth of the species to yield tables and to growth in inventories, both at once.

Drives the program itself: every trial writes copies of the cases with a species.csv of its own, runs
`bannwald validate` on them and reads figures.csv. Both cases hold pure stands, so each species has trial values of
its own in every run, and all species are searched at the same time. Each round moves every value a little, one after
the other, takes the figures as straight lines in the logarithms between, and goes where the loss of these lines is
least, within a radius that shrinks where the lines were wrong.

Seen by the fit: volume, DBH and height of validation/forest_yield at ages 40 to 100, of spruce, fir, beech, larch and
oak also at later ages, and growth of validation/forest_demography at the optimum. Not seen: later ages of pine, ash and
birch, top heights, the hot and the cold edge, mortality, and every other case.

    validation/fit_growth.py --program build/release/bannwald --rounds 3 --write

Four numbers a species, as logarithms of factors: k_npp (wood), hd_low_a and hd_high_a (height at a diameter), and
vigour_half (production of tall and old trees). Which species gets on top of which in mixed forests rests on them, too,
and those are no part of the fit: so k_npp of a species is pulled towards the mean change of all (--together), and all
towards where they were. Those of cembra pine and rowan, which have no data, change as pine and larch, and as maple and
birch on average.
"""

import argparse
import csv
import io
import math
import pathlib
import random
import shutil
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
SPECIES = ROOT / "config/data/species.csv"
YOUNGEST, OLDEST = 40, 100
SEEN_WHEN_OLD = {"piab", "abal", "fasy", "lade", "qupe"}
BY_ANALOGY = {"pice": ("pisy", "lade"), "soau": ("acps", "bepe")}
OPTIMUM = "2"
NUMBERS = ("wood", "height", "lit", "vigour")
STEPS = {"wood": -0.06, "height": -0.05, "lit": 0.06, "vigour": -0.08}
MOST_VIGOUR_HALF = 1.0  # it is a share


def read_species(path):
    lines = path.read_text(encoding="utf-8").splitlines()
    comments = [line for line in lines if line.startswith("#")]
    rows = list(csv.reader(line for line in lines if line and not line.startswith("#")))
    return comments, rows


def write_species(path, comments, rows):
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    path.write_text("\n".join(comments) + "\n" + text.getvalue(), encoding="utf-8")


def changed(rows, trials):
    """The table of species with the factors of a trial."""
    rows = [list(row) for row in rows]
    for row in rows[2:]:
        code = row[0].lower()
        if code in BY_ANALOGY:
            trial = dict.fromkeys(NUMBERS, 0.0)
            trial["wood"] = sum(trials[other]["wood"] for other in BY_ANALOGY[code]) / len(BY_ANALOGY[code])
        else:
            trial = trials[code]
        for column, log_factor in (("k_npp", trial["wood"]), ("hd_low_a", trial["height"] + trial["lit"]),
                                   ("hd_high_a", trial["height"] - trial["lit"]), ("vigour_half", trial["vigour"])):
            if log_factor:
                at = rows[0].index(column)
                row[at] = f"{float(row[at]) * math.exp(log_factor):.4g}"
    return rows


def keep_rows(path, wanted, other=None):
    """Leaves out the rows of a table of the case that `wanted` does not want; `other`: fields to replace."""
    kept, names = [], None
    for line in path.read_text(encoding="utf-8").splitlines():
        fields = next(csv.reader([line]), [])
        if line.startswith("#"):
            kept.append(line)
        elif names is None:
            names = fields
            kept.append(line)
        elif wanted(dict(zip(names, fields))):
            kept.append(",".join({**dict(zip(names, fields)), **(other or {})}.values()))
    path.write_text("\n".join(kept) + "\n", encoding="utf-8")


def figures_of(asked, case, species, shorten):
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / "cases" / case
        shutil.copytree(ROOT / "validation" / case, copy)
        write_species(copy / "species.csv", *species)
        (copy / "criteria.csv").write_text("quantity,low,high,rests_on,rule,cause\n", encoding="utf-8")
        shorten(copy)
        out = pathlib.Path(folder) / "out"
        done = subprocess.run([asked.program, "validate", case, "--cases", str(copy.parent), "--quiet", "--out",
                               str(out), "--threads", str(asked.threads), "--set=years.seeds=1"],
                              capture_output=True, text=True, check=False)
        if not (out / "figures.csv").exists():
            raise SystemExit(done.stdout + done.stderr)
        with open(out / "figures.csv", encoding="utf-8") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return [(row["quantity"].split(":"), float(row["value"] or "nan")) for row in rows]


def simulated(asked, species, codes):
    """Logarithms of the ratios to the references, by species, of tables and of inventories."""
    found = {code: {"table": {}, "inventory": {}} for code in codes}
    for key, value in figures_of(asked, "forest_demography", species,
                                 lambda copy: keep_rows(copy / "sites.csv", lambda r: r["place"] == OPTIMUM,
                                                        {"run.replicates": str(asked.replicates)})):
        if key[0] == "growth_ratio" and len(key) == 5:
            found[key[1]]["inventory"][tuple(key[3:])] = math.log(max(value, 0.02) if value == value else 0.02)
    for key, value in figures_of(asked, "forest_yield", species, lambda copy: None):
        if key[0] in ("volume_ratio", "dbh_ratio", "height_ratio") and len(key) == 3 and value > 0.0:
            found[key[1].split("_")[0]]["table"][key[0], key[1], int(key[2])] = math.log(value)
    return found


def is_seen(code, key):
    return YOUNGEST <= key[2] <= OLDEST or (code in SEEN_WHEN_OLD and key[2] > OLDEST)


def miss(log_ratio, half_width, free):
    """Miss beyond a share `free` of the range that the criteria allow, in logarithms."""
    return min(max(0.0, abs(log_ratio) / half_width - free) ** 1.5, 5.0)


def mean(values):
    values = list(values)
    return sum(values) / len(values) if values else 0.0


def loss(asked, code, found, trial, together):
    table = mean(miss(ratio, math.log(1.15), 0.75) for key, ratio in found["table"].items() if is_seen(code, key))
    inventory = mean(miss(ratio - math.log(math.sqrt(0.6 * 1.6)), math.log(1.6 / 0.6) / 2, 0.8)
                     for ratio in found["inventory"].values())
    return (3.5 * table + 3.3 * inventory + asked.together * max(0.0, abs(trial["wood"] - together) - 0.03) +
            0.5 * abs(trial["vigour"]) + 0.1 * abs(trial["height"]) + 0.05 * abs(trial["lit"]))


def along_lines(found, slopes, code, best, trial):
    return {part: {key: ratio + sum(slopes[code, part, key, name] * (trial[name] - best[name]) for name in NUMBERS)
                   for key, ratio in found[part].items()} for part in found}


def least_on_lines(draw, value_at, best, radius, most_vigour):
    """The trial with the least loss within a radius around the best one, by drawn steps that become smaller."""
    trial, least = dict(best), value_at(best)
    for step in range(1500):
        size = 0.5 * radius * 0.5 ** (step // 300)
        tried = {name: trial[name] + draw.gauss(0.0, size) if draw.random() < 0.7 else trial[name] for name in NUMBERS}
        tried = {name: min(max(tried[name], best[name] - radius), best[name] + radius) for name in NUMBERS}
        tried["lit"] = min(max(tried["lit"], -0.4), 0.4)
        tried["vigour"] = min(max(tried["vigour"], -0.4), most_vigour)
        value = value_at(tried)
        if value < least:
            trial, least = tried, value
    return trial


def near(log_ratios, low, high):
    ratios = list(log_ratios)
    return f"{sum(math.log(low) <= ratio <= math.log(high) for ratio in ratios)}/{len(ratios)}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=str(ROOT / "build/release/bannwald"))
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--replicates", type=int, default=3, help="of forest_demography in a trial")
    parser.add_argument("--seed", type=int, default=7, help="of the search")
    parser.add_argument("--together", type=float, default=1.2, help="pull of k_npp towards the mean change of all")
    parser.add_argument("--write", action="store_true", help="writes config/data/species.csv")
    asked = parser.parse_args()
    comments, rows = read_species(SPECIES)
    half = rows[0].index("vigour_half")
    most_vigour = {row[0].lower(): math.log(MOST_VIGOUR_HALF / float(row[half])) for row in rows[2:]}
    codes = [code for code in most_vigour if code not in BY_ANALOGY]
    draw = random.Random(asked.seed)
    best = {code: dict.fromkeys(NUMBERS, 0.0) for code in codes}
    for code in codes:
        best[code]["vigour"] = min(0.0, most_vigour[code])
    radius = dict.fromkeys(codes, 0.12)
    found = simulated(asked, (comments, changed(rows, best)), codes)
    for _ in range(asked.rounds):
        together = mean(best[code]["wood"] for code in codes)
        least = {code: loss(asked, code, found[code], best[code], together) for code in codes}
        slopes = {}
        for name in NUMBERS:
            moved = {code: {**best[code], name: best[code][name] + STEPS[name]} for code in codes}
            tried = simulated(asked, (comments, changed(rows, moved)), codes)
            for code in codes:
                for part in found[code]:
                    for key, ratio in found[code][part].items():
                        slopes[code, part, key, name] = (tried[code][part].get(key, ratio) - ratio) / STEPS[name]
        trials = {}
        for code in codes:
            def value_at(trial, code=code):
                lines = along_lines(found[code], slopes, code, best[code], trial)
                return loss(asked, code, lines, trial, together)
            trials[code] = least_on_lines(draw, value_at, best[code], radius[code], most_vigour[code])
        tried = simulated(asked, (comments, changed(rows, trials)), codes)
        for code in codes:
            helped = loss(asked, code, tried[code], trials[code], together) < least[code]
            radius[code] *= 1.1 if helped else 0.5
            if helped:
                best[code], found[code] = trials[code], tried[code]
    for code in codes:
        print(f"{code}: within 15 % of the table {near(found[code]['table'].values(), 0.85, 1.15)}, inventories "
              f"{near(found[code]['inventory'].values(), 0.6, 1.6)}; " +
              ", ".join(f"{name} x{math.exp(size):.3f}" for name, size in best[code].items()))
    if asked.write:
        write_species(SPECIES, comments, changed(rows, best))


if __name__ == "__main__":
    main()
