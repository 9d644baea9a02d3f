# SPDX-License-Identifier: MIT
"""Linkages of textbooks and machines by their dimensions, at poses found along the way that each one moves.

Proportions are the known ones where a linkage has such (Hoecken's 1, 2, 2.5; Chebyshev's 2, 4, 5; the double wishbone is a racing car's), else
typical ones. A sketch is one assembled pose with all digits. Its first driver moves it along its curve of poses; along that curve are

  random    any pose
  lattice   the pose as sketched
  dead      the driver turns back there
  flat      a change point, where another way branches off; else links in line, where another body turns back

At such a pose the linkage is typed anew: rounded, in the drawing's frame or in frames of its links, where a link's length is one number.
"""
import math

import numpy as np

from planar import Planar, turned
from spatial import Spatial


# -------------------------------------------------------------------- points
def polar(o, length, degrees):
    return (o[0] + length * math.cos(math.radians(degrees)), o[1] + length * math.sin(math.radians(degrees)))


def meet(a, ra, b, rb, side=1):
    """Where circles about a and b meet: on the left of the way from a to b, or on the right (-1)."""
    d = math.dist(a, b)
    x = (d * d + ra * ra - rb * rb) / (2 * d)
    y = side * math.sqrt(ra * ra - x * x)
    u = ((b[0] - a[0]) / d, (b[1] - a[1]) / d)
    return (a[0] + x * u[0] - y * u[1], a[1] + x * u[1] + y * u[0])


def beyond(a, b, ahead, left=0.0):
    """From a towards b: so far ahead of a, and to the left."""
    d = math.dist(a, b)
    u = ((b[0] - a[0]) / d, (b[1] - a[1]) / d)
    return (a[0] + ahead * u[0] - left * u[1], a[1] + ahead * u[1] + left * u[0])


# -------------------------------------------------------------------- planar sketches
def pins(bodies, *others, drive=(1,), **points):
    """Bodies by the letters of their points, the ground first: bodies that share one are pinned there.

    others: (kind, body, point, body, point, along) of slots and prismatic joints, rods and actuators; ("gear", body, body, ratio).
    drive: a body's number, or that of one of the others, negative: -1 is the first.
    """
    bodies = bodies.split()

    def sketch(m):
        for name in bodies[1:]:
            m.body(*points[name[0]])
        for point, place in points.items():
            on = [k for k, name in enumerate(bodies) if point in name]
            for k in on[1:]:
                m.pin(on[0], k, place)
        made = []
        for kind, a, *rest in others:
            if kind == "gear":
                made.append(m.gear(a, *rest))
            else:
                p, b, q, *along = rest
                made.append(m.joint(kind, a, b, points[p], points[q], *along))
        for k in drive:
            m.drive_angle(k) if k > 0 else m.drive_slide(made[-k - 1])
    return sketch


def four(o, c, first, coupler, last, degrees, side=1, ahead=None, left=0.0, drive=(1,)):
    """A four-bar by its lengths, with a point of the coupler so far ahead."""
    a = polar(o, first, degrees)
    b = meet(a, coupler, c, last, side)
    return pins("OC OA ABP CB", O=o, C=c, A=a, B=b, P=beyond(a, b, coupler / 2 if ahead is None else ahead, left), drive=drive)


def watt_line():
    return four((0, 0), (8, 2), 4, 2, 4, 12, -1)


def evans():
    """Scott Russell's with a rocker in place of the slider."""
    o, g = (0, 0), (4, 5)
    a = polar(o, 2, 40)
    b = meet(a, 2, g, 5)
    return pins("OG OA BAP GB", O=o, G=g, A=a, B=b, P=beyond(b, a, 4))


def hart_inversor():
    at = {"A": (0, 0), "B": (2.5, 2), "C": (3, 0), "D": (0.5, 2), "O": (1, 0.8), "P": (0.2, 0.8), "Q": (2.8, 0.8), "K": (0.6, 0.3)}
    return pins("OK KP AOB BQC CD DPA", **at)


def locomotive():
    """Three wheels on one rod, driven by the piston."""
    v = polar((0, 0), 1, 70)
    at = {**dict(zip("OPQ", [(0, 0), (3, 0), (6, 0)])), **{n: (x + v[0], v[1]) for n, x in zip("ABC", (0, 3, 6))}}
    e = (v[0] + 6 + math.sqrt(16 - v[1] ** 2), 0)
    return pins("OPQ OA PB QC ABC CE E", ("prismatic", 0, "Q", 6, "E", (1, 0)), E=e, drive=(-1,), **at)


def scott_russell():
    """Crank and rod alike: it changes where both lie on each other."""
    o, a = (0, 0), polar((0, 0), 2, 35)
    b = (2 * a[0], 0)
    return pins("O OA ABP B", ("prismatic", 0, "O", 3, "B", (1, 0)), O=o, A=a, B=b, P=beyond(b, a, 4))


def trammel():
    a, b = (3 * math.cos(0.6), 0), (0, 3 * math.sin(0.6))
    return pins("O ABP A B", ("prismatic", 0, "O", 2, "A", (1, 0)), ("prismatic", 0, "O", 3, "B", (0, 1)), O=(0, 0), A=a, B=b, P=beyond(a, b, 5))


