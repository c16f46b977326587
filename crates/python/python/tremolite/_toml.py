"""Python's values as the TOML of a case."""

from __future__ import annotations

import json
import math
import os
from collections.abc import Mapping
from typing import Any

import numpy as np

from ._tremolite import Error

_BARE = frozenset("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-")


def document(case: Mapping[str, Any]) -> str:
    """The text of a case: a table a section, so that messages can name a line."""
    lines: list[str] = []
    _table(lines, "", case)
    return "\n".join(lines).lstrip("\n") + "\n"


def value(given: Any, key: str) -> str:
    """One value, on one line. `key` is what messages call it."""
    if isinstance(given, (bool, np.bool_)):
        return "true" if given else "false"
    if isinstance(given, (int, np.integer)):
        return str(int(given))
    if isinstance(given, (float, np.floating)):
        number = float(given)
        return repr(number) if math.isfinite(number) else {"inf": "inf", "-inf": "-inf"}.get(repr(number), "nan")
    if isinstance(given, os.PathLike):
        given = os.fspath(given)
    if isinstance(given, str):
        if any("\ud800" <= character <= "\udfff" for character in given):
            raise Error(f"{key} holds half a character (a surrogate); decode the text it comes from")
        # JSON's escapes are TOML's, but for those of half characters, which no case has.
        return json.dumps(given, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(given, Mapping):
        entries = ", ".join(f"{_key(name)} = {value(one, f'{key}.{name}')}" for name, one in given.items())
        return f"{{ {entries} }}" if entries else "{}"
    if isinstance(given, np.ndarray):
        given = given.tolist()
        if not isinstance(given, list):
            return value(given, key)
    if isinstance(given, (list, tuple)):
        return "[" + ", ".join(value(one, f"{key}[{n}]") for n, one in enumerate(given)) + "]"
    if given is None:
        raise Error(f"{key} is None; leave the key out, so that it takes its default")
    raise Error(f"{key} is a {type(given).__name__}; a case holds texts, numbers, truths, lists and dicts")


def _key(name: Any) -> str:
    if not isinstance(name, str):
        raise Error(f"the key {name!r} is no text; keys of a case are texts")
    return name if name and set(name) <= _BARE else value(name, name)


def _tables(given: Any) -> bool:
    """Whether a value is a list of tables, each of which has a section of its own."""
    return isinstance(given, (list, tuple)) and len(given) > 0 and all(isinstance(one, Mapping) for one in given)


def _table(lines: list[str], path: str, table: Mapping[str, Any]) -> None:
    # What stands below a header belongs to it: plain values come first.
    sections = {name: one for name, one in table.items() if isinstance(one, Mapping) or _tables(one)}
    for name, one in table.items():
        if name not in sections:
            lines.append(f"{_key(name)} = {value(one, f'{path}.{name}' if path else name)}")
    for name, one in sections.items():
        below = f"{path}.{_key(name)}" if path else _key(name)
        for entry in [one] if isinstance(one, Mapping) else one:
            if not isinstance(one, Mapping):
                lines += ["", f"[[{below}]]"]
            elif not entry or not all(isinstance(under, Mapping) for under in entry.values()):
                lines += ["", f"[{below}]"]
            _table(lines, below, entry)
