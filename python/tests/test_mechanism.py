# SPDX-License-Identifier: MIT
# Are a mechanism's closures, motion, mobility, sweep and sensitivities those of the command line, as arrays and names?
import json
import math

import numpy as np
import pytest
from conftest import without_times

import moivre

DICT = {
    "title": "A four-bar",
    "units": {"length": "mm", "angle": "deg"},
    "ground": {"points": {"A": [0, 0], "D": [90, 10]}},
    "body": {"crank": {"points": {"A": [0, 0], "B": [30, 0]}}, "coupler": {"points": {"B": [0, 0], "C": [80, 0]}},
             "rocker": {"points": {"D": [0, 0], "C": [60, 0]}}},
    "joint": [{"type": "revolute", "at": at} for at in (["ground.A", "crank.A"], ["crank.B", "coupler.B"],
                                                        ["coupler.C", "rocker.C"], ["ground.D", "rocker.D"])],
    "driver": [{"angle": "crank", "start": 60, "velocity": 360}],
}


def test_every_closure_is_found_and_proved(four_bar):
    c = moivre.Mechanism(four_bar).closures()
    assert len(c) == 2 and c.complete and c.completeness == "proved" and not c.moves
    assert [k.id for k in c] == ["A", "B"] and all(k.certified for k in c)
    assert c.counts["complex"] == 2


def test_bodies_and_points_have_names(four_bar):
    c = moivre.Mechanism(four_bar).closures()[0]
    assert math.isclose(c.bodies["crank"].phi, math.radians(40))
    assert c.points["crank.A"].shape == (2,)
    assert np.allclose(c.points["crank.A"], 40 * np.array([math.cos(math.radians(40)), math.sin(math.radians(40))]))
    assert c["crank.phi"] == c.bodies["crank"].phi
    assert np.allclose(c.points["coupler.B"], c.points["rocker.B"])


def test_closures_are_found_by_letter(four_bar):
    c = moivre.Mechanism(four_bar).closures()
    assert np.array_equal(c["B"].q, c[1].q)
    with pytest.raises(KeyError, match="there are A, B"):
        c["C"]
    with pytest.raises(KeyError, match="the coordinates are"):
        c[0]["height"]


def test_a_dictionary_has_the_keys_of_the_file(tmp_path):
    m = moivre.Mechanism(DICT)
    assert m.title == "A four-bar" and len(m.closures()) == 2
    assert math.isclose(m.closures()[0].bodies["crank"].phi, math.radians(60))


def test_numpy_numbers_have_a_place_in_a_dictionary():
    spec = json.loads(json.dumps(DICT))
    spec["ground"]["points"]["D"] = np.array([90.0, 10.0])
    spec["driver"][0]["start"] = np.float64(60)
    assert np.array_equal(moivre.Mechanism(spec).closures().q, moivre.Mechanism(DICT).closures().q)


@pytest.mark.parametrize("value, words", [(float("nan"), "driver"), (object(), "object"), (float("inf"), "not finite")])
def test_what_has_no_place_in_a_dictionary_is_named(value, words):
    spec = json.loads(json.dumps(DICT))
    spec["driver"][0]["start"] = value
    with pytest.raises(ValueError, match=words):
        moivre.Mechanism(spec)


def test_an_unknown_key_is_named_with_its_neighbour():
    with pytest.raises(ValueError, match="^'jiont': unknown key 'jiont' .*joint"):
        moivre.Mechanism({**DICT, "jiont": []})


@pytest.mark.parametrize("change, words", [
    (lambda d: d["body"]["crank"]["points"].update(B=[1, 2, 3]), r"^body 'crank', point 'B': point 'crank.B' must be 2 numbers"),
    (lambda d: d["joint"].append({"type": "revolte", "at": ["ground.A", "crank.A"]}),
     r"^joint 5 \(revolte at \[ground.A, crank.A\]\), 'type': unknown joint type"),
    (lambda d: d["joint"][1].update(limts=[0, 1]), r"^joint 2 \(revolute at \[.*\]\), 'limts': unknown key 'limts'"),
    (lambda d: d["driver"][0].update(angle="crnk"), r"^driver 1, 'angle': there is no body 'crnk'; did you mean 'crank'"),
    (lambda d: d["body"].update({"a b": {"points": {"A": [0, 0]}}}), r"^body 'a b'.*letters, digits"),
    (lambda d: d["body"].update({'c"d\\': {"points": {"A": [0, 0]}}}), r"^body 'c\"d\\'.*letters, digits"),
    (lambda d: d["body"]["crank"]["points"].update(B=None), r"^body.crank.points.B: None"),
    (lambda d: d.update(units={"length": "mm", "angle": "turns"}), r"^units, 'angle': "),
])
def test_a_fault_of_a_dictionary_is_told_by_what_it_is_in(change, words):
    spec = json.loads(json.dumps(DICT))
    change(spec)
    with pytest.raises(ValueError, match=words) as caught:
        moivre.Mechanism(spec)
    assert not isinstance(caught.value, moivre.ParseError) and "^" not in str(caught.value)


