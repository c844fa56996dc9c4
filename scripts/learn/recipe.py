# SPDX-License-Identifier: MIT
"""All that a training depends on, as it stands in the weights' metadata."""

import dataclasses
import json
import math

import losses
from net import layers_from


def one_cycle(rate, warm_up, share):
    """The rate after a share of the training: up in a line, down as a cosine."""
    if share < warm_up:
        return rate * max(share / warm_up, 0.02)
    return rate * (1 + math.cos(math.pi * (share - warm_up) / (1 - warm_up))) / 2


@dataclasses.dataclass(frozen=True)
class Recipe:
    layers: str = "5x16/2 3x32/2 3x32 3x64/2 3x64 3x64 3x128/2 3x128 3x128"
    planes: tuple = ("gray", "mask")
    size: int = 128
    seed: int = 0
    crops: int = 6_000_000
    batch: int = 512
    parts: int = 2  # of a batch, each with statistics of its own: one a processor
    shard: int = 20_000
    first: int = 0  # number of the first training picture
    rate: float = 3e-3
    warm_up: float = 0.05  # share of the training in which the rate rises
    decay: float = 1e-2
    weights: losses.Weights = losses.Weights()

    def rate_at(self, share):
        return one_cycle(self.rate, self.warm_up, share)

    def net_layers(self):
        return layers_from(self.layers)

    def json(self):
        return json.dumps(dataclasses.asdict(self))

    @staticmethod
    def parse(text):
        values = json.loads(text)
        values["planes"] = tuple(values["planes"])
        values["weights"] = losses.Weights(**values["weights"])
        return Recipe(**values)
