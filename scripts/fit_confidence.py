#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Fits the tracker's confidence to the training sequences.

    graspdb eval DB --sequences sequences/train --alphas 0,2 --out DIR
    graspdb eval DB --sequences sequences/train --photoreal sequences/photoreal/train --alphas 0 --out PHOTO
    scripts/fit_confidence.py DIR PHOTO [--temporal kde]

The logistic curve 1 / (1 + exp((distance - half) / width)) of the nearest descriptor's distance that
makes most likely which answers are right, to 30 degrees of rotation; evaluations count alike, however
many answers they have. Prints half and width, as tracker/tracker.cpp has them, and how well the curve
fits what it was fitted to.
"""

import argparse
import pathlib

import numpy

from evaluation_tables import number, read_columns

RIGHT_DEG = 30
STEPS = 50  # of Newton's method, which needs about six


def curve(distance, half, width):
    return 1 / (1 + numpy.exp((distance - half) / width))


def fit(distance, right, weight):
    """(half, width) of greatest likelihood; `weight` is what an answer counts."""
    if right.all() or not right.any():
        raise SystemExit("fit_confidence.py: answers must be right and wrong, and all are the same")
    inputs = numpy.stack([numpy.ones_like(distance), distance], 1)
    weighted = inputs * weight[:, None]
    factors = numpy.zeros(2)
    for _ in range(STEPS):
        likely = 1 / (1 + numpy.exp(-inputs @ factors))
        spread = weighted * (likely * (1 - likely))[:, None]
        factors += numpy.linalg.solve(spread.T @ inputs, weighted.T @ (right - likely))
    if factors[1] >= 0:
        raise SystemExit("fit_confidence.py: nearer answers are not right more often")
    return -factors[0] / factors[1], -1 / factors[1]


def fit_alike(evaluations):
    """fit() where each evaluation, (distance, right), counts as much as any other."""
    weight = [numpy.full(len(right), 1 / len(right)) for _, right in evaluations]
    distance, right = zip(*evaluations)
    return fit(numpy.concatenate(distance), numpy.concatenate(right), numpy.concatenate(weight))


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
    parser.add_argument("directories", type=pathlib.Path, nargs="+", metavar="DIR")
    parser.add_argument("--temporal", default="kde")
    arguments = parser.parse_args()
    evaluations = [answers(directory, arguments.temporal) for directory in arguments.directories]
    half, width = fit_alike(evaluations)
    print(f"half {half:.2f}, width {width:.2f}: expected calibration error on the same answers")
    for directory, (distance, right) in zip(arguments.directories, evaluations):
        error = expected_error(curve(distance, half, width), right)
        print(f"{error:.3f} {directory}: {len(right)} answers, of which {right.mean():.0%} are right")


if __name__ == "__main__":
    main()
