#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Chooses the tracker's options on the training sequences and writes them where it finds them.

    scripts/tune.py DB [--codes] [--graspdb build/release/cli/graspdb] [--write]

For each temporal model by itself: every option is moved one place up and down its list, and all
those moves that help are made at once, or where that was tried before the best one; again, until
none helps. Best is the least pose_error, the mean
over sequences of the mean over their frames, without and with segmentation noise (alpha 0 and 1 %).
sequences/test is never read. Prints every trial (JSON lines, --log) and a table of what was chosen.
"""

import argparse
import json
import pathlib
import statistics
import subprocess
import tempfile

PLACES = {
    "neighbours": (10, 20, 50, 100, 200, 400, 700, 1000),
    "roll_deg": (0, 20, 30, 40, 50),
    "kept": (5, 10, 20, 50, 100, 200, 400),
    "sigma_hog": (0.04, 0.06, 0.08, 0.11, 0.15, 0.2, 0.3, 0.5, 0.7, 1.0, 1.4, 2.0, 2.8, 4.0),
    "sigma_stretch": (0.1, 0.15, 0.2, 0.3, 0.5, 1.0),
    "sigma_arm_deg": (15, 20, 30, 45, 60, 90, 1000),
    "sigma_pose": (0.2, 0.25, 0.35, 0.5, 0.7, 1.0, 1.4),
    "bandwidth": (0.2, 0.25, 0.35, 0.5, 0.7, 1.0, 1.4),
    "merge_deg": (0, 10, 20, 30, 40, 50, 60),
}
SINGLE_FRAME = ("neighbours", "roll_deg", "sigma_hog", "sigma_stretch", "sigma_arm_deg", "merge_deg")
OPTIONS = {  # those that a model reads
    "none": SINGLE_FRAME,
    "gaussian": SINGLE_FRAME + ("sigma_pose",),
    "kde": SINGLE_FRAME + ("kept", "bandwidth"),
    "successors": SINGLE_FRAME + ("kept", "bandwidth"),
}
ARM_DEG = 30  # hardly any arm is seen in rendered sequences: chosen on photoreal ones
START = {"neighbours": 50, "roll_deg": 0, "kept": 20, "sigma_hog": 1.0, "sigma_stretch": 0.2, "sigma_arm_deg": ARM_DEG, "sigma_pose": 0.35,
         "bandwidth": 0.35, "merge_deg": 0}
START_OF_CODES = {**START, "neighbours": 400, "roll_deg": 40, "kept": 100, "sigma_hog": 0.2, "sigma_stretch": 0.5,
                  "sigma_pose": 0.7, "bandwidth": 0.7, "merge_deg": 50}  # learned descriptors
TRACKER = pathlib.Path(__file__).resolve().parents[1] / "tracker"
ROUNDS = 5
MEMBER = {"neighbours": "neighbors"}  # where C++ spells it otherwise
# Not chosen: it tells what is no hand. No frame of the training sequences is further away.
MAX_DISTANCE = {"tuned_for_hogs": 5.0, "tuned_for_codes": 0.65}
HEADER = """// SPDX-License-Identifier: MIT
// Written by scripts/tune.py.
#include "graspdb/core/error.h"
#include "tuned.h"

