"""Positive crossings of rays with Menger sponges, in exact fractions: python3 ray_menger.py > ray_menger.csv

Every solid cell is cut with the ray's line by slabs; stretches longer than 0 are joined where they touch. `margin` is the
smallest difference, relative to the largest parameter, between two different parameters at which the ray meets planes of
cells; `cond` of a crossing is the size of origin, centre and edge over |d| t along the axis of its face.
"""
import random
from fractions import Fraction as F

random.seed(94)


def is_solid(cell, depth):
    for _ in range(depth):
        if sum(c % 3 == 1 for c in cell) >= 2:
            return False
        cell = [c // 3 for c in cell]
    return True


def meet(c, edge, depth, o, d):
    n = 3 ** depth
    c, o, d, edge = [F(x) for x in c], [F(x) for x in o], [F(x) for x in d], F(edge)
    plane = lambda k, i: c[k] + edge * (F(i, n) - F(1, 2))
    spans, ts = [], set()
    cross = [[(plane(k, i) - o[k]) / d[k] if d[k] else None for i in range(n + 1)] for k in range(3)]
    for k in range(3):
        ts.update(t for t in cross[k] if t is not None)
    for cell in ((x, y, z) for x in range(n) for y in range(n) for z in range(n)):
        if not is_solid(cell, depth):
            continue
        enter, leave = None, None
        for k in range(3):
            i = cell[k]
            if not d[k]:
                if not plane(k, i) <= o[k] <= plane(k, i + 1):
                    break
                continue
            a, b = sorted((cross[k][i], cross[k][i + 1]))
            if enter is None or a > enter[0]:
                enter = (a, k)
            if leave is None or b < leave[0]:
                leave = (b, k)
        else:
            if enter[0] < leave[0]:
                spans.append((enter, leave))
    spans.sort(key=lambda s: s[0][0])
    joined = []
    for s in spans:
        if joined and s[0][0] <= joined[-1][1][0]:
            if s[1][0] > joined[-1][1][0]:
                joined[-1] = (joined[-1][0], s[1])
        else:
            joined.append(s)
    ends = [e for s in joined for e in ((s[0], -1), (s[1], 1))]
    ahead = [e for e in ends if e[0][0] > 0]
    ordered = sorted(ts | {F(0)})
    largest = max(abs(t) for t in ordered)
    margin = min((b - a for a, b in zip(ordered, ordered[1:])), default=largest) / largest
    size = max(abs(x) for x in [*o, *c, edge])
    row = [len(ahead)]
    for i in range(2):
        if i < len(ahead):
            (t, k), _ = ahead[i]
            row += [repr(float(t)), repr(float(size / (abs(d[k]) * t)))]
        else:
            row += ["", ""]
    normal = ["", "", ""]
    if ahead:
        (t, k), out = ahead[0]
        normal = [0, 0, 0]
        normal[k] = out * (1 if d[k] > 0 else -1)
    return row + normal + [repr(float(margin))]


def rows():
    for i in range(120):  # anywhere, at every scale
        size = 10.0 ** random.uniform(-8, 9)
        depth = random.choice([0, 1, 2, 2])
        c = [random.uniform(-2, 2) * size for _ in range(3)]
        o = [x + random.uniform(-2, 2) * size for x in c]
        to = [x + random.uniform(-0.5, 0.5) * size for x in c]
        length = 10.0 ** random.uniform(-3, 3)
        yield c, size, depth, o, [(b - a) / size * length for a, b in zip(o, to)]
    for i in range(160):  # whole numbers: planes, edges and corners are met exactly
        depth = random.choice([1, 2])
        n = 3 ** depth
        c = [n / 2.0] * 3
        o = [float(random.randint(-3, n + 3)) + random.choice([0.0, 0.0, 0.5]) for _ in range(3)]
        d = [float(random.choice([0, 0, 0, 1, -1, 2, -3])) for _ in range(3)]
        if any(d):
            yield c, float(n), depth, o, d


print("cx,cy,cz,edge,depth,ox,oy,oz,dx,dy,dz,n_pos,tp0,cond_tp0,tp1,cond_tp1,nx,ny,nz,margin")
for c, edge, depth, o, d in rows():
    print(",".join(map(str, [*map(repr, c), repr(edge), depth, *map(repr, o), *map(repr, d), *meet(c, edge, depth, o, d)])))
