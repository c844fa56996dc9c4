#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The paper's claims, each as a paired difference with a verdict (docs/evaluation.md).

    scripts/claims.py --main DIR [--held DIR --free DIR] [--seen-hand DIR] [--seen-grasp DIR]
                      [--bench bench.json] [--photoreal DIR] --out claims.md

Each DIR is what `graspdb eval --out` wrote. Writes a table and, beside it, claims.json. A claim
whose evaluations are not given is left out.

The rules, written down before the test set was run:

A difference is taken sequence by sequence, of sequences that both sides have; sequences are then
drawn with replacement, 10,000 times, for its 95 % interval. It is confirmed when the whole interval
lies below the margin (0 unless told), refuted when the whole of it lies above, else undecided.
Fewer than six sequences decide nothing: five agree by chance one time in sixteen. A claim of
several differences is refuted when one of them is, confirmed when all are, else undecided. The
measure is the mean pose_error of a sequence; rotation_deg is told and decides nothing.

a1  kde beats gaussian beats none: kde - gaussian and gaussian - none, at each alpha, margin 0.
    kde - none and successors - kde (ours, where it was run) are told and decide nothing.
a2  more so at higher alpha: kde - none at 2 % minus kde - none at 0, margin 0; the same of
    kde - gaussian and gaussian - none is told and decides nothing.
b   largely unaffected by noise up to 2 %: kde at alpha - kde at 0, at each alpha above 0 and up to
    2 %; margin: 10 % of the mean of kde at 0. Higher alphas are told and decide nothing.
c   objects in the database help: --held (a database of held rows) minus --free (of free rows), kde
    at alpha 0, margin 0. Only frames closed to 50 % or more, of sequences in which the object hides
    some of the hand in some frame.
