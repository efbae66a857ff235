#!/usr/bin/env python3
"""The answers to the exercises of docs/teaching.md that are about the scene four-particles, in one program.
    python3 exercises.py METHOD STEP [relative|axial|none [energy]] >mine.csv
METHOD: explicit-euler, symplectic-euler, leapfrog or rk4. STEP in s. The third word is the law of damping. With energy
the rows are t,kinetic,elastic,gravitational,sum in J instead of positions.
"""
import sys

METHODS = ("explicit-euler", "symplectic-euler", "leapfrog", "rk4")
try:
    METHOD, STEP = sys.argv[1], float(sys.argv[2])
    DAMPING = sys.argv[3] if len(sys.argv) > 3 else "relative"
    assert METHOD in METHODS and STEP > 0 and DAMPING in ("relative", "axial", "none")
except (IndexError, ValueError, AssertionError):
    sys.exit(__doc__)
ENERGY = len(sys.argv) > 4
DURATION, ROWS_EVERY = 8.0, 0.2  # s
MASS, SPACING, GRAVITY = 0.1, 0.5, 9.81  # kg, m, m/s2
KD = 0.0 if DAMPING == "none" else 0.02  # N s/m
DIAGONAL = SPACING * 2**0.5
# first end, second end, stiffness (N/m), rest length (m); the particle of column c and row r has the number 2 r + c
SPRINGS = [(0, 1, 10, SPACING), (2, 3, 10, SPACING), (0, 2, 10, SPACING), (1, 3, 10, SPACING),
           (0, 3, 5, DIAGONAL), (1, 2, 5, DIAGONAL)]
PINNED = {0, 1}


def minus(a, b):
    return [p - q for p, q in zip(a, b)]


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def accelerations(x, v):
    force = [[0.0, -MASS * GRAVITY, 0.0] for _ in x]
    for i, j, ks, rest in SPRINGS:
        along, apart = minus(x[i], x[j]), minus(v[i], v[j])
        length = dot(along, along) ** 0.5
        if DAMPING == "axial":  # only what changes the length
            share = dot(apart, along) / length**2
            apart = [share * a for a in along]
        for k in range(3):
            f = -ks * (length - rest) * along[k] / length - KD * apart[k]
            force[i][k] += f
            force[j][k] -= f
    return [[0.0] * 3 if i in PINNED else [f / MASS for f in one] for i, one in enumerate(force)]


def moved(x, h, v):
    return [[a + h * b for a, b in zip(one, by)] for one, by in zip(x, v)]


# One step of h seconds each: from positions, velocities and what the step before has kept to the same at its end.
def explicit_euler(x, v, h, _):
    return moved(x, h, v), moved(v, h, accelerations(x, v)), None


def symplectic_euler(x, v, h, _):
    v = moved(v, h, accelerations(x, v))
    return moved(x, h, v), v, None


def leapfrog(x, v, h, before):
    before = before or accelerations(x, v)
    half = moved(v, h / 2, before)
    x = moved(x, h, half)
    # The damping sees the velocity that is expected at the end of the step.
    a = accelerations(x, moved(half, h / 2, before))
    return x, moved(half, h / 2, a), a


def rk4(x, v, h, _):
    sum_x, sum_v, at_x, at_v, a = x, v, x, v, None
    for share, weight in ((0, 1 / 6), (0.5, 1 / 3), (0.5, 1 / 3), (1, 1 / 6)):
        if a:
            at_x, at_v = moved(x, share * h, at_v), moved(v, share * h, a)
        a = accelerations(at_x, at_v)
        sum_x, sum_v = moved(sum_x, weight * h, at_v), moved(sum_v, weight * h, a)
    return sum_x, sum_v, None


def energies(x, v):
    kinetic = sum(MASS * dot(one, one) / 2 for one in v)
    stretched = [(ks, dot(minus(x[i], x[j]), minus(x[i], x[j])) ** 0.5 - rest) for i, j, ks, rest in SPRINGS]
    elastic = sum(ks * by**2 / 2 for ks, by in stretched)
    gravitational = sum(MASS * GRAVITY * one[1] for one in x)
    return kinetic, elastic, gravitational, kinetic + elastic + gravitational


position = [[(c - 0.5) * SPACING, -r * SPACING, 0.0] for r in range(2) for c in range(2)]
position[2][0] -= 0.1  # the scene draws the lower left corner out before it begins
velocity, kept = [[0.0] * 3 for _ in position], None
step = {"explicit-euler": explicit_euler, "symplectic-euler": symplectic_euler, "leapfrog": leapfrog, "rk4": rk4}[METHOD]
print("t,kinetic,elastic,gravitational,sum" if ENERGY else "t,particle,x,y,z")
steps, every = round(DURATION / STEP), round(ROWS_EVERY / STEP)
for n in range(1, steps + 1):
    position, velocity, kept = step(position, velocity, STEP, kept)
    if n % every == 0 and ENERGY:
        print(f"{n * STEP:.9g}," + ",".join(f"{joules:.9g}" for joules in energies(position, velocity)))
    elif n % every == 0:
        for particle, at in enumerate(position):
            print(f"{n * STEP:.9g},{particle},{at[0]:.17g},{at[1]:.17g},{at[2]:.17g}")
