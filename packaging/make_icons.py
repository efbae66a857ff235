#!/usr/bin/env python3
# Draws Tyg's icon: a sheet of particles and springs that hangs from two pins. Writes packaging/tyg.svg and, with
# rsvg-convert (librsvg2-bin), tyg-48.png, tyg-128.png and tyg-256.png beside it, and tyg.ico for Windows.
#   packaging/make_icons.py
import math
import pathlib
import struct
import subprocess

COLUMNS, ROWS = 7, 7
FOLDER = pathlib.Path(__file__).resolve().parent


def particle(column, row):
    """Where it is in a picture of 256 x 256: the top edge sags between the pins, the hem is narrower and waves."""
    across, down = column / (COLUMNS - 1), row / (ROWS - 1)
    sag = 44 * math.sin(math.pi * across) * (1 - 0.45 * down)
    x = 128 + (across - 0.5) * (176 - 34 * math.sin(math.pi * down / 2)) + 9 * down * math.sin(2.2 * math.pi * across + 2)
    return x, 46 + 142 * down + sag + 7 * down * math.cos(3 * math.pi * across)


def path(points):
    return "M" + " L".join(f"{x:.1f} {y:.1f}" for x, y in points)


def svg():
    rows = [[particle(column, row) for column in range(COLUMNS)] for row in range(ROWS)]
    columns = [list(column) for column in zip(*rows)]
    cells = []
    for row in range(ROWS - 1):
        for column in range(COLUMNS - 1):
            corners = [rows[row][column], rows[row][column + 1], rows[row + 1][column + 1], rows[row + 1][column]]
            light = 0.72 + 0.28 * math.cos(2.2 * math.pi * (column + 0.5) / (COLUMNS - 1) + 0.5)
            colour = "#%02x%02x%02x" % tuple(round(light * part) for part in (0x6f, 0xb2, 0xe2))
            cells.append(f'<path d="{path(corners)} Z" fill="{colour}" stroke="{colour}"/>')
    springs = " ".join(path(line) for line in rows + columns)
    pins = "".join(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="13" fill="#ff7a1f"/>' for x, y in (rows[0][0], rows[0][-1]))
    return ('<svg xmlns="http://www.w3.org/2000/svg" width="256" height="256" viewBox="0 0 256 256">\n'
            '<rect x="4" y="4" width="248" height="248" rx="52" fill="#14181f"/>\n' + "\n".join(cells) +
            f'\n<path d="{springs}" fill="none" stroke="#10202e" stroke-width="3" stroke-linejoin="round"/>\n{pins}\n</svg>\n')


def ico(pngs):
    """Pictures in PNG behind a table of where they are."""
    head, bodies, offset = struct.pack("<HHH", 0, 1, len(pngs)), b"", 6 + 16 * len(pngs)
    for size, png in pngs:
        head += struct.pack("<BBBBHHII", size % 256, size % 256, 0, 0, 1, 32, len(png), offset)
        bodies, offset = bodies + png, offset + len(png)
    return head + bodies


if __name__ == "__main__":
    (FOLDER / "tyg.svg").write_text(svg(), encoding="utf-8")
    made = []
    for size in (48, 128, 256):
        file = FOLDER / f"tyg-{size}.png"
        subprocess.run(["rsvg-convert", "-w", str(size), "-o", file, FOLDER / "tyg.svg"], check=True)
        made.append((size, file.read_bytes()))
    (FOLDER / "tyg.ico").write_bytes(ico(made))