def test_a_point_is_asked_for_by_its_name(four_bar):
    m = moivre.Mechanism(four_bar)
    c = m.closures()
    for name, place in c[0].points.items():
        assert np.allclose(m.point_position(name, c[0].q), place, atol=1e-12)
    curve = m.point_position("coupler.P", m.motion(steps=8).branches[0].q)
    assert curve.shape == (9, 2) and np.allclose(curve[0], c[0].points["coupler.P"])
    assert m.point_position("coupler.P", c.q).shape == (2, 2)
    with pytest.raises(ValueError, match="there is no point 'coupler.p'; did you mean 'coupler.P'"):
        m.point_position("coupler.p", c[0].q)
    with pytest.raises(ValueError, match=r"q: an array of shape \(9,\)"):
        m.point_position("coupler.P", [0, 0, 0])


def test_newton_ends_with_angles_as_closures_have_them(four_bar):
    run = moivre.Mechanism(four_bar).newton(guess={"coupler.phi": 2100})
    assert run.converged and np.abs(run.iterates[:, 5]).max() > 30
    closures = moivre.Mechanism(four_bar).closures().q
    assert np.abs(closures - run.q).max(axis=1).min() < 1e-9
    assert json.loads(run.to_json())["coordinates"]["coupler.phi"] == run.q[5]


def test_a_branch_ends_behind_its_last_sample():
    spec = json.loads(json.dumps(DICT))
    spec["body"]["crank"]["points"]["B"] = [75, 0]     # the crank rocks
    motion = moivre.Mechanism(spec).motion(steps=50)
    assert motion.events
    for branch in motion.branches:
        if branch.event:
            assert branch.t[-1] <= branch.ends and math.isclose(branch.ends, branch.event.t, rel_tol=1e-12)
            assert branch.t[-1] + 1 / 50 > branch.ends


def test_a_closure_that_is_not_there_is_refused_by_its_number(four_bar):
    m = moivre.Mechanism(four_bar)
    for ask in (lambda: m.closures()[2], lambda: m.sensitivity()[2], lambda: m.sensitivity().rate("coupler.P.y", "crank.A.x", 2)):
        with pytest.raises(IndexError, match="there is no closure 2: there are 2, counted from 0"):
            ask()


def test_a_faulty_file_has_line_and_caret(tmp_path):
    file = tmp_path / "faulty.toml"
    file.write_text('[ground.points]\nA = [0, "zero"]\n')
    with pytest.raises(moivre.ParseError) as caught:
        moivre.Mechanism(file)
    assert any(line == 2 for line, _, _ in caught.value.faults) and "faulty.toml:2:" in str(caught.value) and "^" in str(caught.value)


def test_closures_depend_on_the_time(four_bar):
    m = moivre.Mechanism(four_bar)
    assert m.closures(at=0.1)[0].bodies["crank"].phi != m.closures()[0].bodies["crank"].phi


@pytest.mark.parametrize("options, words", [({"at": float("nan")}, "at is not finite"), ({"fit": -1.0}, "fit"),
                                            ({"tolerance": float("nan")}, "tolerance")])
def test_wrong_options_are_named(four_bar, options, words):
    with pytest.raises(ValueError, match=words):
        moivre.Mechanism(four_bar).closures(**options)


def test_a_picture_and_a_page_are_made(four_bar):
    c = moivre.Mechanism(four_bar).closures()
    assert c.svg.startswith("<svg") or c.svg.startswith("<?xml")
    assert c._repr_html_() == c.svg and "<html" in c.to_html()


def test_a_motion_has_arrays(four_bar):
    m = moivre.Mechanism(four_bar)
    motion = m.motion(steps=36)
    assert motion.complete and len(motion.branches) == 2
    branch = motion.branches[0]
    n = len(m.coordinates)
    assert branch.t.shape == (37,)
    assert branch.q.shape == branch.velocity.shape == branch.acceleration.shape == (37, n)
    assert branch.event is None and branch.complete


def test_velocities_are_those_of_the_positions(four_bar):
    branch = moivre.Mechanism(four_bar).motion(steps=2000).branches[0]
    slope = np.gradient(branch.q, branch.t, axis=0)
    scale = np.maximum(np.abs(branch.velocity).max(axis=0), 1)
    assert (np.abs(slope - branch.velocity)[2:-2] / scale).max() < 1e-4