d1  generalises to hands that are not in the database: --main minus --seen-hand (the same motions by
    the database's hand), kde at alpha 0; margin: 10 % of the mean of --seen-hand.
d2  and to grasps and objects: --main minus --seen-grasp (the same motions by the database's hand
    with the database's own grasp of that type); margin: 10 % of the mean of --seen-grasp.
e   real time on one core: the 99th percentile of a frame's whole time, 640 x 480 pixels, with the
    exact search, is below 100 ms (the paper's 10 frames/s), else refuted. Other searches and 30
    frames/s are told and decide nothing.
"""

import argparse
import dataclasses
import json
import math
import pathlib

import numpy

from evaluation_tables import clustered_interval, number, read_columns

CONFIRMED, REFUTED, UNDECIDED = "confirmed", "refuted", "undecided"
SHARE = 0.1  # how much worse "no worse" may be
NOISY = 2.0  # percent of mask pixels dropped, up to which the paper's error hardly rises
FEWEST = 6  # sequences that decide
GRASPING = 0.5  # closure
METRICS = ("pose_error", "rotation_deg")
FRAME_MS = {"10 frames/s": 100.0, "30 frames/s": 1000 / 30}
CAMERA = (640, 480)
SEARCH = "exact"  # the one that evaluations use


@dataclasses.dataclass
class Line:
    """One measured figure; `decides` when the claim's verdict depends on it."""

    measure: str
    metric: str
    sides: tuple  # the two means whose difference it is, if it is one
    mean: float
    low: float
    high: float
    sequences: int
    margin: float
    decides: bool

    @property
    def verdict(self):
        if self.sides and self.sequences < FEWEST:
            return UNDECIDED
        if self.high < self.margin:
            return CONFIRMED
        if self.low > self.margin:
            return REFUTED
        return UNDECIDED


@dataclasses.dataclass
class Claim:
    name: str
    text: str
    lines: list
    note: str = ""

    @property
    def verdict(self):
        verdicts = [line.verdict for line in self.lines if line.decides]
        if REFUTED in verdicts:
            return REFUTED
        return CONFIRMED if set(verdicts) == {CONFIRMED} else UNDECIDED


class Runs:
    """runs.csv: a mean over frames for each sequence, temporal model and alpha."""

    def __init__(self, directory):
        self.file = directory / "runs.csv"
        columns = read_columns(self.file)
        self.values = {}
        for i, sequence in enumerate(columns["sequence"]):
            key = columns["temporal"][i], number(columns["alpha"][i])
            values = {metric: number(columns[metric][i]) for metric in METRICS}
            self.values.setdefault(key, {})[sequence] = values
        self.models = {model for model, _ in self.values}
        self.alphas = sorted({alpha for _, alpha in self.values})

    def of(self, model, alpha, metric="pose_error"):
        """Sequence to value."""
        if (model, alpha) not in self.values:
            raise SystemExit(f"{self.file}: no runs of {model} at alpha {alpha:g}")
        found = self.values[model, alpha]
        return {sequence: values[metric] for sequence, values in found.items()}


def difference(values, others):
    """values - others, of the sequences that both have."""
    return {name: values[name] - others[name] for name in sorted(set(values) & set(others))}


def line(measure, values, others, metric="pose_error", share=0.0, decides=True):
    """values - others; the margin is a share of the mean of others."""
    paired = difference(values, others)
    if not paired:
        raise SystemExit(f"{measure}: no sequence is on both sides")
    sides = tuple(float(numpy.mean([side[name] for name in paired])) for side in (values, others))
    numbers = numpy.array(list(paired.values()))
    low, high = clustered_interval(numbers, list(paired))
    return Line(measure, metric, sides, float(numbers.mean()), low, high, len(paired),
                share * sides[1], decides)


def beats(runs, model, other, alpha, decides=True):
    return line(f"{model} - {other} at {alpha:g} %", runs.of(model, alpha), runs.of(other, alpha),
                decides=decides)


def claim_order(runs):
    lines = []
    for alpha in runs.alphas:
        lines += [beats(runs, "kde", "gaussian", alpha), beats(runs, "gaussian", "none", alpha),
                  beats(runs, "kde", "none", alpha, decides=False)]
        if "successors" in runs.models:  # ours
            lines.append(beats(runs, "successors", "kde", alpha, decides=False))
    return Claim("a1", "kde beats gaussian beats none", lines)


def claim_more_so(runs):
    lines = []
    for model, other in (("kde", "none"), ("kde", "gaussian"), ("gaussian", "none")):
        noisy, clean = (difference(runs.of(model, alpha), runs.of(other, alpha))
                        for alpha in (NOISY, 0))
        lines.append(line(f"({model} - {other}) at {NOISY:g} % - at 0", noisy, clean,
                          decides=(model, other) == ("kde", "none")))
    return Claim("a2", "more so at higher alpha", lines)


def claim_noise(runs):
    clean = runs.of("kde", 0)
    runs.of("kde", NOISY)  # or the claim could be confirmed without it
    lines = [line(f"kde at {alpha:g} % - at 0", runs.of("kde", alpha), clean, share=SHARE,
                  decides=alpha <= NOISY)
             for alpha in runs.alphas if alpha > 0]
    return Claim("b", f"largely unaffected by noise up to {NOISY:g} %", lines)


def left_out(values, others):
    names = sorted(set(values) ^ set(others))
    return f"On one side only, left out: {', '.join(names)}." if names else ""


def grasping_means(directory, metric):
    """Of kde at alpha 0: a sequence's mean over the frames in which a hand holds an object."""
    columns = read_columns(directory / "frames.csv")
    kept, with_object = {}, set()
    for i, sequence in enumerate(columns["sequence"]):
        if columns["temporal"][i] != "kde" or number(columns["alpha"][i]) != 0:
            continue
        if number(columns["occlusion"][i]) > 0:
            with_object.add(sequence)
        if number(columns["closure"][i]) >= GRASPING:
            kept.setdefault(sequence, []).append(number(columns[metric][i]))
    return {name: float(numpy.mean(kept[name])) for name in with_object & set(kept)}


def claim_objects(held, free):
    lines = []
    for metric in METRICS:
        sides = [grasping_means(directory, metric) for directory in (held, free)]
        lines.append(line("held rows - free rows", *sides, metric,
                          decides=metric == "pose_error"))
    return Claim("c", "objects in the database help", lines, left_out(*sides))


def claim_generalises(name, text, measure, main, seen):
    lines = [line(measure, main.of("kde", 0, metric), seen.of("kde", 0, metric), metric,
                  share=SHARE, decides=metric == "pose_error") for metric in METRICS]
    return Claim(name, text, lines, left_out(main.of("kde", 0), seen.of("kde", 0)))


def frame_times(file):
    """Search to 99th percentile of a frame's whole time in ms, and the number of frames, of
    `graspdb bench --json`."""
    tracker = json.loads(file.read_text())["tracker"]
    size = tracker["width_px"], tracker["height_px"]
    if size != CAMERA:
        raise SystemExit(f"{file}: a video of {CAMERA[0]} x {CAMERA[1]} is asked for, not {size}")
    times = {one["search"]: one["ms"]["total"]["p99"] for one in tracker["trackers"]}
    return times, tracker["frames"]


def claim_speed(file):
    times, frames = frame_times(file)
    lines = [Line(f"p99 of a frame, {search}, against {rate}", "ms", (), ms, ms, ms, 0, limit,
                  decides=(search, rate) == (SEARCH, "10 frames/s"))
             for search, ms in times.items() for rate, limit in FRAME_MS.items()]
    return Claim("e", "real time on one core", lines, f"{frames} frames, one thread.")


def told(directory, key):
    file = directory / "eval.json"
    evaluation = json.loads(file.read_text())
    if key not in evaluation:
        raise SystemExit(f"{file}: no {key}")
    return evaluation[key]


def require_alike(directories, *further):
    """A difference says nothing of what it is asked for when something else differs, too."""
    for key in ("trackers", "search", "seed", "fps", *further):
        values = [told(directory, key) for directory in directories]
        if any(value != values[0] for value in values):
            raise SystemExit(f"{' and '.join(map(str, directories))}: {key} differs")


def require_kind(directory, kind):
    if told(directory, "kind") != kind:
        raise SystemExit(f"{directory}: an evaluation of {kind} frames is asked for")


def paper_claims(arguments):
    for directory in (arguments.main, arguments.held, arguments.free, arguments.seen_hand,
                      arguments.seen_grasp):
        if directory:
            require_kind(directory, "rendered")
    main = Runs(arguments.main)
    claims = [claim_order(main), claim_more_so(main), claim_noise(main)]
    if arguments.held:
        require_alike((arguments.held, arguments.free), "hand", "grasps")
        claims.append(claim_objects(arguments.held, arguments.free))
    others = (
        ("d1", arguments.seen_hand, "generalises to hands that are not in the database",
         "own hand - the database's"),
        ("d2", arguments.seen_grasp, "generalises to hands, grasps and objects that are not in it",
         "own hand and grasp - the database's"))
    for name, directory, text, measure in others:
        if directory:
            require_alike((arguments.main, directory), "database")
            claims.append(claim_generalises(name, text, measure, main, Runs(directory)))
    if arguments.bench:
        claims.append(claim_speed(arguments.bench))
    return claims


def photoreal_claims(directory):
    require_kind(directory, "photoreal")
    runs = Runs(directory)
    return [claim_order(runs), claim_more_so(runs), claim_noise(runs)]


UNITS = {"pose_error": ("pose error", ".3f"), "rotation_deg": ("rotation, deg", ".1f"),
         "ms": ("ms", ".1f")}


def value_text(one):
    digits = UNITS[one.metric][1]
    if one.metric == "ms":
        return f"{one.mean:{digits}}"
    if math.isnan(one.low):
        return f"{one.mean:+{digits}}, no interval"
    return f"{one.mean:+{digits}} [{one.low:+{digits}}, {one.high:+{digits}}]"


def table(claims):
    text = "| claim | measure | both sides | value, 95 % interval | below | sequences | verdict |\n"
    text += "| --- | --- | --- | --- | --- | --- | --- |\n"
    for claim in claims:
        for one in claim.lines:
            unit, digits = UNITS[one.metric]
            margin = f"{one.margin:{digits}}" if one.margin else "0"
            verdict = f"**{one.verdict}**" if one.decides else f"({one.verdict})"
            sides = ", ".join(f"{side:{digits}}" for side in one.sides)
            text += (f"| {claim.name} | {one.measure}: {unit} | {sides} | {value_text(one)} | "
                     f"{margin} | {one.sequences or ''} | {verdict} |\n")
    return text


def summary(claim):
    deciding = [one.verdict for one in claim.lines if one.decides]
    counts = ", ".join(f"{deciding.count(kind)} {kind}"
                       for kind in (CONFIRMED, REFUTED, UNDECIDED) if kind in deciding)
    text = f"**({claim.name}) {claim.text}: {claim.verdict}.**"
    if len(deciding) > 1:
        text += f" Of its {len(deciding)} differences: {counts}."
    return f"{text} {claim.note}".rstrip() + "\n"


def markdown(claims):
    legend = "Both sides: the means whose difference it is. In brackets: told, decides nothing."
    return table(claims) + f"\n{legend}\n\n" + "\n".join(map(summary, claims))


def as_json(claims):
    def plain(value):
        return None if isinstance(value, float) and math.isnan(value) else value
    return [{"claim": claim.name, "text": claim.text, "verdict": claim.verdict, "note": claim.note,
             "lines": [{**{k: plain(v) for k, v in dataclasses.asdict(one).items()},
                        "verdict": one.verdict} for one in claim.lines]} for claim in claims]


def parse(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    folder = {"type": pathlib.Path, "metavar": "DIR"}
    parser.add_argument("--main", required=True, help="the sequences as they are", **folder)
    parser.add_argument("--held", help="against a database of held rows only", **folder)
    parser.add_argument("--free", help="against a database of free rows only", **folder)
    parser.add_argument("--seen-hand", help="eval --hand with the database's hand", **folder)
    parser.add_argument("--seen-grasp", help="the same with --grasps as well", **folder)
    parser.add_argument("--bench", type=pathlib.Path, help="what graspdb bench --json printed")
    parser.add_argument("--photoreal", help="photoreal sequences: a and b, apart", **folder)
    parser.add_argument("--out", type=pathlib.Path, required=True, help="claims.md")
    given = parser.parse_args(arguments)
    if (given.held is None) != (given.free is None):
        parser.error("--held and --free belong together")
    return given


def main(arguments=None):
    given = parse(arguments)
    sets = {"claims": paper_claims(given)}
    if given.photoreal:
        sets["photoreal"] = photoreal_claims(given.photoreal)
    text = markdown(sets["claims"])
    if given.photoreal:
        text += "\nThe photoreal sequences:\n\n" + markdown(sets["photoreal"])
    given.out.parent.mkdir(parents=True, exist_ok=True)
    given.out.write_text(text)
    verdicts = {name: as_json(claims) for name, claims in sets.items()}
    given.out.with_suffix(".json").write_text(json.dumps(verdicts, indent=1) + "\n")
    print(given.out)


if __name__ == "__main__":
    main()
