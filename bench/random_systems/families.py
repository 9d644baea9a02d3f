# SPDX-License-Identifier: MIT
# Which random systems are asked of a solver? One function a family; a system follows from (seed, family, number) alone.
#
# A polynomial is {exponents: (re, im)}, as in bench/polynomial_algebra.py. Every family gives square systems of at
# most MOST_PATHS total-degree paths that use all their unknowns. What is asked is written beside each family below.
# Python's standard library only.
import random
import sys
from fractions import Fraction
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from polynomial_algebra import constant, degree, plus, scaled, substituted, times, variable

MOST_PATHS = 300        # of total degree: a system is seconds of work, not minutes
MOST_TRIES = 1000       # of a family before it is said to give nothing
LEAST_TERMS = 2         # of an equation: x^2 = 0 alone asks little


class Dice(random.Random):
    """What the families draw."""

    def sign(self):
        return self.choice((-1, 1))

    def digit(self):
        return self.sign() * self.randint(1, 9)

    def decades(self, most):
        """A digit with up to `most` zeros: sizes spread evenly over the decades."""
        return self.digit() * 10 ** self.randint(0, most)

    def number(self):
        """One of three manners of coefficient, drawn anew for each: units, digits, up to four digits."""
        return self.choice((self.sign, self.digit, lambda: self.sign() * self.randint(1, 9999)))()

    def exponents(self, n, d):
        """A monomial of degree at most d; its degree is uniform."""
        m = [0] * n
        for _ in range(self.randint(0, d)):
            m[self.randrange(n)] += 1
        return tuple(m)

    def support(self, n, d, terms):
        """Up to `terms` different monomials, in the order drawn."""
        return list(dict.fromkeys(self.exponents(n, d) for _ in range(terms)))

    def sparse(self, n, d, draw=None, with_constant=True, terms=None):
        draw = draw or self.number
        p = {m: (Fraction(draw()), Fraction(0)) for m in self.support(n, d, terms or self.randint(n + 1, 2 * n + 3))}
        if with_constant:
            p[(0,) * n] = (Fraction(draw()), Fraction(0))
        else:
            p.pop((0,) * n, None)
        return p

    def linear(self, n, draw=None, with_constant=True):
        draw = draw or self.digit
        p = plus(*(scaled(variable(n, i), draw()) for i in range(n)))
        return plus(p, constant(n, draw())) if with_constant else p

    def size(self):
        """(unknowns, degree) of a small system."""
        n = self.choice((2, 2, 3, 3, 4, 5))
        return n, self.choice({2: (3, 4, 5, 6), 3: (2, 3, 4), 4: (2, 3), 5: (2,)}[n])

    def mixing(self, n):
        """Images x_i + c x_j + ...: a unimodular change of unknowns that hides a triangular form."""
        images = [variable(n, i) for i in range(n)]
        for _ in range(n):
            i, j = self.sample(range(n), 2)
            images[i] = plus(images[i], scaled(images[j], self.choice((-2, -1, 1, 2))))
        return images


def sparse(dice):
    """Few terms, a support of its own for each equation: fewer roots than paths."""
    n, d = dice.size()
    return [dice.sparse(n, d) for _ in range(n)]


def wide(dice):
    """The same with coefficients from 1 to 1e8."""
    n, d = dice.size()
    return [dice.sparse(n, d, lambda: dice.decades(8)) for _ in range(n)]


def shared(dice):
    """One support for all equations, coefficients of one size or of many."""
    n, d = dice.size()
    support = list(dice.sparse(n, d))
    most = dice.choice((0, 0, 3, 8))
    return [{m: (Fraction(dice.decades(most)), Fraction(0)) for m in support} for _ in range(n)]