namespace graspdb {

TrackerOptions FUNCTION(TemporalModel temporal) {
  switch (temporal) {
"""
FOOTER = """  }
  GRASPDB_CHECK(false);
}

}  // namespace graspdb
"""


def key(trial):
    return json.dumps(trial, sort_keys=True)


def moves(trial):
    """The trials one place away."""
    for option in OPTIONS[trial["temporal"]]:
        places = PLACES[option]
        here = places.index(trial[option])
        for there in (here - 1, here + 1):
            if 0 <= there < len(places):
                yield {**trial, option: places[there]}


def run(trials, arguments):
    """What `graspdb tune` measured of each trial."""
    with tempfile.NamedTemporaryFile("w", suffix=".jsonl") as file:
        file.writelines(json.dumps(trial) + "\n" for trial in trials)
        file.flush()
        command = [arguments.graspdb, "tune", arguments.database, "--sequences",
                   arguments.sequences, "--alphas", "0,1", "--trackers", file.name]
        lines = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout
    return [json.loads(line) for line in lines.splitlines()]


def means(result):
    """{metric: mean over sequences}"""
    sequences = list(result["sequences"].values())
    return {metric: statistics.fmean(sequence[metric] for sequence in sequences)
            for metric in sequences[0]}


def error(known, trial):
    return known[key(trial)]["pose_error"]


def all_better(at, known):
    """Every option where it alone was best: usually better still, and found in one round."""
    best = dict(at)
    for option in OPTIONS[at["temporal"]]:
        alone = [trial for trial in moves(at) if trial[option] != at[option]]
        best[option] = min([at, *alone], key=lambda trial: error(known, trial))[option]
    return best


def descend(measure, start):
    """start: {model: trial}. measure: list of trials -> list of {metric: mean}."""
    known, trials, at = {}, {}, dict(start)
    for _ in range(ROUNDS):
        wanted = {key(trial): trial for here in at.values() for trial in (here, *moves(here))}
        new = [trial for name, trial in wanted.items() if name not in known]
        if not new:
            break
        trials.update(wanted)
        known.update(zip(map(key, new), measure(new)))
        for model, here in at.items():
            at[model] = all_better(here, known)
            if key(at[model]) in known:
                at[model] = least(model, trials, known)
    best = {model: least(model, trials, known) for model in start}
    return best, {model: known[key(trial)] for model, trial in best.items()}


def least(model, trials, known):
    of_model = [trial for trial in trials.values() if trial["temporal"] == model]
    return min(of_model, key=lambda trial: error(known, trial))


def statement(trial, max_distance):
    """The return statement. What the model does not read is as in START."""
    begin = "      return {"
    values = {option: trial.get(option, START[option]) for option in PLACES}
    fields = [".temporal = temporal"]
    fields += [f".{MEMBER.get(option, option)} = {value}" for option, value in values.items()]
    fields.append(f".max_distance = {max_distance}")
    return begin + (",\n" + len(begin) * " ").join(fields) + "};\n"


def source(best, function):
    """The text of tracker/tuned_for_hogs.cpp or tuned_for_codes.cpp, whose name is the function's."""
    return HEADER.replace("FUNCTION", function) + "".join(
        f"    case TemporalModel::k{model.capitalize()}:\n" + statement(trial, MAX_DISTANCE[function])
        for model, trial in best.items()) + FOOTER


def table(best, measured):
    lines = ["| | " + " | ".join(PLACES) + " | pose error | rotation, deg | joints, deg |",
             "| --- |" + " --- |" * (len(PLACES) + 3)]
    for model, trial in best.items():
        cells = [str(trial[option]) if option in OPTIONS[model] else "" for option in PLACES]
        of = measured[model]
        lines.append(f"| {model} | " + " | ".join(cells) + f" | {of['pose_error']:.3f} "
                     f"| {of['rotation_deg']:.1f} | {of['joint_deg']:.1f} |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("database")
    parser.add_argument("--graspdb", default="build/release/cli/graspdb")
    parser.add_argument("--sequences", default="sequences/train")
    parser.add_argument("--codes", action="store_true", help="DB has the codes of a learned descriptor")
    parser.add_argument("--log", type=pathlib.Path, help="a JSON line for every trial")
    parser.add_argument("--write", action="store_true",
                        help="tracker/tuned_for_hogs.cpp, or tuned_for_codes.cpp with --codes")
    arguments = parser.parse_args()
    log = arguments.log.open("w") if arguments.log else None

    def measure(trials):
        results = run(trials, arguments)
        if log:
            log.writelines(json.dumps(result) + "\n" for result in results)
            log.flush()
        return [means(result) for result in results]

    first = START_OF_CODES if arguments.codes else START
    start = {model: {"temporal": model, **{option: first[option] for option in options}}
             for model, options in OPTIONS.items()}
    best, measured = descend(measure, start)
    print(table(best, measured))
    if arguments.write:
        function = "tuned_for_codes" if arguments.codes else "tuned_for_hogs"
        (TRACKER / f"{function}.cpp").write_text(source(best, function))


if __name__ == "__main__":
    main()
