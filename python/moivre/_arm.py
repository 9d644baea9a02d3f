# SPDX-License-Identifier: MIT
# With which joint values does an arm hold its tip in a pose? All of them, for one pose or many.
"""Robot arms from URDF, or from Denavit-Hartenberg's numbers."""

import dataclasses
import functools
import os

import numpy as np

from . import _moivre
from ._dh import dh_urdf
from ._errors import ParseError
from ._progress import told
from ._solve import chosen, in_degrees, place, write


class Arm:
    """A serial arm of up to six joints, of any geometry.

    Parameters
    ----------
    path : path or text
        A URDF file, or its text. `Arm.from_dh` takes Denavit-Hartenberg's numbers.
    base, tip : str, optional
        Links. Default: the root, and the leaf where there is one alone.
    hold : dict, optional
        Joints that stand, radians or metres: `{"panda_joint7": 0.8}`.

    Attributes
    ----------
    joints : list of str
        In the order of joint values.
    limits : list of ((float, float) or None)
    base, tip : str
    robot : str
        Its name.

    Examples
    --------
    >>> import moivre, numpy as np
    >>> arm = moivre.Arm("problems/robots/puma560.urdf")
    >>> q0 = [0.1, -0.5, 0.3, 0.4, 0.5, 0.6]
    >>> q = arm.ik(arm.fk(q0))
    >>> int(q.counts[0]), q.complete
    (8, True)
    >>> bool(np.isclose(q.values[0], q0).all(axis=1).any())
    True
    """

    def __init__(self, path, base=None, tip=None, hold=None):
        held = [(str(joint), float(value)) for joint, value in (hold or {}).items()]
        is_text = isinstance(path, str) and path.lstrip().startswith("<")
        try:
            self._arm = (_moivre.arm_of_text(path, base, tip, held) if is_text
                         else _moivre.arm_of_file(os.fspath(path), base, tip, held))
        except ParseError:
            raise
        except ValueError as refusal:
            raise ValueError(str(refusal).replace("`held`", "`hold`")) from None
        self.robot = self._arm.robot
        self.base = self._arm.base
        self.tip = self._arm.tip
        self.joints = self._arm.joints
        self.limits = self._arm.limits

    @classmethod
    def from_dh(cls, rows, *, modified=False, name="arm", hold=None):
        """An arm by Denavit-Hartenberg's numbers.

        Parameters
        ----------
        rows : list of (a, alpha, d, theta)
            Of each joint, metres and radians: it turns by theta and its joint value, about an axis without limits.
            A fifth entry, (lower, upper), says that the joint slides along its axis, between these limits.
        modified : bool, optional
            False: Rz(theta) Tz(d) Tx(a) Rx(alpha) for each joint; True: Craig's Rx(alpha) Tx(a) Rz(theta) Tz(d).
        hold : dict, optional
            Joints that stand, by the names "joint1", "joint2", ...

        Returns
        -------
        Arm

        Examples
        --------
        >>> import moivre
        >>> from math import pi
        >>> arm = moivre.Arm.from_dh([[0, pi/2, 0.3, 0], [0.4, 0, 0, 0], [0.1, 0, 0, 0]])
        >>> arm.fk([0, 0, 0])[:3, 3]
        array([0.5, 0. , 0.3])
        """
        return cls(dh_urdf(rows, modified, name), hold=hold)

    def fk(self, q):
        """Pose of the tip in the base's frame.

        Parameters
        ----------
        q : array_like of float, shape (joints,) or (N, joints)
            Radians, of slides metres.

        Returns
        -------
        ndarray, shape (4, 4) or (N, 4, 4)

        Examples
        --------
        >>> import moivre
        >>> arm = moivre.Arm("problems/robots/puma560.urdf")
        >>> arm.fk([0, 0, 0, 0, 0, 0])[3]
        array([0., 0., 0., 1.])
        """
        return self._arm.fk(np.asarray(q, dtype=float))

    def misfit(self, q, poses):
        """By how much joint values miss a pose, its position and its rotation apart.

        Parameters
        ----------
        q : array_like of float, shape (joints,) or (N, joints)
        poses : array_like of float, shape (4, 4) or (N, 4, 4)
            One for all joint values, or one for each. A rotation that is rounded to two digits or more is the nearest one.

        Returns
        -------
        (position, rotation)
            Metres and radians: floats, or two ndarrays of shape (N,) where q or poses are many.

        Examples
        --------
        >>> import moivre
        >>> arm = moivre.Arm("problems/robots/puma560.urdf")
        >>> T = arm.fk([0, 0, 0, 0, 0, 0])
        >>> T[0, 3] += 0.002
        >>> position, rotation = arm.misfit([0, 0, 0, 0, 0, 0], T)
        >>> round(position, 6), round(rotation, 6)
        (0.002, 0.0)
        """
        q, poses = np.asarray(q, dtype=float), np.asarray(poses, dtype=float)
        is_one = q.ndim == 1 and poses.ndim == 2
        position, rotation = self._arm.misfits(q, poses[np.newaxis] if poses.ndim == 2 else poses).T
        return (float(position[0]), float(rotation[0])) if is_one else (position, rotation)

    def ik(self, poses, *, pose_accuracy=None, nearest=None, limits=None, tracker=None, start=None, seed=None, threads=None,
           time_limit=None, tracker_options=None, progress=None):
        """All joint values that hold the tip in a pose.

        Parameters
        ----------
        poses : array_like of float, shape (4, 4) or (N, 4, 4)
            Homogeneous transforms, lengths in metres. Of a rotation rounded to six digits, or within `pose_accuracy`, the nearest
            one is taken.
        pose_accuracy : float, optional
            How well the poses are known, metres and radians: postures and sets miss them by no more. Default: 1e-10, as
            of computed ones. Of four decimals it is 2e-4.
        nearest : array_like of float, shape (joints,), optional
            Joint values where the arm stands: postures come in the order of their distance from there, `in_limits` with the
            whole turns that bring each joint nearest.
        limits : "wrap", optional
            Reports list every choice of whole turns that the limits allow; `Postures.turns` has them in any case.
        tracker : {"cvode", "lanes"}, optional
            "lanes" is several times faster for many poses.
        start, seed, threads, tracker_options, progress
            As for `solve`.
        time_limit : float, optional
            Seconds. Poses that are not begun by then have no postures, and are not decided.

        Returns
        -------
        Postures

        Raises
        ------
        ValueError
            A pose is no rotation and translation, `nearest` has another size than the arm has joints, `limits` allow more
            choices than can be listed, or an option is out of range.

        Examples
        --------
        >>> import moivre, numpy as np
        >>> arm = moivre.Arm("problems/robots/puma560.urdf")
        >>> stands = [0.1, -0.5, 0.3, 0.4, 0.5, 0.6]
        >>> q = arm.ik(arm.fk(stands), nearest=stands)
        >>> bool(np.allclose(q.in_limits[0, 0], stands)), bool(q.distance[0, 0] < 1e-9)
        (True, True)
        """
        poses = np.asarray(poses, dtype=float)
        is_list = poses.ndim == 3
        if poses.ndim == 2:
            poses = poses[np.newaxis]
        if nearest is not None:
            nearest = np.asarray(nearest, dtype=float).reshape(-1)
        options = chosen(pose_accuracy=pose_accuracy, nearest=nearest, limits=limits, tracker=tracker, start=start, seed=seed,
                         threads=threads, time_limit=time_limit, tracker_options=tracker_options)
        with told(progress) as tell:
            return Postures(_moivre.arm_ik(self._arm, poses, is_list, options, tell))

    def __repr__(self):
        return f"<moivre.Arm: {self.robot}, {self.base} to {self.tip}, {len(self.joints)} joints>"