def oldham():
    o, c, u = (0, 0), (0.6, 0.2), polar((0, 0), 1, 23)
    x = c[0] * u[0] + c[1] * u[1]
    return pins("OC O C D", ("prismatic", 1, "O", 3, "D", u), ("prismatic", 2, "C", 3, "D", (-u[1], u[0])), O=o, C=c, D=(x * u[0], x * u[1]))


def rhombic_drive():
    """Both gears lead the yoke: its guide is redundant."""
    a, b = polar((-1, 0), 0.5, 50), polar((1, 0), 0.5, 130)
    h = a[1] + math.sqrt(4 - (-0.4 - a[0]) ** 2)
    return pins("OC OA CB AD BE DEY", ("gear", 1, 2, (-1, 1)), ("prismatic", 0, "Z", 5, "Y", (0, 1)), O=(-1, 0), C=(1, 0), A=a, B=b, D=(-0.4, h),
                E=(0.4, h), Y=(0, h), Z=(0, 0))


def scissor_lift():
    w, h = 4, 1.5
    at = {"L": (0, 0), "R": (w, 0), "M": (w / 2, h / 2), "A": (0, h), "B": (w, h), "N": (w / 2, 1.5 * h), "C": (0, 2 * h), "D": (w, 2 * h)}
    return pins("L LMB RMA AND BNC C", ("slot", 0, "L", 2, "R", (1, 0)), ("slot", 5, "C", 3, "D", (1, 0)), drive=(-1,), **at)


def pantograph():
    o, b = (0, 0), polar((0, 0), 4, 70)
    p = polar(b, 6, -40)
    a = beyond(o, b, 2)
    c = beyond(b, p, 3)
    return pins("O OAB BCP AD CD", O=o, A=a, B=b, C=c, P=p, D=(a[0] + c[0] - b[0], a[1] + c[1] - b[1]), drive=(1, 2))


def toggle_press():
    g, o = (0, 6), (-4, 4)
    t = polar(g, 3, -75)
    s = (0, t[1] - math.sqrt(9 - t[0] ** 2))
    return pins("OG OA AT GT TS S", ("prismatic", 0, "G", 5, "S", (0, 1)), O=o, G=g, T=t, S=s, A=meet(o, 1, t, 4.4))


def atkinson():
    o, c = (0, 0), (1.4, -2.2)
    a = polar(o, 1, 120)
    b = meet(a, 2.2, c, 1.8, -1)
    d = beyond(a, b, 2.4, 1.1)
    return pins("OC OA ABD CB DS S", ("prismatic", 0, "G", 5, "S", (1, 0)), O=o, C=c, A=a, B=b, D=d, G=(0, 0.4),
                S=(d[0] + math.sqrt(16 - (d[1] - 0.4) ** 2), 0.4))


def excavator():
    o, e = (0, 0), (5.2, 2.6)
    n, i, f = (5.0, 3.5), (6.2, 0.8), (6.5, 0)
    j = meet(i, 0.6, f, 0.9)
    return pins("OK OLME ENQIF IJ JH FHT", ("actuator", 0, "K", 1, "L"), ("actuator", 1, "M", 2, "N"), ("actuator", 2, "Q", 3, "J"), O=o,
                K=(0.5, -0.4), L=(2.4, 2.5), M=(2.8, 3.0), E=e, N=n, Q=(5.6, 3.0), I=i, F=f, J=j, H=meet(j, 0.62, f, 0.45, 1), T=(6.2, -1.3), drive=(-1, -2, -3))


def wiper():
    """Tandem wipers: the second arm on a parallelogram."""
    o, c, d = (0, 0), (3, 0.4), (7, 0.4)
    a = polar(o, 0.5, 75)
    b = meet(a, 3.1, c, 0.9)
    e = beyond(c, b, 1.2)
    return pins("OCD OA AB CBE EF DF", O=o, C=c, D=d, A=a, B=b, E=e, F=(e[0] + 4, e[1]))


def landing_gear():
    """Its folding stay is straight when it is down."""
    o, d = (0, 0), (3, 0.5)
    a = polar(o, 2.5, -60)
    return pins("ODK OAW AB BD", ("actuator", 0, "K", 1, "W"), O=o, D=d, A=a, B=meet(a, 1.75, d, 1.6), K=(-1, 1.2), W=polar(o, 0.8, 100), drive=(-1,))


def garage_door():
    o, m = (0, 0), polar((0, 0), 1.05, -30)
    r = (0, m[1] - math.sqrt(1.21 - m[0] ** 2))
    return pins("O OM MRS", ("slot", 0, "O", 2, "R", (0, 1)), O=o, M=m, R=r, S=beyond(r, m, 2.1))


def ackermann():
    o, c = (0, 0), (13, 0)
    a, b = polar(o, 1.8, -72), polar(c, 1.8, -108)
    return pins("OC OA AB CB", O=o, C=c, A=a, B=b)