def test_a_branch_ends_at_a_dead_point(problems):
    spec = json.loads(json.dumps(DICT))
    spec["body"]["coupler"]["points"]["C"] = [40, 0]
    spec["body"]["rocker"]["points"]["C"] = [40, 0]
    motion = moivre.Mechanism(spec).motion(begin=0, end=1)
    kinds = {event.kind for event in motion.events}
    assert "dead point" in kinds
    ended = [branch for branch in motion.branches if branch.event is not None]
    assert ended and ended[0].event.kind == "dead point" and ended[0].id in ended[0].event.ending


def test_a_motion_of_wrong_times_is_refused(four_bar):
    with pytest.raises(ValueError):
        moivre.Mechanism(four_bar).motion(begin=1, end=0)
    with pytest.raises(ValueError):
        moivre.Mechanism(four_bar).motion(steps=0)


def test_mobility_names_redundant_rows(problems):
    m = moivre.Mechanism(problems / "mechanisms" / "double-parallel-crank.toml").mobility()
    assert m.degrees_of_freedom == 1 and len(m.redundant) == 1
    assert m.null_space.shape[1] == m.degrees_of_freedom


def test_a_sweep_counts_closures(four_bar):
    s = moivre.Mechanism(four_bar).sweep({"coupler.B.x": (100, 200, 21)})
    assert s.complete and s.at.shape == (21, 1) and s.shape == (21,)
    assert set(s.real) == {0, 2} and abs(s.borders[0, 0] - 153.987) < 0.1


def test_a_map_has_two_names(four_bar):
    s = moivre.Mechanism(four_bar).sweep({"crank.A.x": (20, 140, 4), "coupler.B.x": (60, 140, 3)})
    assert s.real.reshape(s.shape).shape == (4, 3) and s.names == ["crank.A.x", "coupler.B.x"]


@pytest.mark.parametrize("vary", [{"crank.Q.x": (0, 1, 3)}, {"crank.A.x": (0, 1)}, {"crank.A.x": (0, 1, 1)},
                                  {"crank.A.x": (0, 1, 2.5)}, {}])
def test_a_wrong_sweep_is_refused(four_bar, vary):
    with pytest.raises(ValueError):
        moivre.Mechanism(four_bar).sweep(vary)


def test_sensitivities_are_derivatives(four_bar):
    m = moivre.Mechanism(four_bar)
    s = m.sensitivity(tolerance=0.05)
    assert s[0].rates.shape == (len(s.quantities), len(s.dimensions))
    assert (s[0].worst_case >= s[0].root_sum_square - 1e-12)[~np.isnan(s[0].worst_case)].all()
    with pytest.raises(KeyError):
        s.rate("crank.phi", "nothing")


def test_guesses_are_the_closures(four_bar):
    m = moivre.Mechanism(four_bar)
    g = m.guesses()
    assert g.names == m.coordinates and np.allclose(g.q, m.closures().q)


def test_typed_equations_have_unknowns():
    m = moivre.Mechanism({"unknowns": {"lengths": ["x", "y"]},
                          "equations": {"circle": "x^2 + y^2 = 4", "hyperbola": "x*y = 1"}})
    c = m.closures()
    assert m.coordinates == ["x", "y"] and len(c) == 4 and c.completeness == "proved"
    assert c[0].bodies == {} and c[0].points == {}
    assert all(abs(k["x"] * k["y"] - 1) < 1e-12 for k in c)


@pytest.mark.parametrize("name", ["four-bar", "jansen-leg"])
def test_json_of_closures_is_that_of_the_command_line(problems, command, name):
    file = problems / "mechanisms" / f"{name}.toml"
    assert without_times(moivre.Mechanism(file).closures().to_json()) == without_times(command("closures", file))


def test_json_of_a_motion_is_that_of_the_command_line(four_bar, command):
    ours = moivre.Mechanism(four_bar).motion(steps=20).to_json()
    assert without_times(ours) == without_times(command("motion", four_bar, "--steps", "20"))


def test_json_of_a_sweep_is_that_of_the_command_line(four_bar, command):
    ours = moivre.Mechanism(four_bar).sweep({"crank.A.x": (10, 150, 15)}).to_json()
    assert without_times(ours) == without_times(command("sweep", four_bar, "--vary", "crank.A.x=10:150:15"))


def test_json_of_mobility_and_guesses_is_that_of_the_command_line(problems, four_bar, command):
    m = moivre.Mechanism(four_bar)
    assert m.mobility().to_json() == command("mobility", four_bar)
    assert without_times(m.guesses().to_json()) == without_times(command("guesses", four_bar))


def test_a_name_that_is_not_there_is_told_with_its_neighbour(four_bar):
    c = moivre.Mechanism(four_bar).closures()[0]
    for listed, name, meant in ((c.points, "coupler.Q", "coupler.P"), (c.bodies, "crnk", "crank"), (c, "crank.ph", "crank.phi")):
        with pytest.raises(KeyError, match=f"there is no .* {name}; did you mean '{meant}'"):
            listed[name]
    assert "coupler.Q" not in c.points and c.points.get("coupler.Q") is None
