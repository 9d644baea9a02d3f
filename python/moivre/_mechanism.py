# SPDX-License-Identifier: MIT
# In how many ways can a mechanism be assembled, how does each move, and what changes with its dimensions?
"""Planar and spatial mechanisms."""

import dataclasses
import os
import types

import numpy as np

from . import _moivre
from ._progress import told
from ._solve import chosen, in_degrees, no_such, place, write
from ._toml import to_toml


class Body(types.SimpleNamespace):
    """Where a body stands: x, y, phi of a planar one; x, y, z, rx, ry, rz (a rotation vector) of a spatial one. Angles in radians."""


class _ByName(dict):
    """Points or bodies by their names."""

    def __init__(self, listed, *what):
        super().__init__(listed)
        self._what = what

    def __missing__(self, name):
        raise no_such(name, list(self), *self._what)


class _Named:
    """Values by the names of coordinates."""

    def __getitem__(self, name):
        try:
            return float(self.q[self.names.index(name)])
        except ValueError:
            raise no_such(name, self.names, "coordinate", "coordinates") from None


class _Told:
    """What the command line says of it, told once: text, JSON and a table."""

    def to_json(self, path=None):
        """The JSON of the command, as text or into a file."""
        return write(self._told["json"], path)

    def to_csv(self, path=None, angles="rad"):
        """The table of the command, as text or into a file. angles: "rad" or "deg"."""
        return write(self._told["csv_in_degrees" if in_degrees(angles) else "csv"], path)

    def __str__(self):
        return self._told["text"]


@dataclasses.dataclass(frozen=True, eq=False)
class Closure(_Named):
    """One way to assemble the mechanism.

    Attributes
    ----------
    id : str
        "A", "B", ...; the same for every seed, tracker and number of threads.
    q : ndarray of float, shape (n,)
        In the order of `names`; `closure["crank.phi"]` is one of them.
    bodies : dict of Body
        `closure.bodies["crank"].phi`; radians, and lengths in the file's unit.
    points : dict of ndarray
        `closure.points["crank.A"]`, in the ground's frame; shape (2,) of planar mechanisms, (3,) of spatial ones.
    certified : bool or None
        Proved to be a simple real root of the exact equations.
    singular : bool
    multiplicity : int
    residual : float
    misfit : float
        By how much it does not close, in the file's unit of length.
    fitted : bool
        It closes only within `fit=`.
    play : float or None
        With `fit=`, how far poses reach that are within it and hang together with this one, in radians or of the pose's size.
    drawn : bool
        It is the pose that was drawn.
    """

    id: str
    names: tuple
    q: np.ndarray
    bodies: dict
    points: dict
    certified: object
    singular: bool
    multiplicity: int
    residual: float
    misfit: float
    fitted: bool
    play: object
    drawn: bool

    def __repr__(self):
        return f"<moivre.Closure {self.id}{': certified' if self.certified else ''}>"


def _bodies(names, q):
    bodies = {}
    for name, value in zip(names, q):
        body, _, coordinate = name.rpartition(".")
        if body:
            setattr(bodies.setdefault(body, Body()), coordinate, float(value))
    return bodies


class _Reported:
    """What every result of a mechanism can write."""

    def to_json(self, path=None):
        """The JSON of the command line (docs/json.md), as text or into a file."""
        return write(self._found.json(), path)

    def to_html(self, path=None):
        """A page for a browser, as text or into a file."""
        return write(self._found.html(), path)

    def to_svg(self, path=None):
        """The picture of the command line, as text or into a file."""
        return write(self._found.svg(), path)

    @property
    def svg(self):
        """The picture of the command line, an SVG document."""
        return self.to_svg()

    def _repr_html_(self):
        return self.to_svg()

    def __str__(self):
        return self._found.text()


