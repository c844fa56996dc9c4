# SPDX-License-Identifier: MIT
"""The curve that answers were drawn from is found again."""
import csv
import sys
import tempfile
import unittest
from pathlib import Path

import numpy

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
# pylint: disable=wrong-import-position
import fit_confidence


class FitConfidence(unittest.TestCase):
    def drawn(self, half, width, count=20_000):
        random = numpy.random.default_rng(1)
        distance = random.uniform(1, 6, count)
        return distance, random.uniform(size=count) < fit_confidence.curve(distance, half, width)

    def test_finds_the_curve_that_answers_were_drawn_from(self):
        distance, right = self.drawn(3.3, 0.9)
        half, width = fit_confidence.fit(distance, right, numpy.ones_like(distance))
        self.assertAlmostEqual(half, 3.3, delta=0.05)
        self.assertAlmostEqual(width, 0.9, delta=0.05)
        self.assertLess(fit_confidence.expected_error(
            fit_confidence.curve(distance, half, width), right), 0.02)

    def test_evaluations_count_alike_however_many_answers_they_have(self):
        few, many = self.drawn(3.3, 0.9, 300), self.drawn(3.0, 0.5, 900)
        as_many = tuple(numpy.tile(values, 3) for values in few)
        expected = fit_confidence.fit(*(numpy.concatenate(parts) for parts in zip(as_many, many)), numpy.ones(1800))
        numpy.testing.assert_allclose(fit_confidence.fit_alike([few, many]), expected, rtol=1e-9)

    def test_a_confidence_that_is_always_wrong_has_the_greatest_error(self):
        confidence = numpy.array([1.0, 1.0, 0.0])
        self.assertEqual(fit_confidence.expected_error(confidence, numpy.array([0, 0, 1])), 1)
        self.assertEqual(fit_confidence.expected_error(confidence, numpy.array([1, 1, 0])), 0)

    def test_refuses_what_has_no_curve(self):
        distance, right = self.drawn(3.3, 0.9, 1000)
        for wrong in (numpy.ones_like(right), ~right):
            with self.assertRaises(SystemExit):
                fit_confidence.fit(distance, wrong, numpy.ones_like(distance))

    def test_reads_only_answers_of_the_model(self):
        with tempfile.TemporaryDirectory() as folder:
            with (Path(folder) / "frames.csv").open("w", newline="") as file:
                csv.writer(file).writerows([["temporal", "valid", "distance", "rotation_deg"],
                                            ["kde", "1", "2.5", "30"], ["kde", "1", "4", "31"],
                                            ["kde", "0", "", "90"], ["none", "1", "1", "2"]])
            distance, right = fit_confidence.answers(Path(folder), "kde")
        self.assertEqual(distance.tolist(), [2.5, 4])
        self.assertEqual(right.tolist(), [True, False])


if __name__ == "__main__":
    unittest.main()
