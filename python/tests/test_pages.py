# SPDX-License-Identifier: MIT
# Do the blocks of docs/python.md run, one after another, and do the types that are told exist?
import ast
import inspect
import os
import re

import pytest
from conftest import ROOT

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
