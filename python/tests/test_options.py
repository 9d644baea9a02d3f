# SPDX-License-Identifier: MIT
# Does an option of the command line do the same in Python, and is a wrong value refused by the argument's name?
import os
import time

import numpy as np
import pytest
from conftest import PROBLEMS, parsed, without_times

import moivre

MECHANISMS = PROBLEMS / "mechanisms"
ROBOTS = PROBLEMS / "robots"
SYSTEM = ["x^2 + y^2 - 4", "x*y - 1"]


def katsura(n):
    def u(k):
        return f"u{abs(k)}" if abs(k) <= n else "0"
    first = [" + ".join(u(k) for k in range(-n, n + 1)) + " - 1"]
    return first + [" + ".join(f"{u(k)}*{u(m - k)}" for k in range(-n, n + 1) if abs(k) <= n and abs(m - k) <= n) + f" - {u(m)}"
                    for m in range(n)]


def same_json(ours, theirs):
    """Lines that differ but for what a name of the file or a time is."""
    assert without_times(ours) == without_times(theirs)


@pytest.fixture
def file(tmp_path):
    (tmp_path / "f.phc").write_text("2\n" + "\n".join(f"{e};" for e in SYSTEM) + "\n")
    return str(tmp_path / "f.phc")


@pytest.mark.parametrize("words, options", [
    (["--real"], {"real": True}),
    (["--positive"], {"positive": True}),
    (["--nonzero"], {"nonzero": True}),
    (["--box", "x=1:"], {"box": {"x": (1, None)}}),
    (["--box", "x=-2:0,y=:0"], {"box": {"x": np.array([-2.0, 0.0]), "y": [None, 0]}}),
    (["--where", "x > y"], {"where": "x > y"}),
    (["--where", "x*y <= 1", "--where", "0 < x < 1"], {"where": ["x*y <= 1", "0 < x < 1"]}),
    (["--cross-check"], {"cross_check": True}),
    (["--positive", "--digits", "20"], {"positive": True, "digits": 20}),
])
def test_roots_are_chosen_as_on_the_command_line(file, command, words, options):
    same_json(moivre.solve(file, **options).to_json(), command("solve", file, *words))


def test_what_a_filter_leaves_out_is_counted():
    r = moivre.solve(SYSTEM, positive=True)
    assert len(r) == 2 and r.filtered == 2 and r.completeness == "proved" and (r.real_points > 0).all()


def test_conditions_stand_among_the_equations_and_in_a_file(file, command):
    with open(file, "a", encoding="utf-8") as more:
        more.write("x > 0;\n0 < y <= 1;\n")
    ours = moivre.solve(file)
    same_json(ours.to_json(), command("solve", file))
    assert len(ours) == 1 and ours.filtered == 3
    for equations in ([*SYSTEM, "x > 0", "0 < y <= 1"], "x^2 + y^2 = 4\nx*y = 1\nx > 0\n0 < y <= 1",
                      "; ".join([*SYSTEM, "x > 0", "0 < y <= 1"])):
        np.testing.assert_array_equal(moivre.solve(equations).points, ours.points)
    assert len(moivre.solve([*SYSTEM, "x > 0", "2*y < x"], variables=["y", "x"])) == 1


def test_a_root_on_the_boundary_of_a_condition_says_so():
    r = moivre.solve(SYSTEM, where="x*y >= 1")
    assert [root.on_boundary for root in r] == [["x*y >= 1"]] * 4
    assert "on the boundary of x*y >= 1" in r.to_text()
    assert len(moivre.solve(SYSTEM, where="x*y > 1")) == 0


@pytest.mark.parametrize("where, words", [("z > 0", "`z` occurs in this condition"), ("x = 1", "expected a condition"),
                                          (3, "where: 3 is no condition"), ([None], "where: None is no condition")])
def test_what_is_no_condition_is_refused(where, words):
    with pytest.raises(ValueError, match=words):
        moivre.solve(SYSTEM, where=where)


def test_a_family_has_no_conditions_and_its_member_has():
    with pytest.raises(ValueError, match="a family has no conditions, such as 'x > 0'"):
        moivre.Family.learn(["x^2 - a", "x > 0"], ["a"])
    r = moivre.solve("x^2 - a", parameters={"a": (1, 4)}, start_points=[[1], [-1]], where="x > 0")
    assert len(r) == 1 and r.filtered == 1