def davis():
    o, c, a, b = (0, 0), (6, 0), (0.7, 1.2), (5.3, 1.2)
    return pins("OC O C AB", ("slot", 1, "O", 3, "A", a), ("slot", 2, "C", 3, "B", (b[0] - 6, b[1])), ("prismatic", 0, "G", 3, "A", (1, 0)), O=o, C=c,
                A=a, B=b, G=(0, 1.2), drive=(-3,))


def vice_grip():
    return four((0, 0), (6.5, 0.8), 1.2, 4.6, 2.1, 95, -1, drive=(2,))


def dump_truck():
    o, k, h = (0, 0), (1.6, -0.3), (2.8, 0.9)
    m = (2.5, 0.2)
    return pins("OKN OH KLM MH", ("actuator", 0, "N", 2, "L"), O=o, K=k, H=h, M=m, L=(2.1, 0.35), N=(4.4, -0.6), drive=(-1,))


def cardan_gear():
    """A planet half as large as its ring leads a slider straight: the guide is redundant."""
    c = polar((0, 0), 1, 40)
    return pins("O OC CP P", ("gear", 0, 2, (2, 1), 1), ("prismatic", 0, "O", 3, "P", (1, 0)), O=(0, 0), C=c, P=(2 * c[0], 0))


def geneva():
    o, c = (0, 0), (math.sqrt(2), 0)
    a = polar(o, 1, 25)
    return pins("OC OA C", ("slot", 2, "C", 1, "A", (a[0] - c[0], a[1])), O=o, C=c, A=a)


def scara():
    o, c = (0, 0), (1.2, 0)
    a, b = polar(o, 2, 120), polar(c, 2, 50)
    return pins("OC OA CB AP BP", O=o, C=c, A=a, B=b, P=meet(a, 2.5, b, 2.5, -1), drive=(1, 2))


def umbrella():
    at = {"A": (-0.2, 5), "B": (0.2, 5), "C": (-0.3, 2.6), "D": (0.3, 2.6)}
    e = meet(at["A"], 2, at["C"], 2.2, -1)
    return pins("AB CD AE CE BF DF", ("prismatic", 0, "G", 1, "H", (0, 1)), E=e, F=(-e[0], e[1]), G=(0, 0), H=(0, 2.6), drive=(-1,), **at)


def dixon():
    """K(3,3) between two perpendicular lines: it moves, which no count of joints tells."""
    at = {"A": (1, 0), "B": (-2, 0), "C": (3.2, 0), "P": (0, 1.5), "Q": (0, -1.1), "R": (0, 2.6)}
    return pins("AP AQ AR BP BQ BR CP CQ CR", **at)


def bourke():
    """A yoke between two pistons: guided twice."""
    p = polar((0, 0), 1, 55)
    return pins("O OP YLR", ("prismatic", 0, "O", 2, "L", (1, 0)), ("prismatic", 0, "O", 2, "R", (1, 0)), ("slot", 2, "Y", 1, "P", (0, 1)), O=(0, 0),
                P=p, Y=(p[0], 0), L=(p[0] - 3, 0), R=(p[0] + 3, 0))


def shaper():
    o, g = (0, 2.5), (0, 0)
    p = polar(o, 1, 20)
    b = beyond(g, p, 6)
    s = (b[0] + math.sqrt(4 - (b[1] - 5.6) ** 2), 5.6)
    return pins("OG OP GB BS S", ("slot", 2, "G", 1, "P", p), ("prismatic", 0, "N", 4, "S", (1, 0)), O=o, G=g, P=p, B=b, S=s, N=(0, 5.6))


def horst_link():
    o, c = (0, 0), (-0.5, 2.4)
    h = polar(o, 4.1, 184)
    k = meet(h, 4.0, c, 0.9, -1)
    return pins("OCE OH HKW KCD", ("actuator", 0, "E", 3, "D"), O=o, C=c, H=h, K=k, W=(-4.6, 0.1), D=beyond(c, k, -0.6), E=(1.2, 1.3), drive=(-1,))


def rapson():
    """A ship's tiller in a sliding block."""
    a = (0.8, 2)
    return pins("O O A", ("slot", 1, "O", 2, "A", a), ("prismatic", 0, "G", 2, "A", (1, 0)), O=(0, 0), A=a, G=(0, 2), drive=(-2,))


def beam_engine():
    """Watt's parallel motion on a beam, and the crank on its other end."""
    o, u = (0, 0), polar((0, 0), 1, 8)
    m, n, x = ((k * u[0], k * u[1]) for k in (-2, -4, 4))
    c = (-4, -2)
    q = meet(m, 2, c, 2, -1)
    k = (4.2, -7)
    return pins("OCK OMNX NP MQ PQ QC XY KY", O=o, C=c, K=k, M=m, N=n, X=x, Q=q, P=(n[0] + q[0] - m[0], n[1] + q[1] - m[1]), Y=meet(x, 7, k, 0.9),
                drive=(7,))


def ross_yoke():
    o, c = (0, 0), (3, 0.9)
    a = polar(o, 0.6, 30)
    b = meet(a, 2.6, c, 1.5, 1)
    left, right = beyond(a, b, -1.2, 0.8), beyond(a, b, 1.2, 0.8)
    s, t = ((x, y[1] + math.sqrt(9 - (y[0] - x) ** 2)) for x, y in ((-1.2, left), (1.2, right)))
    return pins("OC OA ALRB CB LS S RT T", ("prismatic", 0, "G", 5, "S", (0, 1)), ("prismatic", 0, "H", 7, "T", (0, 1)), O=o, C=c, A=a, B=b, L=left,
                R=right, S=s, T=t, G=(-1.2, 0), H=(1.2, 0))


