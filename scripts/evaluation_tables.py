# SPDX-License-Identifier: MIT
"""What scripts share that read the tables of `graspdb eval --out` (docs/evaluation.md)."""

import csv

import numpy

DRAWS = 10_000


def number(value):
    """null and an empty cell are values that do not apply."""
    return numpy.nan if value in (None, "") else float(value)


def read_columns(file):
    """A CSV file as lists of texts by column."""
    with open(file, newline="", encoding="utf-8") as text:
        lines = list(csv.DictReader(text))
    if not lines:
        raise SystemExit(f"{file}: no lines")
    return {name: [line[name] for line in lines] for name in lines[0]}


def clustered_interval(values, sequences):
    """95 % interval of the mean of values when sequences are drawn; none of a single sequence."""
    names, member = numpy.unique(sequences, return_inverse=True)
    if len(names) < 2:
        return numpy.nan, numpy.nan
    total = numpy.bincount(member, values)
    count = numpy.bincount(member)
    drawn = numpy.random.default_rng(0).integers(len(names), size=(DRAWS, len(names)))
    means = total[drawn].sum(1) / count[drawn].sum(1)
    return tuple(float(end) for end in numpy.percentile(means, (2.5, 97.5)))