def test_unknowns_in_another_order_keep_their_denominators():
    r = moivre.solve("(x^2 - 1)/(x - 1) - y; x*y - 6", variables=["y", "x"])
    np.testing.assert_allclose(sorted(r.real_points[:, 1]), [-3, 2])


def test_a_box_takes_symbols():
    sp = pytest.importorskip("sympy")
    x, y = sp.symbols("x y")
    assert len(moivre.solve([x**2 + y**2 - 4, x * y - 1], box={x: (1, None)})) == 1


@pytest.mark.parametrize("options, words", [
    ({"box": {"z": (0, 1)}}, "box: there is no unknown 'z'"),
    ({"box": {"x": (1, 0)}}, "box: the range of 'x'"),
    ({"box": {"x": (np.nan, 0)}}, "box: the range of 'x'"),
    ({"box": {"x": (1, 2, 3)}}, "box: x: "),
    ({"box": [1]}, "box: a dictionary"),
    ({"real": "yes"}, "real: 'yes' is given"),
    ({"time_limit": 0}, "time_limit: seconds above 0"),
    ({"time_limit": np.nan}, "time_limit: seconds above 0"),
    ({"time_limit": "1"}, "time_limit: '1' is given"),
    ({"start_points": [[1, 1]]}, "start_points and parameters"),
    ({"parameters": {"a": (1, 2)}}, "start_points and parameters"),
])
def test_a_wrong_value_is_refused_by_its_name(options, words):
    with pytest.raises(ValueError, match=words):
        moivre.solve(SYSTEM, **options)


def test_the_other_tracker_is_asked():
    check = moivre.solve(SYSTEM, cross_check=True).cross_check
    assert check == {"witness": "lanes", "common": 4, "missed": 0, "unwitnessed": 0, "disagreements": 0}
    assert moivre.solve(SYSTEM).cross_check is None


def test_paths_have_a_table():
    assert len(moivre.solve(SYSTEM).to_paths_csv().splitlines()) == 5


def test_known_roots_lead_to_those_of_other_values():
    r = moivre.solve(["x^2 - a", "y - b*x"], variables=["x", "y", "a", "b"], parameters={"a": (1, 9), "b": (2, "1/3")},
                     start_points=[[1, 2], [-1, -2]])
    assert np.allclose(np.sort(r.points[:, 0].real), [-3, 3]) and np.allclose(r.points[:, 1], r.points[:, 0] / 3)


@pytest.mark.parametrize("options, words", [
    ({"parameters": {"a": (1, 2, 3)}, "start_points": [[1], [2]]}, "parameters: a: "),
    ({"parameters": {"a": (1, 2)}, "start_points": [[1, 2]]}, "start_points of shape"),
    ({"parameters": {"a": (1, np.inf)}, "start_points": [[1]]}, "parameters: a: .*finite"),
    ({"parameters": {"c": (1, 2)}, "start_points": [[1]]}, "c"),
])
def test_a_start_that_does_not_fit_is_refused(options, words):
    with pytest.raises(ValueError, match=words):
        moivre.solve("x^2 - a", **options)


def in_time(seconds, begin):
    """How long a call may take beyond its limit, where other builds share the machine."""
    return time.perf_counter() - begin < seconds + 0.3 + 1.2 * (os.getloadavg()[0] > 0.7 * os.cpu_count())


@pytest.mark.parametrize("tracker", ["cvode", "lanes"])
def test_a_time_limit_ends_a_solve_with_what_is_finished(tracker):
    begin = time.perf_counter()
    r = moivre.solve(katsura(18), tracker=tracker, time_limit=1.0)
    assert in_time(1.0, begin) and r.complete is False and "interrupted" in r.message


def test_a_time_limit_that_is_not_reached_changes_nothing():
    same_json(moivre.solve(SYSTEM, time_limit=60).to_json(), moivre.solve(SYSTEM).to_json())


