"""Runs the code of notebooks, cell by cell, without Jupyter: `python docs/notebooks/run.py docs/notebooks/*.ipynb`."""

import json
import sys
import time
from pathlib import Path


def run(path: Path) -> None:
    """Runs one notebook; the last expression of a cell is not shown. What a cell raises comes through with its number."""
    names = {"__name__": "__main__"}
    for number, cell in enumerate(json.loads(path.read_text(encoding="utf-8"))["cells"], start=1):
        if cell["cell_type"] == "code":
            exec(compile("".join(cell["source"]), f"{path}, cell {number}", "exec"), names)


for name in sys.argv[1:]:
    begin = time.monotonic()
    run(Path(name))
    print(f"== {name}: {time.monotonic() - begin:.0f} s", flush=True)
