#!/usr/bin/env python3
"""Writes the terrains of the cases g318_site (one slope in fine and in coarse cells) and g318_field."""
import math
import os
import random

ABOVE_M = 10           # in plan, above the release
FOOT_M = 60            # flat
WIDTH_M = 50
ZONES = ((70.0, 73.0), (50.0, 200.0), (34.0, 300.0))  # degrees, metres along the slope
GULLY_PM = 0.01        # rises with the square of the distance from the axis
COARSE_M = 5
# Roughness: independent heights on square lattices, linear between their points: spacing and deviation [m].
OCTAVES = ((16, 0.40), (8, 0.25), (4, 0.15), (2, 0.10), (1, 0.06))

os.chdir(os.path.dirname(os.path.abspath(__file__)))


class Roughness:
    def __init__(self, octaves, seed):
        self.octaves = octaves
        self.chance = random.Random(seed)
        self.heights = {}

    def node(self, octave, i, j):
        return self.heights[(octave, i, j)]

    def fill(self, length_m, width_m):
        for octave, (spacing_m, deviation_m) in enumerate(self.octaves):
            for i in range(-1, math.ceil(length_m / spacing_m) + 2):
                for j in range(-1, math.ceil(width_m / spacing_m) + 2):
                    self.heights[(octave, i, j)] = self.chance.gauss(0.0, deviation_m)

    def at(self, x_m, y_m):
        sum_m = 0.0
        for octave, (spacing_m, _) in enumerate(self.octaves):
            i, j = math.floor(x_m / spacing_m), math.floor(y_m / spacing_m)
            u, v = x_m / spacing_m - i, y_m / spacing_m - j
            sum_m += ((1 - u) * (1 - v) * self.node(octave, i, j) + u * (1 - v) * self.node(octave, i + 1, j)
                      + (1 - u) * v * self.node(octave, i, j + 1) + u * v * self.node(octave, i + 1, j + 1))
        return sum_m


def write(name, heights, cell_m):
    """Rows from north to south."""
    with open(name, "w", encoding="ascii") as out:
        out.write(f"ncols {len(heights[0])}\nnrows {len(heights)}\nxllcorner {-ABOVE_M}\nyllcorner 0\n"
                  f"cellsize {cell_m}\n")
        for row in reversed(heights):
            out.write(" ".join(f"{z_m:.2f}" for z_m in row) + "\n")


def profile_m(x_m, zones):
    """Height over the foot, x from the release; the first zone goes on above it."""
    z_m, from_m = 0.0, sum(math.cos(math.radians(deg)) * length for deg, length in zones)
    for deg, length in reversed(zones):
        plan_m = math.cos(math.radians(deg)) * length
        z_m += math.tan(math.radians(deg)) * min(max(from_m - x_m, 0.0), plan_m)
        from_m -= plan_m
    return z_m + math.tan(math.radians(zones[0][0])) * max(-x_m, 0.0)


def site(zones, octaves, seed):
    plan_m = sum(math.cos(math.radians(deg)) * length for deg, length in zones)
    columns = COARSE_M * math.ceil((ABOVE_M + plan_m + FOOT_M) / COARSE_M)
    rough = Roughness(octaves, seed)
    rough.fill(columns, WIDTH_M)
    return [[profile_m(i + 0.5 - ABOVE_M, zones) + GULLY_PM * (j + 0.5 - 0.5 * WIDTH_M) ** 2
             + rough.at(i + 0.5, j + 0.5) for i in range(columns)] for j in range(WIDTH_M)]


def means(heights, cells):
    return [[sum(heights[j + b][i + a] for a in range(cells) for b in range(cells)) / cells ** 2
             for i in range(0, len(heights[0]), cells)] for j in range(0, len(heights), cells)]


fine = site(ZONES, OCTAVES, 318)
write("g318_site/fine.asc", fine, 1)
write("g318_site/coarse.asc", means(fine, COARSE_M), COARSE_M)
write("g318_field/gravel.asc", site(((34.0, 80.0),), OCTAVES[2:], 45), 1)
