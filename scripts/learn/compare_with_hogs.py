#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""What of a learned descriptor is the feature, and what is the metric: retrieval by HOGs as they are, by a linear
map of HOGs that is learned from the same pictures with the same losses, by learned codes, and by both.

    compare_with_hogs.py --program GRASPDB --work DIR --sequences DIR [--photoreal DIR] WEIGHTS

References and frames are kept in --work, as training pictures are.
"""

import argparse
import pathlib

import numpy
import torch
import torch.nn.functional as F
from torch import nn

import export
import losses
import measure
import retrieval
import safetensors
from net import Net
from recipe import Recipe
from shards import LABELS

HOG = 512
SIZE = 128  # of a learned code of HOGs
PICTURES, EPOCHS, BATCH = 200_000, 12, 512
HOG_SHARES = (0.25, 0.5, 1)  # of a HOG's length beside a code's


class Matrix(nn.Module):
    """As a convolution, because Debian's BLAS is slow."""

    def __init__(self):
        super().__init__()
        self.weights = nn.Conv2d(HOG, SIZE, 1, bias=False)

    def forward(self, hogs):
        return self.weights(hogs[:, :, None, None]).flatten(1)


def hogs_of(samples):
    return torch.as_tensor(numpy.array(samples["hog"])).float() / 255


def pictures(program, folder, mode):
    """HOGs and labels of training pictures, the same that a net begins with."""
    samples = measure.made(program, folder / "pictures.safetensors", ["--hog", mode, "--count", PICTURES])
    return {name: torch.as_tensor(numpy.array(samples[name])) for name in ("hog", *LABELS)}


def learned_metric(held):
    torch.manual_seed(0)
    recipe = Recipe()
    metric, loss = Net(Matrix(), SIZE), losses.Losses(recipe.weights)
    steps = EPOCHS * (PICTURES // BATCH)
    optimizer = torch.optim.AdamW(metric.parameters(), recipe.rate, weight_decay=recipe.decay)
    for step in range(steps):
        picked = torch.randint(PICTURES, (BATCH,))
        for group in optimizer.param_groups:
            group["lr"] = recipe.rate_at(step / steps)
        truth = {name: held[name][picked] for name in LABELS}
        total, told = loss(metric(held["hog"][picked].float() / 255), truth)
        optimizer.zero_grad()
        total.backward()
        optimizer.step()
        if step % 500 == 0:
            print(f"  {step / steps:4.0%}  " + "  ".join(f"{name} {part:.3f}" for name, part in told.items()), flush=True)
    return metric.eval()


def joined(codes, hogs, share):
    return F.normalize(torch.cat([codes, share * hogs], 1), dim=1)


def tell_of(measurement, title, codes):
    print(title, flush=True)
    measure.tell(measurement.of_codes(codes))


def directions_of(samples):
    return F.normalize(hogs_of(samples), dim=1)


def compare(options, mode):
    folder = options.work / mode
    measurement = measure.Measurement(options.program, folder, options.sequences, options.photoreal,
                                      described=["--hog", mode])
    weights, codes = safetensors.read(options.weights), {}

    def codes_of(samples):
        if id(samples) not in codes:
            codes[id(samples)] = export.integer_codes(*weights, samples)
        return codes[id(samples)]

    tell_of(measurement, f"HOG, {mode}", directions_of)
    metric = learned_metric(pictures(options.program, folder, mode))
    with torch.no_grad():
        tell_of(measurement, f"linear map of HOGs, {mode}", lambda samples: metric(hogs_of(samples))["code"])
        for title, frames in measurement.frames.items():
            answer = retrieval.answer_of_heads(metric(hogs_of(frames.samples)))
            measure.tell({title + "its heads": frames.figures(answer)})
    tell_of(measurement, "learned codes", codes_of)
    for share in HOG_SHARES:
        tell_of(measurement, f"learned codes and {share} of HOG, {mode}",
                lambda samples, share=share: joined(codes_of(samples), directions_of(samples), share))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--work", required=True, type=pathlib.Path)
    parser.add_argument("--sequences", required=True)
    parser.add_argument("--photoreal")
    parser.add_argument("weights")
    options = parser.parse_args()
    for mode in ("paper", "soft-edges"):
        compare(options, mode)


if __name__ == "__main__":
    main()