@dataclasses.dataclass(frozen=True, eq=False)
class SelfMotion:
    """A set of postures of one pose: the tip stands while the joints move along it. Made by `Postures.motions`.

    Attributes
    ----------
    dimension : int
    q : ndarray of float, shape (joints,)
        One posture of it, whole turns as in `Postures.in_limits`.
    directions : ndarray of float, shape (joints, dimension)
        Unit columns: how the joints may move there.
    lost : ndarray of float, shape (6,)
        Unit: how the tip cannot move from there, its translation before its rotation.
    relations : list of (ndarray of float, shape (joints,), float)
        factors @ q = value holds on the whole set, turns modulo whole ones; none where it is curved.
    samples : ndarray of float, shape (samples, joints)
        Postures along it, whole turns as in `Postures.in_limits`: numpy.unwrap(samples, axis=0) has none between neighbours.
    closes : bool
        It comes back to its beginning.
    misfit : float
        The most that a sample misses the pose by: radians, and lengths beside the arm's.
    within_digits : bool
        It misses the pose by more than this is accurate, but by no more than the digits of the file leave open.
    """

    dimension: int
    q: np.ndarray
    directions: np.ndarray
    lost: np.ndarray
    relations: list
    samples: np.ndarray
    closes: bool
    misfit: float
    within_digits: bool
    _is_on: object = dataclasses.field(repr=False)

    def contains(self, q, within=None):
        """Whether joint values hold the pose and are on this set, as far as its samples show.

        Parameters
        ----------
        q : array_like of float, shape (joints,)
        within : float, optional
            By how much they may miss the pose, metres and radians. Default: as the pose is accurate (`pose_accuracy=` of `Arm.ik`).

        Returns
        -------
        bool
            True: forward kinematics meets the pose, and q is at the samples, or between two of them. A posture beside a curved
            set that holds the pose too, nearer than the samples are apart, is not told from it.

        Examples
        --------
        >>> import moivre
        >>> arm = moivre.Arm("problems/robots/puma560.urdf")
        >>> straight = [0.1, -0.5, 0.3, 0.4, 0, 0.6]
        >>> motion, *_ = [m for m in arm.ik(arm.fk(straight)).motions() if m.contains(straight)]
        >>> motion.contains([0.1, -0.5, 0.3, 0.9, 0, 0.1]), motion.contains([0.1, -0.5, 0.3, 0.9, 0, 0.2])
        (True, False)
        """
        return self._is_on(np.asarray(q, dtype=float).reshape(-1), 0.0 if within is None else float(within))

    def __repr__(self):
        return f"<moivre.SelfMotion of dimension {self.dimension}: {len(self.samples)} samples>"


