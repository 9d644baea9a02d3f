# SPDX-License-Identifier: MIT
# What is a system's structure, and is a result of it true? info() and check(), as the commands of these names.
"""Systems looked at, and results judged."""

import json
import os

from . import _moivre
from ._solve import Result, chosen, write
from ._systems import is_path, to_system


class _Report:
    """What a command of the program reports: print() shows its text."""

    def __init__(self, report, text):
        self._json = report
        self._text = text

    def to_json(self, path=None):
        """The JSON of the command line; written to `path` where one is given."""
        return write(self._json, path)

    def to_text(self):
        """The text of the command line."""
        return self._text

    def __str__(self):
        return self._text


class Info(_Report):
    """The structure of a system. Made by `info`.

    Attributes
    ----------
    variables : list of str
    equations, terms : int
    degrees : list of int
    total_degree : int or None
        None beyond 64 bits.
    paths : dict
        Paths of each start system: "total-degree", "multihomogeneous", "polyhedral"; None where there is no number.
    conditions : list of str
        That stand among the equations.
    """

    def __init__(self, report, text):
        super().__init__(report, text)
        read = json.loads(report)
        system = read["system"]
        self.variables = system["variables"]
        self.equations = system["equations"]
        self.terms = system["terms"]
        self.degrees = system["degrees"]
        self.total_degree = system["total_degree"]
        self.conditions = system.get("conditions", [])
        self.paths = {start["kind"]: start["paths"] for start in read["start_systems"]}

    def __repr__(self):
        return f"<moivre.Info: {self.equations} equations in {', '.join(self.variables)}, degrees {self.degrees}>"


class Verdict(_Report):
    """What is true of a result. Made by `check`.

    Attributes
    ----------
    holds : bool
        No claim is refuted.
    proofs_hold : bool
        And what is said to be proved is: proved again here.
    refuted, open : list of dict
        Claims that are false, and claims that cannot be verified: "claim", "root" (a number from 1, or None), "why".
    """

    def __init__(self, report, text, holds, proofs_hold):
        super().__init__(report, text)
        read = json.loads(report)
        self.holds = holds
        self.proofs_hold = proofs_hold
        self.refuted = read["refuted"]
        self.open = read["open"]

    def __repr__(self):
        stands = "every proof holds" if self.proofs_hold else "no claim is refuted" if self.holds else "refuted"
        return f"<moivre.Verdict: {stands}, {len(self.refuted)} claims refuted, {len(self.open)} open>"


def info(equations, *, variables=None, time_limit=None):
    """The structure of a system: degrees, terms, and the paths of every start. Nothing is solved.

    Parameters
    ----------
    equations, variables
        As for `solve`.
    time_limit : float, optional
        Seconds, after which path counts that are not known yet are None.

    Returns
    -------
    Info

    Examples
    --------
    >>> import moivre
    >>> moivre.info(["x^2 + y^2 - 4", "x*y - 1"]).paths
    {'total-degree': 4, 'multihomogeneous': 4, 'polyhedral': 4}
    """
    system, name = to_system(equations, variables)
    return Info(*_moivre.inspect(system, name, chosen(time_limit=time_limit)))


def check(equations, result, *, variables=None, time_limit=None):
    """Judges a result by certificates, sums and bounds, without anything that follows a path.

    Parameters
    ----------
    equations, variables
        As for `solve`.
    result : Result, text or path
        A result of `solve`, its JSON, or PHCpack's solution list.
    time_limit : float, optional
        Seconds; what was not judged by then is neither refuted nor open, and `proofs_hold` is False.

    Returns
    -------
    Verdict

    Examples
    --------
    >>> import moivre
    >>> equations = ["x^2 + y^2 - 4", "x*y - 1"]
    >>> moivre.check(equations, moivre.solve(equations))
    <moivre.Verdict: every proof holds, 0 claims refuted, 0 open>
    >>> moivre.check(["x^2 + y^2 - 4", "x*y - 2"], moivre.solve(equations)).holds
    False
    """
    system, name = to_system(equations, variables)
    if isinstance(result, Result):
        text, source = result.to_json(), "result"
    elif isinstance(result, os.PathLike) or (isinstance(result, str) and is_path(result)):
        source = os.fspath(result)
        with open(source, encoding="utf-8") as file:
            text = file.read()
    elif isinstance(result, str):
        text, source = result, "result"
    else:
        raise ValueError(f"result: {result!r} is none; a Result, its JSON or a path is wanted")
    return Verdict(*_moivre.judge(system, name, source, text, chosen(time_limit=time_limit)))
