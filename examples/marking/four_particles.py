#!/usr/bin/env python3
"""The scene four-particles as a small program of one's own: leapfrog, the positions as CSV on standard output.
    python3 four_particles.py [STEP] >mine.csv && tyg check four-particles mine.csv --within 1mm
"""
import sys

STEP = float(sys.argv[1]) if len(sys.argv) > 1 else 0.002  # s
DURATION, ROWS_EVERY = 8.0, 0.1  # s
MASS, SPACING, GRAVITY = 0.1, 0.5, -9.81  # kg, m, m/s2
# first end, second end, stiffness (N/m), damping (N s/m), rest length (m)
STRUCTURAL, SHEAR = (10, 0.02, SPACING), (5, 0.02, SPACING * 2**0.5)
SPRINGS = [(0, 1, *STRUCTURAL), (2, 3, *STRUCTURAL), (0, 2, *STRUCTURAL), (1, 3, *STRUCTURAL), (0, 3, *SHEAR), (1, 2, *SHEAR)]
PINNED = {0, 1}

# Rows from the top, columns from the left: the particle of column c and row r has the number 2 r + c.
position = [[(c - 0.5) * SPACING, -r * SPACING, 0.0] for r in range(2) for c in range(2)]
position[2][0] -= 0.1  # the scene draws the lower left corner out before it begins
velocity = [[0.0] * 3 for _ in position]


def accelerations(x, v):
    force = [[0.0, MASS * GRAVITY, 0.0] for _ in x]
    for i, j, ks, kd, rest in SPRINGS:
        along = [a - b for a, b in zip(x[i], x[j])]
        length = sum(a * a for a in along) ** 0.5
        for k in range(3):
            f = -ks * (length - rest) * along[k] / length - kd * (v[i][k] - v[j][k])
            force[i][k] += f
            force[j][k] -= f
    return [[0.0] * 3 if i in PINNED else [f / MASS for f in one] for i, one in enumerate(force)]


def moved(x, h, v):
    return [[a + h * b for a, b in zip(one, by)] for one, by in zip(x, v)]


print("t,particle,x,y,z")
acceleration = accelerations(position, velocity)
steps, every = round(DURATION / STEP), round(ROWS_EVERY / STEP)
for step in range(1, steps + 1):
    half = moved(velocity, STEP / 2, acceleration)
    position = moved(position, STEP, half)
    # The damping sees the velocity that is expected at the end of the step.
    acceleration = accelerations(position, moved(half, STEP / 2, acceleration))
    velocity = moved(half, STEP / 2, acceleration)
    if step % every == 0:
        for particle, at in enumerate(position):
            print(f"{step * STEP:.9g},{particle},{at[0]:.17g},{at[1]:.17g},{at[2]:.17g}")
