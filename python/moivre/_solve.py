# SPDX-License-Identifier: MIT
# What are all isolated roots of a system? solve(), its result as arrays and as a list of roots, and every report of it.
"""Polynomial systems."""

import dataclasses
import html
import math

import numpy as np

from . import _moivre
from ._kept import kept
from ._progress import told
from ._systems import _exact, conditions_of, to_system


def chosen(**options):
    """The options that were given: the library has the defaults."""
    return {name: value for name, value in options.items() if value is not None}


def in_degrees(angles):
    """Whether angles="deg" was given."""
    if angles not in ("rad", "deg"):
        raise ValueError(f'angles: "rad" or "deg" is wanted, {angles!r} is given')
    return angles == "deg"


def place(listed, index, what):
    """The index from 0; one that is beyond is refused by what is listed."""
    try:
        return range(len(listed))[index]
    except IndexError:
        there = f"{len(listed)}, counted from 0" if len(listed) else "none"
        raise IndexError(f"there is no {what} {index}: there are {there}") from None
    except TypeError:
        raise TypeError(f"a {what} is asked for by its number, not by {index!r}") from None


def no_such(name, known, what, several):
    """What a KeyError says of a name that is not there: the one that was meant, or those that are."""
    from difflib import get_close_matches
    near = get_close_matches(str(name), known, 1)
    there = f"did you mean '{near[0]}'?" if near else f"the {several} are {', '.join(known) or 'none'}"
    return KeyError(f"there is no {what} {name}; {there}")


def write(text, path):
    """Returns the text, or writes it to a file."""
    if path is None:
        return text
    with open(path, "w", encoding="utf-8", newline="") as file:
        file.write(text)
    return None


@dataclasses.dataclass(frozen=True, eq=False)
class Root:
    """One isolated root.

    Attributes
    ----------
    x : ndarray of complex, shape (unknowns,)
    variables : tuple of str
        Names of the unknowns; `root["y"]` is the value of y.
    real, singular : bool
    multiplicity : int
    accuracy : float
        The root lies within accuracy * max(1, largest abs(x)) of x; proved where `certified`.
    residual, condition : float
    certified : bool or None
        A root of the exact system is proved to be there; None where this was not asked for or is not possible.
    on_boundary : list of str
        Conditions that its digits do not tell from equalities there.

    Examples
    --------
    >>> import moivre
    >>> root = moivre.solve("x^2 - 2; x*y - 1")[0]
    >>> root.certified, root.multiplicity, round(float(abs(root["x"])), 6)
    (True, 1, 1.414214)
    """

    x: np.ndarray
    variables: tuple
    real: bool
    singular: bool
    multiplicity: int
    accuracy: float
    residual: float
    condition: float
    certified: object
    on_boundary: list

    def __getitem__(self, variable):
        try:
            value = self.x[self.variables.index(str(variable))]
        except ValueError:
            raise no_such(variable, self.variables, "unknown", "unknowns") from None
        return value.real if self.real else value

    def keys(self):
        """The unknowns, so that dict(root) has the value of each."""
        return self.variables

    def __repr__(self):
        values = ", ".join(f"{name} = {_short(value)}" for name, value in zip(self.variables, self.x))
        return f"<moivre.Root: {values}{', certified' if self.certified else ''}>"


def _short(value):
    return f"{value.real:.10g}" if value.imag == 0 else f"{value:.10g}"


