# SPDX-License-Identifier: MIT
# Which system does a PHCpack text file hold? Exact sparse polynomials for the checks that do not trust Moivre's reader.
#
# A polynomial is {exponents: (re, im)}: exponents a tuple with one entry a variable, re and im
# Fractions. Variables stand in order of first appearance, as everywhere in Moivre.
# Python's standard library only. Not supported: division by anything but a number.
import re
from fractions import Fraction

_TOKEN = re.compile(r"\s*(?:(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)|([A-Za-z_]\w*)|(\*\*|[-+*/^();]))")


class System:
    """variables: names; polynomials: one dict a polynomial."""

    def __init__(self, variables, polynomials):
        self.variables = variables
        self.polynomials = polynomials

    def degrees(self):
        return [max(map(sum, p), default=0) for p in self.polynomials]

    def total_degree(self):
        product = 1
        for d in self.degrees():
            product *= d
        return product

    def is_real(self):
        return all(c[1] == 0 for p in self.polynomials for c in p.values())


def read_phcpack(path):
    with open(path, encoding="utf-8") as file:
        return parse_phcpack(file.read())


def parse_phcpack(text):
    header, _, body = text.lstrip().partition("\n")
    count = int(header.split()[0])
    parser = _Parser(body)
    sparse = [parser.polynomial() for _ in range(count)]
    n = len(parser.names)
    return System(parser.names, [_dense_exponents(p, n) for p in sparse])


def _dense_exponents(sparse, n):
    dense = {}
    for monomial, c in sparse.items():
        exponents = [0] * n
        for variable, power in monomial:
            exponents[variable] = power
        dense[tuple(exponents)] = c
    return dense


def _multiply_numbers(a, b):
    return (a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0])


def _add(a, b, sign=1):
    total = dict(a)
    for monomial, c in b.items():
        old = total.get(monomial, (0, 0))
        total[monomial] = (old[0] + sign * c[0], old[1] + sign * c[1])
    return {m: c for m, c in total.items() if c != (0, 0)}


def _multiply(a, b):
    total = {}
    for m, c in a.items():
        for k, d in b.items():
            powers = dict(m)
            for variable, power in k:
                powers[variable] = powers.get(variable, 0) + power
            monomial = tuple(sorted(powers.items()))
            e = _multiply_numbers(c, d)
            old = total.get(monomial, (0, 0))
            total[monomial] = (old[0] + e[0], old[1] + e[1])
    return {m: c for m, c in total.items() if c != (0, 0)}


class _Parser:
    """Recursive descent over the tokens of the polynomials, one `;` a polynomial."""

    def __init__(self, text):
        self.text = text
        self.position = 0
        self.names = []
        self.token = None

    def advance(self):
        match = _TOKEN.match(self.text, self.position)
        if not match:
            raise ValueError(f"unreadable text: {self.text[self.position:self.position + 20]!r}")
        self.position = match.end()
        self.token = match.groups()

    def polynomial(self):
        self.advance()
        value = self.sum()
        if self.token[2] != ";":
            raise ValueError(f"expected ';', found {self.token}")
        return value

    def sum(self):
        value = self.product()
        while self.token[2] in ("+", "-"):
            sign = 1 if self.token[2] == "+" else -1
            self.advance()
            value = _add(value, self.product(), sign)
        return value

    def product(self):
        if self.token[2] in ("+", "-"):
            sign = 1 if self.token[2] == "+" else -1
            self.advance()
            return _add({}, self.product(), sign)
        value = self.power()
        while self.token[2] in ("*", "/"):
            divides = self.token[2] == "/"
            self.advance()
            factor = self.power()
            value = _multiply(value, {(): _reciprocal(factor[()])} if divides else factor)
        return value

    def power(self):
        value = self.atom()
        if self.token[2] in ("^", "**"):
            self.advance()
            exponent = int(self.token[0])
            self.advance()
            result = {(): (Fraction(1), Fraction(0))}
            for _ in range(exponent):
                result = _multiply(result, value)
            return result
        return value

    def atom(self):
        number, name, symbol = self.token
        if symbol == "(":
            self.advance()
            value = self.sum()
            if self.token[2] != ")":
                raise ValueError("expected ')'")
        elif number is not None:
            value = {(): (Fraction(number), Fraction(0))} if Fraction(number) else {}
        elif name in ("i", "I"):
            value = {(): (Fraction(0), Fraction(1))}
        elif name is not None:
            if name not in self.names:
                self.names.append(name)
            value = {((self.names.index(name), 1),): (Fraction(1), Fraction(0))}
        else:
            raise ValueError(f"unexpected {symbol!r}")
        self.advance()
        return value


def _reciprocal(c):
    norm = c[0] * c[0] + c[1] * c[1]
    return (c[0] / norm, -c[1] / norm)
