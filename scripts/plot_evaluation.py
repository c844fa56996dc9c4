#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws what `graspdb eval --out DIR` wrote: one PNG a figure (docs/evaluation.md).

    scripts/plot_evaluation.py DIR --out FIGURES

Needs matplotlib: scripts/install.sh python3-matplotlib
"""

import argparse
import json
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy

from evaluation_tables import clustered_interval, number, read_columns

# Okabe and Ito's colours, which the colour-blind tell apart; marks and dashes say it once more.
MODELS = {
    "none": {"color": "#E69F00", "marker": "o", "linestyle": ":"},
    "gaussian": {"color": "#0072B2", "marker": "s", "linestyle": "--"},
    "kde": {"color": "#009E73", "marker": "^", "linestyle": "-"},
    "successors": {"color": "#D55E00", "marker": "D", "linestyle": "-."},
}
BASELINES = {"oracle": "-", "constant": "--", "random": ":"}
PARTS = {  # of the gap to the oracle
    "stage": {
        "retrieval": "#0072B2",
        "choice": "#E69F00",
        "placement": "#CC79A7",
        "unanswered": "#999999",
    },
    "part": {"view": "#56B4E9", "pose": "#D55E00"},
}
LABELS = {
    "pose_error": "pose error",
    "rotation_deg": "rotation error (degrees)",
    "joint_deg": "joint error (degrees)",
    "mpjpe_mm": "MPJPE (mm)",
}
OCCLUSION_EDGES = (0, 16, 32, 48, 64, 80, 100)  # percent; the last bin holds what lies beyond 80
FEWEST_ANSWERS = 10  # of a calibration bin whose share is drawn


def read(directory):
    """eval.json, and frames.csv as lists of texts by column."""
    evaluation = json.loads((directory / "eval.json").read_text())
    return evaluation, read_columns(directory / "frames.csv")


class Frames:
    """frames.csv by column; `of` picks one run's frames of all sequences."""

    def __init__(self, columns):
        self.columns = columns
        self.temporal = numpy.array(columns["temporal"])
        self.alpha = self.numbers("alpha")
        self.sequence = numpy.array(columns["sequence"])
        self.alphas = sorted(set(self.alpha))

    def numbers(self, name):
        return numpy.array([number(value) for value in self.columns[name]])

    def of(self, model, alpha):
        return (self.temporal == model) & (self.alpha == alpha)

    def extremes(self):
        """The lowest and the highest alpha: what a figure with a panel an alpha shows."""
        return sorted({self.alphas[0], self.alphas[-1]})


def models_of(evaluation):
    found = {run["temporal"] for run in evaluation["set"]["runs"]}
    return [model for model in MODELS if model in found]


def runs_of(evaluation, model):
    runs = [run for run in evaluation["set"]["runs"] if run["temporal"] == model]
    return sorted(runs, key=lambda run: run["alpha"])


def sequence_count(evaluation):
    return len({row["sequence"] for row in evaluation["rows"]})


def draw_baselines(axes, evaluation, metric):
    for name, style in BASELINES.items():
        mean = number(evaluation["set"][name][metric]["mean"])
        axes.axhline(mean, color="0.45", linewidth=1, linestyle=style, zorder=0)
        axes.annotate(
            name, (1, mean), xycoords=axes.get_yaxis_transform(), xytext=(4, 0), color="0.3",
            textcoords="offset points", va="center", fontsize=9)


def draw_with_intervals(axes, x, mean, ends, model):
    """A model's means, with bars from low to high where there is an interval."""
    low, high = ends
    reach = numpy.array([numpy.subtract(mean, low), numpy.subtract(high, mean)]).clip(min=0)
    axes.errorbar(x, mean, None if numpy.isnan(reach).all() else reach, label=model, capsize=2.5,
                  markersize=5, **MODELS[model])


def draw_over_alpha(axes, evaluation, metric):
    models = models_of(evaluation)
    widest = max(run["alpha"] for run in evaluation["set"]["runs"])
    for i, model in enumerate(models):
        runs = runs_of(evaluation, model)
        found = [run["means"][metric] for run in runs]
        mean, low, high = ([number(f[key]) for f in found] for key in ("mean", "low", "high"))
        # A little aside, so that one interval does not hide another.
        x = numpy.array([run["alpha"] for run in runs]) + (i - (len(models) - 1) / 2) * widest / 120
        draw_with_intervals(axes, x, mean, (low, high), model)
    draw_baselines(axes, evaluation, metric)
    axes.set(xlabel="segmentation noise α (% of hand pixels dropped)", ylabel=LABELS[metric])
    axes.set_ylim(bottom=0)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.15), ncols=len(models))