def tops(dice):
    """The highest terms are the same in all equations, up to a factor: most ends are at infinity, and close together there."""
    n, d = dice.choice(((2, 3), (2, 4), (2, 5), (2, 6), (3, 2), (3, 3), (3, 4), (4, 2), (4, 3)))
    top = {m: c for m, c in dice.sparse(n, d, dice.digit, terms=6).items() if sum(m) >= max(2, d - 1)}
    lower = max(1, d - dice.randint(1, 2))
    return [plus(scaled(top, dice.choice((1, 1, dice.digit()))), dice.sparse(n, lower)) for _ in range(n)]


def linprod(dice):
    """Products of linear forms with few terms: roots may be multiple, at infinity or on curves."""
    n = dice.choice((2, 2, 3, 3, 4))

    def form():
        kept = [i for i in range(n) if dice.random() < 0.7] or [dice.randrange(n)]
        p = plus(*(scaled(variable(n, i), dice.digit()) for i in kept))
        return plus(p, constant(n, dice.digit())) if dice.random() < 0.8 else p

    return [times(*(form() for _ in range(dice.randint(2, 2 if n == 4 else 3)))) for _ in range(n)]


def multiple(dice):
    """Powers and products of the equations of a smaller system: its roots are there with multiplicity, others simple."""
    n = dice.choice((2, 2, 3))
    g = [dice.sparse(n, 2, dice.digit, terms=n + 1) for _ in range(n)]
    f = [times(*[g[0]] * dice.choice((2, 2, 3)))]
    for i in range(1, n):
        f.append(dice.choice((g[i], plus(g[i], times(g[0], dice.linear(n))), times(g[i], dice.linear(n)), times(g[i], g[i]))))
    return f


def no_constants(dice):
    """Zero coordinates: no constant terms, or equations that are products with an unknown, as rate equations are."""
    n, d = dice.choice(((2, 3), (2, 4), (2, 5), (3, 2), (3, 3), (3, 4), (4, 2), (4, 3), (5, 2)))
    manner = dice.choice(("none", "none", "all but one", "own factor", "own factor", "some factors", "high"))
    if manner == "none":
        return [dice.sparse(n, d, with_constant=False) for _ in range(n)]
    if manner == "all but one":
        return [dice.sparse(n, d, with_constant=i == 0) for i in range(n)]
    if manner == "own factor":
        return [times(variable(n, i), dice.sparse(n, d - 1)) for i in range(n)]
    if manner == "some factors":
        factors = [dice.choice((constant(n, 1), variable(n, dice.randrange(n)))) for _ in range(n)]
        return [times(factor, dice.sparse(n, d - 1)) for factor in factors]
    return [{m: c for m, c in dice.sparse(n, d, terms=3 * n + 3).items() if sum(m) > 1} for _ in range(n)]


def complex_coefficients(dice):
    """Gaussian integers, of one size or of many: no root has its conjugate beside it."""
    n, d = dice.size()
    most = dice.choice((0, 0, 4))
    return [{m: (c[0], Fraction(dice.decades(most))) if dice.random() < 0.8 else c
             for m, c in dice.sparse(n, d, lambda: dice.decades(most)).items()} for _ in range(n)]


def _triangular(dice, first, n, most_paths=MOST_PATHS):
    """first(x_0), then equations linear or quadratic in x_i with earlier unknowns; unknowns mixed, equations added up."""
    f, paths = [first], degree(first)
    for i in range(1, n):
        earlier = plus(*(scaled(variable(n, j), dice.digit()) for j in range(i)), constant(n, dice.digit()))
        if 2 * paths <= most_paths and dice.random() < 0.6:
            square = times(variable(n, i), variable(n, i))
            f.append(plus(square, times(earlier, variable(n, dice.randrange(i + 1))), constant(n, dice.digit())))
            paths *= 2
        else:
            f.append(plus(scaled(variable(n, i), dice.digit()), earlier))
    images = dice.mixing(n) if n > 1 else [variable(n, 0)]
    return [substituted(p, images) for p in f]


