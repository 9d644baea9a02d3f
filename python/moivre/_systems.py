# SPDX-License-Identifier: MIT
# Which system does a user mean? Text, a file, equations of sympy, or arrays of coefficients and exponents; every number exact.
"""Systems of equations from what users have."""

import decimal
import math
import numbers
import os
import re
import sys

from . import _moivre
from ._errors import ParseError

TEXT = "equations"
_FORMS = "equations are a text, a path, a list of texts, a list of sympy's expressions, or a list of (coefficients, exponents)"
# One word with an ending, as "katsura.phc": no equation looks like it.
_PATH = re.compile(r"[^;*+^=()\n]*\.[A-Za-z]\w*")

# A name of a text, and those that mean something else there.
_PLAIN = re.compile(r"[A-Za-z]\w*", re.ASCII)
_MEANT = ("i", "I", "pi")
_BEHIND = re.compile(r"^\s*(END|TITLE|THE SOLUTIONS)\b", re.MULTILINE)


def _is_sympy(value):
    """Whether sympy is in use and the value is one of its objects; sympy is not imported for it."""
    sympy = sys.modules.get("sympy")
    return sympy is not None and isinstance(value, sympy.Basic)


def _ratio(number, what):
    """A real number as "numerator/denominator", and whether it is exact by its kind (a float is the double that it is)."""
    if isinstance(number, numbers.Rational):
        return f"{int(number.numerator)}/{int(number.denominator)}", True
    if isinstance(number, decimal.Decimal):
        if not number.is_finite():
            raise ValueError(f"{what}: {number} is not finite")
        return "{}/{}".format(*number.as_integer_ratio()), True
    if isinstance(number, numbers.Real):
        number = float(number)
        if not math.isfinite(number):
            raise ValueError(f"{what}: {number} is not finite")
        return "{}/{}".format(*number.as_integer_ratio()), False
    raise ValueError(f"{what}: {number!r} is no number")


def _exact(number, what):
    """((re, im), is_exact): both parts as "numerator/denominator"."""
    if _is_sympy(number):
        return _exact_sympy(number, what)
    if isinstance(number, numbers.Complex) and not isinstance(number, numbers.Real):
        (re_, a), (im, b) = _ratio(number.real, what), _ratio(number.imag, what)
        return (re_, im), a and b
    text, is_exact = _ratio(number, what)
    return (text, "0"), is_exact


def _exact_sympy(number, what):
    parts = _rational_parts(number)
    if parts is None:
        raise ValueError(f"{what}: {number} is neither rational nor a float; give it as a float (.evalf())")
    return parts, True


def _rational_parts(number):
    """Real and imaginary part of a number of sympy as "p/q"; None where they are no rationals."""
    parts = number.as_real_imag()
    return tuple(f"{part.p}/{part.q}" for part in parts) if all(part.is_Rational for part in parts) else None


def _natural(symbol):
    """x2 stands before x10."""
    return [int(part) if part.isdigit() else part for part in re.split(r"(\d+)", str(symbol))]


def _polynomial_terms(expression, symbols):
    """(coefficients, exponents) of a polynomial with rational coefficients; None of any other expression."""
    import sympy
    try:
        terms = [(c, monomial) for monomial, c in sympy.Poly(expression, *symbols).terms() if c != 0]
    except sympy.PolynomialError:
        return None
    except (sympy.polys.polyerrors.BasePolynomialError, IndexError):
        raise ValueError(f"{expression}: an equation has numbers, unknowns and functions of numbers") from None
    coefficients = [_rational_parts(c) for c, _ in terms]
    return None if None in coefficients else (coefficients, [monomial for _, monomial in terms])


def _typed_name(name, taken):
    """A name that a text can hold and that means nothing else there: the symbol's own where it can be."""
    if _PLAIN.fullmatch(name) and name not in _MEANT:
        return name
    k = 1
    while f"s{k}" in taken:
        k += 1
    taken.add(f"s{k}")
    return f"s{k}"


def _typed(expression, names=None):
    """An expression as a text, with these names for its symbols."""
    import sympy
    from sympy.printing.str import StrPrinter

    class Typist(StrPrinter):
        def _print_Exp1(self, _):
            return "exp(1)"

        def _print_Symbol(self, symbol):
            return (names or {}).get(symbol, symbol.name)

    # What sympy has a closed form of: the golden ratio, gamma(3).
    closed = expression.xreplace({x: x.expand(func=True) for x in expression.atoms(sympy.NumberSymbol)})
    return Typist().doprint(closed)