class Result:
    """All isolated roots of a system, and what is known of their number. Made by `solve`.

    `len(r)`, `r[k]` and iteration give `Root`s; print() shows the text of the command line, a notebook a table.

    Attributes
    ----------
    complete : bool
        Every path was decided. Whether a root can be missing, `completeness` tells.
    completeness : str or None
        "proved": there is no other root; "shown": every path was decided and every regular root is certified; "open": neither.
        None where it was not asked for, or there are more equations than unknowns.
    message : str
    variables : list of str
    paths : dict
        tracked = finite + at_infinity + failed.
    filtered : int
        Roots, with multiplicity, that `real=`, `positive=`, `nonzero=`, `box=` or conditions leave out.
    cross_check : dict or None
        What the other tracker says, where that was asked for: witness, common, missed, unwitnessed, disagreements.
    points : ndarray of complex, shape (roots, unknowns)
    real_points : ndarray of float, shape (real roots, unknowns)
    set_points : ndarray of complex, shape (points, unknowns)
        Of sets of positive dimension, where paths end. Their number means nothing.
    planes : list of dict
        Coordinate planes on which every equation is zero: "zero", the unknowns that are 0 there, and "dimension".
    real, singular : ndarray of bool, shape (roots,)
    multiplicity : ndarray of int, shape (roots,)
    accuracy, residual, condition : ndarray of float, shape (roots,)
    certified : list of (bool or None)

    Examples
    --------
    >>> import moivre
    >>> r = moivre.solve(["x^2 + y^2 - 4", "x*y - 1"])
    >>> r.complete, r.completeness, r.points.shape
    (True, 'proved', (4, 2))
    """

    def __init__(self, solved, name):
        self._solved = solved
        self._name = name
        roots = solved.roots()
        self.complete = solved.complete
        self.completeness = solved.completeness
        self.message = solved.message
        self.variables = solved.variables
        self.paths = solved.paths
        self.filtered = solved.filtered
        self.cross_check = solved.cross_check
        self.points = roots["points"]
        self.set_points = solved.set_points()
        self.planes = solved.planes()
        self.real = roots["real"]
        self.singular = roots["singular"]
        self.multiplicity = roots["multiplicity"]
        self.accuracy = roots["accuracy"]
        self.residual = roots["residual"]
        self.condition = roots["condition"]
        self.certified = roots["certified"]
        self._digits = roots["digits"]
        self._on_boundary = roots["on_boundary"]

    @property
    def real_points(self):
        return self.points[self.real].real

    def __len__(self):
        return len(self.points)

    def __getitem__(self, index):
        if isinstance(index, slice):
            return [self[k] for k in range(*index.indices(len(self)))]
        k = place(self, index, "root")
        return Root(self.points[k], tuple(self.variables), bool(self.real[k]), bool(self.singular[k]),
                    int(self.multiplicity[k]), float(self.accuracy[k]), float(self.residual[k]), float(self.condition[k]),
                    self.certified[k], self._on_boundary[k])

    def __iter__(self):
        return (self[k] for k in range(len(self)))

    def digits(self, digits, progress=None, time_limit=None):
        """Every root to so many significant digits, by Newton's method with a proved bound.

        Parameters
        ----------
        digits : int
            From 1 to 1000.
        progress, time_limit
            As for `solve`.

        Returns
        -------
        list of (list or None)
            For each root its coordinates: mpmath's numbers where mpmath is there, else pairs of texts (re, im). None at a
            singular root, and where the digits cannot be guaranteed.

        Examples
        --------
        >>> import moivre
        >>> r = moivre.solve("x^2 - 2")
        >>> sorted(str(x.real) for x, in r.digits(30))
        ['-1.41421356237309504880168872421', '1.41421356237309504880168872421']
        """
        with told(progress) as tell:
            found = self._solved.with_digits(digits, chosen(time_limit=time_limit), tell).roots()["digits"]
        try:
            import mpmath
        except ImportError:
            return [root or None for root in found]
        context = mpmath.mp.clone()
        context.dps = digits
        return [[context.mpc(re, im) for re, im in root] if root else None for root in found]

    def to_json(self, path=None):
        """The JSON of `moivre solve` (docs/json.md), as text or into a file."""
        return write(self._solved.json(self._name), path)

    def to_csv(self, path=None):
        """A line a root, as text or into a file."""
        return write(self._solved.csv(), path)

    def to_paths_csv(self, path=None):
        """A line a path: where it ended and what it took, as text or into a file."""
        return write(self._solved.paths_csv(), path)

    def to_phc(self, path=None):
        """PHCpack's solution list, as text or into a file."""
        return write(self._solved.phc(), path)

    def to_text(self, all=False):
        """The text of the command line; all: with the roots that are not real."""
        return self._solved.text(self._name, all)

    def __str__(self):
        return self.to_text()

    def __repr__(self):
        real = int(np.count_nonzero(self.real))
        return (f"<moivre.Result: {len(self)} roots in {', '.join(self.variables)}, {real} of them real, "
                f"{_standing(self)}>")

    def _repr_html_(self):
        head = "".join(f"<th>{html.escape(v)}</th>" for v in self.variables)
        rows = "".join(
            f"<tr><td>{k}</td>{''.join(f'<td>{_short(x)}</td>' for x in self.points[k])}<td>{self.multiplicity[k]}</td>"
            f"<td>{self.accuracy[k]:.1e}</td><td>{_word(self.certified[k])}</td></tr>" for k in range(len(self)))
        return (f"<p>{html.escape(repr(self)[9:-1])}</p><table><tr><th></th>{head}<th>multiplicity</th><th>accuracy</th>"
                f"<th>certified</th></tr>{rows}</table>")


