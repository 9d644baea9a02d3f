# SPDX-License-Identifier: MIT
"""Which linkages does the trial draw? Random ones and those that textbooks name, at random poses, dead points and folded.

Every function draws one into an empty linkage, by points of its pose. kind: "random"; "lattice", whole multiples of one length; "dead", links in
line where that makes a dead point; "flat", all in one line or plane.
"""
import math

import numpy as np


class Pen:
    """Points of a pose: on a lattice unless the kind is random."""

    def __init__(self, rng, digits, kind, wide):
        self.rng, self.digits, self.kind, self.wide = rng, digits, kind, wide
        self.unit = rng.choice([1, 1, 2, 0.5, 10]) if digits > 2 or kind == "random" else 1

    def number(self):
        if self.kind == "random":
            return round(self.rng.uniform(-5, 5) * self.unit, self.digits)
        return 2 * self.unit * self.rng.randint(-3, 3)

    def point(self, *others):
        """Away from the others."""
        while True:
            p = tuple(self.number() if k == 0 or (self.kind != "flat") else 0.0 for k in range(self.wide))
            if all(math.dist(p, other) > 0.3 * self.unit for other in others):
                return p

    def between(self, a, b):
        """A third point: in line with both at a dead point, or stretched beyond."""
        if self.kind in ("random", "lattice") and self.rng.random() < 0.9:
            return self.point(a, b)
        t = self.rng.choice([0.5, 0.5, 1.5, 2, -0.5, -1])
        p = tuple(x + t * (y - x) for x, y in zip(a, b))
        return p if min(math.dist(p, a), math.dist(p, b)) > 0.2 * self.unit else self.point(a, b)

    def direction(self):
        if self.kind == "random":
            angle = self.rng.uniform(-3, 3)
            return (math.cos(angle), math.sin(angle))
        return self.rng.choice([(1, 0), (0, 1), (1, 1), (0.6, 0.8), (-1, 0)])

    def axis(self):
        if self.kind == "random":
            v = np.array([self.rng.gauss(0, 1) for _ in range(3)])
            return v / np.linalg.norm(v)
        return np.array(self.rng.choice([(0, 0, 1), (1, 0, 0), (0, 1, 0), (0, 0.6, 0.8), (0.6, 0, 0.8)]), float)


def link(m, a, b, *places):
    """A body between two pins."""
    body = m.body(*places[0])
    m.pin(a, body, places[0])
    if b is not None:
        m.pin(body, b, places[1])
    return body


def crank(m, pen):
    o = pen.point()
    body = m.body(*o)
    m.pin(0, body, o)
    m.drive_angle(body)
    return body


# -------------------------------------------------------------------- groups on two bodies
def rrr(m, pen, a, b):
    p, q = pen.point(), None
    q = pen.point(p)
    c = pen.between(p, q)
    x = link(m, a, None, p)
    y = m.body(*c)
    m.pin(x, y, c)
    m.pin(y, b, q)
    return [x, y]


def rrp(m, pen, a, b):
    p = pen.point()
    c = pen.point(p)
    u = pen.direction()
    if pen.kind == "dead":
        u = (-(c[1] - p[1]), c[0] - p[0])
    x, y = link(m, a, None, p), m.body(*c)
    m.pin(x, y, c)
    size = math.hypot(*u)
    far = pen.rng.choice([0, 1, 2]) * pen.unit / size
    m.joint("prismatic", b, y, (c[0] - far * u[0], c[1] - far * u[1]), c, along=u)
    return [x, y]


def rpr(m, pen, a, b):
    """A body with a slot for a pin."""
    p = pen.point()
    q = pen.point(p)
    u = (q[0] - p[0], q[1] - p[1]) if pen.rng.random() < 0.7 else pen.direction()
    if pen.kind == "dead":
        u = (-(q[1] - p[1]), q[0] - p[0])
    x = link(m, a, None, p)
    far = pen.rng.choice([0.5, 1]) if pen.kind != "random" else pen.rng.uniform(0.2, 1)
    m.joint("slot", x, b, (q[0] - far * u[0], q[1] - far * u[1]), q, along=u)
    return [x]