def test_a_time_limit_ends_every_long_call():
    def ended(call, limit=0.05):
        begin = time.perf_counter()
        found = call(limit)
        assert in_time(limit, begin)
        return found

    general = moivre.Mechanism(MECHANISMS / "general-6r.toml")
    four_bar = moivre.Mechanism(MECHANISMS / "four-bar.toml")
    assert not ended(lambda s: general.closures(time_limit=s, threads=1), 0.005).complete
    assert not ended(lambda s: four_bar.motion(steps=30000, time_limit=s)).complete
    assert not ended(lambda s: four_bar.sweep({"crank.A.x": (10, 150, 4000)}, time_limit=s)).complete
    family = moivre.Family.learn(["x^2 + a*x + b"], parameters=["a", "b"])
    members = ended(lambda s: family.solve(np.ones((300000, 2)) + np.arange(300000)[:, None], time_limit=s))
    assert not members.complete
    arm = moivre.Arm(ROBOTS / "ur5.urdf", base="base_link", tip="tool0")
    poses = arm.fk(np.random.default_rng(3).uniform(-2, 2, (20000, 6)))
    q = ended(lambda s: arm.ik(poses, time_limit=s))
    assert not q.complete and not q.decided[-1] and q.counts[-1] == 0 and q.message(19999) == "not begun"
    for call in (four_bar.closures, four_bar.motion, four_bar.mobility):
        with pytest.raises(ValueError, match="time_limit: seconds above 0"):
            call(time_limit=-1)


@pytest.fixture(scope="module")
def arm():
    return moivre.Arm(ROBOTS / "ur5.urdf", base="base_link", tip="tool0")


STANDS = [0.3, -1.2, 1.1, 0.4, 0.8, -0.4]


def typed(pose):
    """The general numbers of the command line."""
    w = np.sqrt(1 + np.trace(pose[:3, :3])) / 2
    x, y, z = pose[2, 1] - pose[1, 2], pose[0, 2] - pose[2, 0], pose[1, 0] - pose[0, 1]
    return " ".join(repr(float(v)) for v in (*pose[:3, 3], w, x / 4 / w, y / 4 / w, z / 4 / w))


def rounded(node):
    """A report with numbers of nine digits, without what the last bit of the pose decides."""
    if isinstance(node, dict):
        return {key: rounded(value) for key, value in node.items()
                if key not in ("time_s", "seconds", "file", "residual", "newton_iterations", "poses", "target", "work")}
    if isinstance(node, list):
        return [rounded(value) for value in node]
    return round(node, 7) + 0.0 if isinstance(node, float) else node


@pytest.mark.parametrize("words, options", [
    (["--nearest", " ".join(map(str, STANDS))], {"nearest": STANDS}),
    (["--nearest", "7 -1.2 1.1 0.4 0.8 -0.4"], {"nearest": np.array([7, -1.2, 1.1, 0.4, 0.8, -0.4])}),
    (["--limits", "wrap"], {"limits": "wrap"}),
    (["--pose-accuracy", "1e-3"], {"pose_accuracy": 1e-3}),
])
def test_postures_are_told_as_on_the_command_line(arm, command, words, options):
    pose = arm.fk(np.array(STANDS) + 0.02)
    theirs = parsed(command("closures", ROBOTS / "ur5.urdf", "--base", "base_link", "--tip", "tool0", "--pose", typed(pose), *words))
    ours = parsed(arm.ik(pose, **options).to_json())
    assert rounded(ours["poses"][0] if "poses" in ours else ours) == rounded(theirs["poses"][0] if "poses" in theirs else theirs)


def test_the_nearest_posture_comes_first(arm):
    q = arm.ik(arm.fk([STANDS, [0.1] * 6]), nearest=STANDS)
    assert np.allclose(q.in_limits[0, 0], STANDS) and q.distance.shape == (2, 16)
    for pose in range(2):
        told = q.distance[pose, :q.counts[pose]]
        assert (np.diff(told) >= 0).all() and np.isnan(q.distance[pose, q.counts[pose]:]).all()
        assert np.allclose(told, np.abs(q.in_limits[pose, :q.counts[pose]] - STANDS).max(axis=1))
    assert arm.ik(arm.fk(STANDS)).distance is None


def test_every_choice_of_whole_turns_is_within_the_limits(arm):
    q = arm.ik(arm.fk(STANDS), limits="wrap")
    lower, upper = np.array(arm.limits).T
    for values, turns in zip(q[0], q.turns(0)):
        assert len(turns) >= 32 and ((turns >= lower) & (turns <= upper)).all()
        assert np.allclose(np.exp(1j * turns), np.exp(1j * values)) and len(np.unique(turns.round(6), axis=0)) == len(turns)
    assert len(q.to_csv().splitlines()) == 1 + sum(map(len, q.turns(0)))