def _of_typed(expressions, symbols, is_exact):
    """The system as the reader of texts takes it: denominators, sqrt(2), pi."""
    taken = {str(s) for s in symbols}
    names = {s: _typed_name(str(s), taken) for s in symbols}
    texts = [_typed(expression, names) for expression in expressions]
    try:
        # Behind a number no name is the heading of a file.
        system = _moivre.system_of_text(TEXT, "".join(f"0 + {text};\n" for text in texts))
    except ParseError as refusal:
        # One behind the last line is of the whole, and there because of others.
        raise ValueError("; ".join(f"equation {line}: {expressions[line - 1]}: {fault}"
                                   for line, _, fault in refusal.faults if line <= len(expressions))) from None
    return system.in_unknowns([(names[s], str(s)) for s in symbols], is_exact)


def _condition_text(relation):
    """A relation of sympy, x*y > 2, as text: both sides as they are, numbers with all their digits."""
    import sympy
    sides = [_typed(side.xreplace({x: sympy.Rational(x) for x in side.atoms(sympy.Float)})) for side in relation.args]
    return f"{sides[0]} {relation.rel_op} {sides[1]}"


def _parts(conditions):
    """Each by itself, where sympy's And holds several."""
    for condition in conditions:
        if not _is_sympy(condition):
            yield condition
            continue
        from sympy import And, Not, Or
        if isinstance(condition, (Or, Not)):
            raise ValueError(f"{condition}: {type(condition).__name__} is no condition: all conditions of a list, or of And, are to hold")
        yield from _parts(condition.args) if isinstance(condition, And) else [condition]


def _is_inequality(value):
    """Whether it is one of sympy's x > 0, x >= 0, x < 0, x <= 0."""
    return _is_sympy(value) and getattr(value, "rel_op", None) in ("<", "<=", ">", ">=")


def conditions_of(where):
    """Conditions as texts, from a text, a relation of sympy or an And of them, or a list of these."""
    listed = [where] if isinstance(where, str) or _is_sympy(where) else where
    texts = []
    for condition in _parts(listed if hasattr(listed, "__iter__") else [listed]):
        if not isinstance(condition, str) and not _is_inequality(condition):
            raise ValueError(f'where: {condition!r} is no condition; a text, "x*y > 2", or a relation of sympy is wanted')
        texts.append(condition if isinstance(condition, str) else _condition_text(condition))
    return texts


def _of_sympy(equations, variables, parameters):
    equations = list(_parts(equations))
    system = _of_expressions([e for e in equations if not _is_inequality(e)], variables, parameters)
    return _moivre.with_conditions(system, [_condition_text(e) for e in equations if _is_inequality(e)])


def _entries(matrix):
    """Of a matrix of sympy, one by one."""
    return list(matrix.as_explicit() if hasattr(matrix, "as_explicit") else matrix)


def _sides(equation, what):
    """What is to be zero, as expressions: an Eq has its difference, a matrix each of its entries."""
    import sympy
    if isinstance(equation, str):
        raise ValueError(f"{what}: a text among sympy's expressions; give all as text or all as expressions")
    given = sympy.sympify(equation)
    if isinstance(given, sympy.logic.boolalg.BooleanAtom):
        raise ValueError(f"{what}: {given} is no equation: == compares at once, and so does Eq of two numbers; give the difference "
                         "of both sides, which is to be zero")
    if isinstance(given, sympy.Equality):
        given = given.lhs - given.rhs
    if isinstance(given, sympy.Poly):
        given = given.as_expr()
    if getattr(given, "is_Matrix", False):
        return [side for entry in _entries(given) for side in _sides(entry, what)]
    if not isinstance(given, sympy.Expr) or given.has(sympy.nan, sympy.oo, -sympy.oo, sympy.zoo):
        raise ValueError(f"{what}: {equation} is no expression with finite numbers")
    if given.has(sympy.Piecewise):
        raise ValueError(f"{what}: {given}: a Piecewise is several equations; solve each piece by itself, with its condition in where=")
    if given.has(sympy.MatrixSymbol):
        raise ValueError(f"{what}: {given}: unknowns are symbols, not entries of a MatrixSymbol; take sympy.Matrix(2, 2, sympy.symbols('x:4'))")
    return [given]


def _of_expressions(equations, variables, parameters):
    import sympy
    given = [side for k, equation in enumerate(equations) for side in _sides(equation, f"equation {k + 1}")]
    is_exact = not any(side.has(sympy.Float) for side in given)
    # Beside a float sympy would round every other number.
    expressions = [side.xreplace({x: sympy.Rational(x) for x in side.atoms(sympy.Float)}) for side in given]
    found = set().union(*(e.free_symbols for e in expressions))
    symbols = _symbols(found, variables, parameters)
    if not symbols:
        raise ValueError("the equations have no unknown")
    names = [str(s) for s in found.union(symbols)]
    for name in sorted({name for name in names if names.count(name) > 1}):
        raise ValueError(f"two different symbols are called {name}: Symbol('{name}') and Symbol('{name}', real=True) are two; make one and use it")
    for name in (str(p) for p in symbols[len(symbols) - len(parameters):] if p not in found):
        raise ValueError(f"the system has no name {name}; its names are {', '.join(map(str, sorted(found, key=_natural)))}")
    for k, expression in enumerate(expressions):
        stray = sorted(map(str, expression.free_symbols - set(symbols)))
        if stray:
            raise ValueError(f"equation {k + 1}: {', '.join(stray)} is neither an unknown nor a parameter")
    terms = [_polynomial_terms(expression, symbols) for expression in expressions]
    if None in terms:
        return _of_typed(expressions, symbols, is_exact)
    return _moivre.system_of_terms([str(s) for s in symbols], _shaped(terms, len(symbols)), is_exact)


