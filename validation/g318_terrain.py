#!/usr/bin/env python3
"""Writes the five slopes of the case g318: 570 m long, a shallow gully, rough in cells of 4 m, a flat foot."""
import math
import os
import random

CELL_M = 4.0
ROWS = 20          # 80 m wide
ABOVE_M = 10.0     # slope above the release, in plan
LENGTH_M = 570.0   # along the slope, from the release to the foot
FOOT_M = 20.0
ROUGH_M = 0.15     # standard deviation of heights
GULLY_PM = 0.01    # rises with the square of the distance from the axis


os.chdir(os.path.dirname(os.path.abspath(__file__)))


def write(slope_deg):
    chance = random.Random(318)
    tangent = math.tan(math.radians(slope_deg))
    foot_m = LENGTH_M * math.cos(math.radians(slope_deg))
    columns = math.ceil((ABOVE_M + foot_m + FOOT_M) / CELL_M)
    with open(f"g318/slope_{slope_deg}.asc", "w", encoding="ascii") as out:
        out.write(f"ncols {columns}\nnrows {ROWS}\nxllcorner {-ABOVE_M:g}\nyllcorner 0\ncellsize {CELL_M:g}\n")
        for row in range(ROWS):
            y_m = (ROWS - row - 0.5) * CELL_M
            heights = []
            for column in range(columns):
                x_m = -ABOVE_M + (column + 0.5) * CELL_M
                z_m = tangent * max(0.0, foot_m - x_m) + GULLY_PM * (y_m - 0.5 * ROWS * CELL_M) ** 2
                heights.append(f"{z_m + chance.gauss(0.0, ROUGH_M):.2f}")
            out.write(" ".join(heights) + "\n")


for degrees in (30, 40, 50, 60, 70):
    write(degrees)
