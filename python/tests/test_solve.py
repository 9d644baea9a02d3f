# SPDX-License-Identifier: MIT
# Does solve() find the roots, say what they are worth, and give them as one expects?
import fractions
import decimal
import pickle

import numpy as np
import pytest
from conftest import without_times

import moivre

CONICS = ["x^2 + y^2 - 4", "x*y - 1"]


def test_finds_all_roots_and_proves_it():
    r = moivre.solve(CONICS)
    assert r.complete and r.completeness == "proved" and len(r) == 4
    assert r.points.dtype == complex and r.points.shape == (4, 2)
    x, y = r.points.T
    assert np.allclose(x**2 + y**2, 4) and np.allclose(x * y, 1)


def test_real_points_are_floats():
    r = moivre.solve("x^3 - 1")
    assert r.real_points.dtype == float
    assert np.allclose(r.real_points, [[1.0]])
    assert r.real.sum() == 1 and len(r) == 3


def test_unknowns_come_in_the_order_of_their_first_appearance():
    assert moivre.solve(["y - 1", "x*y - 2"]).variables == ["y", "x"]


def test_variables_give_the_order():
    r = moivre.solve(["y - 1", "x*y - 2"], variables=["x", "y"])
    assert r.variables == ["x", "y"]
    assert np.allclose(r.points, [[2, 1]])


@pytest.mark.parametrize("names, words", [
    (["x"], "y is not named"), (["x", "z"], "z occurs in no equation"), (["x", "x"], "named twice")])
def test_variables_that_do_not_fit_are_named(names, words):
    with pytest.raises(ValueError, match=words):
        moivre.solve(["y - 1", "x*y - 2"], variables=names)


def test_a_root_has_its_accuracy_multiplicity_and_certificate():
    root = moivre.solve(CONICS)[0]
    assert root.certified is True and root.multiplicity == 1 and root.real and not root.singular
    assert 0 <= root.accuracy < 1e-12
    assert isinstance(root["x"], float)
    with pytest.raises(KeyError, match="the unknowns are x, y"):
        root["z"]


def test_a_double_root_is_not_certified():
    r = moivre.solve(["x^2 - y", "y + x^3"])
    double = [root for root in r if root.multiplicity == 2]
    assert len(double) == 1 and double[0].singular and double[0].certified is False


def test_certificates_can_be_left_out():
    r = moivre.solve(CONICS, certify=False)
    assert r.complete and r.completeness is None and r.certified == [None] * 4


def test_roots_are_a_sequence():
    r = moivre.solve(CONICS)
    assert [root.x[0] for root in r] == list(r.points[:, 0])
    assert len(r[1:3]) == 2 and np.array_equal(r[-1].x, r.points[-1])
    with pytest.raises(IndexError):
        r[4]


def test_a_system_without_roots_gives_empty_arrays():
    r = moivre.solve(["x*y - 1", "x*y - 2"])
    assert r.complete and r.points.shape == (0, 2) and r.real_points.shape == (0, 2)


def test_the_seed_decides_the_order_and_nothing_else():
    once, again, other = (moivre.solve(CONICS, seed=s) for s in (5, 5, 6))
    assert np.array_equal(once.points, again.points)
    assert np.allclose(np.sort_complex(once.points[:, 0]), np.sort_complex(other.points[:, 0]))


def test_one_thread_and_two_give_the_same_bytes(problems):
    one, two = (moivre.solve(problems / "polynomials" / "cassou.phc", tracker="lanes", threads=n) for n in (1, 2))
    assert without_times(one.to_json()) == without_times(two.to_json())


def test_digits_are_those_of_the_root():
    mpmath = pytest.importorskip("mpmath")
    found = moivre.solve("x^2 - 2").digits(50)
    with mpmath.workdps(50):
        assert sorted(mpmath.nstr(x.real, 50) for x, in found) == sorted(
            mpmath.nstr(s * mpmath.sqrt(2), 50) for s in (1, -1))


def test_a_singular_root_has_no_digits():
    r = moivre.solve(["x^2 - y", "y + x^3"])
    assert [d is None for d in r.digits(30)] == list(r.singular)


@pytest.mark.parametrize("digits", [0, -1, 1001])
def test_digits_out_of_range_are_refused(digits):
    with pytest.raises(ValueError, match="between 1 and 1000"):
        moivre.solve("x^2 - 2").digits(digits)
    with pytest.raises(ValueError, match="between 1 and 1000"):
        moivre.solve("x^2 - 2", digits=digits)


