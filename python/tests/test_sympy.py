# SPDX-License-Identifier: MIT
# Are expressions of sympy taken as they stand, every number exact?
import sys

import numpy as np
import pytest

sp = pytest.importorskip("sympy")

import moivre  # noqa: E402

x, y, a, b = sp.symbols("x y a b")


def test_the_first_lines_of_the_manual_run():
    r = moivre.solve([x**2 + y**2 - 4, x * y - 1])
    assert r.completeness == "proved" and r.complete is True
    assert r.points.shape == (4, 2) and r.real_points.shape == (4, 2)
    assert (r[0].multiplicity, r[0].certified) == (1, True)


def test_equations_of_sympy_equal_those_of_text():
    by_text = moivre.solve(["x^2 + y^2 - 4", "x*y - 1"])
    by_sympy = moivre.solve([x**2 + y**2 - 4, x * y - 1])
    assert np.array_equal(by_text.points, by_sympy.points)


def test_an_equality_is_an_equation():
    assert np.allclose(moivre.solve([sp.Eq(x, 2 * y), sp.Eq(y, 3)]).points, [[6, 3]])


def test_a_single_expression_is_a_system():
    assert len(moivre.solve(x**2 - 2)) == 2


def test_unknowns_come_by_name_and_number():
    symbols = sp.symbols("x1:12")
    r = moivre.solve([s - k for k, s in enumerate(symbols)])
    assert r.variables == [str(s) for s in symbols]


def test_variables_may_be_symbols():
    assert moivre.solve([x - 1, y - 2], variables=[y, x]).variables == ["y", "x"]


def test_rationals_stay_exact_beside_floats():
    r = moivre.solve([x * 0.5 - sp.Rational(1, 3)])
    assert str(r.digits(30)[0][0].real) == "0.666666666666666666666666666667"


def test_a_float_is_the_double_that_it_is():
    r = moivre.solve([x - sp.Float(0.1)])
    assert str(r.digits(30)[0][0].real) == "0.100000000000000005551115123126"


def test_complex_coefficients_are_taken():
    r = moivre.solve([x**2 - sp.I])
    assert np.allclose(r.points[:, 0] ** 2, 1j)


def test_products_are_expanded():
    assert moivre.solve([(x - 1) ** 3])[0].multiplicity == 3


@pytest.mark.parametrize("expression, words", [
    (sp.sin(x) - 1, "of an unknown is no polynomial"),
    (x**sp.Rational(1, 2) - 1, "of an unknown is no polynomial"),
    (x**sp.Rational(1, 3) - 1, "the exponent is not an integer"),
    (x**y - 1, "the exponent is not a number"),
    (sp.EulerGamma + sp.zeta(x), "zeta"),
    (sp.nan + x, "finite"),
    (x - sp.oo, "finite"),
    (sp.Eq(1, 1), "True is no equation"),
    (x == 1, "False is no equation"),
])
def test_what_is_no_polynomial_is_named(expression, words):
    with pytest.raises(ValueError, match=f"equation 2: .*{words}") as caught:
        moivre.solve([x - 1, expression])
    assert not isinstance(caught.value, moivre.ParseError)


@pytest.mark.parametrize("expression, text", [
    (1 / x - 2, "1/x - 2"),
    ((x**2 - 1) / (x - 1), "(x^2 - 1)/(x - 1)"),
    (sp.sqrt(2) * x - 1, "sqrt(2)*x - 1"),
    (sp.sqrt(1 + sp.sqrt(2)) * x - 1, "sqrt(1 + sqrt(2))*x - 1"),
    (2 ** sp.Rational(1, 3) * x + sp.Rational(1, 7), "2^(1/3)*x + 1/7"),
    (sp.pi * x**2 - sp.E, "pi*x^2 - exp(1)"),
    (sp.exp(2) * x - sp.log(3), "exp(2)*x - log(3)"),
    (sp.cos(sp.Rational(3, 10)) * x - sp.I, "cos(3/10)*x - I"),
    (x * 0.5 - sp.sqrt(2), "x/2 - sqrt(2)"),
    (sp.GoldenRatio * x - 1, "(1 + sqrt(5))/2*x - 1"),
    (sp.Poly(x**2 - 2, x), "x^2 - 2"),
])
def test_what_a_text_may_hold_an_expression_may(expression, text):
    by_sympy, by_text = moivre.solve([expression]), moivre.solve(text)
    assert np.array_equal(by_sympy.points, by_text.points) and len(by_text) >= 1
    assert (by_sympy.complete, by_sympy.completeness) == (by_text.complete, by_text.completeness)


def test_a_root_of_numbers_that_are_no_fractions_has_thirty_digits():
    r = moivre.solve([sp.sqrt(2) * x - 1])
    assert str(r.digits(30)[0][0].real) == "0.707106781186547524400844362105"
    assert "digits behind the 30th" in str(moivre.solve([sp.sqrt(2) * x - 1], digits=50))