def near_real(dice):
    """Conjugate pairs a +- i e with e from 1e-2 to 1e-9, and real pairs as near to each other: who is real?"""
    n = dice.choice((1, 2, 2, 3))
    factors = []
    for a in dice.sample(range(-6, 7), dice.randint(1, 2)):
        gap = Fraction(dice.randint(1, 9), 10 ** dice.randint(2, 9))
        shifted = plus(variable(n, 0), constant(n, -a))
        factors.append(plus(times(shifted, shifted), constant(n, dice.choice((1, 1, -1)) * gap * gap)))
    factors += [plus(scaled(variable(n, 0), dice.digit()), constant(n, dice.digit())) for _ in range(dice.randint(0, 2))]
    return _triangular(dice, times(*factors), n, 40)


def sizes(dice):
    """Roots of sizes from 1e-12 to 1e12: each unknown in a unit of its own, each equation too; or all sizes in one unknown."""
    if dice.random() < 0.5:
        n = dice.choice((1, 2, 2, 3))
        powers = dice.sample(range(-12, 13), dice.randint(2, 5))
        first = times(*(plus(variable(n, 0), constant(n, dice.digit() * Fraction(10) ** k)) for k in powers))
        f = _triangular(dice, first, n, 40)
    else:
        n, d = dice.size()
        f = [dice.sparse(n, d) for _ in range(n)]
        units = [Fraction(10) ** dice.randint(-12, 12) for _ in range(n)]
        f = [substituted(p, [scaled(variable(n, i), 1 / unit) for i, unit in enumerate(units)]) for p in f]
    return [scaled(p, Fraction(10) ** dice.randint(-6, 6)) for p in f]


def many_unknowns(dice):
    """Six to eight unknowns: sparse quadrics with some linear equations, or a hidden triangular form."""
    n = dice.choice((6, 6, 7, 8))
    if dice.random() < 0.4:
        roots = times(*(plus(scaled(variable(n, 0), dice.digit()), constant(n, dice.digit())) for _ in range(dice.randint(1, 3))))
        return _triangular(dice, roots, n, 64)
    quadrics = dice.randint(4, 6)
    return [dice.sparse(n, 2) if i < quadrics else dice.linear(n) for i in range(n)]


def faces(dice):
    """The terms that are highest in a hidden direction have a common root: the mixed volume, too, is more than the roots."""
    n, d = dice.size()
    weight = [dice.randint(-2, 3) for _ in range(n)]
    f = []
    for _ in range(n):
        p = dice.sparse(n, d, dice.digit, terms=2 * n + 4)
        heights = {m: sum(w * e for w, e in zip(weight, m)) for m in p}
        face = [m for m in p if heights[m] == max(heights.values())]
        if len(face) > 1:
            rest = sum(p[m][0] for m in face[1:])
            p[face[0]] = (-rest, Fraction(0))
        f.append({m: c for m, c in p.items() if c[0]})
    return f


def orbits(dice):
    """A system in products of powers of the unknowns: roots in orbits of a finite group, large winding numbers at infinity."""
    n, d = dice.choice(((2, 2), (2, 3), (3, 1), (3, 2)))
    images = []
    for i in range(n):
        m = [0] * n
        m[i] = dice.randint(1, 3)
        m[(i + 1) % n] += dice.choice((0, 0, 1, 2))
        images.append({tuple(m): (Fraction(1), Fraction(0))})
    return [substituted(dice.sparse(n, d, dice.digit), images) for _ in range(n)]


def near_multiple(dice):
    """`multiple` with constants of 1e-4 to 1e-12 added: clusters of simple roots, which no one may call multiple."""
    f = multiple(dice)
    decades = dice.randint(4, 12)
    return [plus(p, constant(len(f), Fraction(dice.digit(), 10 ** decades))) for p in f]


def beside_curves(dice):
    """A common factor of all equations or of some: curves and surfaces of roots, and isolated roots beside and upon them."""
    n = dice.choice((2, 2, 3, 3))
    h = dice.sparse(n, dice.randint(1, 2), dice.digit, terms=n + 1)
    f = [times(h, dice.sparse(n, dice.randint(1, 2), dice.digit, terms=n + 1)) for _ in range(n)]
    if n == 3 and dice.random() < 0.5:
        f[2] = dice.sparse(n, 2, dice.digit, terms=n + 1)
    return f