def held_by(kind):
    def draw(m, pen, a, b):
        p = pen.point()
        q = pen.point(p)
        s = pen.between(p, q)
        x = link(m, a, None, p)
        joint = m.joint(kind, x, b, s, q)
        if kind == "actuator":
            m.drive_slide(joint)
        return [x]
    return draw


def prp(m, pen, a, b):
    c = pen.point()
    u, v = pen.direction(), pen.direction()
    if pen.kind == "dead":
        v = u
    x, y = m.body(*c), m.body(*c)
    m.pin(x, y, c)
    m.joint("prismatic", a, x, (c[0] - pen.unit * u[0], c[1] - pen.unit * u[1]), c, along=u)
    m.joint("prismatic", b, y, (c[0] - pen.unit * v[0], c[1] - pen.unit * v[1]), c, along=v)
    x2 = m.point(x, c[0] + pen.unit, c[1] + pen.unit)
    return [x, y] if x2 else []


def triad(m, pen, a, b):
    x = m.body(*pen.point())
    used = []
    for k in range(3):
        s = pen.point(*used)
        used.append(s)
        m.joint("rod", x, [a, b, 0][k], s, pen.point(s))
    return [x]


def assur(m, pen, a, b):
    """A ternary body on three links."""
    s = [pen.point()]
    s += [pen.point(s[0])]
    s += [pen.between(s[0], s[1])]
    x = m.body(*s[0])
    ends = []
    for k in range(3):
        y = link(m, x, [a, b, 0][k], s[k], pen.point(s[k]))
        ends.append(y)
    return [x, *ends]


GROUPS = [rrr, rrr, rrr, rrp, rpr, held_by("rod"), held_by("actuator"), prp, triad, assur]


def random_planar(m, pen):
    bodies = [0, crank(m, pen)]
    if pen.rng.random() < 0.2:
        o = pen.point()
        wheel = m.body(*o)
        m.pin(0, wheel, o)
        m.gear(bodies[1], wheel, pen.rng.choice([(-20, 40), (1, -2), (-1, 1), (30, 20)]))
        bodies.append(wheel)
    for k in range(pen.rng.randint(1, 3)):
        a, b = pen.rng.sample(bodies, 2)
        if k == 0 and 1 not in (a, b):
            a = 1 if b != 1 else a
        bodies += pen.rng.choice(GROUPS)(m, pen, a, b)


# -------------------------------------------------------------------- by name, planar
def four_bar(m, pen, driven="crank"):
    a = pen.point()
    d = pen.point(a)
    b = pen.point(a, d)
    c = pen.between(b, d) if driven == "crank" else pen.between(a, b)
    first = link(m, 0, None, a)
    coupler = link(m, first, None, b)
    rocker = link(m, coupler, 0, c, d)
    m.drive_angle(first if driven == "crank" else rocker)


def driven_rocker(m, pen):
    a = pen.point()
    c = pen.point(a)
    b = pen.between(a, c)
    d = pen.point(a, b, c)
    first = link(m, 0, None, a)
    coupler = link(m, first, None, b)
    m.drive_angle(link(m, coupler, 0, c, d))


def slider_crank(m, pen):
    a = pen.point()
    b = pen.point(a)
    c = pen.between(a, b) if pen.rng.random() < 0.5 else pen.point(a, b)
    u = (-(c[1] - b[1]), c[0] - b[0]) if pen.kind == "dead" else pen.direction()
    first = link(m, 0, None, a)
    rod = link(m, first, None, b)
    slider = m.body(*c)
    m.pin(rod, slider, c)
    guide = m.joint("prismatic", 0, slider, (c[0] - u[0], c[1] - u[1]), c, along=u)
    if pen.rng.random() < 0.5:
        m.drive_angle(first)
    else:
        m.drive_slide(guide)


