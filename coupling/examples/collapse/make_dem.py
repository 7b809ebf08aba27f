#!/usr/bin/env python3
"""Writes dem.asc of this example: a SYNTHETIC cliff. Lengths in metres, x from the western edge eastward."""
import math

CELL, COLUMNS, ROWS = 5.0, 200, 124
WEST, SOUTH = 700000.0, 200000.0
FOOT_X = 180.0  # of the cliff, from the western edge

def ramp(x, x0, x1, z0, z1):
    t = min(1.0, max(0.0, (x - x0) / (x1 - x0)))
    return z0 + (z1 - z0) * t

def height(x, y):
    """Height at x (from the western edge) and y (from the southern one)."""
    along = y - 310.0
    top = 125.0 + 15.0 * math.cos(along / 75.0)          # height of the cliff: 110 to 140 m
    dip = 78.0 + 10.0 * math.sin(along / 47.0)            # 68 to 88 degrees
    foot_x = FOOT_X + 6.0 * math.sin(along / 61.0)
    edge_x = foot_x - top / math.tan(math.radians(dip))
    below = below_foot(max(0.0, x - foot_x))
    if x >= foot_x:
        gully = -6.0 * math.exp(-(along / 90.0) ** 2) * min(1.0, (x - foot_x) / 60.0)
        return below + gully
    if x <= edge_x:
        return 300.0 + top + 0.12 * (edge_x - x)          # plateau, rising to the west
    return ramp(x, foot_x, edge_x, 300.0, 300.0 + top)

def below_foot(d):
    """Scree of 30 degrees, an apron of 14, a valley floor of 4."""
    z = 300.0
    for length, slope in ((40.0, 30.0), (150.0, 14.0), (1e9, 4.0)):
        step = min(d, length)
        z -= step * math.tan(math.radians(slope))
        d -= step
    return z

with open('dem.asc', 'w') as out:
    out.write(f'ncols {COLUMNS}\nnrows {ROWS}\nxllcorner {WEST:.0f}\nyllcorner {SOUTH:.0f}\n'
              f'cellsize {CELL:.0f}\nNODATA_value -9999\n')
    for row in range(ROWS):
        y = (ROWS - 0.5 - row) * CELL
        out.write(' '.join(f'{height((c + 0.5) * CELL, y):.1f}' for c in range(COLUMNS)) + '\n')