class Closures(_Reported):
    """All closures of a mechanism at one time of its drivers. Made by `Mechanism.closures`.

    `len(c)`, `c[k]`, `c["A"]` and iteration give `Closure`s, the real ones within the joints' limits.

    Attributes
    ----------
    complete : bool
        Every path was decided.
    completeness : str or None
        "proved": there is no other closure; "shown"; "open".
    counts : dict
        complex, real, filtered (outside limits), rejected, fitted.
    moves : bool
        Closures form a set: with the drivers held, something moves.
    q : ndarray of float, shape (closures, n)
    ids : list of str
        "A", "B", ...
    names : list of str
        Of the coordinates.
    time : float
        Of the drivers, seconds.
    message : str
        What is known, a sentence.
    paths : dict
        tracked = finite + at_infinity + failed.
    svg : str
        The picture of the command line.

    Examples
    --------
    >>> import moivre
    >>> c = moivre.Mechanism("problems/mechanisms/four-bar.toml").closures()
    >>> c
    <moivre.Closures: 2 real of 2 complex, proved complete>
    >>> round(c[0].bodies["crank"].phi, 6), c[0].points["crank.A"].round(3), c[0].certified
    (0.698132, array([30.642, 25.712]), True)
    """

    def __init__(self, found, mechanism):
        self._found = found
        self._mechanism = mechanism
        arrays = found.arrays()
        self._arrays = arrays
        self.complete = found.complete
        self.completeness = found.completeness
        self.message = found.message
        self.counts = found.counts
        self.paths = found.paths
        self.moves = found.moves
        self.time = found.time
        self.names = mechanism.coordinates
        self.q = arrays["q"]
        self.ids = arrays["ids"]

    def __len__(self):
        return len(self.ids)

    def __getitem__(self, index):
        if isinstance(index, str):
            if index not in self.ids:
                raise KeyError(f"there is no closure {index}; there are {', '.join(self.ids) or 'none'}")
            index = self.ids.index(index)
        if isinstance(index, slice):
            return [self[k] for k in range(*index.indices(len(self)))]
        k = place(self, index, "closure")
        core = self._mechanism._core
        places = core.points_at(self.q[k])
        wide = 3 if core.is_spatial else 2
        points = _ByName({name: place[:wide] for name, place in zip(core.points, places)}, "point", "points")
        bodies = _ByName({} if core.is_typed else _bodies(self.names, self.q[k]), "body", "bodies")
        return Closure(self.ids[k], tuple(self.names), self.q[k], bodies, points, self._arrays["certified"][k],
                       bool(self._arrays["singular"][k]), int(self._arrays["multiplicity"][k]),
                       float(self._arrays["residual"][k]), float(self._arrays["misfit"][k]),
                       bool(self._arrays["fitted"][k]), self._arrays["play"][k], bool(self._arrays["drawn"][k]))

    def __iter__(self):
        return (self[k] for k in range(len(self)))

    def to_csv(self, path=None, angles="rad"):
        """A line a closure, as text or into a file. angles: "rad" or "deg"."""
        return write(self._found.csv(angles), path)

    def to_svg(self, path=None, three_views=False):
        """All closures to one scale, as text or into a file. three_views: a spatial one from the front, right and above."""
        return write(self._found.svg(three_views), path)

    def sensitivity(self):
        """How far each closure moves with every dimension; see `Mechanism.sensitivity`."""
        return Sensitivity(self._found.sensitivity())

    def guesses(self):
        """The closures as initial guesses for a solver of your own; see `Mechanism.guesses`."""
        return Guesses(self._found.guesses())

    def __repr__(self):
        told_ = {"proved": ", proved complete"}.get(self.completeness, "") if self.complete else ", not complete"
        moves = ", moves" if self.moves else ""
        return f"<moivre.Closures: {self.counts['real']} real of {self.counts['complex']} complex{moves}{told_}>"


@dataclasses.dataclass(frozen=True, eq=False)
class Event:
    """Where branches end or begin.

    Attributes
    ----------
    kind : str
        "dead point", "bifurcation" or "joint limit".
    t : float
        Seconds.
    q : ndarray of float, shape (n,)
    drivers : list of float
        Their values there.
    ending, beginning : list of str
        Ids of branches.
    """

    kind: str
    t: float
    q: np.ndarray
    drivers: list
    ending: list
    beginning: list


@dataclasses.dataclass(frozen=True, eq=False)
class Branch:
    """One closure followed along the drivers.

    Attributes
    ----------
    id : str
    t : ndarray of float, shape (k,)
        Seconds: the times begin + i (end - begin) / steps of the motion that lie between `begins` and `ends`. Where a branch ends
        between two of them, `ends` is behind the last t, and `event` has the place: `event.t`, `event.q`.
    q, velocity, acceleration : ndarray of float, shape (k, n)
        Angles in radians, going on past half a turn; NaN where the velocity is not unique.
    begins, ends : float
        Seconds, exact to rounding; not samples unless they happen to be times of t.
    begin_event, event : Event or None
        Where it begins and ends; None at the ends of the motion.
    complete : bool
    message : str
        How it ended.
    """

    id: str
    t: np.ndarray
    q: np.ndarray
    velocity: np.ndarray
    acceleration: np.ndarray
    begins: float
    ends: float
    begin_event: object
    event: object
    complete: bool
    message: str

    def __repr__(self):
        return f"<moivre.Branch {self.id}: t = {self.begins:.6g} ... {self.ends:.6g}, {len(self.t)} samples>"


