"""Points, interval and peak of records of five networks, by the words of their headers.

A reading that shares nothing with the readers of the crate: `python3 independent.py > independent.csv`.
"""
import re
from pathlib import Path

here = Path(__file__).parent
F = r"[-+]?\d*\.\d*(?:[eE][-+]?\d+)?"


def show(name, series, dt, unit):
    for k, x in enumerate(series):
        print(name, k, len(x), f"{dt:.6g}", repr(max(x, key=abs) * unit), sep=",")


def text(name):
    return (here / name).read_text().replace("\r", "")


print("file,component,points,interval_s,peak_m_s2")
name = "china_csmnc_eight_values_a_line.dat"
head, body = text(name).split("\nTEST\n\n")
show(name, [[float(w) for w in body.split()]], float(re.search(r"OF:\s+([\d.]+)", head)[1]), 0.01)
name = "iran_bhrc_three_components.V1"
parts = re.split(r"COMP [LVT]1", text(name))[1:]
n, t = (float(re.search(k + r"\s*=\s*([\d.]+)", parts[0])[1]) for k in ("POINTS", "DURATION"))
show(name, [[float(w) for w in re.findall(F, p.split("G/10")[1])[50:]] for p in parts], t / n, 0.1 * 9.80665)
for name, mark, dt, skip in [
    ("turkey_afad_three_columns.txt", "U-D\n", r"INTERVAL \(sec\) : ([\d.]+)", 0),
    ("taiwan_cwb_four_columns.dat", "4F10.3 \n", r"SampleRate\(Hz\): (\d+)", 1),
    ("mexico_asa2_three_columns.101", "-" * 80 + "\n", r"muestras/s\)\s+: /(\d+)", 0),
]:
    head, body = text(name).rsplit(mark, 1)
    x = float(re.search(dt, head)[1])
    rows = [[float(w) for w in line.split()] for line in body.splitlines()]
    show(name, list(zip(*rows))[skip:], x if x < 1 else 1 / x, 0.01)