def test_matrices_are_equations():
    f = [x**2 - 1, x * y - 1]
    known = moivre.solve(f).points
    for given in (sp.Matrix(f), sp.ImmutableMatrix(f), [sp.Matrix(f)], sp.Eq(sp.Matrix([x**2, x * y]), sp.Matrix([1, 1])), np.array(f)):
        assert np.array_equal(moivre.solve(given).points, known)


def test_names_that_a_text_reads_otherwise_stay_unknowns():
    i, pi, odd = sp.Symbol("i"), sp.Symbol("pi"), sp.Symbol("x_{1}")
    r = moivre.solve([sp.sqrt(2) * i - 2, pi - i, odd * i - sp.sqrt(2)])
    assert r.variables == ["i", "pi", "x_{1}"] and np.allclose(r.points, [[2**0.5, 2**0.5, 1]])


def test_unknowns_have_their_order_beside_numbers_that_are_no_fractions():
    r = moivre.solve([y - sp.sqrt(2), x - y - 1], variables=[y, x])
    assert r.variables == ["y", "x"] and np.allclose(r.points, [[2**0.5, 2**0.5 + 1]])
    by_text = moivre.solve("x*y = sqrt(2); y = x^2 + 1;", variables=["y", "x"])
    assert by_text.complete and by_text.variables == ["y", "x"] and len(by_text) == 3


def test_a_stray_symbol_is_named():
    with pytest.raises(ValueError, match="a is neither an unknown nor a parameter"):
        moivre.solve([x - a], variables=[x])


def test_text_among_expressions_is_refused():
    with pytest.raises(ValueError, match="equation 2"):
        moivre.solve([x - 1, "y - 2"])


def test_a_family_of_expressions_is_learned():
    f = moivre.Family.learn([x**2 + a * x + b], parameters=[a, b])
    assert (f.variables, f.parameters, f.roots) == (["x"], ["a", "b"], 2)
    s = f.solve(np.array([[-3.0, 2.0]]))
    assert np.allclose(sorted(s.points[:, 0].real), [1, 2])
    g = moivre.Family.learn([sp.sqrt(2) * x**2 - a / 3], parameters=[a])
    assert np.allclose(np.abs(g.solve(np.array([[3 * 2**0.5]])).points), 1)


def test_moivre_does_not_import_sympy():
    import subprocess
    code = "import sys, moivre; moivre.solve('x^2 - 2'); sys.exit('sympy' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_no_equation_is_refused_as_that():
    for nothing in ([], (), sp.Matrix([])):
        with pytest.raises(ValueError, match="there is no equation"):
            moivre.solve(nothing)


def test_equations_without_an_unknown_are_refused():
    with pytest.raises(ValueError, match="no unknown"):
        moivre.solve([sp.Integer(1)])


def test_inequalities_are_conditions():
    x, y = sp.symbols("x y")
    r = moivre.solve([x**2 + y**2 - 4, x * y - 1, x > 0.25], where=[sp.Le(y, x), y < sp.Rational(3, 2)])
    assert len(r) == 1 and r.filtered == 3 and r.real_points[0, 0] > r.real_points[0, 1]


@pytest.mark.parametrize("equations, words", [
    ([x - 1, sp.Piecewise((x, x > 0), (0, True)) - 1], "^equation 2: .*solve each piece by itself"),
    ([sp.Matrix(sp.MatrixSymbol("X", 2, 2))**2 - sp.eye(2)], "^equation 1: .*entries of a MatrixSymbol; take sympy.Matrix"),
    ([sp.MatrixSymbol("X", 1, 1)[0, 0] ** 2 - 1], "MatrixSymbol"),
])
def test_what_is_no_equation_of_symbols_is_refused_with_what_to_do(equations, words):
    with pytest.raises(ValueError, match=words):
        moivre.solve(equations)


def test_two_symbols_of_one_name_are_told():
    real = sp.Symbol("x", real=True)
    for given in ({"equations": [x**2 - real]}, {"equations": [real**2 - 2], "variables": [x]}):
        with pytest.raises(ValueError, match="two different symbols are called x"):
            moivre.solve(**given)
    assert moivre.solve([real**2 - 2], variables=["x"]).variables == ["x"]


def test_and_is_the_list_of_its_conditions_and_no_other_word_is():
    f = [x**2 - 1]
    assert [root["x"] for root in moivre.solve(f, where=sp.And(x > 0, x < 2))] == [1]
    assert len(moivre.solve([*f, sp.And(x > 0, x < 2)])) == 1 and len(moivre.solve(f, where=["x > 0", sp.And(x > -2, x < 2)])) == 1
    for where, name in ((sp.Or(x > 1, x < 0), "Or"), (sp.Not(sp.Or(sp.Symbol("p"), x < 0), evaluate=False), "Not")):
        with pytest.raises(ValueError, match=f"{name} is no condition"):
            moivre.solve(f, where=where)


def test_a_parameter_that_no_equation_has_is_refused():
    with pytest.raises(ValueError, match="the system has no name q; its names are x"):
        moivre.Family.learn([x**2 - 2], parameters=["q"])