def figure_alpha(evaluation, _, metric):
    """The paper's Figures 8 and 9: the error over segmentation noise."""
    figure, axes = plt.subplots(figsize=(6.4, 4.2))
    draw_over_alpha(axes, evaluation, metric)
    sequences = sequence_count(evaluation)
    axes.set_title(f"Mean over {sequences} sequences; bars: 95 % interval" if sequences > 1 else
                   "One sequence: no intervals")
    return figure


def occlusion_bins(frames, alpha, models):
    """The bins that have frames: (index, label) each, and each frame's index."""
    percent = 100 * frames.numbers("occlusion")
    index = numpy.clip(numpy.digitize(percent, OCCLUSION_EDGES) - 1, 0, len(OCCLUSION_EDGES) - 2)
    chosen = frames.of(models[0], alpha)
    bins = []
    for i in range(len(OCCLUSION_EDGES) - 1):
        here = chosen & (index == i)
        if not here.any():
            continue
        span = f"{OCCLUSION_EDGES[i]}–{OCCLUSION_EDGES[i + 1]} %"
        sequences = len(set(frames.sequence[here]))
        bins.append((i, f"{span}\nn = {here.sum()}\n{sequences} seq."))
    return bins, index


def draw_over_occlusion(axes, frames, metric, alpha, models):
    bins, index = occlusion_bins(frames, alpha, models)
    x = numpy.arange(len(bins))
    errors, oracle = frames.numbers(metric), frames.numbers("oracle_" + metric)
    for i, model in enumerate(models):
        chosen = [frames.of(model, alpha) & (index == b) for b, _ in bins]
        mean = numpy.array([errors[c].mean() for c in chosen])
        ends = numpy.array([clustered_interval(errors[c], frames.sequence[c]) for c in chosen]).T
        draw_with_intervals(axes, x + (i - 1) * 0.06, mean, ends, model)
    chosen = [frames.of(models[0], alpha) & (index == b) for b, _ in bins]
    axes.plot(x, [oracle[c].mean() for c in chosen], color="0.45", linewidth=1, label="oracle")
    axes.set_xticks(x, [label for _, label in bins], fontsize=8)
    axes.set(xlabel="hand hidden by the object; n: frames, seq.: sequences", ylabel=LABELS[metric])
    axes.set_ylim(bottom=0)


def figure_occlusion(evaluation, frames):
    models, alpha = models_of(evaluation), frames.alphas[0]
    figure, panels = plt.subplots(1, 2, figsize=(10.5, 4.2))
    for axes, metric in zip(panels, ("rotation_deg", "mpjpe_mm")):
        draw_over_occlusion(axes, frames, metric, alpha, models)
    panels[1].legend(loc="center left", bbox_to_anchor=(1, 0.5))
    figure.suptitle(f"Mean over frames at α = {alpha:g} %; bars: 95 % interval, sequences drawn")
    return figure


def figure_rotation(evaluation, frames):
    """Cumulative histogram of the rotation error."""
    alphas = frames.extremes()
    figure, panels = plt.subplots(
        1, len(alphas), figsize=(5.2 * len(alphas), 4.2), sharey=True, squeeze=False)
    models, errors = models_of(evaluation), frames.numbers("rotation_deg")
    oracle = frames.numbers("oracle_rotation_deg")
    for axes, alpha in zip(panels[0], alphas):
        for model in models:
            values = numpy.sort(errors[frames.of(model, alpha)])
            share = numpy.arange(1, len(values) + 1) / len(values)
            look = {k: MODELS[model][k] for k in ("color", "linestyle")}
            axes.step(values, 100 * share, where="post", label=model, **look)
        values = numpy.sort(oracle[frames.of(models[0], alpha)])
        axes.step(values, 100 * numpy.arange(1, len(values) + 1) / len(values), where="post",
                  color="0.45", linewidth=1, label="oracle")
        axes.set(xlim=(0, 180), ylim=(0, 100), xticks=range(0, 181, 30),
                 xlabel="rotation error (degrees)", title=f"α = {alpha:g} %")
    panels[0, 0].set_ylabel("frames with at most this error (%)")
    panels[0, -1].legend(loc="lower right")
    return figure


def draw_stack(axes, x, parts, colours):
    """Bars of parts that add up; negative ones hang below zero."""
    above, below = numpy.zeros(len(parts)), numpy.zeros(len(parts))
    for name, colour in colours.items():
        height = numpy.array([number(part[name]) for part in parts])
        base = numpy.where(height >= 0, above, below)
        axes.bar(x, height, 0.8, bottom=base, color=colour, label=name)
        above += numpy.maximum(height, 0)
        below += numpy.minimum(height, 0)
    axes.plot(x, above + below, "k_", markersize=9, label="total")
    axes.axhline(0, color="0.2", linewidth=0.8)