def test_a_straight_wrist_has_its_self_motion(arm):
    q = arm.ik(arm.fk([0.3, -1.2, 1.1, 0.4, 0.0, -0.4]))
    assert q.moves[0] and q.counts[0] >= 1
    motions = q.motions(0)
    assert motions and all(m.dimension == 1 and m.directions.shape == (6, 1) and m.lost.shape == (6,) for m in motions)
    for motion in motions:
        assert np.allclose(arm.fk(motion.samples), arm.fk(motion.q), atol=1e-8)
        for factors, value in motion.relations:
            assert np.allclose(np.exp(1j * (motion.samples @ factors - value)), 1, atol=1e-6)
    assert arm.ik(arm.fk(STANDS)).motions(0) == []


def test_an_arm_of_five_joints_says_which_posture_comes_nearest():
    row = [[0.1, np.pi / 2, 0.2, 0], [0.4, 0, 0, 0], [0.3, 0, 0, 0], [0, np.pi / 2, 0, np.pi / 2], [0, 0, 0.1, 0]]
    arm = moivre.Arm.from_dh(row)
    pose = arm.fk([0.1, 0.3, -0.5, 0.2, 0.4])
    assert arm.ik(pose).nearest_posture(0) is None and arm.ik(pose).counts[0] >= 1
    turned = np.eye(4)
    turned[:3, :3] = [[np.cos(0.1), 0, np.sin(0.1)], [0, 1, 0], [-np.sin(0.1), 0, np.cos(0.1)]]
    off = arm.ik(pose @ turned)
    assert off.counts[0] == 0
    near = off.nearest_posture(0)
    assert near.q.shape == (5,) and np.allclose(arm.misfit(near.q, pose @ turned), (near.position, near.rotation))
    assert 0 < near.rotation <= 0.11 and 0 <= near.position < 0.2
    assert f"misses it by {near.position:.2g} m and {near.rotation:.2g} rad" in off.message(0)
    far = np.eye(4)
    far[0, 3] = 10
    six = moivre.Arm(PROBLEMS / "robots" / "ur5.urdf", base="base_link", tip="tool0").ik(far).nearest_posture(0)
    assert six is not None and six.position > 5
    assert arm.ik(pose @ turned, pose_accuracy=0.2).counts[0] >= 1


@pytest.mark.parametrize("options, words", [
    ({"nearest": [0, 0]}, "nearest: .*each of its 6 joints"),
    ({"nearest": [0, 0, 0, 0, 0, np.nan]}, "nearest: .*finite"),
    ({"limits": "all"}, 'limits: "wrap"'),
    ({"pose_accuracy": -1}, "pose_accuracy: "),
    ({"pose_accuracy": np.inf}, "pose_accuracy: "),
])
def test_a_wrong_option_of_an_arm_is_refused_by_its_name(arm, options, words):
    with pytest.raises(ValueError, match=words):
        arm.ik(np.eye(4), **options)


FOUR_BAR = MECHANISMS / "four-bar.toml"


@pytest.mark.parametrize("words, options", [
    (["--from-guess"], {"from_guess": True}),
    (["--guess", "coupler.phi=-60", "--guess", "rocker.phi=-90"], {"guess": {"coupler.phi": -60, "rocker.phi": -90}}),
    (["--closure", "B"], {"closure": "B"}),
    (["--closure", "A", "--closure", "drawn"], {"closure": ["A"]}),
])
def test_a_motion_begins_where_it_is_asked_to(command, words, options):
    words = [w for w in words if w != "drawn"][: 2 * len(options.get("closure", "AA"))] if "drawn" in words else words
    ours = moivre.Mechanism(FOUR_BAR).motion(steps=20, **options)
    same_json(ours.to_json(), command("motion", FOUR_BAR, "--steps", 20, *words))


def test_tables_have_the_unit_that_is_asked_for(tmp_path, command):
    m = moivre.Mechanism(FOUR_BAR)
    motion = m.motion(steps=20)
    for angles, continuous in (("rad", False), ("deg", True)):
        command("motion", FOUR_BAR, "--steps", 20, "--csv", tmp_path / "m.csv", "--angles", angles, *["--continuous"] * continuous)
        assert motion.to_csv(angles=angles, continuous=continuous) == (tmp_path / "m.csv").read_text()
    command("closures", FOUR_BAR, "--csv", tmp_path / "c.csv", "--angles", "deg")
    assert m.closures().to_csv(angles="deg") == (tmp_path / "c.csv").read_text()
    for table in (m.closures(), m.guesses(), m.sensitivity(), motion):
        with pytest.raises(ValueError, match='angles: "rad" or "deg"'):
            table.to_csv(angles="grad")


