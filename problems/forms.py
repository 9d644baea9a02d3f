# SPDX-License-Identifier: MIT
# What are the equations of five poses, of an Assur structure, of a platform, of a game, of a network? For problems/generate.
#
# Each function gives (names, polynomials): exact polynomials as in bench/polynomial_algebra.py whose unknowns are `names` in
# this order. Rotations are rational (cos and sin of an angle with a rational half-angle tangent; quaternions of integers), so
# that the files hold the exact problem and no root comes in from infinity by rounding. Planar bodies are in isotropic
# coordinates [Wampler96]: a point is a complex number z and its conjugate, a direction t = e^(i phi) and u = 1/t.
# Python's standard library only.
import sys
from fractions import Fraction
from itertools import combinations
from math import lcm
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "bench"))
from polynomial_algebra import constant, plus, scaled, times, variable


def _unknowns(names):
    return [variable(len(names), i) for i in range(len(names))]


def _number(n, z):
    """The constant z, a pair (re, im) or one number."""
    re, im = z if isinstance(z, tuple) else (z, 0)
    return {(0,) * n: (Fraction(re), Fraction(im))} if re or im else {}


def _dot(a, b):
    return plus(*(times(p, q) for p, q in zip(a, b)))


def _rotation(q):
    """Rows of the rotation by the integer quaternion q = (w, x, y, z), of any length."""
    w, x, y, z = q
    n = w * w + x * x + y * y + z * z
    rows = ((w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)),
            (2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)),
            (2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z))
    return [[Fraction(entry, n) for entry in row] for row in rows]


def _equal_lengths(names, poses):
    """|R u + d - x|^2 is |u - x|^2 in every pose (R, d): the point u of the body moves on a circle or sphere about x."""
    n, d = len(names), len(names) // 2
    unknown = _unknowns(names)
    u, x = unknown[:d], unknown[d:]
    equations = []
    for rotation, shift in poses:
        image = [plus(*(scaled(ui, c) for ui, c in zip(u, row)), constant(n, s)) for row, s in zip(rotation, shift)]
        difference = [plus(i, scaled(xi, -1)) for i, xi in zip(image, x)]
        first = [plus(ui, scaled(xi, -1)) for ui, xi in zip(u, x)]
        equations.append(plus(_dot(difference, difference), scaled(_dot(first, first), -1)))
    return names, [_without_denominators(p) for p in equations]


def _without_denominators(p):
    return scaled(p, lcm(*(part.denominator for c in p.values() for part in c)))


def five_poses():
    """The first pose is the identity; (p, q, dx, dy): tan of half the angle is p/q."""
    poses = []
    for p, q, dx, dy in ((3, 4, 4, -1), (1, 3, 4, 0), (-3, 2, 1, -1), (-2, 3, -1, 0)):
        c, s = Fraction(q * q - p * p, q * q + p * p), Fraction(2 * p * q, q * q + p * p)
        poses.append((((c, -s), (s, c)), (dx, dy)))
    return _equal_lengths(["u", "v", "x", "y"], poses)


def seven_poses():
    poses = [((2, 1, 0, 1), (1, 2, -1)), ((3, -1, 1, 0), (-2, 1, 3)), ((1, 1, 2, -1), (3, -1, 2)), ((2, 0, -1, 3), (1, 4, 1)),
             ((3, 2, 1, -2), (-1, -3, 2)), ((1, -2, 2, 2), (2, 2, -4))]
    return _equal_lengths(["u1", "u2", "u3", "x1", "x2", "x3"], [(_rotation(q), shift) for q, shift in poses])


def _loops(loops):
    """Loops {link: coefficient, 0: constant}: sum a_k t_k + a_0 = 0, its conjugate, and t_k u_k = 1 for each link k."""
    links = max(max(loop) for loop in loops)
    names = [f"t{k}" for k in range(1, links + 1)] + [f"u{k}" for k in range(1, links + 1)]
    n, unknown = len(names), _unknowns(names)

    def side(loop, first, sign):
        terms = [constant(n, 0)]
        for k, z in loop.items():
            re, im = z if isinstance(z, tuple) else (z, 0)
            terms.append(times(unknown[first + k - 1] if k else constant(n, 1), _number(n, (_exact(re), sign * _exact(im)))))
        return plus(*terms)

    return names, ([side(loop, 0, 1) for loop in loops] + [side(loop, links, -1) for loop in loops]
                   + [plus(times(unknown[k], unknown[links + k]), constant(n, -1)) for k in range(links)])


def _exact(value):
    return Fraction(str(value))


def seven_links_central():
    """Ternary links 1, 2, 3 turn about the corners of the ground; bars 4, 5, 6 join them to a ring."""
    return _loops([
        {1: (1.2, 0.5), 4: 3.9, 2: (-0.9, 0.7), 0: (-4, 0)},
        {2: (1.4, 0.3), 5: 4.3, 3: (-1.1, -0.6), 0: (2.5, -3)},
        {3: (0.8, 1.3), 6: 4.8, 1: (-1.5, 0.4), 0: (1.5, 3)},
    ])


