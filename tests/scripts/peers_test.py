# SPDX-License-Identifier: MIT
"""Scores of other people's hand trackers: answers whose errors are known."""
import contextlib
import io
import json
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import numpy

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts" / "peers"))
# pylint: disable=wrong-import-position
import score

CAMERA = score.Camera(600, numpy.array([319.5, 239.5]))
HAND = score.flat_hand(CAMERA).points
HAND[7:9, 2] += (0.01, 0.03)  # one bent finger, so that its mirror image is another hand


def turned(points, angle_deg):
    """About an axis that is none of the camera's."""
    x, y, z = numpy.array([2, -1, 2]) / 3
    across = numpy.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    angle = numpy.radians(angle_deg)
    return points @ (numpy.eye(3) + numpy.sin(angle) * across + (1 - numpy.cos(angle)) * across @ across).T


def scored(*answers, hidden=0.0):
    """Frames that all show HAND. An answer is points, or None."""
    count = len(answers)
    truth = score.Truth(numpy.array([HAND] * count), numpy.full(count, hidden), CAMERA)
    pixels = score.projected(HAND, CAMERA)
    return score.score([None if points is None else score.Answer(points, pixels) for points in answers], truth)


class Errors(unittest.TestCase):
    def test_the_truth_has_none(self):
        frame, = scored(HAND)
        for metric in score.METRICS:
            self.assertAlmostEqual(frame[metric], 0, places=4, msg=metric)

    def test_a_turned_copy_is_off_by_the_turn_alone(self):
        for angle, flips in ((30, 0), (89, 0), (91, 1)):
            frame, = scored(turned(HAND, angle))
            self.assertAlmostEqual(frame["rotation_deg"], angle)
            self.assertEqual(frame["flips"], flips)
            self.assertAlmostEqual(frame["pa_mpjpe_mm"], 0)
            self.assertAlmostEqual(frame["flexion_deg"], 0, places=4)

    def test_size_and_place_are_free(self):
        frame, = scored(0.7 * HAND + (0.1, -0.2, 3))
        for metric in score.METRICS:
            self.assertAlmostEqual(frame[metric], 0, places=4, msg=metric)

    def test_a_mirrored_hand_is_another_hand(self):
        frame, = scored(HAND * (-1, 1, 1))
        self.assertGreater(frame["pa_mpjpe_mm"], 1)

    def test_the_error_in_the_picture_is_told_in_palms(self):
        palm_px = numpy.linalg.norm(HAND[9] - HAND[0]) * 600 / HAND[0, 2]
        shifted = score.Answer(HAND, score.projected(HAND, CAMERA) + palm_px * numpy.array([0.3, 0.4]))
        self.assertAlmostEqual(score.errors(shifted, HAND, CAMERA)["error_2d_palms"], 0.5)

    def test_bends_of_a_finger_add_up(self):
        straight = score.flat_hand(CAMERA).points
        bent = straight.copy()
        bent[12] = bent[11] + (0, 0, 0.02)  # the middle finger's tip stands up at a right angle
        difference = score.bends_deg(bent) - score.bends_deg(straight)
        numpy.testing.assert_allclose(difference, [0, 0, 90, 0, 0], atol=1e-4)


class FramesWithoutAnAnswer(unittest.TestCase):
    def test_have_the_last_answers_error(self):
        frames = scored(turned(HAND, 30), None, turned(HAND, 10), None)
        numpy.testing.assert_allclose([frame["rotation_deg"] for frame in frames], [30, 30, 10, 10])
        self.assertEqual([frame["answered"] for frame in frames], [True, False, True, False])

    def test_have_at_first_a_flat_hands(self):
        frame, = scored(None)
        self.assertAlmostEqual(frame["rotation_deg"], 0, places=4)  # HAND is that one, but for a finger
        self.assertGreater(frame["flexion_deg"], 5)

    def test_count_among_all_alone(self):
        result = score.scores({"a": scored(turned(HAND, 30), None, turned(HAND, 10)), "b": scored(turned(HAND, 50)),
                               "c": scored(None)})
        self.assertAlmostEqual(result["answered_share"], (2 / 3 + 1 + 0) / 3)
        self.assertAlmostEqual(result["all"]["rotation_deg"], (70 / 3 + 50 + 0) / 3, places=4)
        self.assertAlmostEqual(result["answered"]["rotation_deg"], (20 + 50) / 2)


class HiddenShare(unittest.TestCase):
    def test_bins_begin_with_their_lower_bound_and_the_last_ends_with_its_end(self):
        frames = [*scored(turned(HAND, 10), hidden=0.159), *scored(turned(HAND, 20), hidden=0.16),
                  *scored(turned(HAND, 30), hidden=1)]
        shares = score.by_hidden_share(frames)
        self.assertAlmostEqual(shares["0-16"], 10)
        self.assertAlmostEqual(shares["16-32"], 20)
        self.assertIsNone(shares["32-48"])
        self.assertAlmostEqual(shares["64-100"], 30)


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        camera = {"fx_px": 600.0, "cx_px": 319.5, "cy_px": 239.5}
        self.write("truth/jar/sequence.json", {"camera": camera})
        self.write("truth/jar/truth.jsonl", *[{"joints_m": HAND.ravel().tolist(), "occlusion": 0.5}] * 2)

    def write(self, name, *lines):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("".join(json.dumps(line) + "\n" for line in lines))

    def run_script(self, *tracks):
        result = self.folder / "scores.json"
        words = ["score.py", str(self.folder / "truth"), *tracks, "--json", str(result)]
        with mock.patch.object(sys, "argv", words), contextlib.redirect_stdout(io.StringIO()) as told:
            score.main()
        return told.getvalue(), json.loads(result.read_text())

    def test_both_kinds_of_track_say_the_same(self):
        points = turned(HAND, 30)
        pixels = score.projected(HAND, CAMERA)
        landmarks = numpy.column_stack([(pixels + 0.5) / (640, 480), numpy.zeros(21)])
        size = {"width": 640, "height": 480}
        self.write("a/jar.jsonl", {"world": [points.tolist()], "landmarks": [landmarks.tolist()], **size},
                   {"world": [], "landmarks": [], **size})
        self.write("b/jar.jsonl", {"valid": True, "joints_m": points.ravel().tolist(),
                                   "joints_px": pixels.ravel().tolist()}, {"valid": False})
        told, result = self.run_script(f"One={self.folder}/a", f"Other={self.folder}/b")
        for name in ("One", "Other"):
            self.assertEqual(result[name]["answered_share"], 0.5)
            self.assertAlmostEqual(result[name]["all"]["rotation_deg"], 30)
            self.assertAlmostEqual(result[name]["answered"]["error_2d_palms"], 0)
            self.assertAlmostEqual(result[name]["all"]["rotation_deg_by_hidden_percent"]["48-64"], 30)
            self.assertRegex(told, rf"(?m)^{name}, all +50 +30\.0 ")

    def test_a_track_of_another_length_is_refused(self):
        self.write("a/jar.jsonl", {"valid": False})
        with self.assertRaisesRegex(SystemExit, "jar.jsonl: expected 2 lines"):
            self.run_script(f"One={self.folder}/a")


if __name__ == "__main__":
    unittest.main()