@dataclasses.dataclass(frozen=True, eq=False)
class NearestPosture:
    """The posture that comes nearest to a pose that none holds. Made by `Postures.nearest_posture`.

    Attributes
    ----------
    q : ndarray of float, shape (joints,)
        Nearest of those that searches from random postures came to: where position, beside the arm's length, and rotation are
        least, the larger of both counts.
    position, rotation : float
        By how much it misses the pose: metres and radians.
    """

    q: np.ndarray
    position: float
    rotation: float

    def __repr__(self):
        return f"<moivre.NearestPosture: misses by {self.position:.2g} m and {self.rotation:.2g} rad>"


def _posture_array(name):
    """An attribute that is made when it is first asked for."""
    return functools.cached_property(lambda postures: getattr(postures._found, name)())


class Postures:
    """All joint values for N poses (N = 1 where one pose was given). Made by `Arm.ik`.

    Attributes
    ----------
    values : ndarray of float, shape (N, 16, joints)
        Turns in (-pi, pi], slides in metres; NaN behind the last posture of a pose.
    in_limits : ndarray of float, shape (N, 16, joints)
        The same with whole turns added where these bring a joint between its limits, nearest to `nearest=` where that was given.
    counts : ndarray of int, shape (N,)
    moves : ndarray of bool, shape (N,)
        The joints can move while the tip stands still; `motions(pose)` has the sets.
    decided : ndarray of bool, shape (N,)
        Every path of the pose was decided.
    residual : ndarray of float, shape (N, 16)
        By how much each posture misses the pose: radians, and lengths beside the arm's; NaN behind the last one, as below.
    within_digits : ndarray of bool, shape (N, 16)
        It misses by more than the pose is accurate, but by no more than the digits of the file leave open.
    moved_by_digits : ndarray of float, shape (N, 16)
        By how much half a unit of the file's last digits may move a joint.
    smallest_singular_value : ndarray of float, shape (N, 16)
        Of the Jacobian; 0 at a singular posture.
    distance : ndarray of float, shape (N, 16), or None
        The largest difference of a joint from `nearest=`, where that was given.
    complete : bool
        All poses are decided.
    """

    def __init__(self, found):
        self._found = found
        arrays = found.pose_arrays()
        self.counts = arrays["counts"]
        self.moves = arrays["moves"]
        self.decided = arrays["complete"]
        self.complete = bool(self.decided.all())

    values = _posture_array("values")
    in_limits = _posture_array("in_limits")
    residual = _posture_array("residual")
    moved_by_digits = _posture_array("moved_by_digits")
    smallest_singular_value = _posture_array("smallest_singular_value")
    distance = _posture_array("distance")

    @functools.cached_property
    def within_digits(self):
        return self._found.within_digits() == 1

    def __len__(self):
        return len(self.counts)

    def __getitem__(self, pose):
        """Joint values for one pose, shape (counts[pose], joints)."""
        pose = self._at(pose)
        return self.values[pose, :self.counts[pose]]

    def _at(self, pose):
        return place(self, pose, "pose")

    def names(self, pose=0):
        """What each posture is called, "shoulder right, elbow up, no flip"; empty where the arm has no such words."""
        return self._found.names(self._at(pose))

    def turns(self, pose=0):
        """Every choice of whole turns that the limits allow: for each posture an ndarray of shape (choices, joints).

        Raises
        ------
        ValueError
            The limits allow more choices than can be listed.
        """
        return self._found.turns(self._at(pose))

    def motions(self, pose=0):
        """The sets of postures along which the joints move while the tip stands in this pose: a list of `SelfMotion`."""
        pose = self._at(pose)
        return [SelfMotion(**each, _is_on=functools.partial(self._found.is_on_motion, pose, k))
                for k, each in enumerate(self._found.motions(pose))]

    def nearest_posture(self, pose=0):
        """The posture that comes nearest to a pose that none holds, a `NearestPosture`; None where one holds it."""
        found = self._found.nearest(self._at(pose))
        return None if found is None else NearestPosture(**found)

    def message(self, pose=0):
        """What is known of the pose, a sentence; why it is not decided, where it is not."""
        return self._found.message(self._at(pose))

    def to_json(self, path=None):
        """The JSON of `moivre closures ARM.urdf`."""
        return write(self._found.json(), path)

    def to_csv(self, path=None, angles="rad"):
        """A line for each posture, as text or into a file. angles: "rad" or "deg"."""
        return write(self._found.csv(in_degrees(angles)), path)

    def to_svg(self, path=None, three_views=False):
        """The postures of one pose side by side, as text or into a file. three_views: each from the front, right and above."""
        return write(self._found.svg(three_views), path)

    def to_html(self, path=None):
        """A page on which the mouse turns the postures of one pose."""
        return write(self._found.html(), path)

    def _repr_html_(self):
        return self.to_svg() if len(self) == 1 else None

    def __str__(self):
        return self._found.text()

    def __repr__(self):
        return (f"<moivre.Postures: {int(self.counts.sum())} of {len(self)} pose{'s' if len(self) != 1 else ''}"
                f"{'' if self.complete else ', not all decided'}>")