def test_more_equations_than_unknowns_are_told():
    r = moivre.solve(["x^2 - 1", "y^2 - 1", "x*y - 1"])
    assert r.complete and len(r) == 2 and r.completeness is None


def test_planes_on_which_every_equation_is_zero_are_told():
    r = moivre.solve(["x*z + x", "y + x^2*y^2*z^2", "x*y + x"])
    assert r.planes == [{"zero": ["x", "y"], "dimension": 1}]
    assert moivre.solve(["x^2 - 1", "x*y - 1"]).planes == []


def test_fewer_equations_are_refused_or_cut():
    with pytest.raises(ValueError):
        moivre.solve(["x^2 + y^2 - z"])
    assert len(moivre.solve(["x^2 + y^2 - z"], slice=True)) == 2


def test_what_is_undecided_is_a_value():
    # Exact algebra finds the roots where the coefficients are real.
    r = moivre.solve("x^2 + y^2 - 5; i*x*y - 2", tracker_options={"maximum_steps": 1})
    assert not r.complete and r.completeness == "open" and r.message
    assert "not complete" in repr(r)


@pytest.mark.parametrize("options, words", [
    ({"tracker": "euler"}, '"cvode" and "lanes"'),
    ({"start": "guess"}, "total-degree"),
    ({"precision": "quad"}, "double-double"),
    ({"tracker_options": {"speed": 9}}, "there is no speed"),
    ({"tracker_options": {"rtol": -1.0}}, "rtol"),
    ({"threads": -1}, "threads"),
])
def test_a_wrong_option_is_named(options, words):
    with pytest.raises(ValueError, match=words):
        moivre.solve(CONICS, **options)


def test_an_option_of_another_type_is_refused():
    with pytest.raises((TypeError, ValueError, RuntimeError)):
        moivre.solve(CONICS, seed="one")


@pytest.mark.parametrize("tracker", ["cvode", "lanes"])
def test_both_trackers_find_the_same(tracker, problems):
    r = moivre.solve(problems / "polynomials" / "puma.phc", tracker=tracker)
    assert len(r) == 16 and r.completeness == "proved"


def test_json_is_that_of_the_command_line(problems, command):
    file = problems / "polynomials" / "puma.phc"
    for options, words in (({}, ()), ({"tracker": "lanes", "seed": 3}, ("--tracker", "lanes", "--seed", "3")),
                           ({"digits": 30}, ("--digits", "30")), ({"certify": False}, ("--no-certify",)),
                           ({"every_path": True, "start": "total-degree"}, ("--every-path", "--start", "total-degree"))):
        assert without_times(moivre.solve(file, **options).to_json()) == without_times(command("solve", file, *words))


def test_reports_go_into_files(tmp_path):
    r = moivre.solve(CONICS)
    r.to_json(tmp_path / "r.json")
    assert (tmp_path / "r.json").read_text() == r.to_json()
    assert r.to_csv().count("\n") == 5
    assert "THE SOLUTIONS" in r.to_phc()


def test_print_shows_the_text_and_a_notebook_a_table():
    r = moivre.solve(CONICS)
    assert "4 isolated roots: 4 real, 0 not real" in str(r)
    assert repr(r) == "<moivre.Result: 4 roots in x, y, 4 of them real, proved complete>"
    assert r._repr_html_().count("<tr>") == 5


def test_a_number_is_exact_by_its_kind():
    third = fractions.Fraction(1, 3)
    r = moivre.solve([([3, -3 * third], [[1], [0]]), ])
    assert r.points[0, 0] == float(third)
    tenth = moivre.solve([([1, decimal.Decimal("-0.1")], [[1], [0]])]).digits(30)
    assert str(tenth[0][0].real) == "0.1"
    double = moivre.solve([([1, -0.1], [[1], [0]])]).digits(30)
    assert str(double[0][0].real) == "0.100000000000000005551115123126"


def test_coefficients_beyond_double_are_brought_into_its_range():
    roots = moivre.solve([([10**400, -3 * 10**400], [[1], [0]])]).points
    assert roots == pytest.approx(np.array([[3]]))
    with pytest.raises(ValueError, match="equation 1: a coefficient is out of the range of double"):
        moivre.solve([([10**400, fractions.Fraction(1, 10**400)], [[1], [0]])])


def test_arrays_of_complex_coefficients_are_taken():
    r = moivre.solve([(np.array([1, 1j]), np.array([[2], [0]]))])
    assert np.allclose(r.points[:, 0] ** 2, -1j)
    assert r.variables == ["x1"]