class Motion(_Reported):
    """Every closure followed along the drivers. Made by `Mechanism.motion`.

    Attributes
    ----------
    complete : bool
        Every branch was followed to an event or to the end, and the checkpoints agree.
    message : str
        What is known, a sentence.
    branches : list of Branch
    events : list of Event
    names : list of str
        Of the coordinates.
    failures : list of str
    svg : str
        The picture of the command line.

    Examples
    --------
    >>> import moivre
    >>> m = moivre.Mechanism("problems/mechanisms/four-bar.toml").motion(steps=8)
    >>> m.complete, [b.id for b in m.branches], m.branches[0].q.shape
    (True, ['A', 'B'], (9, 9))
    """

    def __init__(self, found, mechanism):
        self._found = found
        self.complete = found.complete
        self.message = found.message
        self.failures = found.failures
        self.names = mechanism.coordinates
        self.events = [Event(**event) for event in found.events()]
        self.branches = []
        for k in range(found.branches):
            arrays = found.branch(k)
            begin, end = arrays.pop("begin_event"), arrays.pop("end_event")
            self.branches.append(Branch(begin_event=None if begin is None else self.events[begin],
                                        event=None if end is None else self.events[end], **arrays))

    def to_json(self, path=None, continuous=False):
        """The JSON of `moivre motion`. continuous: angles go on beyond half a turn along a branch, as in `Branch.q`."""
        return write(self._found.json(continuous), path)

    def to_csv(self, path=None, angles="rad", continuous=False):
        """A line a sample, as text or into a file. angles: "rad" or "deg"; continuous as for `to_json`."""
        return write(self._found.csv(angles, continuous), path)

    def __len__(self):
        return len(self.branches)

    def __repr__(self):
        return (f"<moivre.Motion: {len(self.branches)} branches, {len(self.events)} events"
                f"{'' if self.complete else ', not complete'}>")


class Sweep(_Reported):
    """Closures counted while one or two dimensions vary. Made by `Mechanism.sweep`.

    Attributes
    ----------
    names : list of str
        What varies.
    at : ndarray of float, shape (samples, names)
    real, usable, complex : ndarray of int, shape (samples,)
        Closures: real ones, those within limits, and all isolated ones.
    moves, decided : ndarray of bool, shape (samples,)
    borders : ndarray of float, shape (borders, names)
        Where the counts change.
    shape : tuple of int
        `s.real.reshape(s.shape)` is the grid.
    complete : bool
        All samples are decided.
    svg : str
        The picture of the command line.

    Examples
    --------
    >>> import moivre
    >>> m = moivre.Mechanism("problems/mechanisms/four-bar.toml")
    >>> s = m.sweep({"coupler.B.x": (100, 200, 6)})
    >>> s.real
    array([2, 2, 2, 0, 0, 0])
    >>> s.borders.round(3)
    array([[153.971]])
    """

    def __init__(self, found, names, shape):
        self._found = found
        arrays = found.arrays()
        self.names = names
        self.shape = shape
        self.at = arrays["at"]
        self.real = arrays["real"]
        self.usable = arrays["usable"]
        self.complex = arrays["complex"]
        self.moves = arrays["moves"]
        self.decided = arrays["complete"]
        self.borders = arrays["borders"]
        self.complete = found.complete

    def to_csv(self, path=None):
        """A line a sample, as text or into a file."""
        return write(self._found.csv(), path)

    def __len__(self):
        return len(self.at)

    def __repr__(self):
        return (f"<moivre.Sweep: {len(self)} samples over {', '.join(self.names)}, {len(self.borders)} borders"
                f"{'' if self.complete else ', not all decided'}>")


