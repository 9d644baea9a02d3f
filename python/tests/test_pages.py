# SPDX-License-Identifier: MIT
# Do the blocks of docs/python.md run, one after another, and do the types that are told exist?
import ast
import inspect
import os
import re

import pytest
from conftest import PROBLEMS, ROOT

import moivre


def test_the_page_runs(tmp_path, monkeypatch):
    pytest.importorskip("sympy")
    page = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")
    blocks = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    assert len(blocks) >= 4
    code = "\n".join(blocks).replace("problems/", f"{ROOT}/problems/")
    monkeypatch.chdir(tmp_path)
    exec(compile(code, "docs/python.md", "exec"), {})  # noqa: S102
    assert os.path.exists("quadratic.family")


def told_members():
    tree = ast.parse((ROOT / "python" / "moivre" / "__init__.pyi").read_text(encoding="utf-8"))
    for node in tree.body:
        if isinstance(node, ast.ClassDef) and not node.name.startswith("_") and node.name != "Body":
            for member in node.body:
                if isinstance(member, ast.FunctionDef):
                    yield node.name, member.name


def test_every_function_that_is_typed_exists():
    for name, member in told_members():
        assert hasattr(getattr(moivre, name), member), f"{name}.{member}"


def results():
    """One of each class that a call returns."""
    r = moivre.solve(["x^2 + y^2 - 4", "x*y - 1"])
    yield from (r, r[0], moivre.info("x^2 - 2"), moivre.check(["x^2 + y^2 - 4", "x*y - 1"], r))
    f = moivre.Family.learn(["x^2 - a"], parameters=["a"])
    yield from (f, f.solve([[2.0]]))
    m = moivre.Mechanism(PROBLEMS / "mechanisms" / "four-bar.toml")
    rocker = moivre.Mechanism({
        "ground": {"points": {"A": [0, 0], "D": [4, 0]}},
        "body": {"crank": {"points": {"A": [0, 0], "B": [3, 0]}}, "rocker": {"points": {"D": [0, 0], "C": [2, 0]}}},
        "joint": [{"type": "revolute", "at": ["ground.A", "crank.A"]}, {"type": "revolute", "at": ["ground.D", "rocker.D"]},
                  {"type": "rod", "at": ["crank.B", "rocker.C"], "length": 2}],
        "driver": [{"angle": "crank", "start": 1.0, "velocity": 1.0}]}).motion(steps=8)
    yield from (m, m.closures(), m.closures()[0], rocker, rocker.branches[0], rocker.events[0])
    yield m.sweep({"coupler.B.x": (100, 200, 2)}, borders=False)
    yield from (m.sensitivity(), m.sensitivity()[0], m.guesses(), m.mobility(), m.newton())
    arm = moivre.Arm(PROBLEMS / "robots" / "puma560.urdf")
    far = arm.fk([0, 0, 0, 0, 0, 0])
    far[0, 3] = 9
    q = arm.ik(arm.fk([0.1, -0.5, 0.3, 0.4, 0, 0.6]))
    yield from (arm, q, q.motions(0)[0], arm.ik(far).nearest_posture())


def public(thing):
    return {name for name in dir(thing) if not name.startswith("_")}


def test_the_page_and_the_types_name_all_that_a_result_has():
    page = (ROOT / "docs" / "python.md").read_text(encoding="utf-8").partition("## What a result has")[2].partition("\n## ")[0]
    told = {row[0]: set(re.findall(r"`(\w+)`", row[1])) for row in re.findall(r"^\| `(\w+)` \| (.*) \|$", page, re.MULTILINE)}
    tree = ast.parse((ROOT / "python" / "moivre" / "__init__.pyi").read_text(encoding="utf-8"))
    typed = {}
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            names = {m.target.id if isinstance(m, ast.AnnAssign) else m.name for m in node.body
                     if isinstance(m, (ast.AnnAssign, ast.FunctionDef)) and not getattr(m, "name", "").startswith("_")}
            typed[node.name] = names.union(*(typed.get(getattr(base, "id", ""), ()) for base in node.bases))
    seen = set()
    for thing in results():
        name = type(thing).__name__
        seen.add(name)
        assert told.get(name) == public(thing), name
        assert typed[name] == public(thing), name
        documented = set(re.findall(r"\w+", type(thing).__doc__))
        assert {a for a in public(thing) if not callable(getattr(type(thing), a, None))} <= documented, name
    # A Body has the coordinates of its mechanism, an exception is no result.
    assert seen == set(told) == {name for name in moivre.__all__ if inspect.isclass(getattr(moivre, name))} - {"Body", "ParseError"}


def typed_functions():
    tree = ast.parse((ROOT / "python" / "moivre" / "__init__.pyi").read_text(encoding="utf-8"))
    for node in tree.body:
        if isinstance(node, ast.FunctionDef):
            yield getattr(moivre, node.name), node
        if isinstance(node, ast.ClassDef) and not node.name.startswith("_") and node.name != "Body":
            for member in node.body:
                if isinstance(member, ast.FunctionDef) and not (member.name.startswith("__") and member.name != "__init__"):
                    yield inspect.getattr_static(getattr(moivre, node.name), member.name), member


def test_what_is_typed_has_the_arguments_of_the_function():
    for function, node in typed_functions():
        if isinstance(function, property):
            continue
        function = getattr(function, "__func__", function)
        told = [argument.arg for argument in (*node.args.args, *node.args.kwonlyargs)]
        taken = [p.name for p in inspect.signature(function).parameters.values() if p.kind is not p.VAR_KEYWORD]
        assert told == taken, node.name


def test_every_public_name_is_typed_and_documented():
    tree = ast.parse((ROOT / "python" / "moivre" / "__init__.pyi").read_text(encoding="utf-8"))
    typed = {node.name for node in tree.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
    for name in moivre.__all__:
        if name == "__version__":
            continue
        assert name in typed
        assert getattr(moivre, name).__doc__


@pytest.mark.parametrize("name", ["solve", "Result", "Root", "Family", "Closures", "Motion", "Sweep", "Sensitivity", "Guesses",
                                  "Mobility", "Mechanism", "Arm", "ParseError"])
def test_what_users_call_has_an_example(name):
    assert ">>>" in getattr(moivre, name).__doc__
