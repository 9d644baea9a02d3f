# SPDX-License-Identifier: MIT
# Runs that are kept are judged again: the same verdicts without following a path, and a verdict that is another is seen.
import json
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MOIVRE = sys.argv.pop(1)
SYSTEMS = ["noon-3.phc", "multiplicity-4.phc", "parallel-lines.phc"]


def replay(*words):
    return subprocess.run([sys.executable, "-B", ROOT / "bench/replay/replay", *words], capture_output=True, text=True, check=False)


class Replay(unittest.TestCase):
    def test_gives_the_same_verdicts_and_sees_another(self):
        with tempfile.TemporaryDirectory() as folder:
            arm = Path(shutil.copy(ROOT / "problems/robots/puma560.urdf", folder))
            arm.with_suffix(".poses").write_text("0.4 0.1 0.3 1 0 0 0\n0.3 0.2 0.4 0.8 0.6 0 0\n")
            files = [*(ROOT / "problems/polynomials" / name for name in SYSTEMS), arm]
            self.assertEqual(replay("record", MOIVRE, folder, *files).returncode, 0)
            same = replay("judge", MOIVRE, folder)
            self.assertEqual(same.returncode, 0, same.stdout + same.stderr)
            self.assertIn(f"{len(SYSTEMS) + 2} runs judged again, 0 differ, 0 followed other paths too", same.stdout)
            kept = Path(folder) / "noon-3.verdict.json"
            entry = json.loads(kept.read_text())
            entry["verdict"]["roots"].pop()
            kept.write_text(json.dumps(entry))
            other = replay("judge", MOIVRE, folder)
            self.assertEqual(other.returncode, 1)
            self.assertIn("noon-3", other.stdout)
            self.assertIn("1 differ", other.stdout)


if __name__ == "__main__":
    unittest.main()
