# SPDX-License-Identifier: MIT
"""Does the judge of people's files (bench/people) refuse answers that are wrong? Faults are planted in right ones."""
import pathlib
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "bench" / "people"))
try:
    import numpy  # noqa: F401  arms are judged by it
except ImportError:
    sys.exit(77)

from answers import RIGHT, UNDECIDED, WRONG, ask  # noqa: E402
from arms import ArmCase  # noqa: E402
from files import CASES  # noqa: E402

PROGRAM = sys.argv.pop()


def judged(file, fault):
    """What is said of the answers to a file, once the fault is planted in each."""
    def asked(*command):
        answer = ask(PROGRAM, command, "lanes", "7", "60")
        fault(answer)
        return answer

    if file.endswith(".urdf"):
        return ArmCase(ROOT / "tests" / "arms" / "people" / file).run(asked)
    return CASES[file][1](asked, ROOT / "problems" / "people" / file)


def nothing(_):
    pass


def a_posture_less(answer):
    answer.json["closures"].pop()


def no_curve(answer):
    answer.json["moves"] = None


def away(answer):
    for closure in answer.json["closures"]:
        name = next(iter(closure["coordinates"]))
        closure["coordinates"][name] += 1e-5


def another_count(answer):
    answer.json["counts"]["real"] -= 1


def exits(code):
    def fault(answer):
        answer.code = code
    return fault


def incomplete(answer):
    answer.json["complete"] = False


class PlantedFaults(unittest.TestCase):
    def test_right_answers_are_right(self):
        for file in ("so101.urdf", "tx2_90.urdf", "burmester-5-moves.toml", "near-pair-exact.phc"):
            self.assertEqual(judged(file, nothing).kind, RIGHT, file)

    def test_a_posture_less_is_wrong(self):
        self.assertEqual(judged("so101.urdf", a_posture_less).kind, WRONG)

    def test_a_curve_that_is_not_told_is_wrong(self):
        self.assertEqual(judged("tx2_90.urdf", no_curve).kind, WRONG)

    def test_a_posture_that_does_not_hold_the_pose_is_wrong(self):
        self.assertEqual(judged("so101.urdf", away).kind, WRONG)

    def test_another_count_is_wrong(self):
        self.assertEqual(judged("burmester-5-moves.toml", another_count).kind, WRONG)

    def test_an_exit_code_that_its_json_denies_is_wrong(self):
        for file in ("so101.urdf", "burmester-5-moves.toml"):
            for fault in (exits(1), exits(2), exits(134), incomplete):
                self.assertEqual(judged(file, fault).kind, WRONG, file)

    def test_an_answer_that_says_it_is_not_whole_is_never_right(self):
        def both(answer):
            exits(2)(answer)
            incomplete(answer)

        for file in ("so101.urdf", "burmester-5-moves.toml", "near-pair-exact.phc"):
            self.assertEqual(judged(file, both).kind, UNDECIDED, file)

    def test_roots_less_are_wrong(self):
        def fault(answer):
            answer.json["solutions"].pop()

        self.assertEqual(judged("near-pair-exact.phc", fault).kind, WRONG)

    def test_a_root_without_a_right_digit_is_wrong(self):
        def fault(answer):
            least = min(answer.json["solutions"], key=lambda root: abs(root["x"][0][0]))
            least["x"][0][0] = 0.0

        self.assertEqual(judged("refused-msolve358.phc", nothing).kind, RIGHT)
        self.assertEqual(judged("refused-msolve358.phc", fault).kind, WRONG)


if __name__ == "__main__":
    unittest.main()
