# SPDX-License-Identifier: MIT
"""A minute of learning from the program's own pictures: the loss falls, codes find poses, and whole
numbers do as well as floats.

    learn_test.py GRASPDB
"""
import pathlib
import sys
import tempfile
import unittest

import numpy

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts/learn"))
# pylint: disable=wrong-import-position
try:
    import torch  # noqa: F401, only to learn whether it is there
except ImportError:
    print("learn_test.py: skipped, this python has no torch (Debian: python3-torch)")
    sys.exit(77)  # CTest's SKIP_RETURN_CODE

import export
import measure
import retrieval
import safetensors
import train
from integer_net import IntegerNet, code_bytes
from recipe import Recipe
from shards import Shards

PROGRAM = sys.argv.pop(1)
RECIPE = Recipe(layers="4x16/4 3x32 3x64/2 3x64/2", size=64, crops=72_000, batch=128, shard=1500)
QUERIES = 300


class Learned(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = path = pathlib.Path(cls.folder.name)
        cls.shards = Shards(PROGRAM, path, RECIPE.planes, RECIPE.shard)
        cls.trainer = train.Trainer(RECIPE, "cpu")
        clean = path / "clean.safetensors"
        samples = measure.made(PROGRAM, clean, ["--config", measure.HERE / "references.toml", "--count", 3000])
        cls.clean = {name: numpy.array(values) for name, values in samples.items()}
        cls.before = cls.turn_error(cls.codes())
        parts = []
        for number in range(cls.trainer.rounds):
            for batch in train.batches(cls.shards.round(number, cls.trainer.rounds), RECIPE.batch, number):
                parts.append(cls.trainer.learn(batch))
            cls.trainer.replicas.join_statistics()
        cls.parts = parts

    @classmethod
    def tearDownClass(cls):
        cls.shards.close()
        cls.folder.cleanup()

    @classmethod
    def codes(cls):
        return measure.codes_of(cls.trainer.net, cls.clean, RECIPE.planes)

    @classmethod
    def turn_error(cls, codes):
        labels = {name: values[QUERIES:] for name, values in retrieval.labels_of(cls.clean).items()}
        truth = {name: values[:QUERIES] for name, values in retrieval.labels_of(cls.clean).items()}
        answers = retrieval.answers_by_codes(codes[:QUERIES], codes[QUERIES:], labels)
        return retrieval.errors(answers["nearest"], truth)[:, 0].mean().item()

    def test_loss_falls(self):
        for name in ("view", "angles", "joints"):
            first, last = (numpy.mean([part[name] for part in parts]) for parts in (self.parts[:20], self.parts[-20:]))
            self.assertLess(last, 0.9 * first, name)

    def test_retrieval_beats_random_weights(self):
        self.assertLess(self.turn_error(self.codes()), 0.8 * self.before)

    def test_whole_numbers_find_as_well(self):
        tensors, metadata = export.export(self.trainer.net, RECIPE, self.clean, {})
        whole = self.turn_error(export.integer_codes(tensors, metadata, self.clean))
        self.assertLess(abs(whole - self.turn_error(self.codes())), 3)
        few = {name: self.clean[name][:20] for name in RECIPE.planes}
        exact = IntegerNet(tensors, metadata).codes(few)
        numpy.testing.assert_array_equal(exact, IntegerNet(tensors, metadata, export.fast_sums).codes(few))

    def test_the_program_gives_the_same_codes(self):
        tensors, metadata = export.export(self.trainer.net, RECIPE, self.clean, {})
        export.write(self.path / "weights.safetensors", tensors, metadata)
        coded = self.path / "coded.safetensors"
        measure.made(PROGRAM, coded, ["--count", 30, "--descriptor", self.path / "weights.safetensors"])
        samples, _ = safetensors.read(coded)
        numpy.testing.assert_array_equal(samples["embedding"], IntegerNet(tensors, metadata).codes(samples))


class Codes(unittest.TestCase):
    def test_rounds_a_half_away_from_zero_and_clips(self):
        self.assertEqual(code_bytes(numpy.array([[4, -4, 0, 0]]), 10).tolist(), [[136, 120, 128, 128]])
        self.assertEqual(code_bytes(numpy.array([[4, -3]]), 400).tolist(), [[255, 0]])
        self.assertEqual(code_bytes(numpy.array([[0, 0]]), 400).tolist(), [[128, 128]])


if __name__ == "__main__":
    unittest.main()
