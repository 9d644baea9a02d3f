# SPDX-License-Identifier: MIT
# What do the tests of the Python module share? The folder of problems, the program, and JSON without run times.
import json
import os
import pathlib
import subprocess

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROBLEMS = ROOT / "problems"


@pytest.fixture
def problems():
    return PROBLEMS


@pytest.fixture
def four_bar():
    return PROBLEMS / "mechanisms" / "four-bar.toml"


@pytest.fixture
def ur5():
    return PROBLEMS / "robots" / "ur5.urdf"


@pytest.fixture
def command():
    """The JSON text that the command line writes."""
    program = os.environ.get("MOIVRE")
    if not program:
        pytest.skip("the program was not built")

    def run(*arguments):
        words = [program, *map(str, arguments), "--json", "-"]
        done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=False)
        assert done.returncode in (0, 2), done.stderr
        return done.stdout

    return run


def without_times(text):
    """The lines of a report but for those that tell how long it took."""
    return [line for line in text.splitlines() if '"time_s"' not in line and '"seconds"' not in line]


def parsed(text):
    return json.loads(text)
