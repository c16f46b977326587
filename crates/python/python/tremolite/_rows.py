"""Rows of tables that hold words as well as numbers."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from typing import Any

#: Paths of keys have brackets of their own, so a unit stands behind a blank.
_HEAD = re.compile(r"(.*?)(?:\s+\[([^\[\]]*)\])?\s*")

#: As the program writes them; Python's float would take names such as "infinity" and "1_000" as well.
_NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?|NaN|-?inf")


def heads(line: Sequence[str]) -> dict[str, str]:
    """Name -> unit of the columns, empty where there is none."""
    found = [_HEAD.fullmatch(head.strip()) for head in line]
    return {head.group(1): head.group(2) or "" for head in found if head}


def rows(lines: Sequence[Sequence[str]], words: Collection[str]) -> list[dict[str, Any]]:
    """A dict a row. A column is one of numbers where every cell is a number or empty, which is NaN, and it is not among `words`: a name
    that looks like a number stays a name beside others that do not."""
    if not lines:
        return []
    names = list(heads(lines[0]))
    columns = list(zip(*(line for line in lines[1:] if len(line) == len(names)), strict=True))
    made: list[list[Any]] = []
    for name, cells in zip(names, columns, strict=bool(columns)):
        given = [cell.strip() for cell in cells if cell.strip()]
        numbers = name not in words and all(_NUMBER.fullmatch(cell) for cell in given)
        made.append([float(cell) if cell.strip() else float("nan") for cell in cells] if numbers else list(cells))
    return [dict(zip(names, row, strict=True)) for row in zip(*made, strict=True)]
