"""Discs in a box. Usage: simulation.py [discs] [seed] [frames, 0 = for ever]"""
import math
import random
import sys
import time

SIDE = 0.04
RADIUS = 5e-4
MASS = 1e-3
G = 9.81
KN = 5e4
DT = math.pi * math.sqrt(MASS / KN) / 20
STEPS_PER_FRAME = 40


class Disc:
    def __init__(self, x, y, vx, vy):
        self.x, self.y = x, y
        self.vx, self.vy = vx, vy
        self.fx, self.fy = 0.0, 0.0


def place(n):
    discs = []
    while len(discs) < n:
        x = random.uniform(RADIUS, SIDE - RADIUS)
        y = random.uniform(RADIUS, SIDE - RADIUS)
        if all(math.hypot(d.x - x, d.y - y) > 2 * RADIUS for d in discs):
            discs.append(Disc(x, y, random.gauss(0, 0.4), random.gauss(0, 0.4)))
    return discs


def wall(x):
    """Force of the two walls that face each other along one axis."""
    if x < RADIUS:
        return KN * (RADIUS - x)
    if x > SIDE - RADIUS:
        return KN * (SIDE - RADIUS - x)
    return 0.0


def collide(a, b):
    dx, dy = b.x - a.x, b.y - a.y
    d = math.hypot(dx, dy)
    if d < 2 * RADIUS:
        f = KN * (2 * RADIUS - d)
        a.fx -= f * dx / d
        a.fy -= f * dy / d
        b.fx += f * dx / d
        b.fy += f * dy / d


def step(discs):
    for d in discs:
        d.fx = wall(d.x)
        d.fy = wall(d.y) - MASS * G
    # from left to right: only neighbours in x can touch
    row = sorted(discs, key=lambda d: d.x)
    for i, a in enumerate(row):
        for b in row[i + 1:]:
            if b.x - a.x > 2 * RADIUS:
                break
            collide(a, b)
    for d in discs:
        d.vx += d.fx / MASS * DT
        d.vy += d.fy / MASS * DT
        d.x += d.vx * DT
        d.y += d.vy * DT


def write(discs):
    with open("out.txt", "w") as out:
        for d in discs:
            print(d.x, d.y, RADIUS, file=out)


def main():
    numbers = [int(a) for a in sys.argv[1:]] + [20, 1, 400][len(sys.argv) - 1:]
    n, seed, frames = numbers[:3]
    random.seed(seed)
    discs = place(n)
    frame = 0
    while frames == 0 or frame < frames:
        write(discs)
        frame += 1
        time.sleep(0.001)
        for _ in range(STEPS_PER_FRAME):
            step(discs)


main()