@dataclasses.dataclass(frozen=True, eq=False)
class ClosureSensitivity:
    """How far one closure moves with the dimensions.

    Attributes
    ----------
    id : str
    rates : ndarray of float, shape (quantities, dimensions)
        Derivatives; NaN where there is none.
    worst_case, root_sum_square : ndarray of float, shape (quantities,)
        Within the tolerances.
    missing : str
        Why there are no rates; empty where there are.
    """

    id: str
    missing: str
    rates: np.ndarray
    worst_case: np.ndarray
    root_sum_square: np.ndarray


class Sensitivity(_Told):
    """Sensitivities of all closures, of `moivre closures --sensitivity`. Made by `Mechanism.sensitivity`; `s[k]` is a `ClosureSensitivity`.

    Attributes
    ----------
    dimensions, quantities : list of str
        Columns and rows of the rates.
    values, tolerances : ndarray of float, shape (dimensions,)

    Examples
    --------
    >>> import moivre
    >>> s = moivre.Mechanism("problems/mechanisms/four-bar.toml").sensitivity(tolerance=0.05)
    >>> round(s.rate("crank.A.x", "crank.A.x"), 6)
    0.766044
    """

    def __init__(self, told_):
        self.dimensions = told_["dimensions"]
        self.quantities = told_["quantities"]
        self.values = told_["values"]
        self.tolerances = told_["tolerances"]
        self._closures = [ClosureSensitivity(**each) for each in told_["closures"]]
        self._told = told_

    def __len__(self):
        return len(self._closures)

    def __getitem__(self, index):
        if isinstance(index, slice):
            return self._closures[index]
        return self._closures[place(self, index, "closure")]

    def rate(self, quantity, dimension, closure=0):
        """d quantity / d dimension at one closure."""
        for name, names, what in ((quantity, self.quantities, ("quantity", "quantities")),
                                  (dimension, self.dimensions, ("dimension", "dimensions"))):
            if name not in names:
                raise no_such(name, names, *what)
        rates = self[closure].rates
        return float(rates[self.quantities.index(quantity), self.dimensions.index(dimension)])

    def __repr__(self):
        return (f"<moivre.Sensitivity: {len(self)} closures, {len(self.quantities)} quantities by "
                f"{len(self.dimensions)} dimensions>")


class Guesses(_Told):
    """Every closure as an initial guess, of `moivre guesses`. Made by `Mechanism.guesses`.

    Attributes
    ----------
    names : list of str
    ids : list of str
    q : ndarray of float, shape (guesses, names)
        Radians, and lengths in the file's unit.

    Examples
    --------
    >>> import moivre
    >>> g = moivre.Mechanism("problems/mechanisms/four-bar.toml").guesses()
    >>> g.names[:3], g.q.shape
    (['crank.x', 'crank.y', 'crank.phi'], (2, 9))
    """

    def __init__(self, told_):
        self.names = told_["names"]
        self.ids = told_["ids"]
        self.q = told_["q"]
        self._told = told_

    def __len__(self):
        return len(self.ids)

    def __repr__(self):
        return f"<moivre.Guesses: {len(self)} of {len(self.names)} coordinates>"


@dataclasses.dataclass(frozen=True, eq=False)
class Mobility:
    """How freely a mechanism moves. Made by `Mechanism.mobility`.

    Attributes
    ----------
    degrees_of_freedom : int
        Coordinates minus the rank of the constraints; `gruebler` counts equations instead.
    driven_freedoms : int
        Left with the drivers held.
    redundant : list of str
        Constraints that say nothing new, "Phi5 = Phi1 - Phi3" by their names.
    is_singular, is_assembled : bool
    q : ndarray of float, shape (n,)
        The pose.
    null_space : ndarray of float, shape (n, degrees_of_freedom)
    json, text : str
        What `moivre mobility` writes.

    Examples
    --------
    >>> import moivre
    >>> m = moivre.Mechanism("problems/mechanisms/four-bar.toml").mobility()
    >>> m.degrees_of_freedom, m.driven_freedoms, m.redundant
    (1, 0, [])
    """

    degrees_of_freedom: int
    gruebler: int
    driven_freedoms: int
    rank: int
    redundant: list
    is_singular: bool
    is_assembled: bool
    q: np.ndarray
    null_space: np.ndarray
    json: str
    text: str

    def to_json(self, path=None):
        """The JSON of `moivre mobility`."""
        return write(self.json, path)

    def __str__(self):
        return self.text

    def __repr__(self):
        return (f"<moivre.Mobility: {self.degrees_of_freedom} degrees of freedom, {len(self.redundant)} redundant "
                f"constraints>")


