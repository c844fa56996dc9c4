# SPDX-License-Identifier: MIT
"""The net: convolutions in a row, so that whole numbers can follow it, then a short code.

What only training needs, the heads, reads the code too: what they can tell, the code must hold.
"""

import dataclasses

import torch
import torch.nn.functional as F
from torch import nn

from rotations import DIRECTIONS, ROLLS

SIDE = 64
ANGLES, JOINTS = 28, 21


@dataclasses.dataclass(frozen=True)
class Layer:
    outputs: int
    kernel: int
    stride: int
    padding: int


def layers_from(text):
    """"5x16/2 3x32/2 3x32": kernel x outputs / stride. A kernel as large as its stride has no padding."""
    layers = []
    for word in text.split():
        kernel, rest = word.split("x")
        outputs, _, stride = rest.partition("/")
        kernel, stride = int(kernel), int(stride or 1)
        layers.append(Layer(int(outputs), kernel, stride, 0 if kernel == stride else kernel // 2))
    return layers


def side_after(layers):
    side = SIDE
    for layer in layers:
        side = (side + 2 * layer.padding - layer.kernel) // layer.stride + 1
    return side


class Body(nn.Module):
    """Planes [N, P, 64, 64] of 0..1 to codes [N, D], not normalised."""

    def __init__(self, planes, layers, size):
        super().__init__()
        self.layers = layers
        inputs, blocks = planes, []
        for layer in layers:
            blocks += [nn.Conv2d(inputs, layer.outputs, layer.kernel, layer.stride, layer.padding, bias=False),
                       nn.BatchNorm2d(layer.outputs), nn.ReLU(inplace=True)]
            inputs = layer.outputs
        self.blocks = nn.Sequential(*blocks)
        self.code = nn.Conv2d(inputs, size, side_after(layers))

    def forward(self, planes):
        return self.code(self.blocks(planes)).flatten(1)


class Net(nn.Module):
    """`body` gives codes of `size` numbers, not normalised, of whatever it reads."""

    def __init__(self, body, size):
        super().__init__()
        self.body = body
        self.sharpness = nn.Parameter(torch.tensor(8.0))  # how far apart directions are for the heads
        self.view = nn.Linear(size, DIRECTIONS * ROLLS)
        self.angles = nn.Linear(size, ANGLES)
        self.joints = nn.Linear(size, JOINTS * 3)

    def forward(self, seen):
        code = F.normalize(self.body(seen).float(), dim=1)
        sharp = code * self.sharpness
        return {"code": code, "view": self.view(sharp).float(), "angles": self.angles(sharp).float(),
                "joints": self.joints(sharp).float().view(-1, JOINTS, 3)}


def planes_of(samples, names, device="cpu"):
    """The crops [N, P, 64, 64], 0..1, channels last: what oneDNN is fastest with."""
    planes = torch.stack([torch.as_tensor(samples[name]) for name in names], -1).to(device)
    return planes.permute(0, 3, 1, 2).float().div_(255)


def multiplications(layers, planes, size):
    side, inputs, total = SIDE, planes, 0
    for layer in layers:
        side = (side + 2 * layer.padding - layer.kernel) // layer.stride + 1
        total += side * side * layer.kernel ** 2 * inputs * layer.outputs
        inputs = layer.outputs
    return total + side * side * inputs * size
