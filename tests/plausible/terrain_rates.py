#!/usr/bin/env python3
"""How often the rules on heights see wrong terrains, and how often they stop real ones.

    tests/plausible/terrain_rates.py PROGRAM DEM.asc...

Each DEM is an ESRI ASCII grid of real ground. The script makes wrong terrains of its middle 300 x 300 cells,
runs `PROGRAM check` on each and prints a table: error, warning or missed. Needs numpy. The table in
coupling/inputs/plausible/terrain/README.md was made in this way.
"""

import collections
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

# What the rules say, as far as it names them (coupling/inputs/plausible/terrain).
SAYINGS = ("in all cells", "runs through", "exactly level", "straight stripes", "all neighbours", "out of the ground",
           "of their size from one cell", "steeper than", "closed hollows", "cells of", "heights from",
           "heights up to", "stand up by", "all heights")

SCENARIO = """[run]
seed = 1
[terrain]
dem = dem.asc
ground = fine_debris_and_soil
[release]
source_shapes = sources.csv
rocks_per_source = 1
diameter_kind = classes
diameter_classes_m = 0.5
diameter_shares = 100
"""


def read_grid(name):
    header = {}
    with open(name, encoding="ascii") as lines:
        while True:
            before = lines.tell()
            words = lines.readline().split()
            if len(words) != 2 or words[0][0].isdigit() or words[0][0] == "-":
                lines.seek(before)
                break
            header[words[0].lower()] = float(words[1])
        heights = np.array(lines.read().split(), float)
    heights = heights.reshape(int(header["nrows"]), int(header["ncols"]))
    heights[heights == header.get("nodata_value", -9999.0)] = np.nan
    rows, columns = heights.shape
    top, left = max(0, (rows - 300) // 2), max(0, (columns - 300) // 2)
    return heights[top:top + 300, left:left + 300], header["cellsize"]


def bilinear(heights, times):
    rows, columns = heights.shape
    row = np.clip((np.arange(rows * times) + 0.5) / times - 0.5, 0, rows - 1.000001)
    column = np.clip((np.arange(columns * times) + 0.5) / times - 0.5, 0, columns - 1.000001)
    r, c = row.astype(int), column.astype(int)
    down, right = (row - r)[:, None], (column - c)[None]
    corner = lambda i, j: heights[np.ix_(r + i, c + j)]
    return ((1 - down) * ((1 - right) * corner(0, 0) + right * corner(0, 1))
            + down * ((1 - right) * corner(1, 0) + right * corner(1, 1)))


def with_crowns(heights, cell, trees_per_ha=400, share=0.6):
    """Paraboloids of 8 to 30 m at random places of a part of the area."""
    random = np.random.default_rng(1)
    rows, columns = heights.shape
    surface = heights.copy()
    for _ in range(min(60000, int(trees_per_ha * rows * columns * cell * cell / 1e4))):
        x, y = random.uniform(0, columns * cell), random.uniform(0, rows * cell)
        height = random.uniform(8, 30)
        radius = 1.5 + 0.11 * height
        row, column = int(y / cell), int(x / cell)
        patch = np.sin(x / 60.0) + np.sin(y / 45.0 + 1.0)
        if patch < np.sqrt(2) * (1 - 2 * share) or np.isnan(heights[row, column]):
            continue
        reach = int(radius / cell) + 1
        r = np.arange(max(0, row - reach), min(rows, row + reach + 1))
        c = np.arange(max(0, column - reach), min(columns, column + reach + 1))
        away = ((((c + 0.5) * cell - x)[None] ** 2 + ((r + 0.5) * cell - y)[:, None] ** 2) / radius ** 2)
        top = np.where(away < 1, heights[row, column] + height * (1 - 0.5 * away), -np.inf)
        surface[np.ix_(r, c)] = np.fmax(surface[np.ix_(r, c)], top)
    surface[np.isnan(heights)] = np.nan
    return surface


def stripes(heights, period, size, axis):
    high = np.arange(heights.shape[axis]) // max(1, period // 2) % 2
    return heights + size * (high[:, None] if axis == 0 else high[None])


def waves(heights, period, size, degrees):
    rows, columns = np.mgrid[:heights.shape[0], :heights.shape[1]]
    angle = np.radians(degrees)
    return heights + size / 2 * np.sin(2 * np.pi * (columns * np.sin(angle) + rows * np.cos(angle)) / period)


def spiked(heights, size):
    random = np.random.default_rng(3)
    spikes = heights.copy()
    known = np.argwhere(~np.isnan(heights))
    chosen = known[random.choice(len(known), min(40, len(known) // 20), replace=False)]
    spikes[chosen[:, 0], chosen[:, 1]] += size
    return spikes


def nearest(heights, times):
    rows, columns = heights.shape
    row = np.minimum(np.arange(rows) // times * times + times // 2, rows - 1)
    column = np.minimum(np.arange(columns) // times * times + times // 2, columns - 1)
    return heights[np.ix_(row, column)]


def wrong_terrains(heights, cell):
    low, high = np.nanmin(heights), np.nanmax(heights)
    along, across = np.gradient(heights, cell)
    slope = np.arctan(np.hypot(across, along))
    aspect = np.arctan2(along, -across)
    light = np.sin(np.radians(45)) * (np.cos(slope) + np.sin(slope) * np.cos(np.radians(135) - aspect))
    speed = 22 * np.hypot(across, along) * np.random.default_rng(1).uniform(0.6, 1, heights.shape)
    yield "real ground", heights
    yield "feet", heights / 0.3048
    yield "decimetres", heights * 10
    yield "centimetres", heights * 100
    yield "crowns on 60 %", with_crowns(heights, cell)
    yield "crowns on 95 %", with_crowns(heights, cell, 700, 0.95)
    yield "nearest neighbour x 5", nearest(heights, 5)
    yield "nearest neighbour x 2", nearest(heights, 2)
    for step in (10, 5, 1):
        yield f"terraces of {step} m", np.round(heights / step) * step
    yield "stripes of 4 m, 4 cells", stripes(heights, 4, 4, 0)
    yield "stripes of 1 m, 2 cells", stripes(heights, 2, 1, 1)
    yield "stripes of 0.5 m, 4 cells", stripes(heights, 4, 0.5, 1)
    yield "stripes of 2 m, 16 cells", stripes(heights, 16, 2, 0)
    yield "waves of 2 m, 10 cells", waves(heights, 10, 2, 0)
    yield "waves of 4 m at 45 degrees", waves(heights, 6, 4, 45)
    yield "waves of 4 m at 20 degrees", waves(heights, 6, 4, 20)
    yield "40 spikes of 150 m", spiked(heights, 150)
    yield "40 pits of 150 m", spiked(heights, -150)
    yield "upside down", high + low - heights
    yield "hillshade", np.clip(np.round(255 * light), 1, 255)
    yield "heights in 8 bits", np.round((heights - low) / (high - low) * 255)
    yield "speeds", np.round(np.clip(speed, 0, 22), 2)
    yield "slopes in degrees", np.degrees(slope)
    yield "aspects", np.degrees(aspect) + 180


def verdict(program, folder, heights, cell):
    rows, columns = heights.shape
    known = np.argwhere(~np.isnan(heights))
    row, column = known[len(known) // 2]
    with open(folder / "dem.asc", "w", encoding="ascii") as out:
        out.write(f"ncols {columns}\nnrows {rows}\nxllcorner 1000\nyllcorner 2000\ncellsize {cell}\n"
                  "NODATA_value -99999\n")
        np.savetxt(out, np.where(np.isnan(heights), -99999, heights), fmt="%.4f")
    x, y = 1000 + (column + 0.5) * cell, 2000 + (rows - row - 0.5) * cell
    (folder / "sources.csv").write_text(f'zone,wkt\n1,"POINT ({x} {y})"\n', encoding="ascii")
    (folder / "scenario.ini").write_text(SCENARIO, encoding="ascii")
    run = subprocess.run([program, "check", folder / "scenario.ini"], capture_output=True, text=True, check=False)
    said = [line for line in (run.stdout + run.stderr).splitlines()
            if "dem.asc" in line and "found" in line and any(words in line for words in SAYINGS)]
    if not said:
        if run.returncode != 0:  # a refusal for another reason is no verdict on the heights
            sys.exit(f"{program} check ended with {run.returncode}:\n{run.stderr}")
        return "missed", ""
    return ("error" if run.returncode == 4 else "warning"), said[0]


def main():
    program, names = sys.argv[1], sys.argv[2:]
    counts = collections.defaultdict(collections.Counter)
    missed = collections.defaultdict(list)
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        for name in names:
            heights, cell = read_grid(name)
            grids = [(pathlib.Path(name).stem, heights, cell)]
            if 1.0 <= cell < 1.5:
                grids.append((pathlib.Path(name).stem + " at half the cell", bilinear(heights[:150, :150], 2), cell / 2))
            for label, grid, size in grids:
                for kind, wrong in wrong_terrains(grid, size):
                    seen, said = verdict(program, folder, wrong, size)
                    counts[kind][seen] += 1
                    if (seen == "missed") != (kind == "real ground"):
                        missed[kind].append(label + (": " + said if said else ""))
    print("| terrain | error | warning | nothing | which |\n|---|---|---|---|---|")
    for kind, count in counts.items():
        print(f"| {kind} | {count['error']} | {count['warning']} | {count['missed']} | {'; '.join(missed[kind])} |")


if __name__ == "__main__":
    main()