def seven_links_serial():
    """As problems/mechanisms/assur-7-serial.toml."""
    return _loops([
        {1: (-1.19, -1.15), 4: 3.79, 2: (-2.62, 0.96), 0: -4},
        {1: (-1.99, -2.6), 5: 3.42, 2: (-1.36, -0.31), 3: (-2.53, -0.5), 0: -4},
        {6: 5.29, 2: (-1.36, -0.31), 3: (2.52, 1.93), 0: (-1.86, -2.9)},
    ])


def seven_links_quaternary():
    """As problems/mechanisms/assur-7-quaternary.toml."""
    return _loops([
        {1: 0.7, 2: 0.8, 3: -0.4, 0: (-0.7, -0.2)},
        {2: (0.6, 0.5), 3: 0.4, 4: -0.6, 5: 0.8, 0: -0.6},
        {4: 0.6, 5: (0.4, 0.3), 6: -0.9, 0: (-0.5, 0.5)},
    ])


def nine_links():
    """Bars 1 to 4 from the ground to ternary links 5 to 8, which are joined to a ring: the Assur structure 4/4."""
    pivots = ((0, 0), (4, -0.5), (5, 3.5), (0.5, 4))
    bars = (1.5, 1.43, 1.61, 1.66)
    before = ((-0.6, 0.9), (-1.2, -0.5), (0.5, -0.8), (1.1, 0.7))      # the joint with the link before, in the link's frame
    after = ((1, -0.6), (0.7, 1.1), (-1.1, 0.6), (-0.8, -0.8))
    loops = []
    for k in range(4):
        m = (k + 1) % 4
        ground = tuple(_exact(a) - _exact(b) for a, b in zip(pivots[k], pivots[m]))
        loops.append({k + 1: bars[k], k + 5: after[k], m + 1: -bars[m], m + 5: tuple(-c for c in before[m]), 0: ground})
    return _loops(loops)


def platform(base, moving, lengths):
    """Study's form of a Stewart-Gough platform, q0 = 1: leg 1, the others less leg 1, Study's quadric.

    Rotation by the quaternion q, translation g q^-1 with g.q = 0. A leg |R a + t - b| = l times |q|^2 is
    |g|^2 + (a.a + b.b - l^2) |q|^2 + 2 a.vec(q* g) - 2 b.vec(g q*) - 2 b.(q a q*).
    """
    names = ["q1", "q2", "q3", "g0", "g1", "g2", "g3"]
    unknown = _unknowns(names)
    q, g = [constant(7, 1), *unknown[:3]], unknown[3:]
    conjugate = [q[0], *(scaled(p, -1) for p in q[1:])]
    legs = []
    for b, a, length in zip(base, moving, lengths):
        a, b, length = [_exact(c) for c in a], [_exact(c) for c in b], _exact(length)
        point_a, point_b = ([constant(7, 0), *(_number(7, c) for c in p)] for p in (a, b))
        square = sum(c * c for c in a) + sum(c * c for c in b) - length * length
        turned = _product(_product(q, point_a), conjugate)
        legs.append(plus(_dot(g, g), scaled(_dot(q, q), square), scaled(_dot(point_a, _product(conjugate, g)), 2),
                         scaled(_dot(point_b, _product(g, conjugate)), -2), scaled(_dot(point_b, turned), -2)))
    return names, [legs[0], *(plus(leg, scaled(legs[0], -1)) for leg in legs[1:]), _dot(q, g)]


def _product(p, q):
    """Hamilton's product of two quaternions of polynomials."""
    signs = ((1, -1, -1, -1), (1, 1, 1, -1), (1, -1, 1, 1), (1, 1, -1, 1))
    parts = (((0, 0), (1, 1), (2, 2), (3, 3)), ((0, 1), (1, 0), (2, 3), (3, 2)), ((0, 2), (1, 3), (2, 0), (3, 1)),
             ((0, 3), (1, 2), (2, 1), (3, 0)))
    return [plus(*(scaled(times(p[i], q[j]), s) for (i, j), s in zip(row, sign))) for row, sign in zip(parts, signs)]


def dietmaier():
    return platform(
        ((0, 0, 0), (1.107915, 0, 0), (0.549094, 0.756063, 0), (0.735077, -0.223935, 0.525991), (0.514188, -0.526063, -0.368418),
         (0.590473, 0.094733, -0.205018)),
        ((0, 0, 0), (0.542805, 0, 0), (0.956919, -0.528915, 0), (0.665885, -0.353482, 1.402538), (0.478359, 1.158742, 0.107672),
         (-0.137087, -0.235121, 0.353913)),
        (1, 0.645275, 1.086284, 1.503439, 1.281933, 0.771071))