def _word(certified):
    return {True: "yes", False: "no", None: ""}[certified]


def _standing(result):
    if not result.complete:
        return f"not complete ({result.message})"
    if result.completeness == "proved":
        return "proved complete"
    if result.completeness == "shown":
        return "every path decided, regular roots certified"
    return "every path decided"


def _box(box):
    """[(name, from, to)] of a dictionary of ranges."""
    if not hasattr(box, "items"):
        raise ValueError("box: a dictionary of ranges is wanted, such as {'x': (0, 1)}")
    ranges = []
    for name, given in box.items():
        given = list(given) if hasattr(given, "__iter__") else [given]
        if len(given) != 2:
            raise ValueError(f"box: {name}: (from, to) is wanted; None leaves a side open")
        low, high = (math.inf * sign if side is None else float(side) for side, sign in zip(given, (-1, 1)))
        ranges.append((str(name), low, high))
    return ranges


def _value(value, what):
    """(re, im) as exact texts; "1/3" is a number too."""
    if isinstance(value, str):
        import fractions
        try:
            value = fractions.Fraction(value)
        except (ValueError, ZeroDivisionError):
            raise ValueError(f"{what}: {value!r} is no number") from None
    return _exact(value, what)[0]


def _ways(parameters, start_points):
    """Names, values at the start and at the end, and the start points as rows."""
    if start_points is None or not hasattr(parameters, "items"):
        raise ValueError("start_points and parameters come together: parameters={'a': (start, end)} has the values at which "
                         "the start points are roots, and those that are asked for")
    ends = ([], [])
    for name, given in parameters.items():
        given = list(given) if hasattr(given, "__iter__") else [given]
        if len(given) != 2:
            raise ValueError(f"parameters: {name}: (start, end) is wanted")
        for values, value in zip(ends, given):
            values.append(_value(value, f"parameters: {name}"))
    return [str(name) for name in parameters], *ends, np.atleast_2d(np.asarray(start_points, dtype=complex))


