#!/usr/bin/env python3
"""Simulation-based calibration of `bannwald calibrate`.

Draws true parameters from the widths, lets rocks fall by them, observes some stops and scars, calibrates, and counts how
often the 90 % interval of each parameter holds the truth. A search that is honest about what it does not know holds 90 %.

  validation/calibration_coverage.py BANNWALD SCENARIO --truths 50 [--stops 60] [--scars 40] [--threads 2] [--folder DIR]

SCENARIO: a static scenario without [observed], with enough rocks, such as that of `bannwald init DIR --example tyrol`.
All of it is synthetic but the terrain. Standard library only.
"""
import argparse
import csv
import json
import math
import pathlib
import random
import shutil
import subprocess


def run(words):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(done.stderr)


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def write(path, header, lines):
    with open(path, "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(header)
        writer.writerows(lines)


def components(program, scenario, folder):
    """Names and widths of what the site draws, as a run lists them."""
    run([program, "run", scenario, "--out", folder / "names", "--overwrite", "--quiet"])
    widths = {}
    for row in rows(folder / "names" / "tables" / "parameter_draws.csv"):
        widths[row["parameter"]] = float(row["width"])
    return widths


def truth_of(widths, chance):
    """Factors from the widths, cut off at three deviations as runs draw them."""
    factors = {}
    for name, width in widths.items():
        number = chance.gauss(0.0, 1.0)
        while abs(number) > 3.0:
            number = chance.gauss(0.0, 1.0)
        factors[name] = math.exp(width * number)
    return factors


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("scenario", type=pathlib.Path)
    parser.add_argument("--truths", type=int, default=50)
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--stops", type=int, default=60)
    parser.add_argument("--scars", type=int, default=40)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--folder", type=pathlib.Path, default=pathlib.Path("coverage"))
    parser.add_argument("--set", action="append", default=[], help="section.key=value for the calibration")
    given = parser.parse_args()
    folder = given.folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    widths = components(given.program, given.scenario, folder)
    inside = {name: 0 for name in widths}
    learned = {name: 0.0 for name in widths}
    held_out = 0
    calibrated = 0
    for number in range(given.first, given.first + given.truths):
        chance = random.Random(number)
        truth = truth_of(widths, chance)
        write(folder / "truth.csv", ["set", "weight", *truth], [[1, 1, *truth.values()]])
        run([given.program, "run", given.scenario, "--out", folder / "truth", "--overwrite", "--quiet", "--seed",
             1000 + number, "--threads", given.threads, "--set", "run.parameter_draws=no", "--set",
             f"run.parameters={folder / 'truth.csv'}", "--set", "output.geopackage=no"])
        tables = folder / "truth" / "tables"
        stopped = [row for row in rows(tables / "rocks.csv")
                   if row["cover"] == "forest" and row["stop_reason"] != "left_terrain"]
        write(folder / "stops.csv", ["x_m", "y_m"],
              [[row["x_end_m"], row["y_end_m"]] for row in chance.sample(stopped, given.stops)])
        words = ["--set", f"observed.stops={folder / 'stops.csv'}"]
        if given.scars > 0:
            write(folder / "scars.csv", ["height_m"],
                  [[row["height_m"]] for row in chance.sample(rows(tables / "tree_hits.csv"), given.scars)])
            words += ["--set", f"observed.scars={folder / 'scars.csv'}"]
        for setting in given.set:
            words += ["--set", setting]
        run([given.program, "calibrate", given.scenario, "--out", folder / "calibration", "--overwrite", "--quiet",
             "--threads", given.threads, "--seed", number, *words])
        summary = json.loads((folder / "calibration" / "summary.json").read_text())
        calibrated += summary["calibrated"]
        held_out += summary["held_out_as_far"] >= 0.05
        for row in summary["parameters"]:
            name = row["parameter"]
            inside[name] += row["factor_p05"] <= truth[name] <= row["factor_p95"]
            learned[name] += row["learned"] / given.truths
        done = number - given.first + 1
        print(f"{done} truths: {summary['search']['tried']} sets, "
              + ", ".join(f"{name} {inside[name]}" for name in inside), flush=True)
    print(f"\n| parameter | truths inside 90 % of {given.truths} | learned, mean |\n|---|--:|--:|")
    for name in widths:
        print(f"| {name} | {inside[name]} ({100 * inside[name] / given.truths:.0f} %) | {100 * learned[name]:.0f} % |")
    print(f"\nCalibrated by the program's own word: {calibrated} of {given.truths}; "
          f"held out within 95 % of samples: {held_out}.")
    shutil.rmtree(folder / "truth", ignore_errors=True)


if __name__ == "__main__":
    main()
