# SPDX-License-Identifier: MIT
# Are all postures of an arm found, for one pose and for many, and do they hold the pose?
import numpy as np
import pytest
from conftest import parsed

import moivre


@pytest.fixture(scope="module")
def arm():
    from conftest import PROBLEMS
    return moivre.Arm(PROBLEMS / "robots" / "ur5.urdf", base="base_link", tip="tool0")


def poses_of(arm, count, seed=1):
    q = np.random.default_rng(seed).uniform(-np.pi, np.pi, (count, len(arm.joints)))
    return q, arm.fk(q)


def test_an_arm_has_joints_and_limits(arm):
    assert len(arm.joints) == 6 and len(arm.limits) == 6 and (arm.base, arm.tip) == ("base_link", "tool0")


def test_forward_kinematics_of_one_and_of_many(arm):
    q, poses = poses_of(arm, 5)
    assert poses.shape == (5, 4, 4) and arm.fk(q[0]).shape == (4, 4)
    assert np.array_equal(arm.fk(q[0]), poses[0])
    assert np.allclose(poses[:, :3, :3] @ poses[:, :3, :3].transpose(0, 2, 1), np.eye(3))


def test_one_pose_has_its_postures(arm):
    _, poses = poses_of(arm, 1)
    q = arm.ik(poses[0])
    assert q.values.shape == (1, 16, 6) and q.counts.shape == (1,) and q.complete is True
    assert np.isnan(q.values[0, q.counts[0]:]).all() and not np.isnan(q.values[0, :q.counts[0]]).any()
    assert q[0].shape == (q.counts[0], 6)


def test_every_posture_holds_the_pose(arm):
    given, poses = poses_of(arm, 20)
    q = arm.ik(poses, tracker="lanes")
    assert q.complete and q.values.shape == (20, 16, 6)
    for k in range(20):
        assert np.allclose(arm.fk(q[k]), poses[k], atol=1e-8)
        turned = np.abs(np.exp(1j * q[k]) - np.exp(1j * given[k])).max(axis=1)
        assert turned.min() < 1e-6


def test_postures_have_names(arm):
    _, poses = poses_of(arm, 2)
    q = arm.ik(poses)
    assert len(q.names(1)) == q.counts[1] and "shoulder" in q.names(1)[0]


def test_a_pose_out_of_reach_has_none(arm):
    pose = np.eye(4)
    pose[:3, 3] = [10, 0, 0]
    q = arm.ik(pose)
    assert q.complete and q.counts[0] == 0 and np.isnan(q.values).all() and q[0].shape == (0, 6)


def test_no_pose_gives_empty_arrays(arm):
    q = arm.ik(np.zeros((0, 4, 4)))
    assert q.values.shape == (0, 16, 6) and q.complete and len(q) == 0


def broken(change):
    pose = np.eye(4)
    change(pose)
    return pose


@pytest.mark.parametrize("change, words", [
    (lambda p: p.__setitem__((0, 0), np.nan), "not finite"),
    (lambda p: p.__setitem__((0, 3), np.inf), "not finite"),
    (lambda p: p.__setitem__((0, 0), 2), "no rotation"),
    (lambda p: p.__setitem__((0, 0), -1), "no rotation"),
    (lambda p: p.__setitem__((3, 0), 1), "last row"),
])
def test_what_is_no_pose_is_refused_by_number(arm, change, words):
    poses = np.stack([np.eye(4), broken(change)])
    with pytest.raises(ValueError, match=f"pose 1: .*{words}"):
        arm.ik(poses)


@pytest.mark.parametrize("poses", [np.eye(3), np.zeros((2, 3, 4)), np.zeros(16)])
def test_poses_of_another_shape_are_refused(arm, poses):
    with pytest.raises(ValueError, match="4, 4"):
        arm.ik(poses)


@pytest.mark.parametrize("q", [[0, 0, 0], np.zeros((2, 5)), np.zeros((1, 1, 6)), [0, 0, 0, 0, 0, np.nan]])
def test_joint_values_that_do_not_fit_are_refused(arm, q):
    with pytest.raises(ValueError):
        arm.fk(q)