def six_bar(kind):
    """Watt I and II, Stephenson I, II and III: a four-bar with a dyad between two of its bodies."""
    def draw(m, pen):
        a = pen.point()
        d = pen.point(a)
        b = pen.point(a, d)
        c = pen.between(b, d)
        first = link(m, 0, None, a)
        coupler = link(m, first, None, b)
        rocker = link(m, coupler, 0, c, d)
        one, two = {"watt-1": (coupler, rocker), "watt-2": (0, rocker), "stephenson-1": (first, rocker), "stephenson-2": (first, coupler),
                    "stephenson-3": (0, coupler)}[kind]
        rrr(m, pen, one, two)
        if kind == "stephenson-2":
            # Driven at the other ground link: the loop of five is to be solved at once.
            m.drive_angle(rocker)
        else:
            m.drive_angle(first)
    return draw


def klann(m, pen):
    first = link(m, 0, None, pen.point())
    p = pen.point()
    coupler = link(m, first, None, p)
    c = pen.point(p)
    link(m, coupler, 0, c, pen.between(p, c))
    upper = link(m, 0, None, pen.point())
    e = pen.point(c)
    leg = link(m, coupler, None, e)
    m.pin(leg, upper, pen.between(e, c))
    m.drive_angle(first)


def jansen(m, pen):
    o, p, b = pen.point(), pen.point(), pen.point()
    first = link(m, 0, None, o)
    up, down = pen.between(p, b), pen.point(p, b)
    j = link(m, first, None, p)
    ternary = link(m, 0, None, b)
    m.pin(j, ternary, up)
    k = link(m, first, None, p)
    c = link(m, 0, None, b)
    m.pin(k, c, down)
    f = pen.point(up, b)
    g = pen.point(down)
    foot = link(m, c, None, down)
    h = link(m, ternary, None, f)
    m.pin(h, foot, g)
    m.drive_angle(first)


def whitworth(m, pen):
    o, g = pen.point(), None
    g = pen.point(o)
    p = pen.point(o, g)
    if pen.kind == "dead":
        p = (o[0] - (g[1] - o[1]), o[1] + (g[0] - o[0]))
    first = link(m, 0, None, o)
    arm = link(m, 0, None, g)
    m.joint("slot", arm, first, g, p, along=(p[0] - g[0], p[1] - g[1]))
    m.drive_angle(first)
    rrp(m, pen, arm, 0)


def scotch_yoke(m, pen):
    o = pen.point()
    p = pen.point(o)
    first = link(m, 0, None, o)
    yoke = m.body(*p)
    guide = m.joint("prismatic", 0, yoke, (o[0], p[1]), p, along=(1, 0))
    m.joint("slot", yoke, first, (p[0], p[1] - pen.unit), p, along=(0, 1))
    m.drive_slide(guide) if pen.rng.random() < 0.5 else m.drive_angle(first)


def boom(m, pen):
    """Two cylinders, one after another."""
    base = held_by("actuator")(m, pen, 0, 0)[0]
    held_by("actuator")(m, pen, base, pen.rng.choice([0, base]))


def three_rpr(m, pen):
    x = m.body(*pen.point())
    used = []
    for _ in range(3):
        s = pen.point(*used)
        used.append(s)
        m.drive_slide(m.joint("actuator", 0, x, pen.point(s), s))


def gear_five_bar(m, pen):
    first = link(m, 0, None, pen.point())
    o = pen.point()
    wheel = m.body(*o)
    m.pin(0, wheel, o)
    m.gear(first, wheel, pen.rng.choice([(-1, 1), (-20, 40), (1, 2), (-1, 2)]))
    rrr(m, pen, first, wheel)
    m.drive_angle(first)