def test_borders_are_left_out_where_they_are_not_asked_for(command):
    sweep = moivre.Mechanism(FOUR_BAR).sweep({"coupler.B.x": (100, 200, 6)}, borders=False)
    assert len(sweep.borders) == 0 and list(sweep.real) == [2, 2, 2, 0, 0, 0]
    same_json(sweep.to_json(), command("sweep", FOUR_BAR, "--vary", "coupler.B.x=100:200:6", "--no-borders"))


def test_mobility_and_newton_begin_at_a_guess(command):
    m = moivre.Mechanism(FOUR_BAR)
    words = ["--guess", "coupler.phi=-60", "--guess", "rocker.phi=-90"]
    guess = {"coupler.phi": -60, "rocker.phi": -90}
    same_json(m.mobility(guess=guess).to_json(), command("mobility", FOUR_BAR, *words))
    same_json(m.newton(guess=guess).to_json(), command("newton", FOUR_BAR, *words))
    run = m.newton(guess=guess, weight={"coupler.phi": 2}, tolerance=1e-12, max_iterations=2)
    assert not run.converged and run.status == "iteration_limit" and run.iterates.shape == (3, 9)
    assert np.array_equal(run.iterates[-1], run.q)


@pytest.mark.parametrize("call", ["motion", "mobility", "newton"])
def test_a_guess_is_refused_by_the_name_of_its_coordinate(call):
    m = moivre.Mechanism(FOUR_BAR)
    with pytest.raises(ValueError, match="guess: there is no coordinate coupler.ph, did you mean coupler.phi"):
        getattr(m, call)(guess={"coupler.ph": 3})
    with pytest.raises(ValueError, match="guess: .*not finite"):
        getattr(m, call)(guess={"coupler.phi": np.inf})
    with pytest.raises(ValueError, match="guess: a dictionary"):
        getattr(m, call)(guess=[3])


def test_a_closure_that_is_not_there_is_refused():
    with pytest.raises(ValueError, match="F"):
        moivre.Mechanism(FOUR_BAR).motion(closure="F")
    with pytest.raises(ValueError, match="closure and guess"):
        moivre.Mechanism(FOUR_BAR).motion(closure="A", from_guess=True)


def test_a_robot_with_loops_is_a_mechanism(command):
    robot, loops = ROBOTS / "palletizer.urdf", ROBOTS / "palletizer.loops.toml"
    m = moivre.Mechanism.from_robot(robot, loops=loops)
    ours, theirs = parsed(m.closures().to_json()), parsed(command("closures", robot, "--loops", loops))
    assert ours["counts"] == theirs["counts"] and ours["closures"] == theirs["closures"] and len(m.closures()) == 8
    delta = moivre.Mechanism.from_robot((ROBOTS / "delta.urdf").read_text(), hold={"x": 0.05, "y": 0.03, "z": -0.45})
    assert "y" in " ".join(delta.coordinates)
    with pytest.raises(ValueError, match="tip: needs pose"):
        moivre.Mechanism.from_robot(robot, tip="hand")
    with pytest.raises(ValueError, match="pose: .*no rotation"):
        moivre.Mechanism.from_robot(robot, pose=2 * np.eye(4))
    with pytest.raises(ValueError, match="pose: an array of shape"):
        moivre.Mechanism.from_robot(robot, pose=np.eye(3))


def test_a_sensitivity_is_told_as_on_the_command_line(command, tmp_path):
    told = moivre.Mechanism(FOUR_BAR).sensitivity(tolerance=0.05)
    command("closures", FOUR_BAR, "--sensitivity", "--tolerance", "0.05", "--csv", tmp_path / "s.csv")
    assert told.to_csv() == (tmp_path / "s.csv").read_text() and "crank.A.x" in str(told)


def test_the_drawn_closure_is_marked():
    closures = moivre.Mechanism(MECHANISMS / "jansen-leg.toml").closures()
    assert sum(c.drawn for c in closures) <= 1 and all(c.misfit >= 0 and not c.fitted for c in closures)


def test_a_closure_within_a_fit_has_its_play(command):
    file = PROBLEMS / "people" / "fit-not-assembled.toml"
    closures = moivre.Mechanism(file).closures(fit=0.05)
    told = parsed(command("closures", file, "--fit", "0.05"))["closures"]
    assert [c.play for c in closures] == [c["play"] for c in told] and len(told) == 1
    assert closures[0].play > 0
    assert moivre.Mechanism(FOUR_BAR).closures()[0].play is None
