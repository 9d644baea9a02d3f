# SPDX-License-Identifier: MIT
# Do the random systems come out the same every time, is the stored file sound, and does the comparer see a lost root?
import contextlib
import importlib.util
import io
import json
import os
import sys
import tempfile
import unittest
from importlib.machinery import SourceFileLoader
from pathlib import Path
from unittest import mock

PROJECT = Path(__file__).resolve().parents[2]
BENCH = PROJECT / "bench" / "random_systems"
sys.path[:0] = [str(PROJECT / "bench"), str(BENCH)]
from families import FAMILIES, MOST_PATHS, system_of
from polynomial_algebra import decimal, phc_text
from polynomial_text import parse_phcpack

STORED = PROJECT / "problems" / "random" / "stored.jsonl"
FEW = 4      # systems of each family


def load(script):
    loader = SourceFileLoader(script, str(BENCH / script))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(script, loader))
    loader.exec_module(module)
    return module


compare = load("compare")
LINE = '{"id": "1", "family": "f", "dimension": 0, "with_multiplicity": 3, "distinct": 2, "phc": "1\\nx^2*(x-1);\\n"}\n'


def answer(*multiplicities, complete=True):
    return json.dumps({"complete": complete, "solutions": [{"multiplicity": m} for m in multiplicities]})


class Families(unittest.TestCase):
    def test_a_system_follows_from_seed_family_and_number(self):
        for family in FAMILIES:
            self.assertEqual(phc_text(system_of(5, family, 2)), phc_text(system_of(5, family, 2)))
            self.assertNotEqual(phc_text(system_of(5, family, 2)), phc_text(system_of(6, family, 2)))

    def test_the_text_holds_the_polynomials_exactly(self):
        for family in FAMILIES:
            for number in range(FEW):
                f = system_of(1, family, number)
                with self.subTest(family=family, number=number):
                    system = parse_phcpack(phc_text(f))
                    place = [int(name[1:]) - 1 for name in system.variables]
                    for p, q in zip(f, system.polynomials):
                        self.assertEqual({tuple(m[v] for v in place): c for m, c in p.items()}, q)

    def test_systems_are_square_and_have_few_paths(self):
        for family in FAMILIES:
            for number in range(FEW):
                system = parse_phcpack(phc_text(system_of(2, family, number)))
                self.assertEqual(len(system.polynomials), len(system.variables))
                self.assertLessEqual(system.total_degree(), MOST_PATHS)

    def test_no_constants_mostly_lacks_constants(self):
        def lacks(f):
            return any((0,) * len(f) not in p for p in f)

        self.assertGreater(sum(lacks(system_of(3, "no-constants", number)) for number in range(20)), 15)


class Stored(unittest.TestCase):
    entries = [json.loads(line) for line in STORED.read_text(encoding="utf-8").splitlines()]

    def test_three_hundred_and_more_of_all_families_each_once(self):
        self.assertGreaterEqual(len(self.entries), 300)
        self.assertEqual(len({e["id"] for e in self.entries}), len(self.entries))
        self.assertEqual({e["family"] for e in self.entries}, set(FAMILIES))

    def test_counts_are_within_the_bound_of_the_degrees(self):
        for e in self.entries:
            self.assertLessEqual(e["distinct"], e["with_multiplicity"])
            self.assertLessEqual(e["with_multiplicity"], parse_phcpack(e["phc"]).total_degree())


class Verdicts(unittest.TestCase):
    entry = json.loads(LINE)

    def verdict(self, code, stdout):
        return compare.verdict_of(self.entry, code, stdout)[0]

    def test_all_roots_with_their_multiplicities_are_right(self):
        self.assertEqual(self.verdict(0, answer(2, 1)), "right")

    def test_a_lost_root_and_a_lost_multiplicity_are_wrong(self):
        self.assertEqual(self.verdict(0, answer(2)), "wrong")
        self.assertEqual(self.verdict(0, answer(1, 1)), "wrong")
        self.assertEqual(self.verdict(0, answer(1, 1, 1)), "wrong")

    def test_who_says_so_is_undecided_whatever_was_found(self):
        self.assertEqual(self.verdict(2, answer(2, 1)), "undecided")
        self.assertEqual(self.verdict(0, answer(2, complete=False)), "undecided")

    def test_errors_are_refused_or_broken(self):
        self.assertEqual(self.verdict(1, ""), "refused")
        self.assertEqual(self.verdict(3, answer(2, 1)), "broken")
        self.assertEqual(self.verdict(0, "no JSON"), "broken")


class Comparer(unittest.TestCase):
    """With a shell script in the place of the program."""

    def compare(self, folder, body, *options):
        program, calls = folder / "moivre", folder / "calls"
        program.write_text(f'#!/bin/sh\nif [ "$1" = --version ]; then echo stub; exit 0; fi\necho "$@" >> {calls}\n{body}\n')
        program.chmod(0o755)
        (folder / "systems.jsonl").write_text(LINE)
        (folder / "truth.jsonl").write_text(LINE)
        out = io.StringIO()
        with mock.patch.object(sys, "argv", ["compare", str(folder), "--moivre", str(program), *options]), \
                contextlib.redirect_stdout(out):
            code = compare.main()
        return code, out.getvalue(), len(calls.read_text().splitlines())

    def test_a_wrong_answer_is_listed_with_its_file_and_fails(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            code, text, _ = self.compare(folder, f"echo '{answer(2)}'", "--files", str(folder / "wrong"))
            self.assertEqual(code, 2)
            self.assertIn("wrong 1: expected [3, 2], found [2, 1]", text)
            self.assertTrue((folder / "wrong" / "1.phc").exists())

    def test_what_was_run_is_not_run_again_but_with_other_options(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            self.assertEqual(self.compare(folder, f"echo '{answer(2, 1)}'")[::2], (0, 1))
            stamp = (folder / "moivre").stat().st_mtime_ns
            with mock.patch.object(Path, "chmod", lambda path, mode: os.utime(path, ns=(stamp, stamp))):
                self.assertEqual(self.compare(folder, f"echo '{answer(2, 1)}'")[2], 1)
                self.assertEqual(self.compare(folder, f"echo '{answer(2, 1)}'", "--", "--seed", "2")[2], 2)

    def test_who_takes_too_long_is_stopped(self):
        with tempfile.TemporaryDirectory() as name:
            code, text, _ = self.compare(Path(name), "exec sleep 5", "--timeout", "0.1")
            self.assertEqual(code, 0)
            self.assertRegex(text, r"f +1 +0 +0 +0 +1")


class Numbers(unittest.TestCase):
    def test_decimals_are_exact(self):
        from fractions import Fraction
        for value in (Fraction(-1, 8), Fraction(5, 10 ** 9), Fraction(10) ** 14, Fraction(123456789, 10 ** 4), Fraction(-12)):
            self.assertEqual(Fraction(decimal(value)), value)
        self.assertEqual(decimal(Fraction(1, 3)), "(1/3)")


if __name__ == "__main__":
    unittest.main()
