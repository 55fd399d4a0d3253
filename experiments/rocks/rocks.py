#!/usr/bin/env python3
"""Writes tall.json, flat.json and leaning.json: the experiment of rock.json.in for three made-up rocks.

usage: rocks.py [FOLDER]
"""

import json
import os
import sys

# Distances of the left and of the right edge from the centre of mass, its height, and the radius of gyration about it [m].
ROCKS = {
    "tall": ([0.22, 0.34], 0.80, 0.48),
    "flat": ([0.36, 0.30], 0.75, 0.50),
    "leaning": ([0.45, 0.20], 0.60, 0.40),
}


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else "."
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "rock.json.in"), encoding="utf-8") as file:
        rock = json.load(file)
    for name, (edges, height, radius) in ROCKS.items():
        rock["title"] = name
        rock["block"] = {"edges_m": edges, "centre_height_m": height, "radius_of_gyration_m": radius}
        with open(os.path.join(folder, f"{name}.json"), "w", encoding="utf-8") as file:
            json.dump(rock, file, indent=2)


main()
