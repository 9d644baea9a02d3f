# SPDX-License-Identifier: MIT
# The first thing to try: the roots of a system, a four-bar's closures, the postures of a robot arm.
"""Run from anywhere: python3 python/examples/first.py."""

import pathlib

import moivre

problems = pathlib.Path(__file__).resolve().parents[2] / "problems"

r = moivre.solve(["x^2 + y^2 - 4", "x*y - 1"])
print(r)

closures = moivre.Mechanism(problems / "mechanisms" / "four-bar.toml").closures()
for closure in closures:
    print(closure, "coupler at", round(closure.bodies["coupler"].phi, 6), "rad")

arm = moivre.Arm(problems / "robots" / "ur5.urdf", base="base_link", tip="tool0")
postures = arm.ik(arm.fk([0.1, -1.2, 1.1, 0.3, 0.8, -0.4]))
print(postures)
for name, values in zip(postures.names(), postures[0]):
    print(f"{name:40}", values.round(4))
assert r.completeness == closures.completeness == "proved" and postures.complete
