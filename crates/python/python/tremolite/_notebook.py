"""How cases and results look in a notebook."""

from __future__ import annotations

from html import escape
from typing import Any


def table(head: list[str], rows: list[list[Any]]) -> str:
    """An HTML table."""
    return "<table>" + _row(head, "th") + "".join(_row(row, "td") for row in rows) + "</table>"


def _row(cells: list[Any], tag: str) -> str:
    return "<tr>" + "".join(f"<{tag}>{escape(str(cell))}</{tag}>" for cell in cells) + "</tr>"


def case(case: Any) -> str:
    """Title, materials with their groups, and stages of a case."""
    keys = case.to_dict()
    groups: dict[str, list[str]] = {}
    for region in keys.get("region", []):
        groups.setdefault(region.get("material", ""), []).extend(region.get("groups", []))
    materials = [[name, material.get("law", ""), ", ".join(groups.get(name, []))] for name, material in keys.get("material", {}).items()]
    html = f"<b>{escape(case.title)}</b>" + table(["material", "law", "groups"], materials)
    stages = [[stage.get("name", ""), _words(stage.get("excavate")), _words(stage.get("install"))] for stage in keys.get("stage", [])]
    if stages:
        html += table(["stage", "excavates", "installs"], stages)
    motion = keys.get("motion")
    return html + (f"<p>motion: {escape(str(motion.get('kind', '')))}</p>" if motion else "<p>no earthquake</p>")


def result(result: Any) -> str:
    """Verdict, checks that failed, and the page of a result."""
    html = f"<b>{escape(result.title)}</b> ({escape(result.status)})<p>{escape(result.verdict)}</p>"
    failed = [[line.name, line.value, line.limit, line.unit] for line in result.checks.failed]
    if failed:
        html += table(["check that failed", "value", "limit", "unit"], failed)
    return html + f"<p>{escape(str(result.path / 'report.html'))}</p>"


def _words(names: Any) -> str:
    return ", ".join(names) if isinstance(names, list) else str(names or "")
