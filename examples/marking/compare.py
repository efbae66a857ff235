#!/usr/bin/env python3
"""How far two motions are apart, without Tyg: the RMS distance over the particles at every time that both files hold.
    tyg reference four-particles --samples 80 --out reference.csv
    python3 compare.py mine.csv reference.csv
"""
import csv
import sys


def positions(path):
    """By time in microseconds, then by particle."""
    motion = {}
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            at = [float(row[axis]) for axis in "xyz"]
            motion.setdefault(round(1e6 * float(row["t"])), {})[int(row["particle"])] = at
    return motion


mine, exact = positions(sys.argv[1]), positions(sys.argv[2])
common = sorted(set(mine) & set(exact))
if not common:
    sys.exit("the two files have no time in common")
largest = 0.0
for time in common:
    squares = [sum((a - b) ** 2 for a, b in zip(mine[time][i], exact[time][i])) for i in exact[time]]
    error = (sum(squares) / len(squares)) ** 0.5
    largest = max(largest, error)
    print(f"{time / 1e6:g} s: {error:.3g} m")
print(f"largest: {largest:.3g} m")
