# SPDX-License-Identifier: MIT
# Does problems/rectangular/index.json say what its files hold?
import json
import sys
import unittest
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PROJECT / "bench"))
from polynomial_text import read_phcpack

FOLDER = PROJECT / "problems" / "rectangular"
INDEX = json.loads((FOLDER / "index.json").read_text(encoding="utf-8"))["problems"]
KINDS = {"consistent", "inconsistent", "redundant", "with a set", "underdetermined"}


def value(polynomial, point):
    total = 0
    for monomial, c in polynomial.items():
        term = c[0]
        for x, e in zip(point, monomial):
            term *= x ** e
        total += term
    return total


class Rectangular(unittest.TestCase):
    def test_every_file_is_listed_once(self):
        self.assertEqual(sorted(p["file"] for p in INDEX), sorted(f.name for f in FOLDER.glob("*.phc")))

    def test_sizes_and_degrees_are_those_of_the_files(self):
        for p in INDEX:
            with self.subTest(p["name"]):
                system = read_phcpack(FOLDER / p["file"])
                self.assertEqual([len(system.polynomials), len(system.variables), system.degrees()],
                                 [p["equations"], p["variables"], p["degrees"]])
                self.assertEqual(p["equations"] < p["variables"], p["kind"] == "underdetermined")
                self.assertNotEqual(p["equations"], p["variables"])

    def test_counts_fit_the_kind(self):
        for p in INDEX:
            with self.subTest(p["name"]):
                self.assertIn(p["kind"], KINDS)
                self.assertEqual(p["degree"] is not None, p["dimension"] > 0)
                self.assertEqual(p["roots"]["distinct"] > 0, p["kind"] in ("consistent", "redundant", "with a set"))
                self.assertGreaterEqual(p["roots"]["with_multiplicity"], p["roots"]["distinct"])
                self.assertTrue(p["verified"])

    def test_known_points_are_roots_and_all_of_them(self):
        for p in INDEX:
            with self.subTest(p["name"]):
                system = read_phcpack(FOLDER / p["file"])
                for point in p.get("points", []):
                    self.assertTrue(all(value(f, point) == 0 for f in system.polynomials))
                if "points" in p:
                    self.assertEqual(len(p["points"]), p["roots"]["distinct"])

    def test_citations_are_in_the_list(self):
        references = (PROJECT / "docs" / "references.md").read_text(encoding="utf-8")
        for p in INDEX:
            for key in p["citations"]:
                self.assertIn(f"**[{key}]**", references)


if __name__ == "__main__":
    unittest.main()