def combined(dice):
    """A(x) g(x) with polynomial matrices A: few roots at moderate places, singular ends at infinity, no sparsity to see it by."""
    n = dice.choice((2, 2, 3))
    g = [dice.sparse(n, 1 if n == 3 else 2, dice.digit, terms=n + 1) for _ in range(n)]
    f = []
    for i in range(n):
        others = [times(dice.linear(n), p) for j, p in enumerate(g) if j < i]
        f.append(plus(times(g[i], dice.choice((constant(n, 1), constant(n, dice.digit()), dice.linear(n)))), *others))
    dice.shuffle(f)
    return [plus(f[0], scaled(p, dice.digit())) if k else p for k, p in enumerate(f)]


def through_lines(dice, images_of):
    """Few lines through 0 in many dimensions, each equation of order 2 there: singular, on curves, and hard to see so. Then 0 is moved."""
    n = dice.choice((3, 4, 4, 5, 5))
    lines = [[dice.randint(-3, 3) for _ in range(n)] for _ in range(dice.randint(1, 3))]
    lines = [v for v in lines if any(v)]

    def form_through(v):
        j = next(i for i in range(n) if v[i])
        c = [dice.randint(-5, 5) for _ in range(n)]
        c[j] = Fraction(-sum(a * b for i, (a, b) in enumerate(zip(c, v)) if i != j), v[j])
        return plus(*(scaled(variable(n, i), a * abs(v[j])) for i, a in enumerate(c)))

    def product():
        parts = [form_through(v) for v in lines]
        while len(parts) < 2:
            parts.append(dice.linear(n, with_constant=False))
        return times(*parts)

    images = images_of(n)
    f = []
    for _ in range(n):
        p = plus(*(product() for _ in range(2 * n)))
        if dice.random() < 0.3:
            p = times(p, dice.linear(n))
        f.append(substituted(p, images) if p else p)
    return f


def cones(dice):
    """The lines meet in a rational point."""

    def moved(n):
        point = [dice.choice((0, 0, dice.randint(-2, 2))) for _ in range(n)]
        return [plus(variable(n, i), constant(n, -a)) if a else variable(n, i) for i, a in enumerate(point)]

    return through_lines(dice, moved)


def irrational_cones(dice):
    """Curves instead of lines, through two points with a coordinate +-sqrt(2) or +-sqrt(3): no exact algebra knows them."""

    def folded(n):
        images = [variable(n, i) for i in range(n)]
        i = dice.randint(0, n - 1)
        images[i] = plus(times(images[i], images[i]), constant(n, -dice.randint(2, 3)))
        return images

    return through_lines(dice, folded)


FAMILIES = {
    "sparse": sparse, "wide": wide, "shared": shared, "tops": tops, "linprod": linprod, "multiple": multiple,
    "no-constants": no_constants, "complex": complex_coefficients, "near-real": near_real, "sizes": sizes,
    "many-unknowns": many_unknowns, "faces": faces, "orbits": orbits, "near-multiple": near_multiple,
    "beside-curves": beside_curves, "combined": combined, "cones": cones,
    "irrational-cones": irrational_cones,
}


def is_usable(f):
    n = len(f)
    if any(len(p) < LEAST_TERMS or degree(p) == 0 for p in f):
        return False
    paths = 1
    for p in f:
        paths *= degree(p)
    return paths <= MOST_PATHS and all(any(m[i] for p in f for m in p) for i in range(n))


def system_of(seed, family, number):
    """The polynomials of one system."""
    dice = Dice(f"moivre {seed} {family} {number}")
    for _ in range(MOST_TRIES):
        f = FAMILIES[family](dice)
        if is_usable(f):
            return f
    raise ValueError(f"{family} {number}: no usable system in {MOST_TRIES} tries")