# -------------------------------------------------------------------- spatial sketches
def chain(*joints, drive=0):
    """A loop of joints (kind, place, axis, second axis or second point), the ground before the first and after the last."""
    def sketch(m):
        made, before = [], 0
        for k, (kind, place, *more) in enumerate(joints):
            after = m.body() if k + 1 < len(joints) else 0
            if kind == "universal":
                made.append(m.joint(kind, before, after, place, axis=more[0], second=more[1]))
            elif kind == "spherical":
                made.append(m.joint(kind, before, after, place))
            else:
                made.append(m.joint(kind, before, after, place, more[1] if len(more) > 1 else None, axis=np.array(more[0], float)))
            before = after
        m.drive_angle(made[drive])
    return sketch


def turns(*rows, seed=0):
    """A loop of turns by Denavit and Hartenberg's (length, twist in degrees, offset), closed from random angles."""
    def frames(angles):
        m, made = np.eye(4), []
        for angle, (a, twist, d) in zip(angles, rows):
            made.append(m)
            c, s, ct, st = math.cos(angle), math.sin(angle), math.cos(math.radians(twist)), math.sin(math.radians(twist))
            m = m @ np.array([[c, -s * ct, s * st, a * c], [s, c * ct, -c * st, a * s], [0, st, ct, d], [0, 0, 0, 1]])
        return made, (m - np.eye(4))[:3].ravel()

    r = np.random.default_rng(seed)
    while True:
        angles = r.uniform(-3, 3, len(rows))
        for _ in range(60):
            f = frames(angles)[1]
            j = np.column_stack([(frames(angles + h)[1] - frames(angles - h)[1]) / 2e-5 for h in 1e-5 * np.eye(len(rows))])
            step = np.linalg.lstsq(j, -f, rcond=1e-9)[0]
            angles = angles + step * min(1, 0.5 / max(1e-300, np.abs(step).max()))
        if np.abs(frames(angles)[1]).max() < 1e-13 and np.linalg.svd(j, compute_uv=False)[-2] > 0.05 and np.abs(np.sin(angles)).min() > 0.1:
            break
    return chain(*(("revolute", tuple(m[:3, 3]), m[:3, 2]) for m in frames(angles)[0]))


def goldberg():
    """Bennett's linkage twice, one upon the other, without the link between."""
    a, b, alpha = 2.0, 3.0, 30
    beta = math.degrees(math.asin(b / a * math.sin(math.radians(alpha))))
    return turns((a, alpha, 0), (b, beta, 0), (2 * a, 2 * alpha, 0), (b, beta, 0), (a, alpha, 0))


def schatz():
    """Turbula's mixer."""
    return turns((0, 90, 1), (1, 90, 0), (1, 90, 0), (1, 90, 0), (0, 90, 0), (math.sqrt(3), 0, -1), seed=3)


def myard():
    a, alpha = 1.0, 40
    b = a / math.sin(math.radians(alpha))
    return turns((a, alpha, 0), (b, 90, 0), (0, 180 - 2 * alpha, 0), (b, 90, 0), (a, 180 - alpha, 0))


def kaleidocycle():
    return turns(*((1, twist, 0) for twist in (60, -60) * 3), seed=1)


def hooke():
    """A cross between shafts at 35 degrees."""
    x, y = (1, 0, 0), (math.cos(math.radians(35)), math.sin(math.radians(35)), 0)
    one = (0, 0.6, 0.8)
    two = np.cross(one, y)
    return chain(("revolute", (-2, 0, 0), x), ("revolute", (0, 0, 0), one), ("revolute", (0, 0, 0), two / np.linalg.norm(two)),
                 ("revolute", (2 * y[0], 2 * y[1], 0), y))


def cardan_shaft():
    """Two crosses with a slip joint between parallel shafts."""
    x, p, q = (1, 0, 0), np.array([0.0, 0, 0]), np.array([3.0, 1, 0])
    u = (q - p) / np.linalg.norm(q - p)
    return chain(("revolute", (-1, 0, 0), x), ("universal", tuple(p), (0, 0, 1), np.cross((0, 0, 1), u)),
                 ("prismatic", tuple(p + u), u, tuple(p + 2 * u)), ("universal", tuple(q), np.cross((0, 0, 1), u), (0, 0, 1)),
                 ("revolute", (4, 1, 0), x))


def clemens():
    """Two shafts, two hinges and a ball in the plane between."""
    half = math.radians(20)
    x, y = np.array([math.cos(half), math.sin(half), 0]), np.array([math.cos(half), -math.sin(half), 0])
    hinge = np.array([math.sin(half) * 0.6, -math.cos(half) * 0.6, 0.8])
    return chain(("revolute", (-1, 0, 0), x), ("revolute", tuple(-1.5 * x), hinge), ("spherical", (0, 0.9, 1.3)),
                 ("revolute", tuple(1.5 * y), hinge * (-1, 1, 1)), ("revolute", (1, 0, 0), y))


