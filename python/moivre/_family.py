# SPDX-License-Identifier: MIT
# How are many systems with the same monomials solved? A family is learned once, and each member takes few paths.
"""Families of systems with parameters."""

import os

import numpy as np

from . import _moivre
from ._kept import kept
from ._progress import told
from ._solve import Result, chosen, place, write
from ._systems import TEXT, to_system


class Family:
    """A system with parameters, and all roots of one random member. Made by `Family.learn` or `Family.load`.

    Attributes
    ----------
    variables, parameters : list of str
    roots : int
        As many as a generic member has.
    complete : bool
    standing : str
        What is known of that number, in a sentence.

    Examples
    --------
    >>> import moivre
    >>> f = moivre.Family.learn(["x^2 + a*x + b"], parameters=["a", "b"])
    >>> s = f.solve([[-3, 2], [0, -4], [0, 0]])
    >>> s.counts, s.complete
    (array([2, 2, 1]), True)
    >>> sorted(s.of(0)[:, 0].real.round(12).tolist())
    [1.0, 2.0]
    """

    def __init__(self, file, name=TEXT):
        self._file = file
        self._name = name
        self.variables = file.unknowns
        self.parameters = file.parameters
        self.roots = file.roots
        self.complete = file.complete
        self.standing = file.standing

    @classmethod
    def learn(cls, equations, parameters, *, variables=None, monodromy=False, nonzero=False, trace_test=None, tracker=None, start=None, seed=None,
              threads=None, time_limit=None, certify=None, tracker_options=None, progress=None, ledger=None):
        """Solve one random complex member, by a start system or by loops.

        Parameters
        ----------
        equations
            As for `solve`, as many as there are unknowns.
        parameters : list of str or symbols, or dict
            Names that are parameters; a dict gives the size that values of each typically have (1 otherwise).
        variables : list, optional
            As for `solve`: sympy's unknowns in their order.
        monodromy : bool
            From one random root along loops of members; for families that no start system fits.
        nonzero : bool
            Leave out roots with a coordinate 0.
        trace_test : bool, optional
            With monodromy: make the trace test with more than 2000 roots too; takes minutes to hours.
        time_limit : float, optional
            Seconds, after which the run ends with what is finished; `complete` is False then.
        ledger : path, optional
            As for `solve`: keep the run in this file as it goes.
        """
        sizes = {str(p): float(s) for p, s in parameters.items()} if isinstance(parameters, dict) else {
            str(p): 1.0 for p in parameters}
        if len(sizes) != len(parameters):
            raise ValueError("parameters: a name is given twice")
        system, name = to_system(equations, variables, tuple(parameters))
        options = chosen(trace_test=trace_test, tracker=tracker, start=start, seed=seed, threads=threads, time_limit=time_limit, certify=certify,
                         tracker_options=tracker_options)
        asked = repr((system.content(), sorted(sizes.items()), monodromy, nonzero))
        with told(progress) as tell, kept(ledger, "family learn", asked, options) as (options, end):
            family = cls(_moivre.family_learn(system, list(sizes.items()), name, monodromy, nonzero, options, tell), name)
            end(str(family), family.complete)
            return family

    @classmethod
    def load(cls, path):
        """The family in a file, as `save` or `moivre family learn` wrote it."""
        path = os.fspath(path)
        return cls(_moivre.family_load(path), path)

    def save(self, path):
        """Writes a file that `load` and `moivre family solve` read."""
        self._file.save(os.fspath(path))

    def solve(self, members, *, tracker=None, seed=None, threads=None, time_limit=None, certify=None, tracker_options=None, progress=None):
        """All roots of many members.

        Parameters
        ----------
        members : array_like of float or complex, shape (N, parameters) or (parameters,)
            A row each, in the order of `parameters`.
        time_limit : float, optional
            Seconds. Members that are not solved by then are not decided.

        Returns
        -------
        Members
        """
        rows = np.atleast_2d(np.asarray(members, dtype=complex))
        options = chosen(tracker=tracker, seed=seed, threads=threads, time_limit=time_limit, certify=certify, tracker_options=tracker_options)
        with told(progress) as tell:
            return Members(_moivre.family_members(self._file, rows, options, tell), self)

    def member(self, values, *, tracker=None, seed=None, threads=None, time_limit=None, certify=None, tracker_options=None, progress=None):
        """All roots of one member, whose values stay exact.

        Parameters
        ----------
        values : dict
            A number for each parameter: int, Fraction, Decimal, float, or text ("2/3").

        Returns
        -------
        Result

        Examples
        --------
        >>> import moivre
        >>> f = moivre.Family.learn(["x^2 - a"], parameters=["a"])
        >>> sorted(f.member({"a": "1/4"}).real_points[:, 0].tolist())
        [-0.5, 0.5]
        """
        from ._systems import _exact
        texts = []
        for name, value in values.items():
            if not isinstance(value, str):
                re, im = _exact(value, str(name))[0]
                value = f"({re}) + ({im})*i"
            texts.append(f"{name}={value}")
        options = chosen(tracker=tracker, seed=seed, threads=threads, time_limit=time_limit, certify=certify, tracker_options=tracker_options)
        with told(progress) as tell:
            return Result(_moivre.family_member(self._file, ", ".join(texts), options, tell), self._name)

    def to_json(self, path=None):
        """The JSON of `moivre family info`."""
        return write(self._file.json(self._name), path)

    def __str__(self):
        return self._file.text(self._name)

    def __repr__(self):
        return (f"<moivre.Family: {self.roots} roots in {', '.join(self.variables)}, parameters {', '.join(self.parameters)}"
                f"{'' if self.complete else ', not complete'}>")


class Members:
    """The roots of many members of a family, one after another. Made by `Family.solve`.

    Attributes
    ----------
    points : ndarray of complex, shape (roots of all members, unknowns)
    member : ndarray of int, shape (roots of all members,)
        Which member each root belongs to.
    counts : ndarray of int, shape (N,)
        Roots of each member.
    real : ndarray of bool, multiplicity : ndarray of int, accuracy : ndarray of float, certified : ndarray of bool
        Of each root.
    decided : ndarray of bool, shape (N,)
        Every path of the member was decided.
    completeness : list of (str or None)
        Of each member.
    complete : bool
        All members are decided.
    """

    def __init__(self, solved, family):
        self._solved = solved
        self._family = family
        arrays = solved.roots()
        self.points = arrays["points"]
        self.member = arrays["member"]
        self.counts = arrays["counts"]
        self.real = arrays["real"]
        self.multiplicity = arrays["multiplicity"]
        self.accuracy = arrays["accuracy"]
        self.certified = arrays["certified"]
        self.decided = arrays["complete"]
        self.completeness = arrays["completeness"]
        self.complete = bool(self.decided.all())

    def __len__(self):
        return len(self.counts)

    def of(self, member):
        """The roots of one member, shape (counts[member], unknowns)."""
        member = place(self, member, "member")
        end = int(self.counts[:member + 1].sum())
        return self.points[end - int(self.counts[member]):end]

    def to_json(self, path=None):
        """The JSON of `moivre family solve --table`."""
        return write(self._solved.json(self._family._name, "members"), path)

    def to_csv(self, path=None):
        """A line a root, as text or into a file."""
        return write(self._solved.csv(self._family._name, "members"), path)

    def __str__(self):
        return self._solved.text(self._family._name, "members")

    def __repr__(self):
        return (f"<moivre.Members: {len(self.points)} roots of {len(self)} members"
                f"{'' if self.complete else ', not all decided'}>")