def _symbols(found, variables, parameters):
    """Unknowns and behind them parameters; a text is the symbol of its name."""
    import sympy
    by_name = {str(symbol): symbol for symbol in found}
    if variables is not None:
        return [by_name.get(v, sympy.Symbol(v)) if isinstance(v, str) else v for v in [*variables, *parameters]]
    names = [str(p) for p in parameters]
    unknown = [s for name, s in by_name.items() if name not in names]
    given = [by_name.get(name, sympy.Symbol(name)) for name in names]
    return sorted(unknown, key=_natural) + given


def _shaped(terms, variables):
    import numpy
    return [(coefficients, numpy.asarray(exponents, dtype=numpy.int64).reshape(len(coefficients), variables))
            for coefficients, exponents in terms]


def _of_arrays(equations, variables):
    import numpy
    terms = []
    is_exact = True
    for k, (coefficients, exponents) in enumerate(equations):
        what = f"equation {k + 1}"
        try:
            powers = numpy.asarray(exponents)
        except ValueError:
            raise ValueError(f"{what}: exponents are whole numbers of shape (terms, variables); its rows are not of one length") from None
        if powers.ndim != 2 or not numpy.issubdtype(powers.dtype, numpy.integer):
            raise ValueError(f"{what}: exponents are whole numbers of shape (terms, variables)")
        exact = [_exact(c, what) for c in (coefficients.tolist() if hasattr(coefficients, "tolist") else coefficients)]
        is_exact = is_exact and all(is_so for _, is_so in exact)
        terms.append(([number for number, _ in exact], powers))
    if not terms:
        raise ValueError("there is no equation")
    if variables is None:
        variables = [f"x{k + 1}" for k in range(terms[0][1].shape[1])]
    return _moivre.system_of_terms([str(v) for v in variables], terms, is_exact)


def _is_a_line_each(text):
    """Whether every line that holds something has one `=` or is a condition, and none a semicolon: then none is needed."""
    lines = [line for line in (whole.partition("#")[0].strip() for whole in text.splitlines()) if line]
    is_whole = [(line.count("=") == 1 or "<" in line or ">" in line) and ";" not in line for line in lines]
    return len(lines) > 1 and all(is_whole)


def _of_text(text):
    """The last equation of a text needs no semicolon; what follows the equations of a file is left alone."""
    is_ended = text.rstrip().endswith(";") or _BEHIND.search(text) or _is_a_line_each(text)
    return _moivre.system_of_text(TEXT, text if is_ended else text + ";")


def is_path(value):
    """A path, or a text that is the name of a file."""
    if isinstance(value, os.PathLike):
        return True
    return isinstance(value, str) and (_PATH.fullmatch(value.strip()) is not None or os.path.isfile(value))


def to_system(equations, variables=None, parameters=()):
    """The system of the compiled half, and the name that reports give it."""
    if isinstance(equations, _moivre.System):
        return equations, TEXT
    if is_path(equations):
        path = os.fspath(equations)
        return _moivre.system_of_file(path), path
    if isinstance(equations, str):
        return _in_order(_of_text(equations), variables), TEXT
    if getattr(equations, "is_Matrix", False):
        equations = _entries(equations)
    if _is_sympy(equations) and not hasattr(equations, "__iter__"):
        equations = [equations]
    if isinstance(equations, (dict, set)):
        raise ValueError("equations are a list: a dictionary or a set has no place for them")
    if not hasattr(equations, "__iter__"):
        raise ValueError(f"{equations!r} is no system: {_FORMS}")
    equations = list(equations)
    if not equations:
        raise ValueError(f"there is no equation: {_FORMS}")
    if all(isinstance(e, str) for e in equations):
        return _in_order(_of_text("".join(e.strip().rstrip(";") + ";\n" for e in equations)), variables), TEXT
    if any(_is_sympy(e) or getattr(e, "is_Matrix", False) for e in equations):
        return _of_sympy(equations, variables, parameters), TEXT
    if all(isinstance(e, (tuple, list)) and len(e) == 2 for e in equations):
        return _of_arrays(equations, variables), TEXT
    raise ValueError(_FORMS)


def _in_order(system, variables):
    """Unknowns of a text come in the order of their first appearance; variables= may give another one."""
    if variables is None:
        return system
    return system.in_order([str(v) for v in variables])
