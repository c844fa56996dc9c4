# SPDX-License-Identifier: MIT
"""The verdicts on the paper's claims, of small evaluations whose verdicts are known."""
import csv
import json
import sys
import tempfile
import unittest
from pathlib import Path

import numpy

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
# pylint: disable=wrong-import-position
import claims
import evaluation_tables

NAMES = [f"s{i:02}" for i in range(12)]
SPREAD = numpy.random.default_rng(1).normal(0, 1, len(NAMES))  # between sequences


def write_csv(file, lines):
    with open(file, "w", newline="", encoding="utf-8") as text:
        writer = csv.DictWriter(text, lines[0])
        writer.writeheader()
        writer.writerows(lines)


class Claims(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)

    def folder(self, name, settings=None):
        folder = self.root / name
        folder.mkdir()
        told = {"kind": "rendered", "database": "x", "trackers": {"kde": {"k": 20}},
                "search": "exact", "seed": 0, "fps": None, "hand": "", "grasps": "",
                **(settings or {})}
        (folder / "eval.json").write_text(json.dumps(told))
        return folder

    def evaluation(self, name, errors, names=NAMES, settings=None):
        """runs.csv; errors: (model, alpha) to a number, or to one a sequence."""
        folder = self.folder(name, settings)
        write_csv(folder / "runs.csv", [
            {"sequence": sequence, "temporal": model, "alpha": alpha, "pose_error": error,
             "rotation_deg": 30 * error}
            for (model, alpha), value in errors.items()
            for sequence, error in zip(names, numpy.broadcast_to(value, len(names)))])
        return folder

    def frames(self, name, errors, settings=None):
        """frames.csv of kde at alpha 0; errors: sequence to (closure, occlusion, error) a frame."""
        folder = self.folder(name, settings)
        write_csv(folder / "frames.csv", [
            {"sequence": sequence, "temporal": model, "alpha": alpha, "closure": closure,
             "occlusion": occlusion, "pose_error": error if model == "kde" and not alpha else 99,
             "rotation_deg": 30 * error}
            for model in ("none", "kde") for alpha in (0, 2)
            for sequence, frames in errors.items() for closure, occlusion, error in frames])
        return folder

    def models(self, gaussian, kde, noisy=0.0):
        """`none` errs by 2 and more, the others by less, at 2 % by `noisy` times as much less."""
        none = 2 + 0.3 * SPREAD
        gains = {"none": 0, "gaussian": gaussian, "kde": kde}
        return {(model, alpha): none - numpy.asarray(gain) * (1 + noisy * (alpha == 2))
                for model, gain in gains.items() for alpha in (0, 2)}

    def told(self, *arguments):
        """Claim to (verdict, its lines by measure)."""
        out = self.root / "claims.md"
        claims.main([*map(str, arguments), "--out", str(out)])
        self.markdown = out.read_text()
        self.json = json.loads(out.with_suffix(".json").read_text())
        return {claim["claim"]: (claim["verdict"], {
            (one["measure"], one["metric"]): one for one in claim["lines"]})
            for claim in self.json["claims"]}

    def verdicts(self, *arguments):
        return {claim: verdict for claim, (verdict, _) in self.told(*arguments).items()}

    def test_a_clear_order_is_confirmed_and_its_reverse_refuted(self):
        small = 0.01 * SPREAD
        right = self.evaluation("right", self.models(0.2 + small, 0.4 + small, noisy=0.5))
        wrong = self.evaluation("wrong", self.models(-0.2 + small, -0.4 + small, noisy=0.5))
        self.assertEqual({"a1": "confirmed", "a2": "confirmed", "b": "confirmed"},
                         self.verdicts("--main", right))
        self.assertEqual("refuted", self.verdicts("--main", wrong)["a1"])
        self.assertEqual("refuted", self.verdicts("--main", wrong)["a2"])

    def test_an_interval_around_zero_is_undecided(self):
        around = 0.3 * (SPREAD - SPREAD.mean())
        verdict, lines = self.told(
            "--main", self.evaluation("main", self.models(around, 0.5)))["a1"]
        one = lines["gaussian - none at 0 %", "pose_error"]
        self.assertLess(one["low"], 0)
        self.assertGreater(one["high"], 0)
        self.assertEqual(("undecided", "undecided"), (one["verdict"], verdict))
        # Equal to the last bit is no gain either.
        same = self.told("--main", self.evaluation("same", self.models(0, 0)))["a1"][1]
        self.assertEqual("undecided", same["kde - gaussian at 0 %", "pose_error"]["verdict"])

    def test_one_refuted_difference_refutes_the_claim(self):
        errors = self.models(0.2, 0.4)
        errors["kde", 2] = errors["gaussian", 2] + 0.1 + 0.01 * SPREAD
        self.assertEqual("refuted", self.verdicts("--main", self.evaluation("main", errors))["a1"])

    def test_differences_are_taken_sequence_by_sequence(self):
        # A gain far smaller than sequences differ is seen, in whatever order they stand.
        errors = self.models(0.01, 0.02)
        folder = self.evaluation("main", errors)
        lines = (folder / "runs.csv").read_text().splitlines()
        shuffled = numpy.random.default_rng(2).permutation(lines[1:])
        (folder / "runs.csv").write_text("\n".join([lines[0], *shuffled]) + "\n")
        one = self.told("--main", folder)["a1"][1]["kde - none at 2 %", "pose_error"]
        for key in ("mean", "low", "high"):
            self.assertAlmostEqual(-0.02, one[key])

    def few(self, count):
        errors = {key: value[:count] for key, value in self.models(0.2, 0.4, noisy=0.5).items()}
        return self.evaluation(f"few {count}", errors, names=NAMES[:count])

    def test_fewer_than_six_sequences_decide_nothing(self):
        self.assertEqual({"undecided"}, set(self.verdicts("--main", self.few(5)).values()))
        self.assertEqual({"confirmed"}, set(self.verdicts("--main", self.few(6)).values()))

    def test_one_sequence_has_no_interval(self):
        self.assertEqual({"undecided"}, set(self.verdicts("--main", self.few(1)).values()))
        self.assertIn("no interval", self.markdown)
        self.assertIsNone(self.json["claims"][0]["lines"][0]["low"])

    def test_a_tenth_worse_is_the_margin_of_noise(self):
        for rise, verdict in ((0.08, "confirmed"), (0.12, "refuted")):
            errors = self.models(0, 0)
            errors["kde", 2] = errors["kde", 0] + rise * errors["kde", 0].mean()
            errors["kde", 4] = errors["kde", 0] + 2  # beyond what the claim is about
            for model in ("none", "gaussian"):
                errors[model, 4] = errors[model, 0]
            told, lines = self.told("--main", self.evaluation(f"rise {rise}", errors))["b"]
            self.assertEqual(verdict, told)
            self.assertAlmostEqual(0.1 * errors["kde", 0].mean(),
                                   lines["kde at 2 % - at 0", "pose_error"]["margin"])
            self.assertEqual("refuted", lines["kde at 4 % - at 0", "pose_error"]["verdict"])

    def test_noise_without_two_percent_is_refused(self):
        errors = {key: value for key, value in self.models(0, 0).items() if key[1] == 0}
        with self.assertRaisesRegex(SystemExit, "alpha 2"):
            self.told("--main", self.evaluation("main", errors))

    def test_a_further_model_is_told_and_decides_nothing(self):
        errors = self.models(0.2, 0.4)
        for alpha in (0, 2):
            errors["successors", alpha] = errors["kde", alpha] + 0.5
        verdict, lines = self.told("--main", self.evaluation("main", errors))["a1"]
        ours = lines["successors - kde at 0 %", "pose_error"]
        self.assertAlmostEqual(0.5, ours["mean"])
        self.assertEqual(("confirmed", "refuted", False),
                         (verdict, ours["verdict"], ours["decides"]))

    def test_objects_are_judged_while_a_hand_holds_one(self):
        def side(error):
            shown = {name: [(0.2, 0, 9 * error), (0.5, 0, error), (1, 0.3, error)]
                     for name in NAMES}
            return {**shown, "bare": [(1, 0, 7 * error)]}
        main = self.evaluation("main", self.models(0.2, 0.4))
        held, free = self.frames("held", side(1)), self.frames("free", side(1.5))
        told = self.told("--main", main, "--held", held, "--free", free)
        one = told["c"][1]["held rows - free rows", "pose_error"]
        self.assertEqual(("confirmed", -0.5, 12), (told["c"][0], one["mean"], one["sequences"]))
        other = self.told("--main", main, "--held", free, "--free", held)["c"]
        self.assertEqual("refuted", other[0])

    def test_a_sequence_on_one_side_only_is_left_out_of_both(self):
        main = self.evaluation("main", self.models(0, 0))
        fewer = [name for name in NAMES if name != "s03"]
        errors = 2 + 0.3 * SPREAD[[NAMES.index(name) for name in fewer]]
        seen = self.evaluation("seen", {("kde", 0): errors}, names=fewer)
        one = self.told("--main", main, "--seen-hand", seen)["d1"][1][
            "own hand - the database's", "pose_error"]
        self.assertEqual((0, 11), (one["mean"], one["sequences"]))
        numpy.testing.assert_allclose(one["sides"], 2 * [errors.mean()])
        self.assertAlmostEqual(0.1 * errors.mean(), one["margin"])
        self.assertIn("left out: s03.", self.markdown)
        nobody = self.evaluation("nobody", {("kde", 0): 1}, names=["other"])
        with self.assertRaisesRegex(SystemExit, "no sequence"):
            self.told("--main", main, "--seen-hand", nobody)

    def test_what_is_not_in_the_database_may_be_a_tenth_worse(self):
        main = self.evaluation("main", self.models(0, 0))
        own = self.models(0, 0)["kde", 0]
        near = self.evaluation("near", {("kde", 0): own / 1.05})
        far = self.evaluation("far", {("kde", 0): own / 1.3})
        told = self.verdicts("--main", main, "--seen-hand", near, "--seen-grasp", far)
        self.assertEqual(("confirmed", "refuted"), (told["d1"], told["d2"]))

    def test_evaluations_that_differ_in_more_than_what_is_asked_are_refused(self):
        main = self.evaluation("main", self.models(0, 0))
        other = self.evaluation("other", {("kde", 0): 1}, settings={"database": "y"})
        with self.assertRaisesRegex(SystemExit, "database differs"):
            self.told("--main", main, "--seen-hand", other)
        held = self.frames("held", {"a": [(1, 0.1, 1)]}, settings={"seed": 1})
        free = self.frames("free", {"a": [(1, 0.1, 1)]})
        with self.assertRaisesRegex(SystemExit, "seed differs"):
            self.told("--main", main, "--held", held, "--free", free)

    def test_rendered_and_photoreal_frames_are_not_taken_for_each_other(self):
        main = self.evaluation("main", self.models(0, 0))
        photoreal = self.evaluation("photoreal", self.models(0, 0), settings={"kind": "photoreal"})
        for arguments in (["--main", photoreal], ["--main", main, "--seen-hand", photoreal],
                          ["--main", main, "--photoreal", main]):
            with self.assertRaisesRegex(SystemExit, "frames is asked for"):
                self.told(*arguments)

    def bench(self, p99, width=640):
        file = self.root / "bench.json"
        file.write_text(json.dumps({"tracker": {
            "width_px": width, "height_px": 480, "frames": 500, "trackers": [
                {"search": "exact", "ms": {"total": {"p99": p99}}},
                {"search": "scan", "ms": {"total": {"p99": 101}}}]}}))
        return file

    def test_real_time_is_the_last_percentile_below_a_tenth_of_a_second(self):
        main = self.evaluation("main", self.models(0, 0))
        for p99, verdict, thirty in ((20, "confirmed", "confirmed"), (50, "confirmed", "refuted"),
                                     (100.1, "refuted", "refuted")):
            told, lines = self.told("--main", main, "--bench", self.bench(p99))["e"]
            self.assertEqual(verdict, told)
            self.assertEqual(thirty, lines["p99 of a frame, exact, against 30 frames/s", "ms"][
                "verdict"])
        with self.assertRaisesRegex(SystemExit, "640 x 480"):
            self.told("--main", main, "--bench", self.bench(20, width=320))

    def test_photoreal_sequences_are_told_apart(self):
        main = self.evaluation("main", self.models(0.2, 0.4, noisy=0.5))
        photoreal = self.evaluation("photoreal", self.models(-0.2, -0.4), names=NAMES[:5] + [
            f"p{i}" for i in range(7)], settings={"kind": "photoreal"})
        self.assertEqual("confirmed", self.verdicts("--main", main, "--photoreal", photoreal)["a1"])
        apart = {claim["claim"]: claim["verdict"] for claim in self.json["photoreal"]}
        self.assertEqual({"a1": "refuted", "a2": "undecided", "b": "confirmed"}, apart)

    def test_claims_without_evaluations_are_not_in_the_table(self):
        told = self.verdicts("--main", self.evaluation("main", self.models(0, 0)))
        self.assertEqual(["a1", "a2", "b"], list(told))
        for absent in ("| c |", "| d1 |", "| d2 |", "| e |"):
            self.assertNotIn(absent, self.markdown)
        self.assertNotIn("photoreal", self.json)


class Interval(unittest.TestCase):
    def test_it_is_that_of_the_normal_distribution_for_many_values(self):
        values = numpy.random.default_rng(3).normal(5, 2, 400)
        low, high = evaluation_tables.clustered_interval(values, range(400))
        reach = 1.96 * values.std() / 20
        self.assertAlmostEqual(values.mean() - reach, low, delta=0.02)
        self.assertAlmostEqual(values.mean() + reach, high, delta=0.02)

    def test_it_is_sequences_that_are_drawn(self):
        # A hundred frames of one sequence say no more than one of them.
        few = evaluation_tables.clustered_interval(numpy.array([1.0, 2.0, 4.0]), ["a", "b", "c"])
        many = evaluation_tables.clustered_interval(
            numpy.repeat([1.0, 2.0, 4.0], 100), numpy.repeat(["a", "b", "c"], 100))
        numpy.testing.assert_allclose(few, many)
        self.assertEqual((1, 4), few)


if __name__ == "__main__":
    unittest.main()
