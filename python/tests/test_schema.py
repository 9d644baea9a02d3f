# SPDX-License-Identifier: MIT
# Does the JSON of every command keep to docs/schema, and would a broken one be refused? Of the program, of the docs, of the module.
import concurrent.futures
import copy
import json
import os
import re
import subprocess

import pytest
from conftest import PROBLEMS, ROOT

import moivre

jsonschema = pytest.importorskip("jsonschema")

SCHEMA = ROOT / "docs" / "schema"
# As many results as are wanted at least, of each command some.
WANTED = 300
# What takes longer than a fifth of a second, and shows nothing that others do not.
LONG = {"general-6r", "dietmaier", "griffis-duffy", "7r-loop", "snu-3-upu", "delta", "octahedral-3-3", "hexapod", "manseur-doty"}
SYSTEMS = ["puma", "cassou", "katsura-5", "cyclic-5", "multiplicity-3", "tangent-conics-2-3", "duplicated-equation", "double-lines-4",
           "wilkinson-15", "eco-5", "noon-3"]


def schema_of(name, strict):
    """One schema with what it takes from common.json. Strict: with no key that it does not name, as tests want and readers do not."""
    def tightened(node):
        if isinstance(node, list):
            return [tightened(part) for part in node]
        if not isinstance(node, dict):
            return node
        node = {key: tightened(part) for key, part in node.items()}
        return {"additionalProperties": False, **node} if "properties" in node and "anyOf" not in node else node

    text = (SCHEMA / f"{name}.json").read_text(encoding="utf-8").replace("common.json#", "#")
    schema = json.loads(text)
    common = json.loads((SCHEMA / "common.json").read_text(encoding="utf-8"))["$defs"]
    own = schema.setdefault("$defs", {})
    assert not set(own) & set(common), f"{name}: a name stands in common.json too"
    own.update(common)
    return tightened(schema) if strict else schema


VALIDATORS = {}


def validator(name, strict=True):
    if (name, strict) not in VALIDATORS:
        kind = getattr(jsonschema, "Draft202012Validator", jsonschema.Draft7Validator)
        schema = schema_of(name, strict)
        kind.check_schema(schema)
        VALIDATORS[name, strict] = kind(schema)
    return VALIDATORS[name, strict]


def name_of(report):
    """The schema of a result."""
    command = report["command"]
    if command == "closures" and "robot" in report:
        return "closures-robot"
    return "family-learn" if command == "family info" else command.replace(" ", "-")


def faults(report):
    """A robot's closures are of two forms that share their keys: what is not named there cannot be refused."""
    name = name_of(report)
    return [f"{name} {'.'.join(map(str, error.absolute_path))}: {error.message[:200]}"
            for error in validator(name, strict=name != "closures-robot").iter_errors(report)]


def calls(folder):
    """The calls of the program, but those that need another's result."""
    mechanisms = [path for path in sorted((PROBLEMS / "mechanisms").glob("*.toml")) if path.stem not in LONG]
    for path in mechanisms:
        yield from ([command, path] for command in ("mobility", "newton"))
        yield from ([command, path, "--tracker", "lanes"] for command in ("closures", "guesses"))
    for name in ("four-bar", "slider-crank", "parallelogram", "double-parallel-crank", "five-bar", "gear-five-bar"):
        path = PROBLEMS / "mechanisms" / f"{name}.toml"
        yield ["motion", path, "--steps", 4]
        yield ["motion", path, "--steps", 3, "--columns", "all"]
        yield ["closures", path, "--sensitivity", "--tolerance", "0.01"]
    yield ["motion", PROBLEMS / "mechanisms" / "four-bar.toml", "--steps", 3, "--from-guess"]
    for path in sorted((PROBLEMS / "polynomials").glob("*.phc")):
        yield ["info", path]
    for name in SYSTEMS:
        path = PROBLEMS / "polynomials" / f"{name}.phc"
        yield ["solve", path, "--tracker", "lanes", "--seed", 2]
        yield ["track", path, "--path", 0]
    puma = PROBLEMS / "polynomials" / "puma.phc"
    yield ["solve", puma, "--cross-check", "--digits", 20]
    yield ["solve", puma, "--no-certify", "--real"]
    yield ["study", PROBLEMS / "polynomials" / "noon-3.phc", "--settings", "lanes", "--tolerances", "1e-2", "--seeds", 1]
    yield ["closures", PROBLEMS / "robots" / "puma560.urdf", "--pose", "0.4 -0.2 0.3 0.5 0.5 0.5 0.5", "--tracker", "lanes"]
    poses = folder / "poses.csv"
    poses.write_text("0.4,-0.2,0.3,0.5,0.5,0.5,0.5\n9,9,9,1,0,0,0\n", encoding="utf-8")
    yield ["closures", PROBLEMS / "robots" / "ur5.urdf", "--tip", "tool0", "--poses", poses, "--tracker", "lanes"]
    four_bar = PROBLEMS / "mechanisms" / "four-bar.toml"
    yield ["sweep", four_bar, "--vary", "crank.B.x=10:150:20"]
    yield ["sweep", four_bar, "--vary", "crank.B.x=10:150:4", "--vary", "rocker.C.x=40:90:4"]


