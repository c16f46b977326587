"""summary.json as objects."""

from __future__ import annotations

import keyword
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any


class Record(Mapping[str, Any]):
    """A JSON object whose fields are attributes as well: `summary.model.elements`, `summary["model"]["elements"]`."""

    def __init__(self, fields: Mapping[str, Any]) -> None:
        self._fields = dict(fields)

    def __getitem__(self, name: str) -> Any:
        return _object(self._fields[name])

    def __getattr__(self, name: str) -> Any:
        # Copies and pickles ask for what is not set yet.
        if name.startswith("_"):
            raise AttributeError(name)
        # A word of Python's own takes an underscore: `class_`.
        bare = name.removesuffix("_")
        try:
            return self[bare if keyword.iskeyword(bare) else name]
        except KeyError:
            raise AttributeError(f"there is no {name!r}; there are {', '.join(self._fields)}") from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._fields)

    def __len__(self) -> int:
        return len(self._fields)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._fields]

    def __repr__(self) -> str:
        return f"Record({self._fields!r})"

    def to_dict(self) -> dict[str, Any]:
        """The object as plain dicts and lists."""
        return self._fields


def _object(value: Any) -> Any:
    if isinstance(value, dict):
        return Record(value)
    if isinstance(value, list):
        return [_object(one) for one in value]
    return value


class Checks(Sequence[Record]):
    """The checks of a run: each has id, name, value, limit, unit, pass_ and note."""

    def __init__(self, lines: Iterable[Mapping[str, Any]]) -> None:
        # `pass` is a word of Python's.
        self._lines = [Record({**line, "pass_": line.get("pass")}) for line in lines]

    def __getitem__(self, at: Any) -> Any:
        if isinstance(at, str):
            for line in self._lines:
                if line["id"] == at:
                    return line
            raise KeyError(f"no check is called {at!r}; there are {', '.join(line['id'] for line in self._lines)}")
        return self._lines[at]

    def __len__(self) -> int:
        return len(self._lines)

    @property
    def failed(self) -> list[Record]:
        """Those that failed."""
        return [line for line in self._lines if not line["pass_"] and not line.get("not_applicable", False)]

    def __repr__(self) -> str:
        apply = [line for line in self._lines if not line.get("not_applicable", False)]
        return "\n".join([*map(_in_words, apply), f"{len(self._lines) - len(apply)} more do not apply"])


def _in_words(line: Record) -> str:
    passed = "ok  " if line["pass_"] else "FAIL"
    return f"{passed} {line['name']}: {line['value']:.3g} {line.get('unit', '')} (limit {line['limit']:g})"
