# SPDX-License-Identifier: MIT
# Is docs/schema/mechanism-file.json, by which editors complete, of the same mind as the reader?
import copy
import json
import re

import pytest
from conftest import PROBLEMS, ROOT

import moivre

jsonschema = pytest.importorskip("jsonschema")
tomllib = pytest.importorskip("tomllib")

KIND = getattr(jsonschema, "Draft202012Validator", jsonschema.Draft7Validator)
SCHEMA = json.loads((ROOT / "docs" / "schema" / "mechanism-file.json").read_text(encoding="utf-8"))
CHECK = KIND(SCHEMA)
# Side files of robots are no mechanisms.
FILES = [path for folder in (PROBLEMS, ROOT / "docs") for path in sorted(folder.rglob("*.toml")) if ".loops" not in path.name]


def read(path):
    return tomllib.loads(path.read_text(encoding="utf-8"))


def is_read(document):
    try:
        moivre.Mechanism(document)
    except ValueError:
        return False
    return True


def changed_copies(document):
    """Each key left out, each with a stray one beside it, and each value a truth."""
    def walk(node, path):
        items = list(node.items() if isinstance(node, dict) else enumerate(node))
        for key, value in items:
            yield (*path, key)
            if isinstance(value, (dict, list)):
                yield from walk(value, (*path, key))

    for path in walk(document, ()):
        for change in ("left out", "true"):
            copied = copy.deepcopy(document)
            place = copied
            for key in path[:-1]:
                place = place[key]
            if change == "true":
                place[path[-1]] = True
            else:
                del place[path[-1]]
            yield f"{'.'.join(map(str, path))} {change}", copied


def test_the_schema_is_one_and_takes_every_mechanism():
    KIND.check_schema(SCHEMA)
    assert len(FILES) > 60
    for path in FILES:
        found = [f"{list(error.absolute_path)}: {error.message[:200]}" for error in CHECK.iter_errors(read(path))]
        assert not found, f"{path.name}: {found}"


@pytest.mark.parametrize("name", ["four-bar", "gear-five-bar", "rack-steering", "cam-valve", "rssr", "slider-crank-equations"])
def test_what_the_schema_refuses_the_reader_refuses(name):
    document = read(PROBLEMS / "mechanisms" / f"{name}.toml")
    refused = [(what, copied) for what, copied in changed_copies(document) if not CHECK.is_valid(copied)]
    assert len(refused) > 10
    for what, copied in refused:
        assert not is_read(copied), what


RULES = {rule["if"]["properties"]["type"]["const"]: rule["then"] for rule in SCHEMA["$defs"]["joint"]["allOf"]}


def known_keys(joint):
    """Those that the reader names where it meets one that it does not know, in the plane and in space."""
    keys = set()
    for space in ("planar", "spatial"):
        with pytest.raises(ValueError) as refusal:
            moivre.Mechanism({"space": space, "body": {"a": {}}, "joint": [{"type": joint, "stray": "x"}]})
        named = re.search(r"unknown key 'stray' in a .* joint; known are (.*)", str(refusal.value))
        keys |= set(re.findall(r"'([^']+)'", named[1])) if named else set()
    return keys


def test_each_type_of_joint_has_the_keys_that_the_reader_knows():
    assert sorted(RULES) == sorted(SCHEMA["$defs"]["joint"]["properties"]["type"]["enum"])
    for joint, rule in RULES.items():
        assert known_keys(joint) == set(rule["propertyNames"]["enum"]), joint


def test_a_key_that_no_joint_has_and_a_type_that_there_is_not_are_refused():
    four_bar = read(PROBLEMS / "mechanisms" / "four-bar.toml")
    for key, value in (("stray", 1), ("type", "wheel")):
        document = copy.deepcopy(four_bar)
        document["joint"][0][key] = value
        assert not CHECK.is_valid(document)
