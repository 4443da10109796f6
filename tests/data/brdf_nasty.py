#!/usr/bin/env python3
"""Reflection models where they are hard: exponents to 1e6, roughness to 1e-4, angles to 1e-9 from grazing and from the mirror.

    python3 brdf_nasty.py values N SEED > brdf_values_nasty.csv
    python3 brdf_nasty.py albedo N SEED > brdf_albedo_nasty.csv

Values: the textbook formulas, unrearranged, with 120 digits; inputs are exactly the f64 printed. Albedos: quadrature over
the half vector's (or lobe's) polar angle and azimuth, cut at every kink, 48 nodes, in f64: about 7 digits where powers end
in roots.
"""
import cmath, math, random, sys
import mpmath as mp
from mpmath import mpf

what, N, R = sys.argv[1], int(sys.argv[2]), random.Random(int(sys.argv[3]))
g = lambda x: '' if x is None else repr(float(x))
HALF_PI = 1.5707963267948966

def fresnel(eta, k, c):
    """exact, unpolarised, complex"""
    n = mp.mpc(eta, k); s2 = 1 - c * c; q = mp.sqrt(n * n - s2)
    rs = (c - q) / (c + q); rp = (n * n * c - q) / (n * n * c + q)
    return (abs(rs) ** 2 + abs(rp) ** 2) / 2

def value(model, p, ti, to, phi):
    ti, to, phi = mpf(ti), mpf(to), mpf(phi)
    p = [None if x is None else mpf(x) for x in p]
    wi = [mp.sin(ti) * mp.cos(phi), mp.sin(ti) * mp.sin(phi), mp.cos(ti)]
    wo = [mp.sin(to), mpf(0), mp.cos(to)]
    ci, co = wi[2], wo[2]
    if model == 'phong_mod':
        c = -wi[0] * wo[0] - wi[1] * wo[1] + ci * co
        return (p[0] + 2) / (2 * mp.pi) * max(c, mpf(0)) ** p[0]
    h = [a + b for a, b in zip(wi, wo)]; l = mp.sqrt(sum(x * x for x in h)); h = [x / l for x in h]
    ch, cd = h[2], sum(a * b for a, b in zip(h, wo))
    if model == 'blinn_n8': return (p[0] + 8) / (8 * mp.pi) * ch ** p[0]
    if model == 'blinn_exact':
        return (p[0] + 2) * (p[0] + 4) / (8 * mp.pi * (mpf(2) ** (-p[0] / 2) + p[0])) * ch ** p[0]
    if model.startswith('oren'):
        rho, s2 = p[0], p[1] ** 2
        a, b, cp = max(ti, to), min(ti, to), mp.cos(phi)
        A, B = 1 - s2 / 2 / (s2 + mpf('0.33')), mpf('0.45') * s2 / (s2 + mpf('0.09'))
        if model == 'oren_nayar_qual':
            return rho / mp.pi * (A + B * max(cp, mpf(0)) * mp.sin(a) * mp.tan(b))
        C2 = B * (mp.sin(a) if cp >= 0 else mp.sin(a) - (2 * b / mp.pi) ** 3)
        C3 = mpf('0.125') * s2 / (s2 + mpf('0.09')) * (4 * a * b / mp.pi ** 2) ** 2
        f1 = rho / mp.pi * (A + cp * C2 * mp.tan(b) + (1 - abs(cp)) * C3 * mp.tan((a + b) / 2))
        return f1 + mpf('0.17') * rho ** 2 / mp.pi * s2 / (s2 + mpf('0.13')) * (1 - cp * (2 * b / mp.pi) ** 2)
    m = p[0]
    F = p[1] + (1 - p[1]) * (1 - cd) ** 5 if model.endswith('schlick') else fresnel(p[1], p[2], cd)
    t2 = (1 - ch * ch) / ch ** 2
    D = mp.exp(-t2 / m ** 2) / (mp.pi * m ** 2 * ch ** 4)
    G = min(mpf(1), 2 * ch * co / cd, 2 * ch * ci / cd)
    return D * F * G / (4 * ci * co)

def polar():
    k = R.random()
    if k < .4: return R.uniform(0, HALF_PI)
    if k < .7: return HALF_PI - 10 ** R.uniform(-9, -1)
    if k < .8: return 10 ** R.uniform(-9, -1)
    return R.choice([0.0, 1.5, 0.7853981633974483, HALF_PI])

def parameters(model):
    rho = R.choice([1.0, R.random()])
    if model in ('phong_mod', 'blinn_n8', 'blinn_exact'):
        return [R.choice([0.0 if model != 'phong_mod' else 0.5, 1.0, 10 ** R.uniform(0, 6)]), None, None]
    if model.startswith('oren'): return [rho, R.choice([0.0, 10 ** R.uniform(-3, .5)]), None]
    m = 10 ** R.uniform(-4, 0.1)
    if model.endswith('schlick'): return [m, R.choice([0.0, 1.0, R.random()]), None]
    return [m, R.choice([1.0001, 1.5, R.uniform(.1, 4)]), R.choice([0.0, R.uniform(0, 8), 1e-3])]

MODELS = ['phong_mod', 'blinn_n8', 'blinn_exact', 'oren_nayar_qual', 'oren_nayar_full', 'cook_torrance_schlick', 'cook_torrance_fresnel']

