"""Orbits under q -> q^2 + c at 120 digits, for tests/data/julia_escape_nasty.csv: long stays near the boundary, where |q'| uses
up the digits of a number; bailouts from 2 to 10^6; points far away, tiny and on the axes.

    python3 julia_nasty.py > julia_escape_nasty.csv

Inputs are exactly the f64 printed. margin: the least | |q_k| - bailout | / bailout on the way.
"""
import random
from decimal import Decimal, getcontext

getcontext().prec = 120
random.seed(9)
SETS = [(0, 0, 0, 0), (-2, 0, 0, 0), (0.25, 0, 0, 0), (-0.75, 0.1, 0, 0), (-0.2, 0.6, 0.2, 0.2),
        (-1, 0.2, 0, 0), (-0.125, -0.256, 0.847, 0.0895), (0.0, 1.0, 0.0, 0.0), (-1.3, 0.3, -0.2, 0.4), (1.5, 1.5, 0, 0)]


def orbit(c, p, n, bailout):
    c = [Decimal(x) for x in c]
    q = [Decimal(x) for x in (*p, 0.0)]
    bailout, derivative, margin = Decimal(bailout), Decimal(1), Decimal(1)
    for k in range(n + 1):
        size = sum(x * x for x in q).sqrt()
        margin = min(margin, abs(size - bailout) / bailout)
        if size > bailout or k == n:
            return (k if size > bailout else -1), size, derivative, margin
        derivative *= 2 * size
        x, i, j, l = q
        q = [x * x - i * i - j * j - l * l + c[0], 2 * x * i + c[1], 2 * x * j + c[2], 2 * x * l + c[3]]


def near_boundary(c):
    """A point that stays long: bisection on a random line between one that stays and one that leaves."""
    out = [random.gauss(0, 1) for _ in range(3)]
    out = [x * 2.2 / sum(y * y for y in out) ** 0.5 for x in out]
    lo, hi = 0.0, 1.0
    for _ in range(random.choice([10, 20, 30, 40, 52])):
        mid = 0.5 * (lo + hi)
        if orbit(c, [x * mid for x in out], 60, 4.0)[0] < 0:
            lo = mid
        else:
            hi = mid
    return [x * hi for x in out]


def point(c, kind):
    if kind == "boundary":
        return near_boundary(c)
    if kind == "axis":
        p = [0.0, 0.0, 0.0]
        p[random.randrange(3)] = random.choice([0.0, 1.0, -1.0, 0.5, 2.0, 1.5])
        return p
    size = {"far": 10.0 ** random.uniform(1, 120), "tiny": 10.0 ** random.uniform(-200, -3), "any": 1.5}[kind]
    return [random.uniform(-size, size) for _ in range(3)]


print("c0,c1,c2,c3,px,py,pz,N,bailout,escaped,n_escape,qmag,dmag,de,margin")
for i in range(300):
    c = random.choice(SETS)
    kind = random.choice(["boundary"] * 6 + ["axis", "far", "tiny", "any"])
    p, n, bailout = point(c, kind), random.choice([0, 1, 5, 12, 40, 60, 100]), random.choice([2.5, 4.0, 16.0, 1e3, 1e6])
    k, size, derivative, margin = orbit(c, p, n, bailout)
    if kind != "axis" and margin < Decimal("1e-12") or derivative > Decimal("1e25"):
        continue   # 106 bits hold 31 digits
    de = repr(float(size * size.ln() / 2 / derivative)) if k >= 0 and derivative > 0 else ""
    row = [*map(float, c), *p, n, bailout, int(k >= 0), k, float(size), float(derivative), de, float(margin)]
    print(",".join(x if isinstance(x, str) else repr(x) for x in row))