def parallel_cranks(count, crossed=False):
    """Cranks alike on a line: two are a parallelogram, more are redundant. Folded where flat, else at any angle."""
    def draw(m, pen):
        a = pen.point()
        step = pen.point((0,) * 2)
        v = tuple(pen.rng.choice([0.5, 2, 1]) * x for x in step) if pen.kind in ("dead", "flat") else pen.point((0,) * 2)
        cranks = [link(m, 0, None, tuple(x + k * s for x, s in zip(a, step))) for k in range(count)]
        coupler = None
        for k, body in enumerate(cranks):
            tip = tuple(x + k * s + y for x, s, y in zip(a, step, v))
            coupler = m.body(*tip) if coupler is None else coupler
            m.pin(body, coupler, tip)
        if crossed:
            rrr(m, pen, cranks[0], coupler)
        m.drive_angle(cranks[0])
    return draw


def double_parallelogram(m, pen):
    """A desk lamp: two parallelograms, one upon the other."""
    bodies = [0]
    a, step = pen.point(), pen.point((0, 0))
    for _ in range(2):
        v = tuple(2 * x for x in step) if pen.kind in ("dead", "flat") else pen.point((0, 0))
        end = tuple(x + y for x, y in zip(a, v))
        pair = [link(m, bodies[-1], None, tuple(x + k * s for x, s in zip(a, step))) for k in range(2)]
        top = m.body(*end)
        for k, body in enumerate(pair):
            m.pin(body, top, tuple(x + k * s for x, s in zip(end, step)))
        if bodies == [0]:
            m.drive_angle(pair[0])
        else:
            joint = m.joint("actuator", 0, pair[1], pen.point(end), tuple(x + s + y for x, s, y in zip(a, step, v)))
            m.drive_slide(joint)
        bodies.append(top)
        a = end


def kite(m, pen):
    """A four-bar of two pairs of equal links: it folds, and then a pair spins freely."""
    h = 2 * pen.unit
    a, b = (0.0, 0.0), (h, 0.0)
    c = pen.rng.choice([(1.2 * h, 1.6 * h), (h, 2 * h), (2.2 * h, 1.6 * h)])
    d = (0.0, h)
    c = (1.6 * h, 1.6 * h) if pen.kind != "dead" else (0.0, 0.0 + 2 * h)
    if pen.kind in ("dead", "flat"):
        b, c, d = (h, 0.0), (-h, 0.0), (h, 0.0)
        b, d = (h, 0.0), (0.0, h)
        c = (2 * h * 0.8, 2 * h * 0.8)
    first = link(m, 0, None, a)
    coupler = link(m, first, None, b)
    link(m, coupler, 0, c, d)
    m.drive_angle(first)


def scissor(m, pen):
    """Two crossing links on the ground, a slot for one: levels above by pins."""
    w, h = 4 * pen.unit, (0.0 if pen.kind in ("dead", "flat") else 2 * pen.unit)
    left, right = (0.0, 0.0), (w, 0.0)
    one, two = link(m, 0, None, left), m.body(*right)
    guide = m.joint("slot", 0, two, left, right, along=(1, 0))
    m.pin(one, two, (w / 2, h / 2))
    top = m.body(0.0, h)
    m.pin(two, top, (0.0, h))
    m.joint("slot", top, one, (0.0, h), (w, h), along=(1, 0))
    m.drive_slide(guide)


def peaucellier(m, pen):
    k = pen.unit
    o, c, a = (-4 * k, 0.0), (-2.5 * k, 0.0), (-1 * k, 0.0)
    p = (3 * k, 0.0)
    first = link(m, 0, None, c)
    longs = [link(m, 0, None, o) for _ in range(2)]
    corners = [(k * 1.0, 3 * k), (k * 1.0, -3 * k)]
    shorts = [link(m, first, None, a) for _ in range(2)]
    last = [None, None]
    for j in range(2):
        m.pin(longs[j], shorts[j], corners[j])
        last[j] = link(m, longs[j], None, corners[j])
    m.pin(last[0], last[1], p)
    m.drive_angle(first)


