# SPDX-License-Identifier: MIT
"""The map of confused types, against plain loops over a small database."""
import sys
import types
import unittest
from pathlib import Path

import numpy

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
# pylint: disable=wrong-import-position
import confusability


def small_database(rows=300, low=0, top=256):
    random = numpy.random.default_rng(1)
    columns = {
        "hog": random.integers(low, top, (rows, 512), dtype="u1"),
        "grasp": random.choice(numpy.array([3, 7, 12], "<u2"), rows),
        "step": random.integers(1, 6, rows, dtype="u1"),
    }
    grasps = {3: "a", 7: "b", 12: "c"}
    return types.SimpleNamespace(columns=columns, rows=rows, grasps=grasps, steps=5)


def plain_nearest(database, row, k, column="hog"):
    codes = database.columns[column].astype(int)
    pose = list(zip(database.columns["grasp"], database.columns["step"]))
    others = [r for r in range(database.rows) if pose[r] != pose[row]]
    return sorted(others, key=lambda r: (((codes[r] - codes[row]) ** 2).sum(), r))[:k]


class Confusability(unittest.TestCase):
    def test_nearest_rows_are_those_of_a_plain_loop(self):
        for low, top in ((0, 256), (254, 256), (0, 2)):  # sums below 2^24, beyond it, and ties
            database = small_database(low=low, top=top)
            confusability.BLOCK, confusability.QUERIES = 64, 7
            queries = confusability.sample_rows(database, 10, 0)
            nearest = confusability.nearest_rows(database, queries, 5)
            for row, found in zip(queries, nearest):
                self.assertEqual(plain_nearest(database, row, 5), list(found))

    def test_codes_are_compared_where_there_are_any(self):
        database = small_database()
        database.columns["embedding"] = numpy.random.default_rng(2).integers(0, 256, (300, 64), dtype="u1")
        queries = confusability.sample_rows(database, 10, 0)
        nearest = confusability.nearest_rows(database, queries, 5)
        for row, found in zip(queries, nearest):
            self.assertEqual(plain_nearest(database, row, 5, "embedding"), list(found))

    def test_only_closed_hands_are_asked_for(self):
        database = small_database()
        queries = confusability.sample_rows(database, 10, 0)
        self.assertEqual({4, 5}, set(database.columns["step"][queries]))
        grasps, counts = numpy.unique(database.columns["grasp"][queries], return_counts=True)
        self.assertEqual([3, 7, 12], list(grasps))
        self.assertEqual([10, 10, 10], list(counts))

    def test_shares_of_a_type_add_up_to_one(self):
        database = small_database()
        queries = confusability.sample_rows(database, 10, 0)
        nearest = confusability.nearest_rows(database, queries, 5)
        shares = confusability.confusion(database, queries, nearest)
        numpy.testing.assert_allclose(shares.sum(1), 1)
        of_seven = database.columns["grasp"][nearest[database.columns["grasp"][queries] == 3]] == 7
        self.assertAlmostEqual(of_seven.mean(), shares[0, 1])

    def test_confused_types_lie_side_by_side(self):
        shares = numpy.eye(6)
        for a, b in ((0, 4), (4, 2), (1, 5), (5, 3)):  # two chains: 0 4 2 and 1 5 3
            shares[a, b] = 0.5
        order = confusability.similar_together(shares)
        self.assertEqual(list(range(6)), sorted(order))
        place = [order.index(i) for i in range(6)]
        for a, b in ((0, 4), (4, 2), (1, 5), (5, 3)):
            self.assertEqual(1, abs(place[a] - place[b]), order)


if __name__ == "__main__":
    unittest.main()
