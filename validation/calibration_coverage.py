#!/usr/bin/env python3
"""Simulation-based calibration of `bannwald calibrate`.

Draws true parameters from the widths, lets rocks fall by them, observes some stops and scars, calibrates, and counts how
often the 90 % interval of each parameter holds the truth. A search that is honest about what it does not know holds 90 %.

  validation/calibration_coverage.py BANNWALD SCENARIO --truths 50 [--stops 60] [--scars 40] [--trees 60] [--counted 300]
      [--outline 80] [--tracks 20] [--threads 2] [--folder DIR]

--trees N: N scars on the stems of a few plots, of an unknown number of rocks. --counted N: all scars there of N rocks.
--outline N: a hull around N stops, without the 5 % that a mapper leaves out. --tracks N: impacts of N rocks.

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

MOST_DEVIATIONS = 3.0  # inputs/parameters/correlated_draws.hpp


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
    """What the site draws, as a run lists it: width, the parameter that each one goes with ("": none) and how."""
    run([program, "run", scenario, "--out", folder / "names", "--overwrite", "--quiet"])
    parts = {}
    for row in rows(folder / "names" / "tables" / "parameter_draws.csv"):
        parts[row["parameter"]] = (float(row["width"]), row["goes_with"], float(row["correlation"]))
    return parts


def with_forest(rows_of_rocks):
    """Rows of rocks in the forest; of a scenario without one all of them."""
    return [row for row in rows_of_rocks if row["cover"] == "forest"] or rows_of_rocks


def truth_of(parts, chance):
    """Factors drawn together as runs draw them: standard numbers cut off at three, some of which go with others."""
    numbers = {}
    for name in parts:
        numbers[name] = chance.gauss(0.0, 1.0)
        while abs(numbers[name]) > MOST_DEVIATIONS:
            numbers[name] = chance.gauss(0.0, 1.0)
    factors = {}
    for name, (width, partner, correlation) in parts.items():
        number = numbers[name]
        if partner:
            number = correlation * numbers[partner] + math.sqrt(1.0 - correlation ** 2) * number
            number = max(-MOST_DEVIATIONS, min(MOST_DEVIATIONS, number))
        factors[name] = math.exp(width * number)
    return factors


def sources_of(scenario):
    """Centres of the cells that release rocks."""
    head, cells = {}, []
    for line in (scenario.parent / "source.asc").read_text().splitlines():
        words = line.split()
        if words and words[0][0].isalpha():
            head[words[0].lower()] = float(words[1])
        elif words:
            cells.append([float(word) for word in words])
    size = head["cellsize"]
    return [(head["xllcorner"] + (column + 0.5) * size, head["yllcorner"] + (len(cells) - row - 0.5) * size)
            for row, line in enumerate(cells) for column, value in enumerate(line) if value > 0]


def hull(points):
    """Corners of the convex hull, counter-clockwise (Andrew 1979)."""
    def half(points):
        corners = []
        for x, y in points:
            while len(corners) > 1:
                (ax, ay), (bx, by) = corners[-2:]
                if (bx - ax) * (y - ay) - (by - ay) * (x - ax) > 0:
                    break
                corners.pop()
            corners.append((x, y))
        return corners[:-1]
    points = sorted(points)
    return half(points) + half(points[::-1])


def write_outline(path, stops, sources):
    """Around stops: of the 5 % outside half lie beyond the far end, the others farthest from the middle of all."""
    reach = lambda stop: min(math.dist(stop, source) for source in sources)
    left_out = max(1, round(0.025 * len(stops)))
    stops = sorted(stops, key=reach)[:-left_out]
    middle = (sum(x for x, _ in stops) / len(stops), sum(y for _, y in stops) / len(stops))
    stops = sorted(stops, key=lambda stop: math.dist(stop, middle))[:-left_out]
    corners = hull(stops)
    corners.append(corners[0])
    text = ", ".join(f"{x:.2f} {y:.2f}" for x, y in corners)
    write(path, ["wkt"], [[f"POLYGON (({text}))"]])


def write_searched(path, scenario, hits, chance, scars):
    """Stems of plots of 30 m around some that were hit, with their scars: `scars` of them, or all."""
    stems = {row["tree_id"]: (float(row["x_m"]), float(row["y_m"])) for row in rows(scenario.parent / "trees.csv")}
    searched = set()
    while len(searched) < 400:
        middle = stems[chance.choice(hits)["tree_id"]]
        searched |= {tree for tree, place in stems.items() if math.dist(place, middle) < 30.0}
    found = [row["tree_id"] for row in hits if row["tree_id"] in searched]
    found = chance.sample(found, min(scars, len(found))) if scars else found
    counts = {tree: 0 for tree in sorted(searched)}
    for tree in found:
        counts[tree] += 1
    write(path, ["x_m", "y_m", "scars"], [[*stems[tree], count] for tree, count in counts.items()])


def write_tracks(path, impacts, chance, tracks):
    """Impacts of some rocks; where a rock rolls, another track begins."""
    of_rock = {}
    for row in with_forest(impacts):
        of_rock.setdefault(row["rock"], []).append(row)
    lines = []
    for rock in chance.sample(sorted(of_rock), min(tracks, len(of_rock))):
        part = 0
        for row in of_rock[rock]:
            lines.append([row["x_m"], row["y_m"], f"{rock}.{part}", rock])
            part += row["onward"] != "jumps"
    write(path, ["x_m", "y_m", "track", "group"], lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("scenario", type=pathlib.Path)
    parser.add_argument("--truths", type=int, default=50)
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--stops", type=int, default=60)
    parser.add_argument("--scars", type=int, default=40)
    for kind in ("trees", "counted", "outline", "tracks"):
        parser.add_argument("--" + kind, type=int, default=0)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--folder", type=pathlib.Path, default=pathlib.Path("coverage"))
    parser.add_argument("--set", action="append", default=[], help="section.key=value for the calibration")
    given = parser.parse_args()
    folder = given.folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    widths = components(given.program, given.scenario, folder)
    if any(partner not in widths for _, partner, _ in widths.values() if partner):
        raise SystemExit("a parameter goes with one that is not drawn: parameter_draws.csv is not of this program")
    inside = {name: 0 for name in widths}
    learned = {name: 0.0 for name in widths}
    beyond_chance = {name: 0 for name in widths}
    held_out = 0
    calibrated = 0
    effective = []
    tried = []
    for number in range(given.first, given.first + given.truths):
        chance = random.Random(number)
        truth = truth_of(widths, chance)
        write(folder / "truth.csv", ["set", "weight", *truth], [[1, 1, *truth.values()]])
        run([given.program, "run", given.scenario, "--out", folder / "truth", "--overwrite", "--quiet", "--seed",
             1000 + number, "--threads", given.threads, "--set", "run.parameter_draws=no", "--set",
             f"run.parameters={folder / 'truth.csv'}", "--set", "output.geopackage=no", "--set",
             f"output.sample_paths={20 * given.tracks}", "--set",
             f"output.impact_table={'yes' if given.tracks else 'no'}"])
        tables = folder / "truth" / "tables"
        stopped = [row for row in with_forest(rows(tables / "rocks.csv")) if row["stop_reason"] != "left_terrain"]
        words = []
        if given.stops > 0:
            write(folder / "stops.csv", ["x_m", "y_m"],
                  [[row["x_end_m"], row["y_end_m"]] for row in chance.sample(stopped, given.stops)])
            words += ["--set", f"observed.stops={folder / 'stops.csv'}"]
        if given.scars > 0:
            write(folder / "scars.csv", ["height_m"],
                  [[row["height_m"]] for row in chance.sample(rows(tables / "tree_hits.csv"), given.scars)])
            words += ["--set", f"observed.scars={folder / 'scars.csv'}"]
        hits = [row for row in rows(tables / "tree_hits.csv")] if given.trees or given.counted else []
        if given.counted > 0:
            all_rocks = sorted({row["rock"] for row in with_forest(rows(tables / "rocks.csv"))})
            some = set(chance.sample(all_rocks, given.counted))
            hits = [row for row in hits if row["rock"] in some]
            words += ["--set", f"observed.rocks={given.counted}"]
        if hits:
            write_searched(folder / "searched.csv", given.scenario, hits, chance, given.trees)
            words += ["--set", f"observed.trees={folder / 'searched.csv'}"]
        if given.outline > 0:
            write_outline(folder / "outline.csv",
                          [(float(row["x_end_m"]), float(row["y_end_m"]))
                           for row in chance.sample(stopped, given.outline)],
                          sources_of(given.scenario))
            words += ["--set", f"observed.outline={folder / 'outline.csv'}", "--set",
                      f"calibrate.outline_blocks={given.outline}"]
        if given.tracks > 0:
            write_tracks(folder / "impacts.csv", rows(tables / "impacts.csv"), chance, given.tracks)
            words += ["--set", f"observed.impacts={folder / 'impacts.csv'}"]
        for setting in given.set:
            words += ["--set", setting]
        run([given.program, "calibrate", given.scenario, "--out", folder / "calibration", "--overwrite", "--quiet",
             "--threads", given.threads, "--seed", number, *words])
        summary = json.loads((folder / "calibration" / "summary.json").read_text())
        calibrated += summary["calibrated"]
        effective.append(summary["search"]["effective_sets"])
        tried.append(summary["search"]["tried"])
        held_out += summary["held_out_as_far"] is not None and summary["held_out_as_far"] >= 0.05
        for row in summary["parameters"]:
            name = row["parameter"]
            inside[name] += row["factor_p05"] <= truth[name] <= row["factor_p95"]
            learned[name] += row["learned"] / given.truths
            beyond_chance[name] += row["beyond_chance"]
        done = number - given.first + 1
        print(f"{done} truths: {tried[-1]} sets, worth {effective[-1]:.0f}, "
              + ", ".join(f"{name} {inside[name]}" for name in inside), flush=True)
    print(f"\n| parameter | truths inside 90 % of {given.truths} | learned, mean | learned beyond chance |\n"
          "|---|--:|--:|--:|")
    for name in widths:
        print(f"| {name} | {inside[name]} ({100 * inside[name] / given.truths:.0f} %) | {100 * learned[name]:.0f} % "
              f"| {beyond_chance[name]} |")
    print(f"\nCalibrated by the program's own word: {calibrated} of {given.truths}; "
          f"held out within 95 % of samples: {held_out}. Sets tried {sum(tried) / len(tried):.0f}, "
          f"effective {sum(effective) / len(effective):.0f} in the mean.")
    shutil.rmtree(folder / "truth", ignore_errors=True)


if __name__ == "__main__":
    main()
