#!/usr/bin/env python3
"""Fits ground types to where rocks were seen to go: r_t of config/data/surfaces.csv.

Drives the program itself: every trial runs `bannwald validate` on copies of the cases with the values of the trial
as settings (`--set ground.NAME.r_t=...`) and reads verdicts.csv. r_n and the stopping probabilities stay as they are.

Seen by the fit: the figures that criteria.csv of a case marks `fitted` or `rebuilding`. Not seen: those marked
`independent`, among them the largest speeds and heights, numbers of impacts, and Tschamut 2014 block by block.
Steg and Tschamut share pasture and are fitted together; no other ground type lies in two cases.

A figure costs by its distance from the middle of its criterion, strongly near the ends; leaving the published r_t
costs, too, so that a ground type which its cases do not ask for stays published.

    validation/fit_grounds.py --program build/release/bannwald --trials 150 --from-published [--write]

Vaujany's values are not the only ones that serve: seven grounds answer to ten figures there, and other seeds end
elsewhere, at a higher cost.
"""

import argparse
import csv
import math
import pathlib
import random
import shutil
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
SURFACES = ROOT / "config/data/surfaces.csv"
# The ground types of each site and the cases that judge them.
SITES = {
    "Vaujany without forest": (["fine_debris", "coarse_debris", "fine_debris_and_soil"], ["vaujany_open"]),
    "Vaujany with forest": (
        ["fine_debris_forest", "soil_with_debris", "forest_soil", "forest_soil_woody_debris"], ["vaujany_forest"]),
    "Bad Ischl": (["solid_rock", "forest_soil_shallow"], ["bad_ischl"]),
    "Steg and Tschamut 2014": (["pasture", "pasture_wet"], ["steg", "tschamut2014"]),
}
SMALLEST_RT, LARGEST_RT = -0.08, 0.13  # change of r_t
# What leaving the published values costs. Pasture is held more loosely: two sites of their own kind, a large rock and
# small blocks, both ask for far more than the published 0.80, and held as the others are it meets neither.
PULL, LOOSE_PULL = 0.5, 0.15
LOOSE = {"pasture", "pasture_wet"}
RT_SCALE = 0.025  # a change that costs as much


def read_surfaces():
    lines = SURFACES.read_text(encoding="utf-8").splitlines()
    comments = [line for line in lines if line.startswith("#")]
    return comments, list(csv.reader(line for line in lines if not line.startswith("#")))


def published_rt():
    _, rows = read_surfaces()
    head = rows[0]
    return {row[0]: float(row[head.index("r_t_published")]) for row in rows[2:]}


def shipped_values():
    _, rows = read_surfaces()
    head = rows[0]
    return {row[0]: float(row[head.index("r_t")]) for row in rows[2:]}


def copy_cases(folder, cases):
    """The cases without what stands beside the default, which would only take time."""
    for case in cases:
        shutil.copytree(ROOT / "validation" / case, folder / case)
        for beside in ("choices.csv", "variants.csv"):
            (folder / case / beside).unlink(missing_ok=True)


def verdicts(program, folder, cases, values, rocks, settings=()):
    """Rows of verdicts.csv for a trial."""
    out = folder / "out"
    shutil.rmtree(out, ignore_errors=True)
    command = [program, "validate", *cases, "--cases", str(folder), "--out", str(out), "--quiet",
               "--rocks", str(rocks)]
    for ground, r_t in values.items():
        command += ["--set", f"ground.{ground}.r_t={r_t:.3f}"]
    for setting in settings:
        command += ["--set", setting]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode not in (0, 5):
        raise SystemExit(f"{' '.join(command)}\n{run.stderr}")
    with open(out / "verdicts.csv", encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def cost_of(rows, values, published):
    cost = 0.0
    for row in rows:
        if row["rests_on"] not in ("fitted", "rebuilding"):
            continue
        low, high = float(row["low"]), float(row["high"])
        value = float(row["default"]) if row["default"] else math.inf
        distance = min(abs(value - 0.5 * (low + high)) / (0.5 * (high - low)), 9.0)
        if row["quantity"] == "ks":
            distance = value / high  # the smaller, the better
        cost += 0.1 * distance**2 + 3.0 * max(0.0, distance - 0.6)
    for ground, r_t in values.items():
        cost += (LOOSE_PULL if ground in LOOSE else PULL) * ((r_t - published[ground]) / RT_SCALE) ** 2
    return cost


def moved(values, published, width, chance):
    trial = {}
    for ground, r_t in values.items():
        change = r_t - published[ground] + chance.gauss(0.0, 0.03 * width)
        trial[ground] = round(published[ground] + min(max(change, SMALLEST_RT), LARGEST_RT), 3)
    return trial


def fit(program, folder, site, start, options):
    grounds, cases = SITES[site]
    published = published_rt()
    chance = random.Random(f"{options.seed} {site}")
    trials = options.trials

    def cost_with(values):
        return cost_of(verdicts(program, folder, cases, values, options.rocks, options.settings), values, published)

    best = {ground: start[ground] for ground in grounds}
    best_cost = cost_with(best)
    print(f"{site}: cost {best_cost:.3f} at the start", flush=True)
    for number in range(trials):
        trial = moved(best, published, 0.5 if number < trials / 2 else 0.2, chance)
        cost = cost_with(trial)
        if cost < best_cost:
            best, best_cost = trial, cost
            print(f"  {number + 1}: {cost:.3f} {trial}", flush=True)
    return best


def write(values):
    comments, rows = read_surfaces()
    head = rows[0]
    for row in rows[2:]:
        if row[0] in values:
            row[head.index("r_t")] = f"{values[row[0]]:.3f}".rstrip("0").ljust(4, "0")
    with open(SURFACES, "w", encoding="utf-8", newline="") as file:
        file.write("\n".join(comments) + "\n")
        csv.writer(file, lineterminator="\n").writerows(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default=str(ROOT / "build/release/bannwald"))
    parser.add_argument("--trials", type=int, default=150, help="for each site")
    parser.add_argument("--rocks", type=int, default=3000, help="of each trial, on the profiles")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--site", choices=list(SITES), help="one of the sites alone")
    parser.add_argument("--from-published", action="store_true", help="begin there; else with the shipped values")
    parser.add_argument("--set", dest="settings", action="append", default=[], metavar="section.key=value",
                        help="of all trials, to try another law: again for more")
    parser.add_argument("--write", action="store_true", help="put the result into config/data/surfaces.csv")
    options = parser.parse_args()
    published = published_rt()
    start = published if options.from_published else shipped_values()
    found = {}
    for site in [options.site] if options.site else list(SITES):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            copy_cases(folder, SITES[site][1])
            found |= fit(options.program, folder, site, start, options)
    print("ground,r_t")
    for ground, r_t in found.items():
        print(f"{ground},{r_t:.3f}")
    if options.write:
        write(found)


if __name__ == "__main__":
    main()
