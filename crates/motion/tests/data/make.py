"""Records by writers of others: SAC, miniSEED, StationXML (ObsPy 1.5), and files that are named, not read (SciPy 1.17, h5py 3.16, NumPy).

`python3 make.py` writes them beside this script, and `others.csv` with the figures that ObsPy reads back.
"""
from pathlib import Path

import h5py
import numpy as np
import scipy.io
from obspy import Stream, Trace, UTCDateTime, read
from obspy.core.inventory import Channel, Inventory, Network, Response, Station
from obspy.core.inventory.response import InstrumentSensitivity

here = Path(__file__).parent
n, dt = 300, 0.01
t = np.arange(n) * dt
wave = 2.0e4 * np.sin(2 * np.pi * 1.7 * t) * np.exp(-((t - 1.5) ** 2)) + 137.0
start = UTCDateTime(2015, 3, 4, 5, 6, 7, 250000)
head = {"network": "XX", "station": "TEST", "channel": "HN1", "delta": dt, "starttime": start}


def channel(code, azimuth, dip, value, since, until, unit="M/S**2"):
    response = Response(instrument_sensitivity=InstrumentSensitivity(value, 1.0, unit, "COUNTS"))
    at = {"latitude": 30.0, "longitude": 103.0, "elevation": 10.0, "depth": 0.0, "location_code": ""}
    return Channel(code, azimuth=azimuth, dip=dip, response=response, start_date=since, end_date=until, **at)


Trace(wave.astype(np.float32), head | {"sac": {"cmpaz": 120.0, "cmpinc": 90.0}}).write(str(here / "obspy.sac"), "SAC", byteorder=">")
turn = UTCDateTime(2014, 1, 1)
change = start + 1.0
channels = [
    channel("HN1", 10.0, 0.0, 1.0e5, UTCDateTime(2000, 1, 1), turn),
    channel("HN1", 120.0, 0.0, 2.0e5, turn, UTCDateTime(2599, 12, 31)),
    channel("HN2", 210.0, 0.0, 2.0e5, turn, change),
    channel("HN2", 210.0, 0.0, 4.0e5, change, None),
    channel("HNZ", 0.0, 90.0, 2.0e5, turn, None),
    channel("HHZ", 0.0, -90.0, 6.0e8, turn, None, "M/S"),
]
station = Station("TEST", 30.0, 103.0, 10.0, channels=channels, creation_date=turn)
Inventory([Network("XX", [station])], source="make.py").write(str(here / "obspy.xml"), "STATIONXML")
counts = np.round(wave).astype(np.int32)
for code in ["HN1", "HN2", "HNZ", "HHZ"]:
    Stream([Trace(counts, head | {"channel": code})]).write(str(here / f"obspy_{code}.mseed"), "MSEED", encoding="STEIM2", reclen=512)

np.save(here / "numpy.npy", wave[:20])
scipy.io.savemat(here / "scipy.mat", {"acceleration": wave[:20]})
with h5py.File(here / "h5py.h5", "w") as file:
    file["acceleration"] = wave[:20]

rows = ["file,points,interval_s,peak,index,azimuth_deg,counts_per_m_s2"]
for name, azimuth, factor in [("obspy.sac", 120, 1.0), ("obspy_HN1.mseed", 120, 2.0e5)]:
    trace = read(str(here / name))[0]
    x = trace.data.astype(float)
    k = int(np.argmax(np.abs(x)))
    rows.append(f"{name},{len(x)},{trace.stats.delta:.6g},{float(x[k])!r},{k},{azimuth},{factor}")
(here / "others.csv").write_text("\n".join(rows) + "\n")
