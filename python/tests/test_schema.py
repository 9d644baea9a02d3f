# SPDX-License-Identifier: MIT
# Does the JSON of solve and closures keep to docs/schema, and would a broken one be refused?
import copy
import json

import pytest
from conftest import PROBLEMS, ROOT

import moivre

jsonschema = pytest.importorskip("jsonschema")

SYSTEMS = ["puma", "cassou", "katsura-5", "cyclic-5", "multiplicity-3", "tangent-conics-2-3", "duplicated-equation", "double-lines-4",
           "wilkinson-15", "eco-5", "noon-3"]
MECHANISMS = sorted(path.stem for path in (PROBLEMS / "mechanisms").glob("*.toml"))[:40]


def validator(name):
    schema = json.loads((ROOT / "docs" / "schema" / f"{name}.json").read_text(encoding="utf-8"))
    kind = getattr(jsonschema, "Draft202012Validator", jsonschema.Draft7Validator)
    kind.check_schema(schema)
    return kind(schema)


def solved(name):
    return json.loads(moivre.solve(PROBLEMS / "polynomials" / f"{name}.phc", tracker="lanes").to_json())


@pytest.mark.parametrize("name", SYSTEMS)
def test_a_solve_keeps_to_its_schema(name):
    validator("solve").validate(solved(name))


def test_digits_and_failures_keep_to_the_schema():
    system = ["x^2 + y^2 - 4", "x*y - 1"]
    for options in ({"digits": 20}, {"certify": False}, {"tracker_options": {"maximum_steps": 1}}):
        validator("solve").validate(json.loads(moivre.solve(system, **options).to_json()))


@pytest.mark.parametrize("name", MECHANISMS)
def test_closures_keep_to_their_schema(name):
    try:
        found = moivre.Mechanism(PROBLEMS / "mechanisms" / f"{name}.toml").closures(tracker="lanes")
    except ValueError as refusal:
        pytest.skip(str(refusal))
    validator("closures").validate(json.loads(found.to_json()))


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


def test_a_broken_report_is_refused():
    report = solved("puma")
    check = validator("solve")
    for key in report:
        lacking = {k: v for k, v in report.items() if k != key}
        assert not check.is_valid(lacking), f"{key} is missing"
    for path, broken in broken_copies(report):
        assert not check.is_valid(broken), f"{path} is of another type"