# -------------------------------------------------------------------- spatial
def random_loop(m, pen):
    """One loop of joints with seven freedoms, the first driven."""
    freedom = {"revolute": 1, "prismatic": 1, "cylindrical": 2, "universal": 2, "spherical": 3}
    while True:
        kinds = ["revolute"] + [pen.rng.choice(["revolute", "revolute", "revolute", "prismatic", "cylindrical", "universal", "spherical"])
                                for _ in range(pen.rng.randint(2, 5))]
        if (sum(freedom[k] for k in kinds) == 7 and kinds.count("spherical") < 2 and kinds.count("prismatic") < 3
                and kinds[-1] != "universal" and len(kinds) < 7):
            break
    before, places, first = 0, [], None
    for k, kind in enumerate(kinds):
        after = m.body() if k + 1 < len(kinds) else 0
        place = pen.point(*places[-1:])
        places.append(place)
        axis = pen.axis()
        if kind == "universal":
            e = np.cross(axis, [0.48, 0.6, 0.64]) if pen.kind == "random" else np.eye(3)[int(np.argmin(np.abs(axis)))]
            joint = m.joint(kind, before, after, place, axis=axis, second=e / np.linalg.norm(e))
        elif kind == "spherical":
            joint = m.joint(kind, before, after, place)
        elif kind == "revolute":
            joint = m.joint(kind, before, after, place, axis=axis)
        else:
            other = np.asarray(place) + pen.unit * axis
            joint = m.joint(kind, before, after, place, other, axis=axis)
        first = first or joint
        before = after
    m.drive_angle(first)


def rssr(m, pen):
    o, p = pen.point(), None
    p = pen.point(o)
    a, b = pen.point(o), pen.point(p)
    one, two = m.body(), m.body()
    first = m.joint("revolute", 0, one, o, axis=pen.axis())
    m.joint("revolute", 0, two, p, axis=pen.axis())
    m.joint("rod", one, two, a, b)
    m.drive_angle(first)


def rssp(m, pen):
    o = pen.point()
    a = pen.point(o)
    b = pen.point(a)
    one, two = m.body(), m.body()
    first = m.joint("revolute", 0, one, o, axis=pen.axis())
    u = pen.axis()
    slide = m.joint("prismatic", 0, two, np.asarray(b) - pen.unit * u, b, axis=u)
    m.joint("rod", one, two, a, b)
    m.drive_angle(first) if pen.rng.random() < 0.5 else m.drive_slide(slide)


def four_turns(axes_of):
    """A loop of four turns, redundant in space."""
    def draw(m, pen):
        places, axes = axes_of(pen)
        before, first = 0, None
        for k in range(4):
            after = m.body() if k < 3 else 0
            joint = m.joint("revolute", before, after, places[k], axis=axes[k])
            first = first or joint
            before = after
        m.drive_angle(first)
    return draw


def spherical_axes(pen):
    return [(0.0, 0.0, 0.0)] * 4, [pen.axis() for _ in range(4)]


def planar_axes(pen):
    places = []
    for _ in range(4):
        p = pen.point(*places)
        places.append(p)
    return [(x, y, 0.0) for x, y, *_ in places], [np.array([0.0, 0.0, 1.0])] * 4


def bennett_axes(pen):
    """Bennett's linkage: sin(alpha) / a = sin(beta) / b, at one of its poses."""
    a, alpha = 2.0 * pen.unit, math.radians(pen.rng.choice([30, 40, 50]))
    b = pen.unit * pen.rng.choice([3.0, 2.5])
    beta = math.asin(b / a * math.sin(alpha)) if b / a * math.sin(alpha) < 1 else math.pi / 2 - 0.1
    b = a * math.sin(beta) / math.sin(alpha)
    theta = pen.rng.uniform(0.4, 2.6)
    other = 2 * math.atan2(math.sin((alpha + beta) / 2), math.sin((beta - alpha) / 2) * math.tan(theta / 2))
    places, axes = [np.zeros(3)], [np.array([0.0, 0.0, 1.0])]
    m = np.eye(4)

    def step(angle, length, twist):
        c, s, ct, st = math.cos(angle), math.sin(angle), math.cos(twist), math.sin(twist)
        return np.array([[c, -s * ct, s * st, length * c], [s, c * ct, -c * st, length * s], [0, st, ct, 0], [0, 0, 0, 1]])

    for angle, length, twist in ((theta, a, alpha), (other, b, beta), (-theta, a, alpha)):
        m = m @ step(angle, length, twist)
        places.append(m[:3, 3].copy())
        axes.append(m[:3, 2].copy())
    return [tuple(p) for p in places], axes


