#!/usr/bin/env python3
"""Fits growth of the species to yield tables and to growth in inventories, both at once.

Drives the program itself: every trial writes copies of the cases with a species.csv of its own, runs
`bannwald validate` on them and reads figures.csv. Both cases hold pure stands, so each species has trial values of
its own in every run, and all species are searched at the same time.

Seen by the fit: volume, DBH, height and top height of validation/forest_yield at ages 40 to 100, how volume drifts
from 60 to 100 years, and growth of validation/forest_demography at the optimum. Not seen: ages above 100, the hot and the cold edge, mortality, and every
other case.

    validation/fit_growth.py --program build/release/bannwald --rounds 60 --write

Four numbers a species, as logarithms of factors: k_npp (wood), hd_low_a and hd_high_a (height at a diameter), and
vigour_half (production of tall and old trees), which is kept low: the ceiling of old forests rests on it.
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
OPTIMUM = "2"
# As all fits were made: growth alone, while which trees die by age and size is another question.
WITHOUT_DEATHS = ["forest.background_deaths=no", "forest.regeneration=no"]
# The greatest factor on vigour_half: spruce has to age before beech and fir.
MOST_VIGOUR = {"piab": 0.15, "fasy": 0.3, "lade": 0.45, "abal": 0.3, "acps": 0.1}


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
        trial = trials.get(row[0].lower())
        if trial:
            for column, log_factor in (("k_npp", trial["wood"]), ("hd_low_a", trial["height"] + trial["lit"]),
                                       ("hd_high_a", trial["height"] - trial["lit"]),
                                       ("vigour_half", trial["vigour"])):
                at = rows[0].index(column)
                row[at] = f"{float(row[at]) * math.exp(log_factor):.4g}"
    return rows


def keep_rows(path, wanted):
    """Leaves out the rows of a table of the case that `wanted` does not want."""
    kept, names = [], None
    for line in path.read_text(encoding="utf-8").splitlines():
        fields = next(csv.reader([line]), [])
        if line.startswith("#"):
            kept.append(line)
        elif names is None:
            names = fields
            kept.append(line)
        elif wanted(dict(zip(names, fields))):
            kept.append(line)
    path.write_text("\n".join(kept) + "\n", encoding="utf-8")


def figures_of(asked, case, species, settings, shorten):
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / "cases" / case
        shutil.copytree(ROOT / "validation" / case, copy)
        write_species(copy / "species.csv", *species)
        (copy / "criteria.csv").write_text("quantity,low,high,rests_on,rule,cause\n", encoding="utf-8")
        shorten(copy)
        out = pathlib.Path(folder) / "out"
        done = subprocess.run([asked.program, "validate", case, "--cases", str(copy.parent), "--quiet", "--out",
                               str(out), "--threads", str(asked.threads), *(f"--set={one}" for one in settings)],
                              capture_output=True, text=True, check=False)
        if not (out / "figures.csv").exists():
            raise SystemExit(done.stdout + done.stderr)
        with open(out / "figures.csv", encoding="utf-8") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return [(row["quantity"].split(":"), float(row["value"] or "nan")) for row in rows]


def simulated(asked, species, codes):
    """Ratios to the references by species: of the table, of top heights, of growth in inventories; and how volume
    drifts off its table from 60 to 100 years."""
    found = {code: {"table": [], "top": [], "inventory": [], "drift": []} for code in codes}
    volumes = {}
    for key, value in figures_of(asked, "forest_demography", species, [f"run.replicates={asked.seeds}"],
                                 lambda copy: keep_rows(copy / "sites.csv", lambda r: r["place"] == OPTIMUM)):
        if key[0] == "growth_ratio" and len(key) == 5 and key[1] in found:
            found[key[1]]["inventory"].append(value)
    for key, value in figures_of(asked, "forest_yield", species, WITHOUT_DEATHS,
                                 lambda copy: keep_rows(copy / "sites.csv", lambda r: r["regimes.list"] != "none")):
        code = key[1].split("_")[0] if len(key) == 3 else ""
        if code in found and key[2].isdigit() and YOUNGEST <= int(key[2]) <= OLDEST:
            if key[0] in ("volume_ratio", "dbh_ratio", "height_ratio"):
                found[code]["table"].append(value)
            if key[0] == "volume_ratio":
                volumes[key[1], int(key[2])] = value
            if key[0] == "top_height_ratio":
                found[code]["top"].append(value)
    for (site, age), value in volumes.items():
        if age == OLDEST and (site, 60) in volumes:
            found[site.split("_")[0]]["drift"].append(value / volumes[site, 60])
    return found


def miss(ratios, centre, half_width, free):
    """Mean miss beyond a share `free` of the range that the criteria allow, in logarithms."""
    if not ratios:
        return 0.0
    beyond = (max(0.0, abs(math.log(max(r, 0.02) / centre)) / half_width - free) for r in ratios)
    return sum(min(b ** 1.5, 5.0) for b in beyond) / len(ratios)


def loss(found, trial, of_drift):
    fifteen = math.log(1.15)
    value = 3.5 * miss(found["table"], 1.0, fifteen, 0.7) + 0.9 * miss(found["top"], 1.0, fifteen, 0.6)
    value += of_drift * miss(found["drift"], 1.0, fifteen, 0.2)
    value += 3.3 * miss(found["inventory"], math.sqrt(0.6 * 1.6), math.log(1.6 / 0.6) / 2, 0.8)
    value += 0.4 * max(0.0, trial["vigour"]) + 0.1 * abs(trial["height"]) + 0.05 * abs(trial["lit"])
    return value if found["table"] else value + 0.15 * abs(trial["wood"])


def next_trial(draw, trial, spread, last_step, code):
    """A trial near the best one: along the last step that helped, or in a drawn direction."""
    if last_step and draw.random() < 0.5:
        step = {name: size * draw.uniform(0.3, 1.5) for name, size in last_step.items()}
    else:
        step = {name: draw.gauss(0.0, size) if draw.random() < 0.6 else 0.0 for name, size in spread.items()}
    following = {name: trial[name] + step[name] for name in trial}
    following["lit"] = min(max(following["lit"], -0.4), 0.3)
    following["vigour"] = min(max(following["vigour"], -0.3), MOST_VIGOUR.get(code, 0.6))
    return following, step


def near(ratios, low, high):
    return f"{sum(low <= r <= high for r in ratios)}/{len(ratios)}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=str(ROOT / "build/release/bannwald"))
    parser.add_argument("--species", default="piab,abal,fasy,lade,pisy,acps,frex,bepe,qupe")
    parser.add_argument("--rounds", type=int, default=60)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--seeds", type=int, default=2, help="of forest_demography in a trial")
    parser.add_argument("--seed", type=int, default=1, help="of the search")
    parser.add_argument("--drift", type=float, default=1.2, help="weight of volume that drifts from 60 to 100 years")
    parser.add_argument("--write", action="store_true", help="writes config/data/species.csv")
    asked = parser.parse_args()
    codes = asked.species.split(",")
    comments, rows = read_species(SPECIES)
    draw = random.Random(asked.seed)
    best = {code: {"wood": 0.0, "height": 0.0, "lit": 0.0, "vigour": 0.0} for code in codes}
    spread = {code: {"wood": 0.04, "height": 0.05, "lit": 0.08, "vigour": 0.04} for code in codes}
    last_step = dict.fromkeys(codes)
    found = simulated(asked, (comments, changed(rows, best)), codes)
    least = {code: loss(found[code], best[code], asked.drift) for code in codes}
    for _ in range(asked.rounds):
        drawn = {code: next_trial(draw, best[code], spread[code], last_step[code], code) for code in codes}
        trials = {code: trial for code, (trial, _) in drawn.items()}
        tried = simulated(asked, (comments, changed(rows, trials)), codes)
        for code in codes:
            value = loss(tried[code], trials[code], asked.drift)
            helped = value < least[code]
            spread[code] = {name: size * (1.15 if helped else 0.95) for name, size in spread[code].items()}
            last_step[code] = drawn[code][1] if helped else None
            if helped:
                least[code], best[code], found[code] = value, trials[code], tried[code]
    for code in codes:
        print(f"{code}: within 15 % of the table {near(found[code]['table'], 0.85, 1.15)}, top heights "
              f"{near(found[code]['top'], 0.85, 1.15)}, inventories {near(found[code]['inventory'], 0.6, 1.6)}; " +
              ", ".join(f"{name} x{math.exp(size):.3f}" for name, size in best[code].items()))
    if asked.write:
        write_species(SPECIES, comments, changed(rows, best))


if __name__ == "__main__":
    main()