def rscr():
    return chain(("revolute", (0, 0, 0), (0, 0, 1)), ("spherical", (1.2, 0.5, 0.3)), ("cylindrical", (2, 2, 1), (0.6, 0, 0.8), (2.6, 2, 1.8)),
                 ("revolute", (4, 1, 0), (0, 1, 0)))


def elbow():
    """Bent rods that slide in both shafts: Hobson's coupling, one rod."""
    return chain(("revolute", (3, 0, 0), (1, 0, 0)), ("cylindrical", (2, 0.6, 0.8), (1, 0, 0), (1.5, 0.6, 0.8)),
                 ("cylindrical", (0.6, 2, 0.8), (0, 1, 0), (0.6, 1.5, 0.8)), ("revolute", (0, 3, 0), (0, 1, 0)))


def hinged(m, a, b, place, axis):
    return m.joint("revolute", a, b, place, axis=np.array(axis, float))


def slider_crank_in_space(m):
    """Haug's: crank 0.8, rod 3."""
    one, two = m.body(), m.body()
    c = (math.cos(0.7), math.sin(0.7))
    a = (0, 1 + 0.8 * c[1], 1.2 + 0.8 * c[0])
    first = hinged(m, 0, one, (0, 1, 1.2), (1, 0, 0))
    m.joint("prismatic", 0, two, (0, 0, 0), (math.sqrt(9 - a[1] ** 2 - a[2] ** 2), 0, 0), axis=np.array([1.0, 0, 0]))
    m.joint("rod", one, two, a, (math.sqrt(9 - a[1] ** 2 - a[2] ** 2), 0, 0))
    m.drive_angle(first)


def wobble_plate(m):
    """A plate on a skew crank, held by a cross, moves two pistons."""
    shaft, plate = m.body(), m.body()
    t = math.radians(20)
    first = hinged(m, 0, shaft, (0, 0, 0), (1, 0, 0))
    hinged(m, shaft, plate, (0, 0, 0), (math.cos(t), math.sin(t), 0))
    m.joint("universal", 0, plate, (0, 0, 0), axis=(0, 0, 1), second=(-math.sin(t), math.cos(t), 0))
    for y, z in ((1, 0), (0, 1.2)):
        piston = m.body()
        ball = (-math.sin(t) * y, math.cos(t) * y, z)
        head = (3, y, z)
        m.joint("prismatic", 0, piston, (2, y, z), head, axis=np.array([1.0, 0, 0]))
        m.joint("rod", plate, piston, ball, head)
    m.drive_angle(first)


def three_rrs(m):
    top = m.body()
    made = []
    for k, lift in enumerate((2.0, 2.3, 1.9)):
        angle = 2 * math.pi * k / 3
        out, side = np.array([math.cos(angle), math.sin(angle), 0]), np.array([-math.sin(angle), math.cos(angle), 0])
        low, high = m.body(), m.body()
        made.append(hinged(m, 0, low, tuple(2 * out), side))
        hinged(m, low, high, tuple(2.8 * out + (0, 0, 1)), side)
        m.joint("spherical", high, top, tuple(1.5 * out + (0, 0, lift)))
    for joint in made:
        m.drive_angle(joint)


def tripteron(m):
    """Three legs of a slide and three turns along x, y and z: nine constraints are redundant."""
    top = m.body()
    made = []
    for k in range(3):
        e, u, v = np.roll(np.eye(3), k, axis=0)
        slide, low, high = m.body(), m.body(), m.body()
        made.append(m.joint("prismatic", 0, slide, tuple(4 * u), tuple(4 * u + (1 + 0.3 * k) * e), axis=e))
        hinged(m, slide, low, tuple(4 * u + (1 + 0.3 * k) * e), e)
        hinged(m, low, high, tuple(2.5 * u + 1.8 * v + (1 + 0.3 * k) * e), e)
        hinged(m, high, top, tuple((1.6 + 0.1 * k) * u + 1.2 * v + (1 + 0.3 * k) * e), e)
    for joint in made:
        m.drive_slide(joint)


def parallelogram(m, base, top, near, far, side, half):
    """Two bars along `side`, hinged about it to the base and to the top, and two links between them."""
    near, far, side = (np.array(x, float) for x in (near, far, side))
    across = np.cross(side, far - near)
    across /= np.linalg.norm(across)
    bar, foot = m.body(), m.body()
    hinged(m, base, bar, tuple(near), side)
    hinged(m, foot, top, tuple(far), side)
    for shift in (half * side, -half * side):
        link = m.body()
        hinged(m, bar, link, tuple(near + shift), across)
        hinged(m, link, foot, tuple(far + shift), across)


