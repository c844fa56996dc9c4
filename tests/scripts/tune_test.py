# SPDX-License-Identifier: MIT
"""Options are found where the error is least, each trial measured once, and written as C++."""
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
# pylint: disable=wrong-import-position
import tune

LEAST = {"neighbours": 200, "kept": 100, "sigma_hog": 0.7, "sigma_stretch": 0.5, "sigma_pose": 0.25,
         "bandwidth": 0.7}


def start(model):
    options = {option: tune.START[option] for option in tune.OPTIONS[model]}
    return {"temporal": model, **options}


class Tune(unittest.TestCase):
    def setUp(self):
        self.measured = []

    def bowl(self, trials):
        """An error that grows with every place away from LEAST."""
        self.measured += map(tune.key, trials)
        return [{"pose_error": sum(abs(places.index(trial[option]) - places.index(LEAST[option]))
                                   for option, places in tune.PLACES.items() if option in trial),
                 "rotation_deg": 1, "joint_deg": 1} for trial in trials]

    def test_finds_the_least_error_of_each_model(self):
        best, means = tune.descend(self.bowl, {"none": start("none"), "kde": start("kde")})
        for model, trial in best.items():
            for option in tune.OPTIONS[model]:
                self.assertEqual(trial[option], LEAST[option], (model, option))
            self.assertEqual(means[model]["pose_error"], 0)

    def test_measures_no_trial_twice(self):
        tune.descend(self.bowl, {"gaussian": start("gaussian")})
        self.assertEqual(len(self.measured), len(set(self.measured)))

    def test_stays_where_nothing_is_better(self):
        trial = {"temporal": "none", **{option: LEAST[option] for option in tune.SINGLE_FRAME}}
        best, _ = tune.descend(self.bowl, {"none": trial})
        self.assertEqual(best, {"none": trial})

    def test_writes_only_what_a_model_reads(self):
        text = tune.source({"none": start("none"), "gaussian": start("gaussian")})
        none, gaussian = text.split("kGaussian")
        self.assertIn("case TemporalModel::kNone:", none)
        self.assertIn(".neighbours = 50", none)
        self.assertNotIn("sigma_pose", none)
        self.assertIn(".sigma_pose = 0.35", gaussian)

    def test_every_model_of_the_tracker_is_chosen_for(self):
        header = Path(__file__).resolve().parents[2] / "tracker/include/graspdb/tracker.h"
        names = header.read_text().split("kTemporalModels = {")[1].split("}")[0]
        self.assertEqual(names.count("TemporalModel::"), len(tune.OPTIONS))


if __name__ == "__main__":
    unittest.main()
