# SPDX-License-Identifier: MIT
# What does `import moivre` give? Every root of a polynomial system, every closure of a mechanism, every posture of an arm.
"""Every isolated root of a polynomial system, every way a mechanism can be assembled, every posture of a robot arm.

Each answer knows what it is worth: `complete` (every path was decided), `completeness` ("proved": no root is missing, "shown",
"open") and `certified` (of each root). What is undecided is a value; a wrong call raises `ValueError`, a fault in a text or a
file `ParseError`.

Examples
--------
>>> import moivre
>>> r = moivre.solve(["x^2 + y^2 - 4", "x*y - 1"])
>>> r
<moivre.Result: 4 roots in x, y, 4 of them real, proved complete>
>>> r.real_points.round(3)
array([[-1.932, -0.518],
       [ 0.518,  1.932],
       [-0.518, -1.932],
       [ 1.932,  0.518]])
"""

from ._errors import ParseError
from ._moivre import __version__
from ._solve import Result, Root, solve
from ._judged import Info, Verdict, check, info
from ._family import Family, Members
from ._mechanism import (Body, Branch, Closure, ClosureSensitivity, Closures, Event, Guesses, Mechanism, Mobility, Motion, Newton,
                         Sensitivity, Sweep)
from ._arm import Arm, NearestPosture, Postures, SelfMotion

__all__ = ["Arm", "Body", "Branch", "Closure", "ClosureSensitivity", "Closures", "Event", "Family", "Guesses", "Info", "Mechanism",
           "Members", "Mobility", "Motion", "NearestPosture", "Newton", "ParseError", "Postures", "Result", "Root", "SelfMotion", "Sensitivity", "Sweep",
           "Verdict", "check", "info", "solve",
           "__version__"]