def test_limits_are_met_by_whole_turns_where_that_can_be(arm):
    _, poses = poses_of(arm, 3)
    q = arm.ik(poses)
    lower, upper = np.array([limit or (-np.inf, np.inf) for limit in arm.limits]).T
    inside = (q.in_limits >= lower) & (q.in_limits <= upper) | np.isnan(q.in_limits)
    assert inside.all()
    assert np.allclose(np.exp(1j * q.values[0, 0]), np.exp(1j * q.in_limits[0, 0]))


def test_a_joint_can_be_held(problems):
    arm = moivre.Arm(problems / "robots" / "panda.urdf", tip="panda_hand_tcp", hold={"panda_joint7": 0.8})
    assert len(arm.joints) == 6
    assert arm.ik(arm.fk([0.1, 0.2, 0.3, -1.0, 0.5, 1.5])).counts[0] >= 1


@pytest.mark.parametrize("options", [{"tip": "hand"}, {"base": "nowhere"}, {"hold": {"elbow": 1}}])
def test_unknown_links_and_joints_are_named(ur5, options):
    with pytest.raises(ValueError):
        moivre.Arm(ur5, **options)


def test_a_file_that_is_no_robot_has_a_place(tmp_path):
    (tmp_path / "r.urdf").write_text("<robot name='r'>\n<link/>\n</robot>")
    with pytest.raises(moivre.ParseError) as caught:
        moivre.Arm(tmp_path / "r.urdf")
    assert caught.value.line == 2


def test_postures_are_those_of_the_command_line(arm, ur5, command, tmp_path):
    _, poses = poses_of(arm, 3)
    rows = []
    for pose in poses:
        w = np.sqrt(1 + np.trace(pose[:3, :3])) / 2
        x, y, z = ((pose[2, 1] - pose[1, 2]) / 4 / w, (pose[0, 2] - pose[2, 0]) / 4 / w, (pose[1, 0] - pose[0, 1]) / 4 / w)
        rows.append(" ".join(map(repr, map(float, [*pose[:3, 3], w, x, y, z]))))
    (tmp_path / "poses.csv").write_text("\n".join(rows))
    theirs = parsed(command("closures", ur5, "--base", "base_link", "--tip", "tool0", "--poses", tmp_path / "poses.csv"))
    ours = parsed(arm.ik(poses).to_json())
    assert set(ours) == set(theirs) and len(ours["poses"]) == len(theirs["poses"])
    q = arm.ik(poses)
    for k, pose in enumerate(theirs["poses"]):
        values = np.array([[c["coordinates"][joint] for joint in arm.joints] for c in pose["closures"]])
        assert np.allclose(values, q[k], atol=1e-9)


def test_a_single_pose_is_drawn(arm):
    q = arm.ik(arm.fk([0.1, -1.2, 1.1, 0.3, 0.8, -0.4]))
    assert "<svg" in q.to_svg() and q._repr_html_() and "<html" in q.to_html()


def dh_pose(rows, q, modified):
    """The product of Denavit-Hartenberg's matrices."""
    pose = np.eye(4)
    for (a, alpha, d, theta, *limits), value in zip(rows, q):
        d, theta = (d + value, theta) if limits else (d, theta + value)
        c, s, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
        along = np.array([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, d], [0, 0, 0, 1]])
        across = np.array([[1, 0, 0, a], [0, ca, -sa, 0], [0, sa, ca, 0], [0, 0, 0, 1]])
        pose = pose @ (across @ along if modified else along @ across)
    return pose


STANFORD = [[0, -np.pi / 2, 0.4, 0], [0, np.pi / 2, 0.15, 0], [0, 0, 0.1, -np.pi / 2, (0, 1.5)],
            [0, -np.pi / 2, 0, 0], [0, np.pi / 2, 0, 0], [0, 0, 0.26, 0]]
UR_BY_CRAIG = [[0, 0, .15185, 0], [0, np.pi / 2, 0, 0], [-.24355, 0, 0, 0], [-.2132, 0, .13105, 0], [0, np.pi / 2, .08535, 0],
               [0, -np.pi / 2, .0921, 0]]


