# SPDX-License-Identifier: MIT
"""What does the program say when it is asked as a user asks, what does it take, and how is it judged?"""
import json
import pathlib
import resource
import subprocess
import tempfile
from dataclasses import dataclass

RIGHT, UNDECIDED, WRONG = "right", "undecided", "wrong"


@dataclass
class Verdict:
    kind: str
    note: str


def worst(verdicts):
    return max(verdicts, key=lambda verdict: [RIGHT, UNDECIDED, WRONG].index(verdict.kind))


@dataclass
class Answer:
    code: int
    json: dict | None
    text: str
    error: str
    seconds: float  # of the processor, user


def whole(answer):
    """What is to be said of an answer before it is looked into; None for one that says, by its exit code and its JSON alike, that it is whole."""
    if answer.json is None or answer.code not in (0, 2):
        return Verdict(WRONG, answer.error[:200] or f"exit code {answer.code}")
    if answer.json.get("complete", answer.code == 0) != (answer.code == 0):
        return Verdict(WRONG, f"exit code {answer.code}, but complete: {answer.json['complete']}")
    return Verdict(UNDECIDED, answer.json.get("message") or "exit code 2") if answer.code == 2 else None


def ask(program, command, tracker, seed, limit):
    """Runs `program COMMAND...` on one thread; the time limit is of the clock, generously."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "answer.json"
        words = [program, *command, "--json", file]
        # What checks a result, or runs Newton's method, follows no paths.
        if command[0] not in ("check", "newton"):
            words += ["--threads", "1", "--seed", seed, "--tracker", tracker, "--time-limit", limit]
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        run = subprocess.run([str(x) for x in words], capture_output=True, text=True, check=False)
        seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        told = json.loads(file.read_text(encoding="utf-8")) if file.exists() else None
        return Answer(run.returncode, told, run.stdout, run.stderr.strip(), seconds)