def platform(legs):
    """legs: (foot, head) of each."""
    def draw(m, pen):
        x = m.body()
        low, high = [], []
        for _ in range(1 + max(foot for foot, _ in legs)):
            p = pen.point(*low)
            low.append(p if pen.kind == "random" else (p[0], p[1], 0.0))
        lift = {"random": pen.rng.uniform(2, 4), "flat": 0.0}.get(pen.kind, 4) * pen.unit
        for _ in range(1 + max(head for _, head in legs)):
            p = pen.point(*high, *low)
            high.append((p[0], p[1], round(lift + (0.2 * p[2] if pen.kind == "random" else 0.0), pen.digits)))
        for foot, head in legs:
            m.drive_slide(m.joint("actuator", 0, x, low[foot], high[head]))
    return draw


def rccc(m, pen):
    kinds = ["revolute", "cylindrical", "cylindrical", "cylindrical"]
    before, first = 0, None
    for k, kind in enumerate(kinds):
        after = m.body() if k < 3 else 0
        place, axis = pen.point(), pen.axis()
        other = place if kind == "revolute" else np.asarray(place) + pen.unit * axis
        joint = m.joint(kind, before, after, place, other, axis=axis)
        first = first or joint
        before = after
    m.drive_angle(first)


def sarrus(m, pen):
    """A plate on two chains of three parallel hinges: it moves straight, one of its constraints being redundant."""
    k = pen.unit
    x = m.body()
    guide = None
    for turn in (0, 1):
        def at(u, z):
            return (u * k, 0.0, z * k) if turn == 0 else (0.0, u * k, z * k)
        axis = np.array([0.0, 1.0, 0.0]) if turn == 0 else np.array([1.0, 0.0, 0.0])
        out = 3.0 if pen.kind in ("dead", "flat") else 4.0
        low, high = m.body(), m.body()
        z = 0.0 if pen.kind == "flat" else 4.0
        joint = m.joint("revolute", 0, low, at(2, 0), axis=axis)
        m.joint("revolute", low, high, at(out, z / 2), axis=axis)
        m.joint("revolute", high, x, at(2, z), axis=axis)
        guide = guide or joint
    m.drive_angle(guide)


PLANAR = {"four-bar": four_bar, "driven-rocker": driven_rocker, "slider-crank": slider_crank, "watt-1": six_bar("watt-1"),
          "watt-2": six_bar("watt-2"), "stephenson-1": six_bar("stephenson-1"), "stephenson-2": six_bar("stephenson-2"),
          "stephenson-3": six_bar("stephenson-3"), "klann": klann, "jansen": jansen, "whitworth": whitworth, "scotch-yoke": scotch_yoke,
          "boom": boom, "3-rpr": three_rpr, "gear-five-bar": gear_five_bar, "parallelogram": parallel_cranks(2),
          "three-cranks": parallel_cranks(3), "four-cranks": parallel_cranks(4), "parallelogram-with-dyad": parallel_cranks(2, True),
          "three-cranks-with-dyad": parallel_cranks(3, True), "desk-lamp": double_parallelogram, "kite": kite, "scissor": scissor,
          "peaucellier": peaucellier, "random": random_planar}
SPATIAL = {"rssr": rssr, "rssp": rssp, "rccc": rccc, "spherical-four-bar": four_turns(spherical_axes),
           "four-bar-in-space": four_turns(planar_axes), "bennett": four_turns(bennett_axes), "sarrus": sarrus,
           "octahedral": platform([(0, 0), (0, 1), (1, 1), (1, 2), (2, 2), (2, 0)]),
           "platform-6-3": platform([(k, k // 2) for k in range(6)]), "platform-6-6": platform([(k, k) for k in range(6)]),
           "random-loop": random_loop}
