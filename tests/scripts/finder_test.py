# SPDX-License-Identifier: MIT
"""Half a minute of learning to find, on discs before noise: the loss falls, discs are found, whole numbers do as well
as floats, the program finds what the trainer finds, and a training that was cut goes on.

    finder_test.py GRASPDB
"""
import dataclasses
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

import numpy

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts/learn"))
# pylint: disable=wrong-import-position
try:
    import cv2
    import torch
except ImportError:
    print("finder_test.py: skipped, this python has no torch or no cv2 (Debian: python3-torch, python3-opencv)")
    sys.exit(77)  # CTest's SKIP_RETURN_CODE

import finder_export
import finder_pictures
import safetensors
import train_finder
from finder_measure import hand_of, iou, scores_of_net
from finder_pictures import HAND, OBJECT, REST_OR_ARM, Pictures, with_print, with_thing

PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
RECIPE = train_finder.Recipe(layers="5x8/2 3x16/2 3x16 3x8+0 1x4", pictures=6400, batch=16, rate=5e-3)
SKIN, SLEEVE, SLEEVE_LABEL = (12600, 18200, 30800, 65535), (14400, 10800, 4800, 65535), 4


def write_scene(folder, rng):
    """A room of coloured noise, and a skin-coloured disc with a sleeve before it."""
    folder.mkdir(parents=True)
    room = cv2.resize(rng.integers(0, 30000, (6, 8, 3)).astype(numpy.uint16), (320, 240))
    cv2.imwrite(str(folder / "room.png"), room)
    x, y = int(rng.integers(100, 220)), int(rng.integers(80, 160))
    front, labels = numpy.zeros((240, 320, 4), numpy.uint16), numpy.zeros((240, 320), numpy.uint8)
    for image, sleeve, hand in ((front, SLEEVE, SKIN), (labels, SLEEVE_LABEL, HAND)):
        cv2.rectangle(image, (x - 12, y), (x + 12, 239), sleeve, cv2.FILLED)
        cv2.circle(image, (x, y), 34, hand, cv2.FILLED)
    cv2.imwrite(str(folder / "front0.png"), front)
    cv2.imwrite(str(folder / "labels0.png"), labels)