@dataclasses.dataclass(frozen=True, eq=False)
class Newton:
    """One run of Newton-Raphson. Made by `Mechanism.newton`.

    Attributes
    ----------
    converged : bool
    status : str
        "converged", "diverged", "cycling", "singular", "no_solution" or "iteration_limit".
    message : str
    q : ndarray of float, shape (n,)
        Where it ended; angles in (-pi, pi], as those of closures.
    iterates : ndarray of float, shape (iterations + 1, n)
        The guess first, angles as the run has them: a long step turns a body more than once.
    residuals : ndarray of float, shape (iterations + 1,)
        The largest constraint's.
    rank : int
        Of the constraints' Jacobian at q.
    is_singular : bool
    condition : float
    json, text : str
        What `moivre newton` writes.
    """

    converged: bool
    status: str
    message: str
    q: np.ndarray
    iterates: np.ndarray
    residuals: np.ndarray
    rank: int
    is_singular: bool
    condition: float
    json: str
    text: str

    def __len__(self):
        return len(self.iterates)

    def to_json(self, path=None):
        """The JSON of `moivre newton`."""
        return write(self.json, path)

    def __str__(self):
        return self.text

    def __repr__(self):
        return f"<moivre.Newton: {self.status}, {len(self) - 1} iterations>"


def _values(argument, given):
    """[(coordinate, value)] of a dictionary; None stays None."""
    if given is None:
        return None
    if not hasattr(given, "items"):
        raise ValueError(f"{argument}: a dictionary is wanted, such as {{'crank.phi': 40}}")
    return [(str(name), float(value)) for name, value in given.items()]


