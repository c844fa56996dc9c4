#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Fits the tracker's confidence to the training sequences.

    graspdb eval DB --sequences sequences/train --alphas 0,2 --out DIR
    scripts/fit_confidence.py DIR [--temporal kde]

The logistic curve 1 / (1 + exp((distance - half) / width)) of the nearest descriptor's distance that
makes most likely which answers are right, to 30 degrees of rotation. Prints half and width, as
tracker/tracker.cpp has them, and how well the curve fits what it was fitted to.
"""

import argparse
import pathlib

import numpy

from evaluation_tables import number, read_columns

RIGHT_DEG = 30
STEPS = 50  # of Newton's method, which needs about six


def curve(distance, half, width):
    return 1 / (1 + numpy.exp((distance - half) / width))


def fit(distance, right):
    """(half, width) of greatest likelihood."""
    if right.all() or not right.any():
        raise SystemExit("fit_confidence.py: answers must be right and wrong, and all are the same")
    inputs = numpy.stack([numpy.ones_like(distance), distance], 1)
    factors = numpy.zeros(2)
    for _ in range(STEPS):
        likely = 1 / (1 + numpy.exp(-inputs @ factors))
        spread = inputs * (likely * (1 - likely))[:, None]
        factors += numpy.linalg.solve(spread.T @ inputs, inputs.T @ (right - likely))
    if factors[1] >= 0:
        raise SystemExit("fit_confidence.py: nearer answers are not right more often")
    return -factors[0] / factors[1], -1 / factors[1]


def expected_error(confidence, right):
    """Of ten equal bins: the mean over answers of how far the bin's confidence is from the truth."""
    bins = numpy.minimum((confidence * 10).astype(int), 9)
    return sum(abs(confidence[bins == i].sum() - right[bins == i].sum())
               for i in range(10)) / len(right)


def answers(directory, temporal):
    """distance, and whether it was right, of every answer of the model, whatever the alpha."""
    columns = read_columns(directory / "frames.csv")
    rows = [(number(distance), number(rotation) <= RIGHT_DEG)
            for model, valid, distance, rotation in zip(
                columns["temporal"], columns["valid"], columns["distance"], columns["rotation_deg"])
            if model == temporal and valid == "1"]
    if not rows:
        raise SystemExit(f"{directory}/frames.csv: no answer of {temporal}")
    distance, right = zip(*rows)
    return numpy.array(distance), numpy.array(right)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("directory", type=pathlib.Path)
    parser.add_argument("--temporal", default="kde")
    arguments = parser.parse_args()
    distance, right = answers(arguments.directory, arguments.temporal)
    half, width = fit(distance, right)
    error = expected_error(curve(distance, half, width), right)
    print(f"half {half:.2f}, width {width:.2f}: expected calibration error {error:.3f} on the same "
          f"{len(right)} answers, of which {right.mean():.0%} are right")


if __name__ == "__main__":
    main()