def stored():
    """Results in the documents."""
    page = (ROOT / "docs" / "json.md").read_text(encoding="utf-8")
    yield from (json.loads(block) for block in re.findall(r"```json\n(.*?)```", page, re.DOTALL))


def results(program, folder):
    """Of every call; a call that is refused has none."""
    def run(words):
        done = subprocess.run([program, *map(str, words), "--json", "-", "--quiet"], capture_output=True, text=True, check=False,
                              cwd=folder)
        return done.stdout if done.returncode in (0, 2) else None

    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        texts = [text for text in pool.map(run, calls(folder)) if text]
    for text in list(texts):
        if json.loads(text)["command"] == "solve":
            (folder / "solved.json").write_text(text, encoding="utf-8")
            texts.append(run(["check", json.loads(text)["file"], "solved.json"]))
    (folder / "wanted.phc").write_text("x^2 + y^2 = 5\nx*y = 2\nx > 0\nx*y <= 2\n", encoding="utf-8")
    texts += [run(["info", "wanted.phc"]), run(["solve", "wanted.phc", "--where", "x + y >= 3"])]
    (folder / "conics.phc").write_text("2 5\na*x^2 + b*x*y + y^2 - c;\nx^2 + y^2 - x - 1;\n", encoding="utf-8")
    (folder / "members.csv").write_text("a,b,c\n2,0.5,1.5\n1,0.5*i,2\n", encoding="utf-8")
    texts.append(run(["family", "learn", "conics.phc", "--parameters", "a,b,c", "-o", "conics.family"]))
    texts.append(run(["family", "info", "conics.family"]))
    texts.append(run(["family", "solve", "conics.family", "--at", "a=1,b=2,c=3"]))
    texts.append(run(["family", "solve", "conics.family", "--table", "members.csv"]))
    return [json.loads(text) for text in texts if text]


@pytest.fixture(scope="module")
def reports(tmp_path_factory):
    program = os.environ.get("MOIVRE")
    if not program:
        pytest.skip("the program was not built")
    return results(program, tmp_path_factory.mktemp("schema")) + list(stored())


def test_the_json_of_every_command_keeps_to_its_schema(reports):
    assert len(reports) >= WANTED, len(reports)
    seen = {name_of(report) for report in reports}
    assert seen == {path.stem for path in SCHEMA.glob("*.json")} - {"common", "mechanism-file"}
    found = [f"{report.get('file')}: {fault}" for report in reports for fault in faults(report)]
    assert not found, "\n".join(found[:20])


def test_the_module_keeps_to_the_schemas():
    system = ["x^2 + y^2 - 4", "x*y - 1"]
    for options in ({}, {"digits": 20}, {"certify": False}, {"tracker_options": {"maximum_steps": 1}}):
        assert not faults(json.loads(moivre.solve(system, **options).to_json()))
    four_bar = moivre.Mechanism(PROBLEMS / "mechanisms" / "four-bar.toml")
    for answer in (four_bar.closures(), four_bar.motion(steps=3), four_bar.mobility()):
        assert not faults(json.loads(answer.to_json()))


def broken_copies(report):
    """Each key left out, and each value of another type, down to the first element of every list."""
    def walk(node, path):
        items = node.items() if isinstance(node, dict) else enumerate(node[:1])
        for key, value in items:
            yield (*path, key), value
            if isinstance(value, (dict, list)):
                yield from walk(value, (*path, key))

    for path, value in walk(report, ()):
        copied = copy.deepcopy(report)
        place = copied
        for key in path[:-1]:
            place = place[key]
        place[path[-1]] = {"an": "object"} if not isinstance(value, dict) else "a text"
        yield ".".join(map(str, path)), copied


def test_a_broken_report_is_refused_as_those_read_it_who_take_new_keys(reports):
    wanted = {path.stem for path in SCHEMA.glob("*.json")} - {"common", "mechanism-file"}
    optional = {"solve": {"digits", "cross_check", "filtered", "on_denominators"}, "closures": {"dimensions"}, "motion": {"columns"}}
    for name in sorted(wanted):
        report = min((r for r in reports if name_of(r) == name), key=lambda r: len(json.dumps(r)))
        check = validator(name, strict=False)
        for key in report:
            lacking = {k: v for k, v in report.items() if k != key}
            is_optional = key in optional.get(name.replace("family-", ""), ()) or (name, key) == ("family-solve", "at")
            assert is_optional or not check.is_valid(lacking), f"{name}: {key} is missing"
        for path, broken in broken_copies(report):
            assert not check.is_valid(broken), f"{name}: {path} is of another type"