def values():
    mp.mp.dps = 120
    print('model,p0,p1,p2,p3,theta_i,theta_o,dphi,f'); done = 0
    while done < N:
        model = MODELS[done % len(MODELS)]; p = parameters(model); to = polar(); dphi = R.uniform(0, 6.283)
        ti = polar()
        if model not in ('oren_nayar_qual', 'oren_nayar_full') and R.random() < .85:   # inside the lobe
            w = p[0] if model.startswith('cook') else (p[0] + 1) ** -.5
            ti = min(abs(to + w * R.gauss(0, 1.5)), HALF_PI); dphi = 3.141592653589793 + (w * R.gauss(0, 1.5) / max(to, w) if to > 0 else 0)
        if R.random() < .1: dphi = R.choice([0.0, 3.141592653589793, 1.5707963267948966])
        f = value(model, p, ti, to, dphi)
        if f != 0 and not mpf(10) ** -280 < abs(f) < mpf(10) ** 280: continue
        print(','.join([model] + [g(x) for x in p] + ['', g(ti), g(to), g(dphi), g(f)])); done += 1

NODES = [(float(x), float(w)) for x, w in mp.calculus.quadrature.GaussLegendre(mp.mp).calc_nodes(5, 80)]   # 48

def quad(f, points, low, high):
    """Gauss-Legendre on each interval between the points"""
    ends = [low] + sorted(x for x in points if low < x < high) + [high]
    total = 0.0
    for a, b in zip(ends, ends[1:]):
        total += sum(w * f((a + b) / 2 + (b - a) / 2 * x) for x, w in NODES) * (b - a) / 2
    return total

def fresnel64(eta, k, c):
    n = complex(eta, k); q = cmath.sqrt(n * n - (1 - c * c))
    return (abs((c - q) / (c + q)) ** 2 + abs((n * n * c - q) / (n * n * c + q)) ** 2) / 2

def albedo(model, p, to):
    co, so = math.cos(to), math.sin(to)
    if model == 'phong_mod':
        n = p[0]
        def ring(a):
            A, B = math.cos(a) * co, math.sin(a) * so
            if A >= B: over = 2 * math.pi * A
            elif A <= -B: over = 0.0
            else: e = math.acos(-A / B); over = 2 * (A * e + B * math.sin(e))
            return math.cos(a) ** n * math.sin(a) * over
        w = (n + 1) ** -.5
        return (n + 2) / (2 * math.pi) * quad(ring, [w * k / 2 for k in range(1, 24)] + [HALF_PI - to], 0.0, HALF_PI)
    if model.startswith('blinn'):
        n = p[0]
        C = (n + 8) / (8 * math.pi) if model == 'blinn_n8' else (n + 2) * (n + 4) / (8 * math.pi * (2 ** (-n / 2) + n))
        D = lambda t: C * math.cos(t) ** n
        weight = lambda ch, cd, ci: 4 * cd * ci
        w = (n + 1) ** -.5; kinks = lambda ch: []
    else:
        m = p[0]; w = m
        F = (lambda c: p[1] + (1 - p[1]) * (1 - c) ** 5) if model.endswith('schlick') else (lambda c: fresnel64(p[1], p[2], c))
        D = lambda t: math.exp(-math.tan(t) ** 2 / m ** 2) / (math.pi * m ** 2 * math.cos(t) ** 4)
        weight = lambda ch, cd, ci: F(min(cd, 1.0)) * min(1.0, 2 * ch * co / cd, 2 * ch * ci / cd) / co * cd
        kinks = lambda ch: [co / ch, 2 * ch * co] + ([2 * ch * co / (4 * ch * ch - 1)] if ch != 0.5 else [])
    def ring(t):
        ch, sh = math.cos(t), math.sin(t); a, b = co * ch, so * sh
        at = lambda cd: math.acos(max(-1.0, min(1.0, (cd - a) / b))) if b != 0 else (math.pi if cd < a else 0.0)
        end = at(co / (2 * ch))
        if end <= 0: return 0.0
        def f(phi):
            cd = a + b * math.cos(phi); ci = 2 * cd * ch - co
            return weight(ch, cd, ci) if ci > 0 and cd > 0 else 0.0
        return D(t) * 2 * sh * quad(f, [at(k) for k in kinks(ch)], 0.0, end)
    # 12 widths of the lobe hold all but e^-72 of it
    top = min(HALF_PI - 1e-12, max(12 * math.atan(w), 1e-6))
    turns = [math.pi / 4 - to / 2, math.pi / 4 + to / 2, to / 2, to / 3, math.pi / 6, math.pi / 4]
    steps = [math.atan(w) * k for k in (.5, 1, 1.5, 2, 3, 4, 5, 7)] + [(HALF_PI - to) * k for k in (.25, 1, 4)]
    return quad(ring, turns + steps, 0.0, top)

def albedos():
    print('model,p0,p1,p2,theta_o,albedo')
    for i in range(N):
        model = [m for m in MODELS if not m.startswith('oren')][i % 5]
        p = parameters(model)
        if model.startswith('cook'): p[0] = 10 ** R.uniform(-3, 0)
        to = min(polar(), HALF_PI - 1e-5)
        print(','.join([model] + [g(x) for x in p] + [g(to), g(albedo(model, p, to))]), flush=True)

values() if what == 'values' else albedos()