@pytest.mark.parametrize("rows, modified", [(STANFORD, False), (UR_BY_CRAIG, True)])
def test_an_arm_by_denavit_hartenberg_has_its_poses_and_postures(rows, modified):
    arm = moivre.Arm.from_dh(rows, modified=modified)
    q = np.random.default_rng(4).uniform(-1, 1, (20, 6))
    q[:, 2] = np.abs(q[:, 2]) + 0.1
    poses = arm.fk(q)
    assert np.allclose(poses, [dh_pose(rows, row, modified) for row in q], atol=1e-14)
    found = arm.ik(poses, tracker="lanes")
    assert found.complete
    for k in range(20):
        assert np.abs(np.exp(1j * found[k]) - np.exp(1j * q[k])).max(axis=1).min() < 1e-6


@pytest.mark.parametrize("rows, words", [
    ([[1, 2, 3]], "row 1: a, alpha, d, theta are wanted"),
    ([[1, 2, 3, 4, 5]], "row 1: a, alpha, d, theta are wanted"),
    ([[0, 0, 0, 0], [1, 2, 3, "x"]], "row 2: .* are numbers"),
    ([[1, 2, 3, np.nan]], "row 1: a number is not finite"),
    ([[1, 2, 3, 4, (0, np.inf)]], "row 1: a number is not finite"),
    ([], "no joint"),
    ([[0.1, 0.2, 0.3, 0.4]] * 7, "Hold 1 of them by `hold`: joint1"),
])
def test_what_is_no_arm_by_denavit_hartenberg_is_refused_by_row(rows, words):
    with pytest.raises(ValueError, match=words):
        moivre.Arm.from_dh(rows)


def test_the_text_of_a_urdf_is_an_arm():
    from conftest import PROBLEMS
    path = PROBLEMS / "robots" / "puma560.urdf"
    q = [0.1, -0.5, 0.3, 0.4, 0.5, 0.6]
    assert np.array_equal(moivre.Arm(path.read_text()).fk(q), moivre.Arm(path).fk(q))
    with pytest.raises(moivre.ParseError, match="needs the attribute 'name'"):
        moivre.Arm('<robot name="x"><link/></robot>')


def test_a_rotation_of_three_digits_is_refused_with_what_to_do(arm):
    _, poses = poses_of(arm, 1)
    with pytest.raises(ValueError, match="no rotation: the nearest one is off by .*pose_accuracy=.*numpy.linalg.svd"):
        arm.ik(poses[0].round(3))
    u, _, vt = np.linalg.svd(poses[0, :3, :3].round(3))
    poses[0, :3, :3] = u @ vt
    assert arm.ik(poses[0]).complete


@pytest.mark.parametrize("decimals", [2, 3, 4, 5, 6])
def test_a_rotation_within_the_poses_accuracy_is_the_nearest_one(arm, decimals):
    q, poses = poses_of(arm, 20)
    rounded = poses.round(decimals)
    accuracy = 2 * 10.0**-decimals
    found = arm.ik(rounded, pose_accuracy=accuracy, tracker="lanes")
    for k in range(20):
        u, _, vt = np.linalg.svd(rounded[k, :3, :3])
        nearest = rounded[k].copy()
        nearest[:3, :3] = u @ vt
        position, rotation = arm.misfit(found[k], nearest)
        assert len(found[k]) >= 1 and position.max() < accuracy and rotation.max() < accuracy
    assert np.array_equal(arm.ik(rounded, pose_accuracy=10).counts, found.counts)


def test_what_is_no_rotation_within_the_accuracy_is_refused(arm):
    stretched = np.diag([1.01, 1, 1, 1])
    with pytest.raises(ValueError, match="off by 0.01, and may be by 0.001; a larger pose_accuracy="):
        arm.ik(stretched, pose_accuracy=1e-3)
    with pytest.raises(ValueError, match="left-handed"):
        arm.ik(np.diag([1, 1, -1, 1]), pose_accuracy=3)


def test_a_misfit_is_measured_from_a_rotation_of_four_digits(arm):
    q = [0.3, -1.0, 1.2, 0.4, 0.5, 0.7]
    position, rotation = arm.misfit(q, arm.fk(q).round(4))
    assert position < 1e-4 and rotation < 1e-3


