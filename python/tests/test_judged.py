# SPDX-License-Identifier: MIT
# Do info(), check() and ledger= what the commands and the option of these names do?
import contextlib
import json
import os
import signal
import sqlite3
import subprocess
import sys
import time

import pytest
from conftest import ROOT

import moivre

SYSTEM = ["x^2 + y^2 - 4", "x*y - 1"]


def test_info_is_that_of_the_command_line(command):
    path = ROOT / "problems" / "polynomials" / "cassou.phc"
    info = moivre.info(path)
    assert info.to_json() == command("info", path)
    assert info.total_degree == 1344 and info.paths["polyhedral"] == 24 and info.variables == moivre.solve(path).variables
    assert "Paths of each start system" in str(info)


def test_info_tells_of_conditions():
    assert moivre.info([*SYSTEM, "0 < x <= 1"]).conditions == ["0 < x", "x <= 1"]


def test_check_is_that_of_the_command_line(command, tmp_path):
    path = ROOT / "problems" / "polynomials" / "puma.phc"
    roots = tmp_path / "roots.json"
    result = moivre.solve(path)
    result.to_json(roots)
    verdict = moivre.check(path, roots)
    assert verdict.to_json() == command("check", path, roots)
    assert verdict.proofs_hold and verdict.refuted == []
    assert moivre.check(path, result).proofs_hold and moivre.check(path, result.to_json()).proofs_hold


def test_check_names_a_false_claim():
    report = json.loads(moivre.solve(SYSTEM).to_json())
    report["solutions"][2]["x"][0][0] += 1e-3
    verdict = moivre.check(SYSTEM, json.dumps(report))
    assert not verdict.holds and not verdict.proofs_hold
    assert {finding["root"] for finding in verdict.refuted if finding["root"]} == {3}
    with pytest.raises(ValueError, match="no result of moivre solve"):
        moivre.check(SYSTEM, json.dumps({"command": "info"}))
    with pytest.raises(ValueError, match="result: 3 is none"):
        moivre.check(SYSTEM, 3)


KATSURA = "import moivre, sys; moivre.solve(sys.argv[1], tracker='cvode', threads=1, ledger=sys.argv[2])"


def has_observations(book):
    if not book.exists():
        return False
    try:
        with contextlib.closing(sqlite3.connect(f"file:{book}?mode=ro", uri=True)) as kept:
            return kept.execute("SELECT count(*) FROM observation").fetchone()[0] > 0
    except sqlite3.OperationalError:
        return False  # its tables are not laid yet


def test_a_killed_call_goes_on_to_the_same_bytes(tmp_path):
    path, book = ROOT / "problems" / "polynomials" / "katsura-10.phc", tmp_path / "run.db"
    killed = subprocess.Popen([sys.executable, "-c", KATSURA, str(path), str(book)], env={**os.environ})
    while not has_observations(book) and killed.poll() is None:
        time.sleep(0.005)
    killed.send_signal(signal.SIGKILL)
    assert killed.wait() == -signal.SIGKILL, "it ended before"
    r = moivre.solve(path, tracker="cvode", threads=2, ledger=book)
    begin = time.process_time()
    plain = moivre.solve(path, tracker="cvode")
    middle = time.process_time()
    assert r.complete and (r.points == plain.points).all() and (r.accuracy == plain.accuracy).all()
    again = moivre.solve(path, tracker="cvode", ledger=book, real=True)
    assert (again.points == plain.points[plain.real]).all()
    assert time.process_time() - middle < (middle - begin) / 2, "no path is followed again"


def test_a_ledger_belongs_to_one_run(tmp_path):
    moivre.solve(SYSTEM, ledger=tmp_path / "run.db")
    with pytest.raises(ValueError, match="content"):
        moivre.solve(["x^2 + y^2 - 5", "x*y - 1"], ledger=tmp_path / "run.db")
    with pytest.raises(ValueError, match="seed"):
        moivre.solve(SYSTEM, seed=2, ledger=tmp_path / "run.db")


def test_the_program_shows_a_ledger_of_python(tmp_path):
    program = os.environ.get("MOIVRE")
    if not program:
        pytest.skip("the program was not built")
    family = moivre.Family.learn(["x^2 + a*x + b"], ["a", "b"], ledger=tmp_path / "run.db")
    assert family.roots == 2
    done = subprocess.run([program, "ledger", str(tmp_path / "run.db")], capture_output=True, text=True, check=False)
    assert done.returncode == 0 and "family learn in Python" in done.stdout, done.stdout + done.stderr