def tangent_conics(points, lines):
    """a x^2 + b x y + c y^2 + p x + q y + 1 = 0 through the points (x, y) and tangent to the lines l1 x + l2 y + l3 = 0.

    A line touches where l.adj(M) l = 0, M the symmetric matrix of the conic; here twice M.
    """
    names = ["a", "b", "c", "p", "q"]
    a, b, c, p, q = _unknowns(names)
    f = constant(5, 1)
    equations = [plus(*(scaled(r, w) for r, w in zip((a, b, c, p, q, f), (x * x, x * y, y * y, x, y, 1)))) for x, y in points]
    matrix = ((scaled(a, 2), b, p), (b, scaled(c, 2), q), (p, q, scaled(f, 2)))

    def cofactor(i, j):
        (r, s), (u, v) = ((i + 1) % 3, (i + 2) % 3), ((j + 1) % 3, (j + 2) % 3)
        return plus(times(matrix[r][u], matrix[s][v]), scaled(times(matrix[r][v], matrix[s][u]), -1))

    for line in lines:
        equations.append(plus(*(scaled(cofactor(i, j), line[i] * line[j]) for i in range(3) for j in range(3))))
    return names, equations


POINTS = ((1, 2), (-2, 3), (3, -1))
LINES = ((1, 2, 5), (3, -1, 7), (2, 5, -13))


def nash(n, draw):
    """Totally mixed equilibria of n players with two strategies each: p_j in equation i for every j but i, all products.

    `draw` gives the difference of player i's two payoffs for each choice of the others, an integer.
    """
    names = [f"p{i}" for i in range(1, n + 1)]
    unknown = _unknowns(names)
    equations = []
    for i in range(n):
        others = [p for j, p in enumerate(unknown) if j != i]
        terms = []
        for size in range(n):
            for chosen in combinations(range(n - 1), size):
                probability = constant(n, 1)
                for j, p in enumerate(others):
                    probability = times(probability, p if j in chosen else plus(constant(n, 1), scaled(p, -1)))
                terms.append(scaled(probability, draw()))
        equations.append(plus(*terms))
    return names, equations


def wnt(draw):
    """Steady states of the shuttle model of the Wnt pathway [GHRS16, (1) and (2)]; `draw` gives rates and totals.

    The rates of change of x2, x4, x8, x9 and x12 follow from the others and the conserved totals; they are left out.
    """
    names = [f"x{i}" for i in range(1, 20)]
    x = dict(enumerate(_unknowns(names), 1))
    k = {i: draw() for i in range(1, 32)}
    totals = [draw() for _ in range(5)]

    def rate(*terms):
        return plus(*(scaled(times(*(x[i] for i in factors)) if factors else constant(19, 1), c) for c, factors in terms))

    rates = [
        rate((-k[1], (1,)), (k[2], (2,))),
        rate((k[26], (2,)), (-k[27], (3,)), (-k[14], (3, 6)), (k[15] + k[16], (15,))),
        rate((-k[28], (5,)), (k[29], (7,)), (-k[6], (5, 8)), (k[5], (14,)), (k[7], (16,))),
        rate((-k[14], (3, 6)), (-k[20], (6, 11)), (k[15], (15,)), (k[19], (17,)), (k[21] + k[22], (19,))),
        rate((k[28], (5,)), (-k[29], (7,)), (-k[17], (7, 9)), (k[16], (15,)), (k[18], (17,))),
        rate((k[12], ()), (-k[13] - k[30], (10,)), (-k[9], (4, 10)), (k[31], (11,)), (k[10], (18,))),
        rate((-k[23] - k[31], (11,)), (k[30], (10,)), (-k[20], (6, 11)), (-k[24], (11, 12)), (k[25], (13,)), (k[21], (19,))),
        rate((k[24], (11, 12)), (-k[25], (13,))),
        rate((k[3], (2, 4)), (-k[4] - k[5], (14,))),
        rate((k[14], (3, 6)), (-k[15] - k[16], (15,))),
        rate((k[6], (5, 8)), (-k[7] - k[8], (16,))),
        rate((k[17], (7, 9)), (-k[18] - k[19], (17,))),
        rate((k[9], (4, 10)), (-k[10] - k[11], (18,))),
        rate((k[20], (6, 11)), (-k[21] - k[22], (19,))),
    ]
    conserved = ((1, 2, 3, 14, 15), (4, 5, 6, 7, 14, 15, 16, 17, 18, 19), (8, 16), (9, 17), (12, 13))
    return names, rates + [plus(*(x[i] for i in species), constant(19, -total)) for species, total in zip(conserved, totals)]


def minors(rows, columns, order, names, draw):
    """The minors of `order` of a rows x columns matrix of linear forms in `names`; `draw` gives the coefficients."""
    n = len(names)
    unknown = [*_unknowns(names), constant(n, 1)]
    matrix = [[plus(*(scaled(p, draw()) for p in unknown)) for _ in range(columns)] for _ in range(rows)]
    return names, [_determinant([[matrix[i][j] for j in chosen] for i in others])
                   for others in combinations(range(rows), order) for chosen in combinations(range(columns), order)]


def _determinant(matrix):
    if len(matrix) == 1:
        return matrix[0][0]
    return plus(*(scaled(times(entry, _determinant([row[:j] + row[j + 1:] for row in matrix[1:]])), (-1) ** j)
                  for j, entry in enumerate(matrix[0])))