def solve(equations, *, variables=None, real=None, positive=None, nonzero=None, box=None, where=None, parameters=None, start_points=None,
          tracker=None, start=None, seed=None, threads=None, time_limit=None, slice=None, precision=None, certify=None, every_path=None,
          digits=None, cross_check=None, tracker_options=None, progress=None, ledger=None):
    """All isolated roots of a polynomial system, complex roots included.

    Parameters
    ----------
    equations : text, path, or list
        A text in PHCpack's or Bertini's form ("x^2 - 4; x*y - 1"), a path to such a file, a list of texts, a list of sympy's
        expressions (each is to be 0, or an Eq, a Poly, a matrix of these), or a list of (coefficients, exponents): numbers, and
        whole numbers of shape (terms, unknowns). Among texts and expressions may stand conditions, as in `where`. int, Fraction,
        Decimal and sympy's Rational stay exact; a float is the double that it is; sqrt(2), pi and the like are taken with 40 digits.
    variables : list of str or symbols, optional
        The unknowns in their order. Default: a text's in the order of their first appearance, sympy's by name.
    real, positive, nonzero : bool, optional
        Tell real roots alone; real ones whose coordinates are all above zero; roots without a coordinate zero. All are looked
        for in any case: `filtered` counts those that are not told.
    box : dict, optional
        Tell real roots alone within ranges: `{"x": (0, 1)}`; None leaves a side open.
    where : str or list of (str or sympy relation), optional
        Tell real roots alone that meet conditions: "x*y > 2", "0 < x <= 1". Roots that their digits do not tell from the boundary
        of one meet `>=` and not `>`; `Root.on_boundary` names it.
    start_points : array_like of complex, shape (points, unknowns), optional
        Roots that are known, of the system with `parameters` at their start values: they are followed to the end values. Then
        those roots are found that the given ones lead to; whether these are all only a proved count can tell.
    parameters : dict, optional
        With `start_points`: `{"a": (start, end)}`.
    tracker : {"cvode", "lanes"}, optional
    start : {"auto", "total-degree", "multihomogeneous", "polyhedral"}, optional
    seed : int, optional
        Of the random numbers. The same seed gives the same roots in the same order.
    threads : int, optional
        Default: 0, as many as the machine has.
    time_limit : float, optional
        Seconds, after which the run ends with what is finished; `complete` is False then.
    slice : bool, optional
        Add random linear equations where equations are missing.
    precision : {"auto", "double", "double-double"}, optional
    certify : bool, optional
        False: say nothing of certificates and completeness.
    every_path : bool, optional
        Follow every path to its end, also where as many roots are known as there can be.
    digits : int, optional
        Also give every nonsingular root to so many digits; reports have them.
    cross_check : bool, optional
        Also solve with the other tracker, and compare path by path: `Result.cross_check`.
    tracker_options : dict, optional
        By the names of docs/trackers.md.
    progress : True, callable or tqdm-shaped bar, optional
        Told (paths done, paths in all).
    ledger : path, optional
        Keep the run in this file as it goes: after a kill or a crash the same call goes on, and one that has ended is told again
        without following a path. `moivre ledger` shows how it stands.

    Returns
    -------
    Result

    Raises
    ------
    ValueError
        Names the argument, and every rule that it breaks; `ParseError` for a text or a file.

    Notes
    -----
    Ctrl-C ends the run; what is finished is returned and is not complete. A second Ctrl-C raises KeyboardInterrupt. Python's
    lock is free while paths run.

    Examples
    --------
    >>> import moivre
    >>> from fractions import Fraction
    >>> r = moivre.solve([([1, Fraction(-1, 4)], [[2], [0]])])
    >>> sorted(r.real_points[:, 0].tolist())
    [-0.5, 0.5]
    >>> r.certified
    [True, True]
    >>> r = moivre.solve(["x^2 + y^2 - 4", "x*y - 1"], positive=True, box={"x": (1, None)})
    >>> r.real_points.round(3), r.filtered
    (array([[1.932, 0.518]]), 3)
    >>> r = moivre.solve(["x^2 + y^2 - 4", "x*y - 1", "x > 0"], where="y >= 1")
    >>> r.real_points.round(3), r.filtered
    (array([[0.518, 1.932]]), 3)
    >>> r = moivre.solve("x^2 - a", parameters={"a": (1, 4)}, start_points=[[1], [-1]])
    >>> sorted(r.real_points[:, 0].tolist())
    [-2.0, 2.0]
    """
    options = chosen(real=real, positive=positive, nonzero=nonzero, box=None if box is None else _box(box),
                     where=None if where is None else conditions_of(where), tracker=tracker, start=start, seed=seed, threads=threads, time_limit=time_limit, slice=slice, precision=precision,
                     certify=certify, every_path=every_path, digits=digits, cross_check=cross_check, tracker_options=tracker_options)
    if parameters is None and start_points is None:
        system, name = to_system(equations, variables)
        with told(progress) as tell, kept(ledger, "solve", system.content(), options) as (options, end):
            result = Result(_moivre.solve(system, options, tell), name)
            end(result.to_text(), result.complete)
            return result
    names, begin, end, points = _ways(parameters, start_points)
    if slice or cross_check:
        raise ValueError("slice and cross_check: not with start_points")
    if ledger is not None:
        raise ValueError("ledger: not with start_points, whose paths are few")
    system, name = to_system(equations, variables, tuple(parameters))
    with told(progress) as tell:
        return Result(_moivre.led_on(system, names, begin, end, points, options, tell), name)