def label_runs(axes, x, runs, models):
    """The temporal model under each bar, alpha under each group of them."""
    axes.set_xticks(x, [run["temporal"] for run in runs], rotation=90)
    groups = x.reshape(-1, len(models)).mean(1)
    alphas = [f"α = {run['alpha']:g} %" for run in runs[:: len(models)]]
    axes.xaxis.remove_overlapping_locs = False  # a group's middle is a bar's
    axes.set_xticks(groups, alphas, minor=True)
    axes.tick_params(axis="x", which="minor", length=0, pad=58)


def figure_gap(evaluation, _):
    models = models_of(evaluation)
    runs = sorted(evaluation["set"]["runs"],
                  key=lambda run: (run["alpha"], models.index(run["temporal"])))
    x = numpy.arange(len(runs)) + numpy.arange(len(runs)) // len(models)  # a gap after each alpha
    figure, panels = plt.subplots(2, 2, figsize=(11, 6.6), sharex=True, sharey="row")
    for row, metric in enumerate(("pose_error", "mpjpe_mm")):
        for axes, split in zip(panels[row], PARTS):
            draw_stack(axes, x, [run["gap"][metric][split] for run in runs], PARTS[split])
        panels[row, 0].set_ylabel(f"{LABELS[metric]},\nanswer − oracle")
    for axes, title in zip(panels[0], ("by stage", "by part")):
        axes.set_title(title, pad=24)
        axes.legend(ncols=5, fontsize=8, loc="lower center", bbox_to_anchor=(0.5, 1),
                    borderaxespad=0)
    for axes in panels[1]:
        label_runs(axes, x, runs, models)
    return figure


def draw_calibration(above, below, evaluation, alpha):
    models = models_of(evaluation)
    for i, model in enumerate(models):
        run = next(r for r in runs_of(evaluation, model) if r["alpha"] == alpha)
        bins = [b for b in run["calibration"]["bins"] if b["frames"] >= FEWEST_ANSWERS]
        label = f"{model} (ECE {number(run['calibration']['expected_error']):.2f})"
        above.plot([b["confidence"] for b in bins], [100 * b["right"] for b in bins], label=label,
                   markersize=5, **MODELS[model])
        every = run["calibration"]["bins"]
        x = [b["from"] + (i + 0.5) * 0.1 / len(models) for b in every]
        below.bar(x, [b["frames"] for b in every], 0.09 / len(models), color=MODELS[model]["color"])
    above.plot((0, 1), (0, 100), color="0.6", linewidth=1, zorder=0)
    above.set(xlim=(0, 1), ylim=(0, 100), title=f"α = {alpha:g} %")
    above.legend(fontsize=8, loc="upper left")
    below.set(xlabel="confidence")


def figure_calibration(evaluation, frames):
    alphas = frames.extremes()
    figure, panels = plt.subplots(
        2, len(alphas), figsize=(4.8 * len(alphas), 5.6), sharex=True, sharey="row", squeeze=False,
        height_ratios=(3, 1))
    for column, alpha in enumerate(alphas):
        draw_calibration(*panels[:, column], evaluation, alpha)
    panels[0, 0].set_ylabel("answers with rotation\nwithin 30 degrees (%)")
    panels[1, 0].set_ylabel("answers")
    figure.supxlabel(f"bins with fewer than {FEWEST_ANSWERS} answers have no mark", fontsize=8)
    return figure


FIGURES = {
    "pose_error": lambda *data: figure_alpha(*data, "pose_error"),
    "rotation": lambda *data: figure_alpha(*data, "rotation_deg"),
    "occlusion": figure_occlusion,
    "rotation_histogram": figure_rotation,
    "gap": figure_gap,
    "calibration": figure_calibration,
}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("directory", type=pathlib.Path, help="what graspdb eval --out wrote")
    parser.add_argument("--out", type=pathlib.Path, required=True, help="where the figures go")
    arguments = parser.parse_args()
    evaluation, columns = read(arguments.directory)
    out = arguments.out
    out.mkdir(parents=True, exist_ok=True)
    plt.rcParams.update({"axes.spines.top": False, "axes.spines.right": False,
                         "legend.frameon": False, "figure.constrained_layout.use": True})
    frames = Frames(columns)
    for name, draw in FIGURES.items():
        figure = draw(evaluation, frames)
        figure.savefig(out / f"{name}.png", dpi=130)
        plt.close(figure)
        print(out / f"{name}.png")


if __name__ == "__main__":
    main()
