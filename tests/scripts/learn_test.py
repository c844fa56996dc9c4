# SPDX-License-Identifier: MIT
"""A minute of learning from the program's own pictures: the loss falls, codes find poses, and whole
numbers do as well as floats.

    learn_test.py GRASPDB
"""
import dataclasses
import json
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
import starting_weights
import train
from integer_net import IntegerNet, code_bytes
from recipe import Recipe
from shards import Shards

PROGRAM = sys.argv.pop(1)
RECIPE = Recipe(layers="4x16/4 3x32 3x64/2 3x64/2", size=64, crops=72_000, batch=128, shard=1500)
QUERIES = 300
GLOVE = '[{"name": "glove", "hash": "0"}]'


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

    def exported(self, name, **extra):
        path = self.path / name
        tensors, metadata = export.export(self.trainer.net, RECIPE, self.clean, extra)
        export.write(path, tensors, metadata)
        return path, tensors, metadata

    def test_weights_are_gone_on_from(self):
        path, tensors, metadata = self.exported("before.safetensors", crops_seen=str(RECIPE.crops), assets=GLOVE)
        goes_on = train.Trainer(RECIPE, "cpu")
        goes_on.start_from(path, self.clean)
        codes = measure.codes_of(goes_on.net, self.clean, RECIPE.planes)
        likeness = (codes * export.integer_codes(tensors, metadata, self.clean)).sum(1)
        self.assertGreater(likeness.mean().item(), 0.99)
        goes_on.save(self.path / "checkpoint.pt", {})
        again, _ = train.Trainer.load(self.path / "checkpoint.pt", "cpu")
        train.write_weights(again, self.shards, None, self.path / "after.safetensors")
        after = safetensors.read(self.path / "after.safetensors")[1]
        self.assertEqual(json.loads(after["started_from"])["recipe"], json.loads(RECIPE.json()))
        self.assertLessEqual({"glove", *self.shards.assets}, {asset["name"] for asset in json.loads(after["assets"])})

    def test_goes_on_with_the_first_picture_that_no_round_held(self):
        # 72,000 crops in rounds of 3 x 1500, of which 4480 make whole batches: 17 rounds of 19 shards.
        path, *_ = self.exported("seen.safetensors", crops_seen=str(72_000 // 4480 * 4480 + 1), assets="[]")
        self.assertEqual(starting_weights.first_unseen(path), 19 * RECIPE.shard)

    def test_weights_of_another_net_are_not_gone_on_from(self):
        path, *_ = self.exported("other.safetensors", crops_seen="1", assets="[]")
        with self.assertRaisesRegex(SystemExit, "size: expected 128, found 64"):
            starting_weights.check_fits(path, dataclasses.replace(RECIPE, size=128))
        path, *_ = self.exported("nameless.safetensors")
        with self.assertRaisesRegex(SystemExit, "crops_seen: expected"):
            starting_weights.check_fits(path, RECIPE)
        path, *_ = self.exported("older.safetensors", format_version="1")
        with self.assertRaisesRegex(SystemExit, "format_version: expected 2, found 1"):
            starting_weights.check_fits(path, RECIPE)

    def test_pictures_of_another_training_are_refused(self):
        with self.assertRaisesRegex(SystemExit, "start in another work folder"):
            Shards(PROGRAM, self.path, RECIPE.planes, RECIPE.shard, first=1).load(max(self.shards.held))

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
