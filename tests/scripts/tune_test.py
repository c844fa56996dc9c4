# SPDX-License-Identifier: MIT
"""Options are found where the error is least, each trial measured once, and written as C++."""
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
# pylint: disable=wrong-import-position
import tune

TRACKER = Path(__file__).resolve().parents[2] / "tracker"
WRITTEN = [TRACKER / "tuned_for_hogs.cpp", TRACKER / "tuned_for_codes.cpp"]
LEAST = {"neighbours": 200, "roll_deg": 30, "kept": 100, "sigma_hog": 0.7, "sigma_stretch": 0.5, "sigma_arm_deg": 60, "sigma_pose": 0.25,
         "bandwidth": 0.7, "merge_deg": 20}


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

    def test_what_a_model_does_not_read_is_as_at_the_start(self):
        text = tune.source({"none": {**start("none"), "sigma_hog": 2.8}, "kde": start("kde")}, "tuned_for_hogs")
        none, kde = text.split("kKde")
        self.assertIn("case TemporalModel::kNone:", none)
        self.assertIn(".sigma_hog = 2.8", none)
        self.assertIn(f".sigma_pose = {tune.START['sigma_pose']}", none)
        self.assertIn(".neighbors = 50", kde)
        self.assertEqual(text.count(".max_distance = 5.0"), 2)

    def chosen(self, written):
        """What the file holds, as source() was given it."""
        best = {}
        for case in written.read_text().split("case TemporalModel::k")[1:]:
            model = case.split(":")[0].lower()
            values = dict(re.findall(r"\.(\w+) = ([\d.]+)", case))
            best[model] = {option: float(value) if "." in value else int(value)
                           for option in tune.OPTIONS[model]
                           for value in [values[tune.MEMBER.get(option, option)]]}
        return best

    def test_the_file_that_is_there_is_what_it_would_write(self):
        for written in WRITTEN:
            self.assertEqual(tune.source(self.chosen(written), written.stem), written.read_text())

    @unittest.skipUnless(shutil.which("clang-format"), "no clang-format")
    def test_leaves_nothing_to_clang_format(self):
        def written(value):
            return len(str(value))
        for which in (min, max):  # the shortest lines that can be chosen, and the longest
            text = tune.source({model: {option: which(tune.PLACES[option], key=written)
                                        for option in options}
                                for model, options in tune.OPTIONS.items()}, "tuned_for_codes")
            formatted = subprocess.run(
                ["clang-format", f"--assume-filename={WRITTEN[0]}"], input=text, text=True,
                stdout=subprocess.PIPE, check=True).stdout
            self.assertEqual(text, formatted)

    def test_every_model_of_the_tracker_is_chosen_for(self):
        header = Path(__file__).resolve().parents[2] / "tracker/include/graspdb/tracker/tracker.h"
        names = header.read_text().split("kTemporalModels = {")[1].split("}")[0]
        self.assertEqual(names.count("TemporalModel::"), len(tune.OPTIONS))


if __name__ == "__main__":
    unittest.main()