def hinged_delta(m):
    """A delta robot of hinges alone: twelve constraints are redundant."""
    top = m.body()
    made = []
    for k, lift in enumerate((0.3, 0.7, 0.5)):
        angle = 2 * math.pi * k / 3 + 0.1
        out, side = np.array([math.cos(angle), math.sin(angle), 0]), np.array([-math.sin(angle), math.cos(angle), 0])
        low = m.body()
        made.append(hinged(m, 0, low, tuple(2 * out), side))
        near, far = 2 * out + 3 * np.array([math.cos(lift) * out[0], math.cos(lift) * out[1], math.sin(lift)]), 0.6 * out + (0.4, -0.3, -6)
        parallelogram(m, low, top, near, far, side, 0.5)
    for joint in made:
        m.drive_angle(joint)


def orthoglide(m):
    top, made = m.body(), []
    place = np.array([0.5, -0.3, 0.4])
    for k in range(3):
        e, side = np.eye(3)[k], np.eye(3)[(k + 1) % 3]
        slide = m.body()
        far = place + 0.6 * e
        off = far - far[k] * e
        near = (far[k] + math.sqrt(16 - off @ off)) * e
        made.append(m.joint("prismatic", 0, slide, tuple(6 * e), tuple(near), axis=e))
        parallelogram(m, slide, top, near, far, side, 0.4)
    for joint in made:
        m.drive_slide(joint)


def arm(m, front, rear):
    body = m.body()
    axis = np.subtract(front, rear)
    return body, hinged(m, 0, body, rear, axis / np.linalg.norm(axis))


def double_wishbone(m):
    """A racing car's hard points, 100 mm, with push rod and rocker."""
    low, joint = arm(m, (1.7698, 2.523, 1.2489), (-1.7512, 2.8187, 1.2641))
    up, _ = arm(m, (1.7851, 2.5087, 2.8196), (-1.7774, 2.8138, 2.6458))
    upright = m.body()
    m.joint("spherical", low, upright, (0.0893, 5.6142, 1.4075))
    m.joint("spherical", up, upright, (-0.1565, 5.451, 3.2375))
    m.joint("rod", 0, upright, (0.7589, 2.3, 2.01), (0.7589, 5.5249, 2.4094))
    rocker = m.body()
    hinged(m, 0, rocker, (0.3, 2.1666, 4.983), (1, 0, 0))
    m.joint("rod", low, rocker, (0.15, 5.1049, 1.3841), (0.3, 1.9529, 5.2512))
    m.drive_angle(joint)


def macpherson(m):
    low, joint = arm(m, (1.5, 3.8, 2.0), (-2.1, 3.9, 2.1))
    upright, strut = m.body(), m.body()
    m.joint("spherical", low, upright, (0.1, 7.2, 1.9))
    top = np.array([-0.3, 5.9, 8.4])
    foot = np.array([0.0, 6.6, 3.6])
    m.joint("spherical", 0, strut, tuple(top))
    m.joint("prismatic", upright, strut, tuple(foot), tuple((foot + top) / 2), axis=(top - foot) / np.linalg.norm(top - foot))
    m.joint("rod", 0, upright, (-1.4, 3.6, 2.6), (-1.3, 6.9, 2.5))
    m.drive_angle(joint)


def five_link(m):
    """Five rods and the spring's length."""
    upright = m.body()
    for inner, outer in (((1.2, 4.0, 4.6), (0.3, 6.8, 4.9)), ((-1.4, 4.1, 4.5), (-0.4, 6.7, 4.8)), ((2.6, 4.6, 1.9), (0.5, 7.0, 1.7)),
                         ((-1.9, 3.4, 1.8), (-0.7, 7.1, 1.6)), ((-2.2, 3.6, 2.6), (-1.6, 6.9, 2.4))):
        m.joint("rod", 0, upright, inner, outer)
    m.drive_slide(m.joint("actuator", 0, upright, (-0.2, 5.2, 7.4), (-0.1, 6.4, 2.2)))


def aileron(m):
    """Bell cranks on skew pivots, one rod after another."""
    last, first = 0, None
    for pivot, axis, come, go in (((0, 0, 0), (0, 0, 1), None, (1, 0.4, 0.2)), ((4, 0.5, 0), (0, 1, 0), (4, 0.5, 0.9), (4.8, 0.5, 0.1)),
                                  ((6, 4, 0.5), (0.8, 0, 0.6), (5.7, 4.9, 0.9), None)):
        body = m.body()
        joint = hinged(m, 0, body, pivot, axis)
        first = first or joint
        if come:
            m.joint("rod", last, body, leave, come)
        last, leave = body, go
    m.drive_angle(first)


def swash_plate(m):
    """A helicopter's: a collar on the mast, three jacks and scissors."""
    collar, plate, low, high = (m.body() for _ in range(4))
    m.joint("prismatic", 0, collar, (0, 0, 0), (0, 0, 2), axis=np.array([0.0, 0, 1]))
    m.joint("spherical", collar, plate, (0, 0, 2))
    hinged(m, 0, low, (1.5, 0, 0.5), (0, 1, 0))
    hinged(m, low, high, (2.4, 0, 1.2), (0, 1, 0))
    m.joint("spherical", high, plate, (1.5, 0, 2))
    for degrees in (60, 180, 300):
        c, s = polar((0, 0), 1.2, degrees)
        m.drive_slide(m.joint("actuator", 0, plate, (c, s, 0), (c, s, 2)))


