#!/usr/bin/env python3
"""Dominant wavelengths that are hard to find, in exact rational arithmetic: writes dominant_wavelength_nasty.csv.

    python3 tests/data/nasty_colours.py > tests/data/dominant_wavelength_nasty.csv

Colours one rounding to 0.1 from the white, right above and beside it, at 1e-300 to 1e299, on the line of purples, on the
curve and beyond. The locus is that of src/color/cie1931.csv from 380 to 780 nm, linear in xy between its rows; where the curl at
the red end is met more than once the shortest wavelength counts.
"""
import math, os, random
from fractions import Fraction as F

random.seed(14)
here = os.path.dirname(os.path.abspath(__file__))
P = []
for line in open(os.path.join(here, "../../src/color/cie1931.csv")):
    cells = line.strip().split(",")
    if cells[0].isdigit() and 380 <= int(cells[0]) <= 780:
        x, y, z = (F(float(c)) for c in cells[1:])
        P.append((int(cells[0]), x / (x + y + z), y / (x + y + z)))


def meetings(points, dx, dy, xw, yw):
    """Where the ray from white meets a polyline: (wavelength, how often d goes into the way)."""
    for (l, a, b), (l2, a2, b2) in zip(points, points[1:]):
        from_, to = (a - xw) * dy - (b - yw) * dx, (a2 - xw) * dy - (b2 - yw) * dx
        if from_ == to or from_ * to > 0:
            continue
        s = from_ / (from_ - to)
        px, py = a + s * (a2 - a) - xw, b + s * (b2 - b) - yw
        reach = (px * dx + py * dy) / (dx * dx + dy * dy)
        if reach > 0:
            yield l + s * (l2 - l), reach


def number(v):
    try:
        return float(v)
    except OverflowError:
        return math.inf


def truth(row):
    x, y, xw, yw = map(F, row)
    dx, dy = x - xw, y - yw
    if dx == dy == 0:
        return "", "0", "0"
    for l, reach in meetings(P, dx, dy, xw, yw):
        return repr(number(l)), repr(number(1 / reach)), "0"
    (_, reach), = meetings([P[-1], P[0]], dx, dy, xw, yw)
    l = next(meetings(P, -dx, -dy, xw, yw))[0]
    return repr(-number(l)), repr(number(1 / reach)), "1"


rows = []
for w in [(0.3127, 0.3290), (1 / 3, 1 / 3), (0.4476, 0.4074), (0.31006, 0.31616)]:
    def at(x, y):
        rows.append((x, y, *w))
    for _ in range(40):
        a, r = random.uniform(0, 2 * math.pi), 10 ** random.uniform(-16, -1)
        at(w[0] + r * math.cos(a), w[1] + r * math.sin(a))
    for _ in range(10):
        at(w[0] + random.choice([0, 1, -1, 2]) * 2**-54, w[1] + random.choice([0, 1, -1, 3]) * 2**-54)
    for _ in range(20):
        at(random.choice([-1, 1]) * 10 ** random.uniform(-300, 299), random.choice([-1, 1]) * 10 ** random.uniform(-300, 299))
    for _ in range(20):
        t, (_, a, b), (_, c, d) = F(random.random()), P[-1], P[0]
        at(float(a + t * (c - a)), float(b + t * (d - b)))
    for _ in range(30):
        i, t, s = random.randrange(318), F(random.random()), random.choice([1, 1, 0.5, 1e-9, 1.5])
        (_, a, b), (_, c, d) = P[i], P[i + 1]
        at(w[0] + s * (float(a + t * (c - a)) - w[0]), w[1] + s * (float(b + t * (d - b)) - w[1]))
    for l in range(381, 699, 40):
        at(float(P[l - 380][1]), float(P[l - 380][2]))
    for x, y in [(w[0], 0.9), (w[0], -0.9), (0.9, w[1]), w, (-0.2, -0.3), (1e308, -1e308), (-1e308, 5e-324)]:
        at(x, y)

print("x,y,xw,yw,dominant_nm,purity,complementary")
for row in rows:
    print(",".join([*map(repr, row), *truth(row)]))
