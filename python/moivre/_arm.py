# SPDX-License-Identifier: MIT
# With which joint values does an arm hold its tip in a pose? All of them, for one pose or many.
"""Robot arms from URDF, or from Denavit-Hartenberg's numbers."""

import os

import numpy as np

from . import _moivre
from ._dh import dh_urdf
from ._errors import ParseError
from ._progress import told
from ._solve import chosen, write


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

    def ik(self, poses, *, tracker=None, start=None, seed=None, threads=None, tracker_options=None, progress=None):
        """All joint values that hold the tip in a pose.

        Parameters
        ----------
        poses : array_like of float, shape (4, 4) or (N, 4, 4)
            Homogeneous transforms, lengths in metres. A rotation rounded to six digits is made exactly one.
        tracker : {"cvode", "lanes"}, optional
            "lanes" is several times faster for many poses.

        Returns
        -------
        Postures
        """
        poses = np.asarray(poses, dtype=float)
        is_list = poses.ndim == 3
        if poses.ndim == 2:
            poses = poses[np.newaxis]
        options = chosen(tracker=tracker, start=start, seed=seed, threads=threads, tracker_options=tracker_options)
        with told(progress) as tell:
            return Postures(_moivre.arm_ik(self._arm, poses, is_list, options, tell))

    def __repr__(self):
        return f"<moivre.Arm: {self.robot}, {self.base} to {self.tip}, {len(self.joints)} joints>"


class Postures:
    """All joint values for N poses (N = 1 where one pose was given). Made by `Arm.ik`.

    Attributes
    ----------
    values : ndarray of float, shape (N, 16, joints)
        Turns in (-pi, pi], slides in metres; NaN behind the last posture of a pose.
    in_limits : ndarray of float, shape (N, 16, joints)
        The same with whole turns added where these bring a joint between its limits.
    counts : ndarray of int, shape (N,)
    moves : ndarray of bool, shape (N,)
        The joints can move while the tip stands still; one such posture is listed.
    decided : ndarray of bool, shape (N,)
        Every path of the pose was decided.
    complete : bool
        All poses are decided.
    """

    def __init__(self, found):
        self._found = found
        arrays = found.arrays()
        self.values = arrays["values"]
        self.in_limits = arrays["in_limits"]
        self.counts = arrays["counts"]
        self.moves = arrays["moves"]
        self.decided = arrays["complete"]
        self.complete = bool(self.decided.all())

    def __len__(self):
        return len(self.counts)

    def __getitem__(self, pose):
        """Joint values for one pose, shape (counts[pose], joints)."""
        pose = range(len(self))[pose]
        return self.values[pose, :self.counts[pose]]

    def names(self, pose=0):
        """What each posture is called, "shoulder right, elbow up, no flip"; empty where the arm has no such words."""
        return self._found.names(range(len(self))[pose])

    def to_json(self, path=None):
        """The JSON of `moivre closures ARM.urdf`."""
        return write(self._found.json(), path)

    def to_svg(self, path=None):
        """The postures of one pose side by side, as text or into a file."""
        return write(self._found.svg(), path)

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