def test_a_misfit_is_told_in_metres_and_radians(arm):
    q, poses = poses_of(arm, 3)
    off = poses.copy()
    off[:, :3, 3] += [0.003, 0, 0.004]
    turn = np.array([[np.cos(0.02), -np.sin(0.02), 0], [np.sin(0.02), np.cos(0.02), 0], [0, 0, 1]])
    off[:, :3, :3] = off[:, :3, :3] @ turn
    position, rotation = arm.misfit(q, off)
    assert np.allclose(position, 0.005) and np.allclose(rotation, 0.02)
    assert np.allclose(arm.misfit(q[0], off[0]), (0.005, 0.02)) and isinstance(arm.misfit(q[0], off[0])[0], float)
    assert arm.misfit(q[0], off)[0].shape == (3,) and arm.misfit(q, off[0])[0].shape == (3,)
    with pytest.raises(ValueError, match="as many poses as joint values"):
        arm.misfit(q, off[:2])


def test_a_number_of_a_pose_that_is_not_there_is_refused(arm):
    q = arm.ik(poses_of(arm, 2)[1])
    for ask in (lambda: q[2], lambda: q.names(2), lambda: q.motions(-3), lambda: q.message(5)):
        with pytest.raises(IndexError, match="there is no pose -?[0-9]: there are 2, counted from 0"):
            ask()


def straight_wrists():
    return moivre.Arm.from_dh([[0, np.pi / 2, 0.4, 0], [0.5, 0, 0, 0], [0.1, np.pi / 2, 0, 0],
                               [0, -np.pi / 2, 0.5, 0], [0, np.pi / 2, 0, 0], [0, 0, 0.1, 0]])


@pytest.mark.parametrize("made, given", [
    (straight_wrists, [0.1, 0.2, 0.3, 2.9, 0, 2.8]),   # a plane in joint space, turns without limits
    (lambda: moivre.Arm("problems/robots/ur5.urdf", base="base_link", tip="tool0"), [0.1, -1.2, 1.1, 0.3, 0, -0.4]),
])
def test_postures_of_a_set_have_turns_as_closures_have(made, given, monkeypatch):
    from conftest import ROOT
    monkeypatch.chdir(ROOT)
    arm = made()
    q = arm.ik(arm.fk(given))
    assert q.moves[0]
    for motion in q.motions(0):
        for posture in (*motion.samples, motion.q):
            for value, limits in zip(posture, arm.limits):
                assert limits is not None and limits[0] <= value <= limits[1] or -np.pi < value <= np.pi
            assert np.allclose(arm.misfit(posture, arm.fk(given)), 0, atol=1e-8)
        assert all(-np.pi < value <= np.pi for _, value in motion.relations)
        way = np.unwrap(motion.samples, axis=0)
        assert np.abs(np.diff(way, axis=0)).max() < 0.5


def test_of_two_sets_each_contains_its_own_postures(arm):
    q = arm.ik(arm.fk([0.1, -1.2, 1.1, 0.3, 0, -0.4]))
    one, other = q.motions(0)
    for motion, elsewhere in ((one, other), (other, one)):
        assert all(motion.contains(posture) and not elsewhere.contains(posture) for posture in motion.samples[::10])


def test_a_set_contains_its_postures_alone():
    arm = straight_wrists()
    given = np.array([0.1, 0.2, 0.3, 0.4, 0, 0.6])
    pose = arm.fk(given)
    q = arm.ik(pose)
    motions = q.motions(0)
    own = [m for m in motions if m.contains(given)]
    assert len(own) == 1 and len(q[0]) >= 1
    along = given + np.array([0, 0, 0, 1.7, 0, -1.7])
    assert own[0].contains(along) and own[0].contains(along + 2 * np.pi * np.array([0, 0, 0, 1, 0, -3]))
    assert not own[0].contains(given + np.array([0, 0, 0, 0.1, 0, 0]))    # misses the pose
    assert not any(own[0].contains(posture) for posture in q[0])           # holds it, elsewhere
    rounded = along + 3e-5
    assert not own[0].contains(rounded) and own[0].contains(rounded, within=1e-3)
    for wrong, words in (([0, 0], "6 joints"), ([np.nan] * 6, "not finite")):
        with pytest.raises(ValueError, match=words):
            own[0].contains(wrong)
    with pytest.raises(ValueError, match="within: metres and radians"):
        own[0].contains(given, within=-1)
