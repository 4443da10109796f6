#!/usr/bin/env python3
"""Area lights where they are hard: 1e-12 rad wide, edges on the horizon, receivers in the plane, on an edge, on a vertex.

    python3 area_light_nasty.py N SEED > area_light_nasty.csv
    python3 area_light_nasty.py check N SEED       spheres and triangles against quadrature

Lambert's polygon formula and the clipped sphere with 1500 digits; inputs are exactly the f64 printed. A receiver in the
polygon's plane is answered by p + ε n, as the library defines it (and ε² N, for an n in that plane). `scale` is what the error of an answer is
measured by: the square of the angle that the light covers where that is small, else 1.
"""
import random, sys
import mpmath as mp
from mpmath import mpf

CHECK = sys.argv[1] == 'check'
N, R = int(sys.argv[-2]), random.Random(int(sys.argv[-1]))
mp.mp.dps = 1500
TINY = mpf(10) ** -330
g = lambda x: '' if x is None else repr(float(x))
sub = lambda a, b: [x - y for x, y in zip(a, b)]
dot = lambda a, b: sum((x * y for x, y in zip(a, b)), mpf(0))
cross = lambda a, b: [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
norm = lambda a: mp.sqrt(dot(a, a))
M = lambda v: [mpf(x) for x in v]

def clip(r, n):
    out = []
    for a, b in zip(r, r[1:] + r[:1]):
        ha, hb = dot(n, a), dot(n, b)
        if ha >= 0: out.append(a)
        if ha * hb < 0: out.append([x + (y - x) * ha / (ha - hb) for x, y in zip(a, b)])
    return out

def polygon(v, p, n):
    v, p, n = [M(x) for x in v], M(p), M(n)
    n = [x / norm(n) for x in n]
    N_ = cross(sub(v[1], v[0]), sub(v[2], v[0]))
    size = max(norm(sub(x, p)) for x in v)
    if abs(dot(N_, sub(p, v[0]))) <= mpf(10) ** -1100 * norm(N_) * size:
        k = TINY * TINY * size * (1 if dot(N_, n) >= 0 else -1) / (norm(N_) or 1)
        p = [x + TINY * size * y + k * z for x, y, z in zip(p, n, N_)]
    r = [sub(x, p) for x in v]
    size = max(norm(x) for x in r); r = [[x / size for x in y] for y in r]
    r = clip(r, n)
    total = mpf(0)
    for a, b in zip(r, r[1:] + r[:1]):
        c = cross(a, b); l = norm(c)
        if l > 0: total += mp.atan2(l, dot(a, b)) * dot(n, c) / l
    return abs(total) / 2 if abs(total) > mpf(10) ** -300 else mpf(0)

def sphere(c, radius, p, n):
    d, n = sub(M(c), M(p)), M(n); D = norm(d); R_ = mpf(radius)
    if D < R_: return mp.pi
    co = dot(n, d) / norm(n) / D; s = R_ / D; k = mp.sqrt(1 - s * s)
    if co >= s: return mp.pi * s * s * co
    if co <= -s: return mpf(0)
    w = mp.sqrt(s * s - co * co)
    return s * s * co * mp.atan2(w, -k * co) - k * w + mp.atan2(w, k)

def wide(v, p):
    v = [sub(M(x), M(p)) for x in v]; near = min(norm(x) for x in v)
    return min(mpf(1), max(norm(sub(x, v[0])) for x in v) ** 2 / near ** 2) if near > 0 else mpf(1)

def direction():
    while True:
        v = [R.gauss(0, 1) for _ in range(3)]; l = sum(x * x for x in v) ** .5
        if l > .1: return [x / l for x in v]

def unit(v):
    l = sum(x * x for x in v) ** .5
    return [x / l for x in v]

FX = lambda a, b: [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
def triangle(center, size, flat=1.0):
    w = direction(); x = unit(FX(w, direction())); y = FX(w, x)
    k = lambda: R.uniform(-1, 1)
    return [[c + size * (k() * a + flat * k() * b) for c, a, b in zip(center, x, y)] for _ in range(3)]

def rectangle(corner, a, b):
    """exactly flat: two axes only"""
    i, j = R.sample(range(3), 2); v = [list(corner) for _ in range(4)]
    for k in (1, 2): v[k][i] += a
    for k in (2, 3): v[k][j] += b
    return v

light = lambda c, s: triangle(c, s) if R.random() < .5 else rectangle([x - s / 2 for x in c], s * R.uniform(.2, 1), s * R.uniform(.2, 1))
p10 = lambda a, b: 10 ** R.uniform(a, b)
pull = lambda v, w: [a + b for a, b in zip(v, w)]
near = lambda d, e: unit([x + e * y for x, y in zip(d, direction())])
def inside(v):
    k = [R.random() + .05 for _ in v]; s = sum(k)
    return [sum(a * x[i] for a, x in zip(k, v)) / s for i in range(3)]

def tiny():
    d = direction(); return light(d, p10(-12, -1)), [0., 0., 0.], R.choice([direction(), near(d, .3)])
def tiny_offset():
    o = [p10(0, 6) * R.choice([-1, 1]) for _ in range(3)]; d = direction()
    return light(pull(o, [8 * x for x in d]), p10(-5, -1)), o, near(d, .3)
def tiny_clipped():
    d = direction(); s = p10(-9, -2); side = unit(FX(d, direction()))
    return light(d, s), [0., 0., 0.], unit([a + s * R.uniform(-.3, .3) * b for a, b in zip(side, d)])
def touches():
    v = triangle(direction(), .5); n = unit(FX(v[0], v[1])); n = n if sum(a * b for a, b in zip(n, v[2])) > 0 else [-x for x in n]
    return v, [0., 0., 0.], near(n, R.choice([0., p10(-17, -2)]))
def touches_exactly():
    k = lambda: R.randint(1, 9); v = [[k(), k(), 0], [-k(), k(), 0], [k(), -k(), R.choice([-1, 1]) * k() * p10(-20, 0)]]
    return [M(x) for x in v], [0., 0., 0.], R.choice([[0., 0., 1.], [0., 0., -1.]])
def above():
    v = rectangle([-1., -1.5, -2.], 3., 4.5); i = [k for k in range(3) if len({x[k] for x in v}) == 1][0]
    p = inside(v); p[i] += R.choice([-1, 1]) * p10(-18, 0); return v, p, R.choice([direction(), [float(k == i) for k in range(3)]])
def near_plane():
    v = triangle([0., 0., 0.], 1.); w = unit(FX([b - a for a, b in zip(v[0], v[1])], [b - a for a, b in zip(v[0], v[2])]))
    p = [a + 3 * (a - b) for a, b in zip(v[0], inside(v))]; e = p10(-16, -1); return v, [a + e * b for a, b in zip(p, w)], direction()
def on():
    """integer corners in the plane x + 2y − z = 0, halves of them as receivers: exact"""
    v = [[float(a), float(b), float(a + 2 * b)] for a, b in R.choice([[(0, 0), (4, 0), (0, 4)], [(-4, -2), (6, 0), (0, 8)], [(1, 1), (-3, 5), (-1, -7)]])]
    k = R.randrange(4); mid = lambda a, b: [(x + y) / 2 for x, y in zip(a, b)]
    p = [v[0], mid(v[0], v[1]), mid(v[2], mid(v[0], v[1])), [3 * x - 2 * y for x, y in zip(v[0], v[1])]][k]
    n = R.choice([direction(), unit([1., 2., -1.]), [1., 2., -1.], [-1., -2., 1.], [2., -1., 0.]]); return v, p, n
def on_rectangle():
    v = rectangle([0., 0., 0.], 1., 2.); p = R.choice([v[R.randrange(4)], [(x + y) / 2 for x, y in zip(v[0], v[1])], [(x + y) / 2 for x, y in zip(v[0], v[2])]])
    e = R.choice([0., 0., p10(-17, -1)]); return v, [x + e * R.choice([-1, 0, 1]) for x in p], R.choice([direction(), [0., 0., 1.], [1., 0., 0.]])
def near_edge():
    v = light([R.uniform(-1, 1) for _ in range(3)], 1.); t = R.choice([0., R.random()]); e = p10(-17, -2)
    return v, [a + t * (b - a) + e * c for a, b, c in zip(v[0], v[1], direction())], direction()
def grazing():
    d = direction(); side = unit(FX(d, direction())); return light(d, p10(-3, 0)), [0., 0., 0.], near(side, p10(-16, -1))
def sliver():
    d = direction(); return triangle(d, p10(-2, 0), p10(-14, -2)), [0., 0., 0.], direction()
def offset():
    o = [p10(0, 8) * R.choice([-1, 1]) for _ in range(3)]; d = direction(); return light(pull(o, d), p10(-2, 1)), o, direction()
def scale():
    s = R.choice([p10(90, 150), p10(-150, -90), 3e306, 1e-300]); v, p, n = R.choice([offset0, near_edge])()
    return [[x * s for x in y] for y in v], [x * s for x in p], [x * p10(-5, 5) for x in n]
def offset0():
    return light(direction(), p10(-1, 1)), [0., 0., 0.], direction()
def disparate():
    return [[R.gauss(0, 1) * p10(-12, 12) for _ in range(3)] for _ in range(3)], [R.gauss(0, 1) * p10(-12, 12) for _ in range(3)], direction()

def ball():
    d = direction(); k = R.randrange(7); o = [0., 0., 0.]; r = p10(-12, -.1); n = direction(); side = unit(FX(d, direction()))
    if k == 1: n = near(d, .5); r = p10(-150, -10)
    if k == 2: n = unit([a + b * r * R.uniform(-1.2, 1.2) for a, b in zip(side, d)])
    if k == 3: n = unit([a + b * r * (R.choice([-1, 1]) + R.choice([-1, 1]) * p10(-16, -1)) for a, b in zip(side, d)])
    if k == 4: r = 1 - p10(-16, -1); n = R.choice([n, unit([a + b * R.uniform(-1, 1) for a, b in zip(side, d)])])
    if k == 5: o = [p10(0, 8) * R.choice([-1, 1]) for _ in range(3)]; r = p10(-8, -.1)
    c = pull(o, d)
    if k == 6:
        o, c, r = R.choice([([0., 0., 0.], [3., 4., 12.], 13.), ([1., 1., 1.], [1., 2., 1.], 1.), ([0.1, 0., 0.], [0., 0., 0.], .2), ([1., 2., 3.], [1., 2., 3.], 4.)])
    if R.random() < .1 and k != 5:
        s = R.choice([1e150, 1e-150, 3e306, 1e-300]); o, c, r = [x * s for x in o], [x * s for x in c], r * s
    return c, r, o, n

CLASSES = [tiny, tiny_offset, tiny_clipped, touches, touches_exactly, above, near_plane, on, on_rectangle, near_edge, grazing, sliver, offset, scale, disparate]

def rows():
    print('cls,kind,v0x,v0y,v0z,v1x,v1y,v1z,v2x,v2y,v2z,v3x,v3y,v3z,radius,px,py,pz,nx,ny,nz,irradiance,scale')
    for i in range(N):
        if i % 5 == 4:
            c, r, p, n = ball(); e = sphere(c, r, p, n); v, kind, name, scale = [c], 'sphere', 'ball', min(mpf(1), (mpf(r) / (norm(sub(M(c), M(p))) or 1)) ** 2)
        else:
            made = CLASSES[(i - i // 5) % len(CLASSES)]; v, p, n = made(); name, r = made.__name__, None
            v = [[float(x) for x in y] for y in v]; e, scale = polygon(v, p, n), wide(v, p); kind = ['triangle', 'rectangle'][len(v) - 3]
        cells = [x for y in v for x in y]; cells += [None] * (12 - len(cells))
        print(','.join([name, kind] + [g(x) for x in cells + [r] + list(p) + list(n) + [e, scale]]))

def check():
    mp.mp.dps = 30; worst = mpf(0)
    for _ in range(N):
        n, d = M(unit(direction())), direction(); r = R.uniform(.01, .95)
        co = dot(n, M(d)); th, sg = mp.acos(co), mp.asin(mpf(r))
        def ring(a):
            A, B = mp.cos(a) * co, mp.sin(a) * mp.sin(th)
            if A >= B: over = 2 * mp.pi * A
            elif A <= -B: over = mpf(0)
            else: f = mp.acos(-A / B); over = 2 * (A * f + B * mp.sin(f))
            return over * mp.sin(a)
        kinks = sorted(x for x in [abs(mp.pi / 2 - th)] if 0 < x < sg)
        worst = max(worst, abs(mp.quad(ring, [0] + kinks + [sg]) - sphere(d, r, [0, 0, 0], n)))
        v = [M(x) for x in triangle([2 * x for x in d], 1.)]; N_ = cross(sub(v[1], v[0]), sub(v[2], v[0])); A = norm(N_)
        n = M(unit(pull(d, [.3 * x for x in direction()])))
        def f(s, t):
            x = [a + s * ((b - a) + t * (c - b)) for a, b, c in zip(*v)]; l = norm(x)
            return s * A * abs(dot(N_, x)) / A / l ** 4 * max(dot(n, x), 0)
        if min(dot(n, x) for x in v) > 0: worst = max(worst, abs(mp.quad(f, [0, 1], [0, 1]) - polygon(v, [0, 0, 0], n)))
    print('largest difference', mp.nstr(worst, 3))

check() if CHECK else rows()
