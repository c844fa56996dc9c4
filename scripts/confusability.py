#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Which types of grasp a database's descriptors confuse: a map (PNG) and its numbers (CSV).

    scripts/confusability.py hands.graspdb --out confusability.png

For rows of hands closed to 80 % or more (a seeded sample of --rows of each type) the --neighbours
nearest rows by descriptor are found, exactly, among all rows of any step, view, hand and variant
but those of the same grasp at the same step, which only show the very pose again. The map says what
share of them belongs to which type; on the diagonal are other steps of the row's own.
Needs matplotlib: scripts/install.sh python3-matplotlib
"""

import argparse
import csv
import pathlib
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "python"))
from graspdb_reader import Database  # pylint: disable=wrong-import-position

BLOCK = 16384  # rows of the database at a time
QUERIES = 512


def sample_rows(database, per_type, seed):
    """Rows closed to 80 % or more, at most per_type of each grasp, in ascending order."""
    columns = database.columns
    closed = numpy.flatnonzero(columns["step"].astype(int) * 5 >= database.steps * 4)
    random = numpy.random.default_rng(seed)
    chosen = []
    for grasp in sorted(database.grasps):
        rows = closed[columns["grasp"][closed] == grasp]
        chosen.append(random.choice(rows, min(per_type, len(rows)), replace=False))
    return numpy.sort(numpy.concatenate(chosen))


def pose_of(columns):
    """One number for each pair of grasp and step."""
    return columns["grasp"].astype(numpy.int64) * 256 + columns["step"]


def descriptors_of(columns):
    """What is searched: the codes of a learned descriptor where there are any."""
    return columns.get("embedding", columns["hog"])


def nearest_rows(database, queries, k):
    """[Q, k]: each query's nearest rows of another pose, ties to the smaller row number."""
    rows, pose = descriptors_of(database.columns), pose_of(database.columns)
    best = numpy.full((len(queries), k), numpy.iinfo(numpy.int64).max)
    for start in range(0, database.rows, BLOCK):
        block = slice(start, min(start + BLOCK, database.rows))
        for first in range(0, len(queries), QUERIES):
            part = slice(first, first + QUERIES)
            found = keys(rows, queries[part], block)
            found[pose[queries[part], None] == pose[None, block]] = numpy.iinfo(numpy.int64).max
            both = numpy.concatenate([best[part], found], axis=1)
            best[part] = numpy.partition(both, k - 1, axis=1)[:, :k]
    if (best == numpy.iinfo(numpy.int64).max).any():
        raise SystemExit(f"fewer than {k} rows of other poses")
    return numpy.sort(best, axis=1) % (1 << 32)


def keys(rows, queries, block):
    """Squared distance and row number in one whole number, so that its order is theirs.

    Sums of products of bytes below 2^24 are whole numbers that single precision holds exactly.
    """
    a, b = rows[queries].astype(numpy.float64), rows[block].astype(numpy.float64)
    squares_a, squares_b = (a * a).sum(1), (b * b).sum(1)
    if max(squares_a.max(), squares_b.max()) < 1 << 24:
        a, b = a.astype(numpy.float32), b.astype(numpy.float32)
    distance = squares_a[:, None] + squares_b - 2 * (a @ b.T).astype(numpy.float64)
    return (distance.astype(numpy.int64) << 32) + numpy.arange(block.start, block.stop)


def confusion(database, queries, nearest):
    """[G, G]: of the rows nearest to those of grasp i, the share that is of grasp j."""
    grasps = sorted(database.grasps)
    ordinal = numpy.searchsorted(grasps, database.columns["grasp"])
    counts = numpy.zeros((len(grasps), len(grasps)))
    numpy.add.at(counts, (ordinal[queries][:, None], ordinal[nearest]), 1)
    return counts / counts.sum(1, keepdims=True)


def similar_together(shares):
    """An order in which what is confused lies side by side: average linkage, fitting ends joined."""
    likeness = (shares + shares.T) / 2
    chains = [[i] for i in range(len(shares))]
    while len(chains) > 1:
        pairs = [(i, j) for i in range(len(chains)) for j in range(i)]
        i, j = max(pairs, key=lambda p: likeness[numpy.ix_(chains[p[0]], chains[p[1]])].mean())
        a, b = chains[j], chains[i]
        joints = [(x, y) for x in (a, a[::-1]) for y in (b, b[::-1])]
        x, y = max(joints, key=lambda joint: likeness[joint[0][-1], joint[1][0]])
        chains = [c for n, c in enumerate(chains) if n not in (i, j)] + [x + y]
    return chains[0]


def write_csv(file, database, shares, rows):
    """A line a type in the order of their numbers; a column a type that nearest rows belong to."""
    grasps = sorted(database.grasps)
    with open(file, "w", newline="") as out:
        writer = csv.writer(out)
        writer.writerow(["grasp", "name", "rows", *grasps])
        for grasp, line, count in zip(grasps, shares, rows):
            writer.writerow([grasp, database.grasps[grasp], count, *(f"{s:.5f}" for s in line)])


def draw(file, database, shares, title):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    order = similar_together(shares)
    grasps = [sorted(database.grasps)[i] for i in order]
    percent = 100 * shares[numpy.ix_(order, order)]
    figure, axes = plt.subplots(figsize=(max(6.6, 3.4 + 0.27 * len(order)), 1.6 + 0.27 * len(order)),
                                layout="constrained")
    picture = axes.imshow(percent, cmap="cividis", vmin=0)
    for i, j in zip(*numpy.nonzero(percent >= 4.5)):
        colour = "black" if percent[i, j] > percent.max() / 2 else "white"
        axes.text(j, i, f"{percent[i, j]:.0f}", ha="center", va="center", color=colour, fontsize=7)
    axes.set_xticks(range(len(order)), grasps, fontsize=8)
    names = [f"{database.grasps[g]}  {g}" for g in grasps]
    axes.set_yticks(range(len(order)), names, fontsize=8)
    axes.set(xlabel="type of the nearest rows", ylabel="type of the row")
    figure.suptitle(title, fontsize=9)
    figure.colorbar(picture, label="share of nearest rows (%)", shrink=0.6)
    figure.savefig(file, dpi=130)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("database")
    parser.add_argument("--out", type=pathlib.Path, required=True,
                        help="the picture; its numbers go beside it as .csv")
    parser.add_argument("--rows", type=int, default=100, help="sampled of each type [100]")
    parser.add_argument("-k", "--neighbours", type=int, default=20, help="nearest rows [20]")
    parser.add_argument("--seed", type=int, default=0, help="of the sample [0]")
    arguments = parser.parse_args()
    database = Database(arguments.database)
    queries = sample_rows(database, arguments.rows, arguments.seed)
    shares = confusion(database, queries, nearest_rows(database, queries, arguments.neighbours))
    found = database.columns["grasp"][queries]
    per_type = [int((found == g).sum()) for g in sorted(database.grasps)]
    write_csv(arguments.out.with_suffix(".csv"), database, shares, per_type)
    title = (f"{arguments.neighbours} nearest of {database.rows} rows, the row's own pose left out; "
             f"{len(queries)} rows asked for.\n"
             f"By chance a type would have about {100 / len(shares):.1f} %. No number: under 4.5 %.")
    draw(arguments.out, database, shares, title)
    print(f"of the row's own type: {100 * numpy.trace(shares) / len(shares):.1f} %")


if __name__ == "__main__":
    main()