PLANAR = {
    "hoecken": lambda: four((0, 0), (2, 0), 1, 2.5, 2.5, 50, ahead=5), "chebyshev": lambda: four((0, 0), (4, 0), 5, 2, 5, 60),
    "roberts": lambda: four((0, 0), (4, 0), 3, 2, 3, 65, ahead=1, left=-math.sqrt(8)), "watt-line": watt_line, "evans": evans,
    "hart-inversor": hart_inversor, "antiparallelogram": lambda: four((0, 0), (3, 0), 1, 3, 1, 60, -1),
    "galloway": lambda: four((0, 0), (1, 0), 1, 2, 2, 60), "drag-link": lambda: four((0, 0), (1, 0), 2, 2.5, 2, 40), "locomotive": locomotive,
    "scott-russell": scott_russell, "trammel": trammel, "oldham": oldham, "rhombic-drive": rhombic_drive, "scissor-lift": scissor_lift,
    "pantograph": pantograph, "toggle-press": toggle_press, "atkinson": atkinson, "excavator": excavator, "wiper": wiper,
    "landing-gear": landing_gear, "garage-door": garage_door, "ackermann": ackermann, "davis": davis, "vice-grip": vice_grip,
    "dump-truck": dump_truck, "cardan-gear": cardan_gear, "geneva": geneva, "scara": scara, "umbrella": umbrella, "dixon": dixon, "bourke": bourke,
    "shaper": shaper, "horst-link": horst_link, "rapson": rapson, "beam-engine": beam_engine, "ross-yoke": ross_yoke}
SPATIAL = {
    "hooke": hooke, "cardan-shaft": cardan_shaft, "clemens": clemens, "rscr": rscr, "elbow": elbow, "schatz": schatz, "myard": myard,
    "goldberg": goldberg, "kaleidocycle": kaleidocycle, **{name: lambda sketch=sketch: sketch for name, sketch in {
        "slider-crank-in-space": slider_crank_in_space, "wobble-plate": wobble_plate, "3-rrs": three_rrs, "tripteron": tripteron, "hinged-delta": hinged_delta, "orthoglide": orthoglide,
        "double-wishbone": double_wishbone, "macpherson": macpherson, "five-link": five_link, "aileron": aileron,
        "swash-plate": swash_plate}.items()}}
SKETCHES = {**{name: (Planar, sketch) for name, sketch in PLANAR.items()}, **{name: (Spatial, sketch) for name, sketch in SPATIAL.items()}}


# -------------------------------------------------------------------- along the way that a linkage moves
class Way:
    """Poses of a sketch with its first driver let go: (q, the driver's value), the way on, and how far more than one way is from leading on."""

    def __init__(self, m, steps=60, length=0.12):
        self.m, self.length, turning = m, length, m.drivers[0]["kind"] == "angle"
        self.units = np.append(m.units(), 1.0 if turning else m.size())
        start = (m.drawn(), m.drivers[0]["value"])
        self.nodes = []
        for sign in (1, -1):
            here = start
            way, weak = self.onward(here)
            way = sign * way
            for _ in range(steps):
                self.nodes.append((here, way, weak))
                here = self.ahead(here, way, length)
                if here is None or abs(here[1] - start[1]) > (math.pi if turning else 2 * m.size()):
                    break
                way, weak = self.onward(here, way)
        m.drivers[0]["value"] = start[1]

    def rows(self, place):
        q, value = place
        driver = self.m.drivers[0]
        f = []
        for h in (1e-4, -1e-4, 0):
            driver["value"] = value + h
            f.append(self.m.equations(q[None]))
        by_value = (f[0][0] - f[1][0])[0] / 2e-4
        return f[2][0][0], np.column_stack([f[2][1][0], by_value]) * self.units

    def onward(self, place, before=None):
        _, sigma, v = np.linalg.svd(self.rows(place)[1])
        return v[-1] if before is None or v[-1] @ before >= 0 else -v[-1], sigma[len(self.units) - 2]

    def moved(self, place, step):
        step = step * self.units
        return self.m.moved(place[0][None], step[None, :-1])[0], place[1] + step[-1]

    def ahead(self, place, way, length):
        """The pose so far ahead, across the way; None where Newton's method does not come to one."""
        to = self.moved(place, length * way)
        for _ in range(12):
            f, j = self.rows(to)
            step = np.linalg.lstsq(np.vstack([j, way]), -np.append(f, 0.0), rcond=1e-11)[0]
            if np.linalg.norm(step) > 2 * abs(length) + 1e-3:
                return None
            to = self.moved(to, step)
            if np.linalg.norm(step) < 1e-14:
                break
        return to if np.abs(self.rows(to)[0]).max() < 1e-12 * self.m.size() else None

    def turning(self, coordinates):
        """Nodes after which one of the coordinates turns back."""
        return [(node, c) for node, after in zip(self.nodes, self.nodes[1:]) for c in coordinates
                if node[1][c] * after[1][c] < 0 and min(abs(node[1][c]), abs(after[1][c])) > 1e-9 and node[1] @ after[1] > 0]

    def turned_back(self, node, c):
        place, way, _ = node
        low, high = 0.0, self.length
        for _ in range(60):
            at = self.ahead(place, way, (low + high) / 2)
            if at is None:
                return None
            there, weak = self.onward(at, way)
            low, high = ((low + high) / 2, high) if there[c] * way[c] > 0 else (low, (low + high) / 2)
        return at if weak > 1e-5 else None

    def branching(self):
        found = []
        for before, node, after in zip(self.nodes, self.nodes[1:], self.nodes[2:]):
            place, way, weak = node
            if weak > min(before[2], after[2]) or weak > 0.15:
                continue
            low, high = -self.length, self.length
            while high - low > 1e-9:
                one, two = low + 0.382 * (high - low), low + 0.618 * (high - low)
                a, b = self.ahead(place, way, one), self.ahead(place, way, two)
                if a is None or b is None:
                    break
                low, high = (low, two) if self.onward(a)[1] < self.onward(b)[1] else (one, high)
            at = self.ahead(place, way, (low + high) / 2)
            if at is not None and self.onward(at)[1] < 1e-5:
                found.append(at)
        return found


