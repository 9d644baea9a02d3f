#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# Do the function generators of problems/generate say what six-bars do? Six-bars are turned by Newton's method on the lengths of
# their bars alone; where they stand, their own numbers satisfy the equations, and other numbers do not.
import cmath
import math
import random
import re
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "problems"))
from function_generators import FEWEST_POSITIONS, LINKAGES, MOST_POSITIONS, family, logarithm

STEP, SMALL = 0.03, 1e-9


def bars(kind, w, v, other, z, y, r, factors, f, g, t):
    """From one end to the other of the two links that only keep their lengths, with joints placed link by link."""
    if kind == "function-generator":
        return tuple(p * w * f + arm * t + q * other + on_output * v * g + fixed
                     for arm, (p, q, on_output, fixed) in ((z, factors[:4]), (y, factors[4:])))
    if kind == "watt-2":
        return (1 + w * f) - r * t, (other + v * g) - t
    first = w * f + z * t, w * f + y * t      # joints of the coupler
    if kind == "stephenson-2":
        return first[0] - (1 + v * g), first[1] - (1 + other * g)
    return first[0] - other, first[1] - (1 + v * g)


def turned(kind, numbers, start, positions):
    """(f, g, t) in each position, (1, 1, start) first: the input turns on, the two lengths give the other angles."""
    lengths = [abs(p) for p in bars(kind, **numbers, f=1, g=1, t=start)]
    psi, theta, result = 0.0, cmath.phase(start), [(1, 1, start)]

    def misses(phi, psi, theta):
        there = bars(kind, **numbers, f=cmath.exp(1j * phi), g=cmath.exp(1j * psi), t=cmath.exp(1j * theta))
        return [abs(p) - length for p, length in zip(there, lengths)]

    for j in range(1, positions):
        phi = j * STEP
        for _ in range(30):
            miss, h = misses(phi, psi, theta), 1e-6
            by_psi = [(a - b) / (2 * h) for a, b in zip(misses(phi, psi + h, theta), misses(phi, psi - h, theta))]
            by_theta = [(a - b) / (2 * h) for a, b in zip(misses(phi, psi, theta + h), misses(phi, psi, theta - h))]
            determinant = by_psi[0] * by_theta[1] - by_psi[1] * by_theta[0]
            if abs(determinant) < 1e-3:
                return None                   # beside a dead point
            psi -= (miss[0] * by_theta[1] - miss[1] * by_theta[0]) / determinant
            theta -= (by_psi[0] * miss[1] - by_psi[1] * miss[0]) / determinant
        if max(map(abs, misses(phi, psi, theta))) > 1e-13:
            return None
        result.append(tuple(cmath.exp(1j * angle) for angle in (phi, psi, theta)))
    return result


def values_of(kind, text, numbers, places):
    """The left sides of the family's equations."""
    names = {}
    for letter, value in {"w": numbers["w"], "v": numbers["v"], "z": numbers["z"], "y": numbers["y"],
                          {"watt-2": "d", "stephenson-2": "x"}.get(kind, "b"): numbers["other"]}.items():
        names[letter], names[letter + "c"] = value, value.conjugate()
    names["r"] = numbers["r"]
    for k, factor in enumerate(numbers["factors"]):
        name = "pqrs"[k % 4] + str(1 + k // 4)
        names[name], names[name + "c"] = factor, factor.conjugate()
    for j, place in enumerate(places):
        names.update({f"{letter}{j}": value for letter, value in zip("fgt", place)})
    unknowns = re.search(r"variable_group (.*);", text).group(1).split(", ")
    equations = re.findall(r"^  (?:one|two)\d = (.*);$", text, re.M)
    assert len(unknowns) == len(equations), (kind, unknowns)
    return [eval(equation, {}, names) for equation in equations]


def main():
    draw = random.Random(1)
    for kind in LINKAGES:
        for positions in range(FEWEST_POSITIONS, MOST_POSITIONS + 1):
            text, places = family(kind, positions), None
            while places is None:
                numbers = {name: complex(draw.uniform(-2, 2), draw.uniform(-2, 2)) for name in ("w", "v", "other", "z", "y")}
                numbers["r"] = draw.uniform(0.5, 2)
                numbers["factors"] = [complex(draw.uniform(-2, 2), draw.uniform(-2, 2)) for _ in range(8)]
                start = cmath.exp(1j * draw.uniform(-3, 3)) if positions % 2 == 0 else 1
                places = turned(kind, numbers, start, positions)
            largest = max(map(abs, values_of(kind, text, numbers, places)))
            assert largest < SMALL, (kind, positions, largest)
            for name in ("w", "v", "other"):
                other = {**numbers, name: numbers[name] + 0.1}
                assert max(map(abs, values_of(kind, text, other, places))) > 1e4 * SMALL, (kind, positions, name)
    table = logarithm(8).split("\n")
    turns = dict(zip(table[0].split(","), (complex(cell.replace("*i", "j")) for cell in table[1].split(","))))
    assert all(abs(abs(z) - 1) < 1e-14 for name, z in turns.items() if name != "r")
    assert math.isclose(cmath.phase(turns["g7"]), math.radians(100) * math.log10((5.5 + 4.5 * math.cos(math.pi / 16)) / (5.5 - 4.5 * math.cos(math.pi / 16))),
                        rel_tol=1e-12)


main()
