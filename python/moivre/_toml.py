# SPDX-License-Identifier: MIT
# How is a dictionary written as a mechanism file? Same keys, same values; numbers as Python shows them.
"""Dictionaries as TOML, the text of mechanism files."""

import decimal
import json
import math
import numbers
import re

_BARE = re.compile(r"[A-Za-z0-9_-]+")


def _key(name):
    name = str(name)
    return name if _BARE.fullmatch(name) else json.dumps(name, ensure_ascii=False)


def _value(value, where):
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, (numbers.Real, decimal.Decimal)):
        if not math.isfinite(value):
            raise ValueError(f"{where}: {value} is not finite")
        # A Decimal keeps its digits; of a fraction the file has the nearest double.
        text = str(value) if isinstance(value, decimal.Decimal) else repr(float(value))
        return text if any(c in text for c in ".eE") else text + ".0"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_value(item, f"{where}[{k}]") for k, item in enumerate(value)) + "]"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{_key(k)} = {_value(v, f'{where}.{k}')}" for k, v in value.items()) + "}"
    if value is None:
        raise ValueError(f"{where}: None has no place in a mechanism file; leave the key out")
    raise ValueError(f"{where}: {type(value).__name__} has no place in a mechanism file")


def _is_table_list(value):
    return isinstance(value, (list, tuple)) and len(value) > 0 and all(isinstance(item, dict) for item in value)


def to_toml(table, path=()):
    """The text of the tables, values before tables as TOML wants them."""
    lines = []
    inner = []
    for key, value in table.items():
        here = (*path, str(key))
        if isinstance(value, dict):
            inner.append("[" + ".".join(map(_key, here)) + "]\n" + to_toml(value, here))
        elif _is_table_list(value):
            inner += ["[[" + ".".join(map(_key, here)) + "]]\n" + to_toml(item, here) for item in value]
        else:
            lines.append(f"{_key(key)} = {_value(value, '.'.join(here))}\n")
    return "".join(lines + inner)