ALONG = {}


def along(name):
    """(the sketch, its way, its change points)."""
    if name not in ALONG:
        make, sketch = SKETCHES[name]
        m = make(15, "drawing", None)
        sketch()(m)
        residual = np.abs(m.equations(m.drawn()[None])[0]).max()
        if residual > 1e-12 * m.size():
            raise ValueError(f"{name}: the sketch does not close, by {residual:.1e}")
        way = Way(m)
        ALONG[name] = m, way, way.branching()
    return ALONG[name]


def pose(name, kind, rng):
    """(q, the body that is driven there or None, what it is): where a linkage has none of a kind, any pose."""
    m, way, branching = along(name)
    if kind == "lattice":
        return m.drawn(), None, "as sketched"
    if kind == "flat" and branching and rng.random() < 0.7:
        return rng.choice(branching)[0], None, "change point"
    if kind in ("dead", "flat"):
        # In the plane whatever body turns back may be driven there.
        last = len(way.units) - 1
        bodies = range(2, last, 3) if m.space == "planar" else range(last)
        once = m.space == "planar" and len(m.drivers) == 1
        found = way.turning([last, *(bodies if once else [])] if kind == "dead" else bodies)
        rng.shuffle(found)
        for node, c in found[:5]:
            at = way.turned_back(node, c)
            if at is not None:
                return at[0], 1 + c // 3 if kind == "dead" and c < last else None, "dead point" if kind == "dead" else "in line"
    place, onward, _ = rng.choice(way.nodes)
    at = way.ahead(place, onward, rng.uniform(0, way.length))
    return (at or place)[0], None, "random"


def typed_planar(base, q, driven, digits, frames, rng):
    m = Planar(digits, "drawing", rng)
    for k in range(1, len(base.bodies)):
        x, y, phi = q[3 * k - 3:3 * k]
        places = [turned(phi, *p) for p in base.points[k].values()]
        places = [(x + dx, y + dy) for dx, dy in places]
        m.body()
        if frames == "own":
            far = [p for p in places if math.dist(p, places[0]) > 1e-6]
            turn = math.atan2(far[0][1] - places[0][1], far[0][0] - places[0][0]) if far else 0.0
            m.frames[-1] = (*(m.typed(c) for c in places[0]), m.typed(turn))
    made = {}
    for j in base.joints:
        a, b = j["a"], j["b"]
        if j["type"] == "gear":
            m.gear(a, b, j["ratio"], j["carrier"])
            continue
        p, r = (tuple(base.place(q[None], body, j[key])[0][0]) for body, key in ((a, "P"), (b, "Q")))
        more = {"along": turned(float(base.angle(q[None], a)[0]), *j["along"])} if "along" in j else {}
        made[j["name"]] = m.joint(j["type"], a, b, p, p if j["type"] == "revolute" else r, **more)
    for d in base.drivers if driven is None else [{"kind": "angle", "body": driven}]:
        m.drive_angle(d["body"]) if d["kind"] == "angle" else m.drive_slide(made[d["joint"]["name"]])
    return m


def typed_spatial(base, q, _, digits, frames, rng):
    m = Spatial(digits, frames, rng)
    for _ in base.bodies[1:]:
        m.body()
    made = {}
    for j in base.joints:
        a, b = j["a"], j["b"]
        p, r = (base.place(q[None], body, j[key])[0] for body, key in ((a, "P"), (b, "Q")))
        more = {}
        if "axes" in j:
            one, two = (base.state(q[None], body)[0][0] @ np.array(axis) for body, axis in zip((a, b), j["axes"]))
            more = {"axis": one, **({"second": two} if j["type"] == "universal" else {})}
        apart = j["type"] not in ("revolute", "spherical", "universal")
        made[j["name"]] = m.joint(j["type"], a, b, p, r if apart else p, **more)
    for d in base.drivers:
        (m.drive_angle if d["kind"] == "angle" else m.drive_slide)(made[d["joint"]["name"]])
    return m


def draw(name, digits, kind, frames, rng):
    """A linkage, and what its pose is."""
    q, driven, what = pose(name, kind, rng)
    m = along(name)[0]
    return (typed_planar if m.space == "planar" else typed_spatial)(m, q, driven, digits, frames, rng), what