@pytest.mark.parametrize("number", [float("nan"), float("inf"), complex(0, float("inf")), decimal.Decimal("NaN"), "x", None])
def test_what_is_no_finite_number_is_refused(number):
    with pytest.raises(ValueError, match="equation 1"):
        moivre.solve([([1, number], [[1], [0]])])


def test_exponents_of_rows_that_differ_are_refused_by_their_equation():
    with pytest.raises(ValueError, match="^equation 2: exponents are whole numbers .*rows are not of one length"):
        moivre.solve([([1, -1], [[1, 0], [0, 0]]), ([1, -1], [[1, 0], [0]])])


@pytest.mark.parametrize("exponents", [[[1.5], [0]], [[-1], [0]], [[1]], [1, 0], [[1, 0], [0, 0], [0, 0]]])
def test_exponents_of_another_kind_are_refused(exponents):
    with pytest.raises(ValueError):
        moivre.solve([([1, -1], exponents)])


def test_a_fault_in_a_text_has_line_column_and_caret():
    with pytest.raises(moivre.ParseError) as caught:
        moivre.solve(["x^2 - 4", "x*(y - "])
    assert caught.value.line == 2 and caught.value.column > 1
    assert "^" in str(caught.value) and "equations:2:" in str(caught.value)
    assert isinstance(caught.value, ValueError)
    again = pickle.loads(pickle.dumps(caught.value))
    assert str(again) == str(caught.value) and again.faults == caught.value.faults


def test_every_fault_is_told():
    with pytest.raises(moivre.ParseError) as caught:
        moivre.solve(["x + + * y", "x ? y"])
    assert len(caught.value.faults) >= 2


def test_a_file_that_is_not_there_is_named():
    with pytest.raises(ValueError, match="nowhere.phc"):
        moivre.solve("nowhere.phc")


@pytest.mark.parametrize("equations", [[], 5, [1, 2], None, {"x": 1}, {"x", "y"}])
def test_what_is_no_system_is_refused(equations):
    with pytest.raises((ValueError, TypeError)):
        moivre.solve(equations)


@pytest.mark.parametrize("option, words", [
    ({"seed": -1}, "seed: -1 is given, but a whole number from 0 up is wanted"),
    ({"threads": "2"}, "threads: '2' is given, but a whole number is wanted"),
    ({"slice": "yes"}, "slice: 'yes' is given, but True or False is wanted"),
    ({"digits": "many"}, "digits: 'many' is given, but a whole number is wanted"),
    ({"tracker_options": {"rtol": "small"}}, "tracker_options rtol: 'small' is given, but a number is wanted"),
])
def test_an_option_of_another_kind_is_refused_by_name(option, words):
    with pytest.raises(ValueError, match=words):
        moivre.solve("x^2 - 2", **option)


def test_whole_numbers_of_numpy_are_options():
    assert len(moivre.solve("x^2 - 2", seed=np.int64(3), threads=np.int32(1))) == 2


def test_equations_of_a_text_may_stand_a_line_each():
    assert len(moivre.solve("x^2 + y^2 = 4   # a circle\n\nx*y = 1")) == 4


@pytest.mark.parametrize("what", [None, 3, 2.5])
def test_what_is_no_system_is_refused_with_the_forms_of_one(what):
    with pytest.raises(ValueError, match="is no system: equations are a text, a path"):
        moivre.solve(what)


def test_a_root_becomes_a_dictionary():
    assert dict(moivre.solve("x = 2; y = x + 1")[0]) == {"x": 2.0, "y": 3.0}


def test_a_root_that_is_not_there_is_refused_by_its_number():
    r = moivre.solve("x^2 - 2")
    with pytest.raises(IndexError, match="there is no root 9: there are 2, counted from 0"):
        r[9]
    with pytest.raises(IndexError, match="there is no root 0: there are none"):
        moivre.solve("x^2 - 2", box={"x": (5, 6)})[0]
    with pytest.raises(TypeError, match="a root is asked for by its number, not by 'x'"):
        r["x"]
    assert r[-1]["x"] == r[1]["x"] and len(list(r)) == 2


def test_no_threads_means_all_cores():
    assert np.array_equal(moivre.solve("x^2 - 2", threads=0).points, moivre.solve("x^2 - 2").points)
    with pytest.raises(ValueError, match="threads must lie between 0 \\(all cores\\)"):
        moivre.solve("x^2 - 2", threads=-1)
