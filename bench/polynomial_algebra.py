# SPDX-License-Identifier: MIT
# What are sums, products and the text of exact sparse polynomials? For the generators of test systems.
#
# A polynomial is {exponents: (re, im)} with Fractions, as in polynomial_text.py: exponents a tuple with one entry a variable.
# Python's standard library only.
from fractions import Fraction

LONG_INTEGER = 10 ** 9  # from here on zeros at the end are written as a power of ten
FEWEST_ZEROS = 3        # behind a decimal point, from which on a power of ten is written


def constant(n, c):
    return {(0,) * n: (Fraction(c), Fraction(0))}


def variable(n, i):
    return {tuple(int(i == j) for j in range(n)): (Fraction(1), Fraction(0))}


def plus(*polynomials):
    total = {}
    for p in polynomials:
        for m, c in p.items():
            old = total.get(m, (0, 0))
            total[m] = (old[0] + c[0], old[1] + c[1])
    return {m: c for m, c in total.items() if c != (0, 0)}


def times(*polynomials):
    result = polynomials[0]
    for q in polynomials[1:]:
        terms = []
        for m, c in result.items():
            terms += [{tuple(map(sum, zip(m, k))): (c[0] * d[0] - c[1] * d[1], c[0] * d[1] + c[1] * d[0])} for k, d in q.items()]
        result = plus(*terms)
    return result


def scaled(p, c):
    return {m: (a[0] * c, a[1] * c) for m, a in p.items() if c}


def degree(p):
    return max(map(sum, p), default=0)


def substituted(p, images):
    """p at x_i = images[i], polynomials all."""
    n = len(next(iter(images[0])))
    parts = []
    for m, c in p.items():
        term = {(0,) * n: c}
        for image, exponent in zip(images, m):
            for _ in range(exponent):
                term = times(term, image)
        parts.append(term)
    return plus(*parts)


def decimal(value):
    """The exact text of a Fraction: an integer, a decimal with its power of ten, or a quotient."""
    power = 0
    while value.denominator > 1 and value.denominator % 2 * (value.denominator % 5) == 0:
        value, power = value * 10, power - 1
    if value.denominator > 1:
        return f"({value.numerator}/{value.denominator * 10 ** -power})"
    number = value.numerator
    if abs(number) >= LONG_INTEGER:
        while number % 10 == 0:
            number, power = number // 10, power + 1
    zeros = -power - len(str(abs(number)))
    if power < 0 and zeros < FEWEST_ZEROS:
        digits = str(abs(number)).rjust(1 - power, "0")
        return ("-" if number < 0 else "") + digits[:power] + "." + digits[power:]
    return f"{number}e{power}" if power else str(number)


def _term_text(m, c, names):
    """(sign, the rest) of one term."""
    powers = [names[i] if e == 1 else f"{names[i]}^{e}" for i, e in enumerate(m) if e]
    if c[1]:
        sign, number = "+", f"({decimal(c[0])}{'-' if c[1] < 0 else '+'}{decimal(abs(c[1]))}*i)"
    else:
        sign, number = "-" if c[0] < 0 else "+", decimal(abs(c[0]))
    return sign, "*".join(powers if number == "1" and powers else [number, *powers])


def polynomial_text(p, names, space=""):
    """Highest terms first; `space` stands on both sides of a sign between two terms."""
    text = ""
    for m in sorted(p, key=lambda m: (sum(m), m), reverse=True):
        sign, rest = _term_text(m, p[m], names)
        text += (space + sign + space if text else sign.strip("+")) + rest
    return text


def phc_text(f):
    """The system in PHCpack's format, unknowns x1, x2, ..."""
    names = [f"x{i + 1}" for i in range(len(next(iter(f[0]))))]
    return f"{len(f)}\n" + "".join(polynomial_text(p, names) + ";\n" for p in f)
