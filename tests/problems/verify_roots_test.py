# SPDX-License-Identifier: MIT
# Does the judge of bench/peers count regular roots, each once, and nothing else?
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))
from polynomial_text import parse_phcpack, read_phcpack
from verify_roots import points_of_moivre, points_of_phcpack, verify

PROBLEMS = Path(__file__).resolve().parents[2] / "problems" / "polynomials"


def count(name, points):
    return len(verify(read_phcpack(PROBLEMS / f"{name}.phc"), points))


class Verify(unittest.TestCase):
    def test_every_integer_root_of_wilkinson_20_is_confirmed(self):
        self.assertEqual(count("wilkinson-20", [[complex(k)] for k in range(1, 21)]), 20)

    def test_a_root_reported_twice_counts_once(self):
        self.assertEqual(count("one-root", [[-3, -7], [-3 + 1e-9j, -7]]), 1)

    def test_a_point_that_is_no_root_does_not_count(self):
        self.assertEqual(count("one-root", [[-3.1, -7], [float("nan"), 0], [float("inf"), 1]]), 0)

    def test_a_double_root_does_not_count_even_when_exact(self):
        for point in ([1, 0], [1, 1e-9], [1, 1e-60]):
            self.assertEqual(count("tangent-circle", [point]), 0)

    def test_a_point_on_a_curve_of_roots_does_not_count(self):
        self.assertEqual(count("duplicated-equation", [[1, 2], [2, 1]]), 0)

    def test_one_double_root_is_not_taken_for_two_near_ones(self):
        self.assertEqual(count("near-double", [[1, 1], [1, 1]]), 0)
        self.assertEqual(count("near-double", [[1 - 1e-5, 1 - 1e-5], [1 + 1e-5, 1 + 1e-5]]), 2)

    def test_roots_of_very_different_size_are_confirmed(self):
        system = parse_phcpack("2\n x - 1000000;\n 1000000*y^2 - 0.000001;\n")
        self.assertEqual(len(verify(system, [[1e6, 1e-6], [1e6, -1e-6]])), 2)

    def test_real_means_that_the_refined_imaginary_part_vanishes(self):
        system = parse_phcpack("1\n x^3 - 1;\n")
        roots = verify(system, [[1 + 1e-10j], [-0.5 + 0.8660254j], [-0.5 - 0.8660254j]])
        self.assertEqual([len(roots), sum(r.real for r in roots)], [3, 1])


class Readers(unittest.TestCase):
    system = parse_phcpack("2\n y - (1/2 + 3*i)*x**2;\n x*y - 1.5E-1;\n\nTITLE : two\n")

    def test_coefficients_are_exact_and_variables_stand_as_they_appear(self):
        self.assertEqual(self.system.variables, ["y", "x"])
        self.assertEqual([str(c) for c in self.system.polynomials[0][0, 2]], ["-1/2", "-3"])
        self.assertEqual(str(self.system.polynomials[1][0, 0][0]), "-3/20")

    def test_solutions_of_phcpack_are_taken_by_name(self):
        text = "THE SOLUTIONS :\n1 2\n====\nsolution 1 :\nt : 1.0 0.0\nm : 1\nthe solution for t :\n" \
               " x :  1.0E+00 2.0E+00\n y : -3.0E+00 0.0E+00\n== err :  1.0E-16 = rco : 1.0E+00 =\n"
        self.assertEqual(points_of_phcpack(text, self.system), [[-3, 1 + 2j]])

    def test_solutions_of_moivre_are_taken_by_the_names_it_lists(self):
        text = '{"system": {"variables": ["x", "y"]}, "solutions": [{"x": [[1, 2], [-3, 0]]}]}'
        self.assertEqual(points_of_moivre(text, self.system), [[-3, 1 + 2j]])


if __name__ == "__main__":
    unittest.main()