class Mechanism:
    """A planar or spatial mechanism, or typed constraint equations.

    Parameters
    ----------
    source : path or dict
        A mechanism file (docs/mechanism-file.md), or a dictionary with the same keys.

    Attributes
    ----------
    title : str
    coordinates : list of str
        "crank.x", "crank.y", "crank.phi", ...
    points : list of str
        "crank.A", ... of the moving bodies.
    dimensions : list of str
        What `sweep` may vary.
    warnings : list of str

    Examples
    --------
    >>> import moivre
    >>> rocker = moivre.Mechanism({
    ...     "ground": {"points": {"A": [0, 0], "D": [90, 10]}},
    ...     "body": {"crank": {"points": {"A": [0, 0], "B": [30, 0]}},
    ...              "coupler": {"points": {"B": [0, 0], "C": [80, 0]}},
    ...              "rocker": {"points": {"D": [0, 0], "C": [60, 0]}}},
    ...     "joint": [{"type": "revolute", "at": at} for at in (
    ...         ["ground.A", "crank.A"], ["crank.B", "coupler.B"], ["coupler.C", "rocker.C"], ["ground.D", "rocker.D"])],
    ...     "driver": [{"angle": "crank", "start": 1.0, "velocity": 6.0}]})
    >>> len(rocker.closures())
    2
    """

    def __init__(self, source):
        if isinstance(source, dict):
            self._take(_moivre.mechanism_in_code(to_toml(source)))
        else:
            self._take(_moivre.mechanism_of_file(os.fspath(source)))

    def _take(self, core):
        self._core = core
        self.title = self._core.title
        self.coordinates = self._core.coordinates
        self.points = self._core.points
        self.dimensions = self._core.dimensions
        self.warnings = self._core.warnings

    @classmethod
    def from_robot(cls, path, *, loops=None, hold=None, tip=None, pose=None):
        """A robot (URDF) as a mechanism, whose loops a side file may close (docs/robots.md).

        Parameters
        ----------
        path : path or text
            A URDF file, or its text.
        loops : path, optional
            The side file: points of links, joints and drivers.
        hold : dict, optional
            Joints that stand, radians or metres.
        tip : str, optional
            The link that takes `pose`. Default: the leaf where there is one alone.
        pose : array_like of float, shape (4, 4), optional
            Of the tip in the root's frame, metres.

        Returns
        -------
        Mechanism

        Examples
        --------
        >>> import moivre
        >>> m = moivre.Mechanism.from_robot("problems/robots/palletizer.urdf", loops="problems/robots/palletizer.loops.toml")
        >>> len(m.closures())
        8
        """
        if tip is not None and pose is None:
            raise ValueError("tip: needs pose, which says where it is to be")
        held = [(str(joint), float(value)) for joint, value in (hold or {}).items()]
        if pose is not None:
            pose = np.asarray(pose, dtype=float)
            if pose.shape != (4, 4):
                raise ValueError("pose: an array of shape (4, 4) is wanted")
        is_text = isinstance(path, str) and path.lstrip().startswith("<")
        make = _moivre.mechanism_of_robot_text if is_text else _moivre.mechanism_of_robot_file
        made = cls.__new__(cls)
        made._take(make(path if is_text else os.fspath(path), tip, held, pose, None if loops is None else os.fspath(loops)))
        return made

    def point_position(self, point, q):
        """Where a point is, in the ground's frame.

        Parameters
        ----------
        point : str
            "coupler.P", or "ground.A".
        q : array_like of float, shape (n,) or (k, n)
            In the order of `coordinates`: of a closure, a branch, a Newton run.

        Returns
        -------
        ndarray of float, shape (2,) or (k, 2); of a spatial mechanism (3,) or (k, 3)

        Examples
        --------
        >>> import moivre
        >>> m = moivre.Mechanism("problems/mechanisms/four-bar.toml")
        >>> m.point_position("crank.A", m.closures()[0].q).round(3)
        array([30.642, 25.712])
        >>> m.point_position("coupler.P", m.motion(steps=8).branches[0].q).shape
        (9, 2)
        """
        q = np.asarray(q, dtype=float)
        if q.ndim not in (1, 2) or q.shape[-1] != len(self.coordinates):
            raise ValueError(f"q: an array of shape ({len(self.coordinates)},) or (k, {len(self.coordinates)}) is wanted, not {q.shape}")
        places = self._core.point_position(str(point), np.atleast_2d(q))
        return places[0] if q.ndim == 1 else places

    def closures(self, *, at=None, fit=None, meshings=None, tolerance=None, tracker=None, start=None, seed=None, threads=None,
                 time_limit=None, certify=None, tracker_options=None, progress=None):
        """Every way to assemble the mechanism.

        Parameters
        ----------
        at : float, optional
            Time of the drivers, seconds.
        fit : float, optional
            Accept closures that miss by no more than this length; for lengths that were rounded.
        meshings : bool, optional
            Closures in every meshing of the gears.
        tolerance : float, optional
            Of dimensions, for `Closures.sensitivity`.
        tracker, start, seed, threads, time_limit, certify, tracker_options, progress
            As for `solve`.

        Returns
        -------
        Closures
        """
        options = chosen(at=at, fit=fit, meshings=meshings, tolerance=tolerance, tracker=tracker, start=start, seed=seed,
                         threads=threads, time_limit=time_limit, certify=certify, tracker_options=tracker_options)
        with told(progress) as tell:
            return Closures(self._core.closures(options, tell), self)

    def motion(self, *, begin=None, end=None, steps=None, checkpoints=None, guess=None, from_guess=None, closure=None, fit=None,
               meshings=None, tracker=None, start=None, seed=None, threads=None, time_limit=None, certify=None,
               tracker_options=None, progress=None):
        """Every closure followed along the drivers.

        Parameters
        ----------
        begin, end : float, optional
            Seconds. Default: from 0, for one turn of the first driver.
        steps : int, optional
            Samples at begin + k (end - begin) / steps.
        checkpoints : int, optional
            How often closures are solved again and compared.
        guess : dict, optional
            `{"crank.phi": 40}`, angles in the file's unit: change these values of the file's guess, and follow only the pose
            that Newton-Raphson assembles from it. No closures are solved.
        from_guess : bool, optional
            Follow only the pose assembled from the file's guess.
        closure : str or list of str, optional
            Show only the branches that can be reached from these closures without taking the mechanism apart: "A", "B", ...
            at the start of the motion, or "drawn"; of independent sub-chains also "E.H" or "1:E".
        fit, meshings
            As for `closures`.
        tracker, start, seed, threads, time_limit, certify, tracker_options, progress
            As for `solve`.

        Returns
        -------
        Motion
        """
        closure = [closure] if isinstance(closure, str) else closure
        options = chosen(guess=_values("guess", guess), from_guess=from_guess, fit=fit, meshings=meshings, steps=steps,
                         checkpoints=checkpoints, closure=None if closure is None else [str(name) for name in closure],
                         tracker=tracker, start=start, seed=seed, threads=threads, time_limit=time_limit, certify=certify,
                         tracker_options=tracker_options)
        options.update({name: value for name, value in (("from", begin), ("to", end)) if value is not None})
        with told(progress) as tell:
            return Motion(self._core.motion(options, tell), self)

    def sweep(self, vary, *, at=None, fit=None, meshings=None, borders=None, tracker=None, start=None, seed=None, threads=None,
              time_limit=None, tracker_options=None, progress=None):
        """Closures counted while one or two dimensions vary.

        Parameters
        ----------
        vary : dict
            `{"crank.A.x": (from, to, count)}`, one or two names of `dimensions`; values in the file's units.
        borders : bool, optional
            False: do not locate where the counts change.
        at, fit, meshings
            As for `closures`.
        tracker, start, seed, threads, time_limit, tracker_options, progress
            As for `solve`.

        Returns
        -------
        Sweep
        """
        ranges = []
        for name, given in vary.items():
            if len(given) != 3 or int(given[2]) != given[2] or given[2] < 2:
                raise ValueError(f"{name}: (from, to, count) is wanted, count whole and at least 2")
            ranges.append((str(name), float(given[0]), float(given[1]), int(given[2])))
        options = chosen(at=at, fit=fit, meshings=meshings, borders=borders, tracker=tracker, start=start, seed=seed,
                         threads=threads, time_limit=time_limit, tracker_options=tracker_options)
        with told(progress) as tell:
            found = self._core.sweep(ranges, options, tell)
        return Sweep(found, [name for name, *_ in ranges], tuple(count for *_, count in ranges))

    def sensitivity(self, tolerance=None, *, at=None, **options):
        """How far each closure moves with every dimension, and within the tolerances.

        Parameters
        ----------
        tolerance : float, optional
            Of point coordinates and rod lengths, in the file's unit; more specific ones in the file come first.
        at : float, optional
            Time of the drivers.
        **options
            As for `closures`.

        Returns
        -------
        Sensitivity
        """
        return self.closures(at=at, tolerance=tolerance, **options).sensitivity()

    def guesses(self, *, at=None, **options):
        """Every closure as an initial guess for a Newton solve of your own; options as for `closures`."""
        return self.closures(at=at, **options).guesses()

    def mobility(self, *, at=None, guess=None, fit=None, meshings=None, time_limit=None):
        """Degrees of freedom and redundant constraints at the closures, or at the pose found from the file's guess.

        Parameters
        ----------
        at : float, optional
            Time of the drivers, seconds.
        guess : dict, optional
            `{"rocker.phi": -98}`, angles in the file's unit: look at the pose that Newton-Raphson assembles from there.
        fit, meshings
            As for `closures`.
        time_limit : float, optional
            Seconds.

        Returns
        -------
        Mobility
        """
        return Mobility(**self._core.mobility(chosen(at=at, guess=_values("guess", guess), fit=fit, meshings=meshings,
                                                     time_limit=time_limit)))

    def newton(self, *, at=None, guess=None, weight=None, tolerance=None, max_iterations=None):
        """One run of Newton-Raphson from a guess, iteration by iteration: it finds one pose, and says nothing of others.

        Parameters
        ----------
        at : float, optional
            Time of the drivers, seconds.
        guess : dict, optional
            `{"rocker.phi": -98}`, angles in the file's unit; other coordinates start from the file's guess.
        weight : dict, optional
            Of coordinates in steps of least norm, where constraints are too few.
        tolerance : float, optional
            On each constraint, relative to the sum of the magnitudes of its terms.
        max_iterations : int, optional

        Returns
        -------
        Newton

        Examples
        --------
        >>> import moivre
        >>> run = moivre.Mechanism("problems/mechanisms/four-bar.toml").newton(guess={"coupler.phi": -60, "rocker.phi": -90})
        >>> run.converged, len(run) == len(run.residuals)
        (True, True)
        """
        return Newton(**self._core.newton(chosen(at=at, guess=_values("guess", guess), weight=_values("weight", weight),
                                                 tolerance=tolerance, max_iterations=max_iterations)))

    def __repr__(self):
        return f"<moivre.Mechanism: {self.title or 'untitled'}, {len(self.coordinates)} coordinates>"
