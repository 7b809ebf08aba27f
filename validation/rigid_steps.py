#!/usr/bin/env python3
"""Do the stops of rigid blocks depend on the step of lasting contact?

Runs the nominal case of g318 (cubes on 40 degrees of debris) or another scenario once for each step of
`rigid.step_s`, with other seeds, and compares the distributions of run-outs: largest distance of the distribution
functions (Kolmogorov-Smirnov) beside what 5 % of samples of one distribution exceed, and means with two standard errors.

    validation/rigid_steps.py --program build/release/bannwald --work /tmp/steps [--rocks 400] [--steps 0.0005 0.001 0.002]

Finished runs in the folder are used again. Ends with 1 where a distance exceeds its bound.
"""

import argparse
import bisect
import csv
import pathlib
import statistics
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent


def run_outs(args, step, seed):
    out = args.work / f"step_{step:g}"
    if not (out / "summary.json").exists():
        settings = {"rigid.step_s": step, "run.seed": seed, "release.rocks": args.rocks, "output.rock_table": "yes"}
        command = [args.program, "run", args.scenario, "--out", out, "--overwrite", "--quiet"]
        for key, value in settings.items():
            command += ["--set", f"{key}={value}"]
        subprocess.run(command, check=True)
    with open(out / "tables" / "rocks.csv", newline="", encoding="utf-8") as file:
        return sorted(float(row["run_out_m"]) for row in csv.DictReader(line for line in file if line[0] != "#"))


def distance(a, b):
    """Largest distance of two empirical distribution functions."""
    return max(abs(bisect.bisect_right(a, x) / len(a) - bisect.bisect_right(b, x) / len(b)) for x in a + b)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=ROOT / "build/release/bannwald")
    parser.add_argument("--work", type=pathlib.Path, required=True)
    parser.add_argument("--scenario", default=ROOT / "validation/g318/scenario.ini")
    parser.add_argument("--rocks", type=int, default=400)
    parser.add_argument("--steps", type=float, nargs="+", default=[0.0005, 0.001, 0.002])
    args = parser.parse_args()
    args.work.mkdir(parents=True, exist_ok=True)
    found = {step: run_outs(args, step, 1000 + i) for i, step in enumerate(args.steps)}
    for step, ways in found.items():
        error = statistics.stdev(ways) / len(ways) ** 0.5
        print(f"step {1000 * step:g} ms: {len(ways)} blocks, mean run-out {statistics.fmean(ways):.1f} +- {2 * error:.1f} m, "
              f"median {statistics.median(ways):.1f} m")
    exceeded = False
    steps = list(found)
    for i, one in enumerate(steps):
        for other in steps[i + 1:]:
            n, m = len(found[one]), len(found[other])
            bound = 1.358 * ((n + m) / (n * m)) ** 0.5
            largest = distance(found[one], found[other])
            exceeded |= largest > bound
            print(f"{1000 * one:g} and {1000 * other:g} ms: distance {largest:.3f}, by chance {bound:.3f}")
    return 1 if exceeded else 0


if __name__ == "__main__":
    sys.exit(main())
