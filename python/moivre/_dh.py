# SPDX-License-Identifier: MIT
# How are Denavit-Hartenberg's numbers written as a URDF? One joint a row; what stands before its axis is the origin.
"""Arms by Denavit-Hartenberg's numbers."""

import html
import math


def _row(row, k):
    """(a, alpha, d, theta), and the limits of a slide."""
    row = list(row)
    slides = row[4:]
    if len(row) not in (4, 5) or not all(isinstance(limits, (tuple, list)) and len(limits) == 2 for limits in slides):
        raise ValueError(f"row {k + 1}: a, alpha, d, theta are wanted, and of a slide (lower, upper)")
    try:
        numbers = [float(x) for x in row[:4]]
        limits = [float(x) for x in slides[0]] if slides else None
    except (TypeError, ValueError):
        raise ValueError(f"row {k + 1}: a, alpha, d, theta and limits are numbers") from None
    if not all(map(math.isfinite, numbers + (limits or []))):
        raise ValueError(f"row {k + 1}: a number is not finite")
    return numbers, limits


def _joint(name, kind, parent, child, xyz, rpy, limits=None):
    axis = '' if kind == "fixed" else '<axis xyz="0 0 1"/>'
    limit = f'<limit lower="{limits[0]!r}" upper="{limits[1]!r}" effort="1" velocity="1"/>' if limits else ""
    origin = f'<origin xyz="{" ".join(map(repr, xyz))}" rpy="{" ".join(map(repr, rpy))}"/>'
    return (f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>{origin}{axis}{limit}'
            "</joint>")


def dh_urdf(rows, modified, name):
    """The arm as the text of a URDF. Between two axes stand Rz(theta) Tz(d) and Tx(a) Rx(alpha), in this order or, as Craig has
    it, a row's a and alpha before its axis; each is an origin of its own, so that no angle is computed."""
    rows = [_row(row, k) for k, row in enumerate(rows)]
    parts = [f"<robot name=\"{html.escape(str(name))}\"><link name=\"base\"/>"]
    last = "base"

    def add(link, joint, kind, xyz, rpy, limits=None):
        nonlocal last
        parts.append(f'<link name="{link}"/>' + _joint(joint, kind, last, link, xyz, rpy, limits))
        last = link

    for k, ((a, alpha, d, theta), limits) in enumerate(rows, 1):
        across = (f"across{k}", "fixed", (a, 0.0, 0.0), (alpha, 0.0, 0.0))
        if modified:
            add(f"before{k}", *across)
        kind = "prismatic" if limits else "continuous"
        add(f"link{k}", f"joint{k}", kind, (0.0, 0.0, d), (0.0, 0.0, theta), limits)
        if not modified:
            add(f"end{k}", *across)
    add("tip", "flange", "fixed", (0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
    return "".join(parts) + "</robot>"
