#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# Which roots of the logarithm are linkages that can be built, and how near do they come to the function?
#
#   bench/logarithms.py ROOTS.csv       of: moivre family solve watt-2-8.family --table problems/families/logarithm-8.csv --csv ROOTS.csv
#
# Real: every vector is the conjugate of its conjugate and |t| = 1. Usable: from the first position to the last neither four-bar
# comes to a dead point or leaves its way of being assembled. Error: the greatest in y = log10 x between the first position and the
# last, x in 400 steps. Exit: 0, 1 usage. Python's standard library only.
import cmath
import csv
import math
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "problems"))
from function_generators import INPUT_DEG, OUTPUT_DEG

POSITIONS, STEPS, SMALL = 8, 400, 1e-8


def linkage(row):
    """w, d, v, r and t0, t1, ..., or None where it is no real one."""
    def number(name):
        return complex(float(row[f"{name}.re"]), float(row[f"{name}.im"]))

    vectors = [(number(x), number(x + "c")) for x in ("w", "d", "v")]
    turns = [number(f"t{j}") for j in range(POSITIONS)]
    is_real = all(abs(a - b.conjugate()) <= SMALL * max(1, abs(a)) for a, b in vectors) and all(abs(abs(t) - 1) <= SMALL for t in turns)
    return (*(a for a, _ in vectors), float(row["r"]), turns) if is_real else None


def direction(end, arm, bar, side):
    """u, |u| = 1, with |end - arm u| = bar, on that side of `end`; None where it cannot be reached."""
    if end == 0:
        return None
    cosine = (abs(end) ** 2 + arm ** 2 - bar ** 2) / (2 * arm * abs(end))
    return end / abs(end) * cmath.exp(1j * side * math.acos(cosine)) if abs(cosine) <= 1 else None


def side_of(end, u):
    return 1 if (u * end.conjugate()).imag > 0 else -1


def greatest_error(w, d, v, r, turns, positions):
    """None where it is not usable. positions: (x, f, g)."""
    bars = abs(1 + w - r * turns[0]), abs(d + v - turns[0])
    sides = {(side_of(1 + w * f, t), side_of(t - d, v * g)) for (_, f, g), t in zip(positions, turns)}
    if len(sides) > 1:
        return None
    first, second = sides.pop()
    start, stop = positions[0][0], positions[-1][0]
    worst = 0
    for k in range(STEPS + 1):
        x = start + (stop - start) * k / STEPS
        t = direction(1 + w * cmath.exp(1j * math.radians(INPUT_DEG) * (x - start) / 9), r, bars[0], first)
        u = direction(t - d, abs(v), bars[1], second) if t is not None else None
        if u is None:
            return None
        wanted = cmath.exp(1j * math.radians(OUTPUT_DEG) * math.log10(x / start))
        worst = max(worst, abs(cmath.phase(u * abs(v) / v / wanted)) / math.radians(OUTPUT_DEG))
    return worst


def main(arguments):
    if len(arguments) != 1:
        print("usage: logarithms.py ROOTS.csv", file=sys.stderr)
        return 1
    with open(arguments[0], encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    points = [5.5 - 4.5 * math.cos(math.pi * (2 * k + 1) / (2 * POSITIONS)) for k in range(POSITIONS)]
    positions = [(x, cmath.exp(1j * math.radians(INPUT_DEG) * (x - points[0]) / 9),
                  cmath.exp(1j * math.radians(OUTPUT_DEG) * math.log10(x / points[0]))) for x in points]
    real = [found for found in map(linkage, rows) if found]
    usable = sorted(((error, found) for found in real if (error := greatest_error(*found, positions)) is not None), key=lambda u: u[0])
    print(f"{len(rows)} roots, {len(real)} real linkages, {len(usable)} usable")
    for error, (w, d, v, _, turns) in usable[:5]:
        print(f"error {error:.1e}: w = {w:.4f}, d = {d:.4f}, v = {v:.4f}, t0 = {turns[0]:.4f}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