class Finder(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = pathlib.Path(cls.folder.name)
        for number in range(16):
            write_scene(cls.path / f"scenes/{number:06}", numpy.random.default_rng(number))
        cls.enterClassContext(unittest.mock.patch.multiple(finder_pictures, BEHIND=0, BEFORE=0))
        cls.pictures = train_finder.PICTURES = Pictures([cls.path / "scenes"])
        cls.maker = train_finder.Maker(0)
        cls.trainer = train_finder.Trainer(RECIPE, "cpu")
        cls.losses = [cls.trainer.learn(batch)["loss"] for batch in cls.maker.batches(16, 0, cls.trainer.steps)]
        cls.trainer.replicas.join_statistics()
        cls.unseen = next(cls.maker.batches(48, 1000, 1))

    @classmethod
    def tearDownClass(cls):
        cls.maker.pool.terminate()
        cls.folder.cleanup()

    def agreement(self, scores):
        """Mean IoU, of pictures with a disc."""
        pairs = zip(scores, self.unseen["classes"])
        return numpy.mean([iou(hand_of(score, classes.shape), classes == HAND) for score, classes in pairs
                           if (classes == HAND).any()])

    def test_loss_falls(self):
        self.assertLess(numpy.mean(self.losses[-10:]), 0.5 * numpy.mean(self.losses[:10]))

    def test_discs_are_found(self):
        self.assertGreater(self.agreement(scores_of_net(self.trainer.net)(self.unseen["picture"])), 0.8)

    def test_whole_numbers_do_as_well(self):
        floats = scores_of_net(self.trainer.net)(self.unseen["picture"])
        pictures = torch.as_tensor(self.unseen["picture"]).permute(0, 3, 1, 2).float() / 255
        tensors, metadata = finder_export.export(self.trainer.net, pictures, {})
        whole = finder_export.integer_scores(tensors, metadata, self.unseen["picture"])
        self.assertGreater((floats.argmax(1) == whole.argmax(1)).float().mean().item(), 0.98)
        self.assertGreater(self.agreement(whole), self.agreement(floats) - 0.01)

    def test_the_program_finds_what_the_trainer_finds(self):
        pictures = self.unseen["picture"]
        tensors, metadata = finder_export.export(
            self.trainer.net, torch.as_tensor(pictures).permute(0, 3, 1, 2).float() / 255, {})
        weights, frames, masks = self.path / "w.safetensors", self.path / "frames", self.path / "masks"
        safetensors.write(weights, tensors, metadata)
        frames.mkdir()
        for number, picture in enumerate(pictures):
            cv2.imwrite(str(frames / f"{number}.png"), picture)
        subprocess.run([PROGRAM, "find", frames, "--still", "--finder", weights, "--out", masks], check=True,
                       capture_output=True)
        scores, within = finder_export.integer_scores(tensors, metadata, pictures), []
        for number, classes in enumerate(self.unseen["classes"]):
            found = cv2.imread(str(masks / f"{number}.png"), cv2.IMREAD_GRAYSCALE) > 0
            if (classes == HAND).sum() > 400:  # one of two hands may be the one that is found
                # The colours of what is found may show more of the hand than the scores do.
                hand = hand_of(scores[number], classes.shape) | (classes == HAND)
                within.append((found & hand).sum() / max(found.sum(), 1))
        self.assertGreater(len(within), 20)
        self.assertGreater(numpy.mean(within), 0.9)

    def test_a_print_is_on_the_object_alone(self):
        rng, light = numpy.random.default_rng(1), numpy.full((120, 160, 3), 0.5, numpy.float32)
        shown = numpy.zeros((120, 160), bool)
        shown[40:80, 50:90] = True
        printed = with_print(light, shown, rng)
        self.assertTrue((printed[~shown] == light[~shown]).all())
        self.assertTrue((printed[shown] != light[shown]).any(axis=-1).all())

    def test_a_thing_lies_where_it_is_put_and_hides_a_part_of_the_hand(self):
        light = numpy.full((120, 160, 3), 0.5, numpy.float32)
        drawn, shown = with_thing(light, (30, 100), numpy.random.default_rng(3))
        self.assertTrue(shown[30, 100])
        self.assertTrue((drawn[~shown] == light[~shown]).all())
        with unittest.mock.patch.multiple(finder_pictures, BEFORE=1):
            hidden = [self.pictures.draw(numpy.random.default_rng(number))[1] for number in range(20)]
        self.assertTrue(any((classes == OBJECT).any() for classes in hidden))  # no scene here holds one
        self.assertFalse(any((classes == OBJECT).any() for classes in self.unseen["classes"]))

    def test_frames_of_sequences_leave_open_what_is_sleeve(self):
        frame, labels = self.path / "frame.png", self.path / "frame_labels.png"
        cv2.imwrite(str(frame), numpy.full((240, 320, 3), 90, numpy.uint8))
        cv2.imwrite(str(labels), numpy.repeat(numpy.arange(4, dtype=numpy.uint8), 60)[:, None] + numpy.zeros((1, 320), numpy.uint8))
        _, classes = Pictures([], [(frame, labels)]).draw_frame(numpy.random.default_rng(2))
        self.assertEqual(set(numpy.unique(classes)) - {HAND, OBJECT}, {REST_OR_ARM})

    def test_a_picture_depends_on_its_number_alone(self):
        again = next(self.maker.batches(48, 1000, 1))
        numpy.testing.assert_array_equal(again["picture"], self.unseen["picture"])
        self.assertFalse((next(self.maker.batches(48, 1001, 1))["picture"] == again["picture"]).all())

    def test_a_training_that_was_cut_goes_on_as_if_nothing_had_been(self):
        recipe = dataclasses.replace(RECIPE, pictures=20 * 16, seed=3)
        maker, checkpoint = train_finder.Maker(recipe.seed), self.path / "checkpoint.pt"
        self.addCleanup(maker.pool.terminate)
        cut = train_finder.Trainer(recipe, "cpu")
        for batch in maker.batches(16, 0, 8):
            cut.learn(batch)
        cut.save(checkpoint)
        self.assertEqual(train_finder.Trainer.recipe_of(checkpoint), recipe)
        again = train_finder.Trainer.load(checkpoint, "cpu")
        for trainer in (cut, again):
            train_finder.train(trainer, maker, self.path / "end.pt", None)
            self.assertEqual(trainer.step, 20)
        for one, other in zip(cut.net.state_dict().values(), again.net.state_dict().values()):
            torch.testing.assert_close(one, other)
        train_finder.write_weights(again, maker, None, self.path / "finder.safetensors")
        tensors, metadata = safetensors.read(self.path / "finder.safetensors")
        self.assertEqual(metadata["pictures_seen"], "320")
        self.assertEqual(tensors["layer3.weight"].shape, (8, 3, 3, 24))

    def test_a_training_that_starts_from_another_tells_so(self):
        maker, start = train_finder.Maker(7), self.path / "start.pt"
        self.addCleanup(maker.pool.terminate)
        first = train_finder.Trainer(dataclasses.replace(RECIPE, pictures=16, seed=7), "cpu")
        train_finder.train(first, maker, start, None)
        second = train_finder.Trainer(dataclasses.replace(RECIPE, pictures=32, seed=8), "cpu")
        second.start_from(start)
        for one, other in zip(first.net.state_dict().values(), second.net.state_dict().values()):
            torch.testing.assert_close(one, other)
        train_finder.train(second, maker, self.path / "end.pt", None)
        train_finder.write_weights(train_finder.Trainer.load(self.path / "end.pt", "cpu"), maker, None,
                                   self.path / "second.safetensors")
        metadata = safetensors.read(self.path / "second.safetensors")[1]
        self.assertEqual(metadata["pictures_seen"], "32")
        self.assertEqual(json.loads(metadata["started_from"]), json.loads(json.dumps(first.history)))


if __name__ == "__main__":
    unittest.main()
