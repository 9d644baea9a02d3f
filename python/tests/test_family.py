# SPDX-License-Identifier: MIT
# Is a family learned once, kept in a file, and solved for many members?
import fractions

import numpy as np
import pytest
from conftest import parsed, without_times

import moivre


@pytest.fixture(scope="module")
def quadratic():
    return moivre.Family.learn(["x^2 + a*x + b"], parameters=["a", "b"])


def test_a_family_knows_its_roots(quadratic):
    assert quadratic.roots == 2 and quadratic.complete and quadratic.standing
    assert repr(quadratic) == "<moivre.Family: 2 roots in x, parameters a, b>"


def test_members_are_solved_row_by_row(quadratic):
    p = np.random.default_rng(1).normal(size=(100, 2))
    s = quadratic.solve(p)
    assert s.complete and len(s) == 100 and np.array_equal(s.counts, np.full(100, 2))
    assert np.array_equal(s.member, np.repeat(np.arange(100), 2))
    x = s.points[:, 0]
    assert np.allclose(x**2 + p[s.member, 0] * x + p[s.member, 1], 0)


def test_members_with_fewer_roots_have_their_own_count(quadratic):
    s = quadratic.solve([[0, 0], [-3, 2]])
    assert list(s.counts) == [1, 2] and list(s.multiplicity) == [2, 1, 1]
    assert np.allclose(s.of(0), [[0]]) and np.allclose(sorted(s.of(1)[:, 0].real), [1, 2])


def test_a_single_row_is_a_member(quadratic):
    assert len(quadratic.solve([1.0, 2.0])) == 1


def test_complex_parameters_are_taken(quadratic):
    s = quadratic.solve([[0, 1j]])
    assert np.allclose(s.points[:, 0] ** 2, -1j)


@pytest.mark.parametrize("members", [[[1, 2, 3]], [[1]], [[1, float("nan")]], [[float("inf"), 1]]])
def test_members_that_do_not_fit_are_refused(quadratic, members):
    with pytest.raises(ValueError):
        quadratic.solve(members)


def test_one_member_keeps_its_numbers_exact(quadratic):
    r = quadratic.member({"a": 0, "b": fractions.Fraction(-1, 9)})
    assert r.complete and str(abs(r.digits(20)[0][0].real)) == "0.33333333333333333333"


def test_a_member_without_all_values_is_refused(quadratic):
    with pytest.raises(ValueError, match="b"):
        quadratic.member({"a": 1})


def test_a_family_survives_its_file(quadratic, tmp_path):
    quadratic.save(tmp_path / "f.family")
    again = moivre.Family.load(tmp_path / "f.family")
    p = [[1.0, 2.0], [3.0, 4.0]]
    assert np.array_equal(again.solve(p).points, quadratic.solve(p).points)


def test_a_broken_file_is_refused(tmp_path):
    (tmp_path / "f.family").write_text('{"moivre_family": 1}')
    with pytest.raises(ValueError, match="f.family"):
        moivre.Family.load(tmp_path / "f.family")


def test_sizes_of_parameters_may_be_given():
    assert moivre.Family.learn("x^2 - a", parameters={"a": 100}).roots == 2


@pytest.mark.parametrize("parameters", [["c"], ["a", "a"]])
def test_unknown_parameters_are_refused(parameters):
    with pytest.raises(ValueError):
        moivre.Family.learn("x^2 - a", parameters=parameters)


def test_monodromy_finds_as_many_roots():
    f = moivre.Family.learn(["x^3 + a*x*y + 1", "y^2 + b*x + c"], parameters=["a", "b", "c"], monodromy=True)
    assert f.roots == moivre.Family.learn(["x^3 + a*x*y + 1", "y^2 + b*x + c"], parameters=["a", "b", "c"]).roots


def test_json_is_that_of_the_command_line(quadratic, tmp_path, command):
    file = tmp_path / "f.family"
    quadratic.save(file)
    f = moivre.Family.load(file)
    assert without_times(f.to_json()) == without_times(command("family", "info", file))
    (tmp_path / "members").write_text("a,b\n1,2\n3,4\n")
    ours, theirs = (parsed(t) for t in (f.solve([[1, 2], [3, 4]]).to_json(),
                                        command("family", "solve", file, "--table", tmp_path / "members")))
    for one in (ours, theirs):
        one.pop("time_s", None), one.pop("table", None), one.pop("file", None)
    assert ours == theirs
