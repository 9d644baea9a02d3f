# SPDX-License-Identifier: MIT
# Is this list of points really a list of distinct, finite, regular roots? An independent Newton iteration decides.
#
# F and its Jacobian are evaluated in fixed point with FRACTION_BITS bits from the exact coefficients; the Newton
# step is solved in double. The error then falls by about condition * 1e-16 a step, down to far below double.
# A point counts when
#   1. the iteration converges to REFINED_TO, relative to max(1, |x|_inf), and fast: at a singular root it does not;
#   2. it stays within MAY_MOVE of the point, and within NEAREST of the distance to any other root found.
# Points that go to one root count once. Not supported: roots larger than 1e30; multiple roots (they are not counted).
import cmath
import json
import math
import sys

from polynomial_text import read_phcpack

FRACTION_BITS = 256          # 1e-77: room for terms that cancel to 40 digits
REFINED_TO = 1e-26           # far below any two different roots that double can tell apart
MAY_MOVE = 1e-3              # Wilkinson's roots are off by this much when a solver rounds the coefficients
NEAREST = 0.25               # a point halfway between two roots is neither
SAME_ROOT = 1e-12
REAL_TO = 1e-20              # imaginary part of a refined real root
VANISHING_PIVOT = 1e-14      # of a scaled Jacobian known to double precision: it is singular, as on a curve of roots
SHRINKS = 0.1                # of the step before: a root of multiplicity m gives only 1 - 1/m
PUSH = 1e-9                  # relative push before the first step ...
PUSH_FLOOR = 1e-3            # ... of a coordinate that is zero or nearly so
MOST_STEPS = 40

_ONE = 1 << FRACTION_BITS


def _fixed(value):
    """round(value * 2^FRACTION_BITS) of a Fraction, an integer or a double, without rounding twice."""
    if isinstance(value, float):
        mantissa, exponent = math.frexp(value)
        shift = exponent - 53 + FRACTION_BITS
        whole = int(math.ldexp(mantissa, 53))
        return whole << shift if shift >= 0 else whole >> -shift
    return round(value * _ONE)


def _times(a, b):
    return ((a[0] * b[0] - a[1] * b[1]) >> FRACTION_BITS, (a[0] * b[1] + a[1] * b[0]) >> FRACTION_BITS)


def _to_complex(a):
    return complex(a[0] / _ONE, a[1] / _ONE)


class Evaluator:
    """F(x) and dF/dx in fixed point; x is a list of pairs of integers."""

    def __init__(self, system):
        self.n = len(system.variables)
        self.rows = [
            [((_fixed(c[0]), _fixed(c[1])), [(v, e) for v, e in enumerate(m) if e]) for m, c in p.items()]
            for p in system.polynomials
        ]
        self.highest = [max((m[v] for p in system.polynomials for m in p), default=0) for v in range(self.n)]

    def __call__(self, x):
        powers = []
        for value, highest in zip(x, self.highest):
            table = [(_ONE, 0)]
            for _ in range(highest):
                table.append(_times(table[-1], value))
            powers.append(table)
        values, jacobian = [], []
        for row in self.rows:
            total, gradient = [0, 0], [[0, 0] for _ in range(self.n)]
            for coefficient, factors in row:
                for skipped, (v, e) in enumerate(factors):
                    d = _times(coefficient, powers[v][e - 1])
                    for other, (w, k) in enumerate(factors):
                        if other != skipped:
                            d = _times(d, powers[w][k])
                    gradient[v][0] += e * d[0]
                    gradient[v][1] += e * d[1]
                    if skipped == 0:
                        first = _times(d, x[v])
                        total[0] += first[0]
                        total[1] += first[1]
                if not factors:
                    total[0] += coefficient[0]
                    total[1] += coefficient[1]
            values.append(total)
            jacobian.append([_to_complex(g) for g in gradient])
        return [_to_complex(v) for v in values], jacobian


def _solve(matrix, right):
    """Gaussian elimination with partial pivoting after scaling rows and columns; None when a pivot vanishes."""
    n = len(matrix)
    scales = [max(abs(row[j]) for row in matrix) for j in range(n)]
    if min(scales) == 0:
        return None
    rows = []
    for row, b in zip(matrix, right):
        scaled = [a / s for a, s in zip(row, scales)]
        largest = max(map(abs, scaled))
        if largest == 0:
            return None
        rows.append([a / largest for a in scaled] + [b / largest])
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(rows[i][k]))
        if abs(rows[pivot][k]) < VANISHING_PIVOT:
            return None
        rows[k], rows[pivot] = rows[pivot], rows[k]
        for i in range(k + 1, n):
            factor = rows[i][k] / rows[k][k]
            if factor:
                rows[i] = [a - factor * b for a, b in zip(rows[i], rows[k])]
    x = [0j] * n
    for k in reversed(range(n)):
        x[k] = (rows[k][n] - sum(rows[k][j] * x[j] for j in range(k + 1, n))) / rows[k][k]
    return [value / s for value, s in zip(x, scales)]


class Root:
    """x: refined, rounded to complex doubles; real: imaginary parts below REAL_TO; moved: relative to the point given."""

    def __init__(self, x, real, moved):
        self.x = x
        self.real = real
        self.moved = moved


def refine(evaluate, point):
    """The root that Newton reaches from `point`, or None. It starts beside the point: an exact double root shows itself too."""
    if not all(cmath.isfinite(z) and abs(z) < 1e30 for z in point):
        return None
    pushed = [z + PUSH * max(abs(z), PUSH_FLOOR) * cmath.rect(1, k) for k, z in enumerate(point)]
    x = [(_fixed(z.real), _fixed(z.imag)) for z in pushed]
    previous = None
    for _ in range(MOST_STEPS):
        values, jacobian = evaluate(x)
        try:
            step = _solve(jacobian, values)
        except (OverflowError, ZeroDivisionError):
            return None
        if step is None or not all(cmath.isfinite(z) for z in step):
            return None
        x = [(a[0] - _fixed(z.real), a[1] - _fixed(z.imag)) for a, z in zip(x, step)]
        now = [_to_complex(a) for a in x]
        size = max(1.0, max(map(abs, now)))
        moved = max(abs(a - b) for a, b in zip(now, point)) / size
        if moved > MAY_MOVE:
            return None
        length = max(map(abs, step)) / size
        if previous is not None and length <= min(REFINED_TO, SHRINKS * previous):
            real = all(abs(a[1]) <= REAL_TO * size * _ONE for a in x)
            return Root(now, real, moved)
        previous = length
    return None


def verify(system, points):
    """The distinct regular roots among `points`, in no particular order."""
    evaluate = Evaluator(system)
    refined = [root for root in (refine(evaluate, p) for p in points) if root]
    distinct = []
    for root in sorted(refined, key=lambda r: _projection(r.x)):
        if not any(_distance(root.x, other.x) <= SAME_ROOT for other in _neighbours(distinct, root)):
            distinct.append(root)
    return [r for r in distinct if all(r.moved <= NEAREST * _distance(r.x, s.x) for s in distinct if s is not r)]


def _projection(x):
    return sum(z.real * math.cos(1 + k) + z.imag * math.sin(2 + k) for k, z in enumerate(x))


def _neighbours(distinct, root):
    """Roots already kept whose projection is close enough for being the same root."""
    at = _projection(root.x)
    width = SAME_ROOT * 4 * len(root.x) * max(1.0, max(map(abs, root.x)))
    for other in reversed(distinct):
        if at - _projection(other.x) > width:
            return
        yield other


def _distance(a, b):
    """Relative to max(1, |a|_inf)."""
    return max(abs(u - v) for u, v in zip(a, b)) / max(1.0, max(map(abs, a)))


def points_of_moivre(text, system):
    """Solutions of `moivre solve --json`, in the order of the system's variables."""
    result = json.loads(text)
    order = [result["system"]["variables"].index(name) for name in system.variables]
    return [[complex(*solution["x"][k]) for k in order] for solution in result["solutions"]]


def points_of_phcpack(text, system):
    """Solutions in PHCpack's format, as `phc -b` appends them to its input file."""
    points, current = [], {}
    at = text.find("THE SOLUTIONS")
    for line in text[at:].splitlines() if at >= 0 else []:
        if line.startswith("=="):
            if current:
                points.append([current[name] for name in system.variables])
            current = {}
        elif line.startswith(" ") and ":" in line:
            name, _, numbers = line.partition(":")
            re, im = map(float, numbers.split())
            current[name.strip()] = complex(re, im)
    return points


def main(arguments):
    if len(arguments) != 2:
        print("usage: verify_roots.py SYSTEM.phc SOLUTIONS, SOLUTIONS from moivre (JSON) or phc (text)", file=sys.stderr)
        return 1
    system = read_phcpack(arguments[0])
    with open(arguments[1], encoding="utf-8") as file:
        text = file.read()
    reader = points_of_moivre if text.lstrip().startswith("{") else points_of_phcpack
    points = reader(text, system)
    roots = verify(system, points)
    real = sum(r.real for r in roots)
    print(f"{len(points)} points, {len(roots)} distinct regular roots, {real} of them real")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
