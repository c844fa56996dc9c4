# SPDX-License-Identifier: MIT
"""The finder's net: a frame's colours to scores of what each of its parts shows.

Convolutions in a row; one marked "+n" reads the result before it, doubled in size, beside that of layer n, so that
what was seen coarsely is told finely.
"""

import dataclasses

import torch
import torch.nn.functional as F
from torch import nn

LAYERS = "5x16/2 3x32/2 3x32 3x64/2 3x64 3x96/2 3x96 3x96 3x64+4 3x32+2 3x32+0 1x4"
CLASSES = ("rest", "hand", "arm", "object")


@dataclasses.dataclass(frozen=True)
class Layer:
    outputs: int
    kernel: int
    stride: int = 1
    beside: int | None = None  # the layer whose result is read, too

    @property
    def padding(self):
        return self.kernel // 2


def layers_from(text):
    layers = []
    for word in text.split():
        kernel, rest = word.split("x")
        rest, _, beside = rest.partition("+")
        outputs, _, stride = rest.partition("/")
        layers.append(Layer(int(outputs), int(kernel), int(stride or 1), int(beside) if beside else None))
    return layers


def doubled(picture, like):
    """Each pixel four times; what sticks out beyond the other picture is cut."""
    return F.interpolate(picture, scale_factor=2, mode="nearest")[..., : like.shape[2], : like.shape[3]]


class FinderNet(nn.Module):
    """Colours [N, 3, H, W] of 0..1 to scores [N, classes, H / 2, W / 2], rounded up."""

    def __init__(self, layers):
        super().__init__()
        self.layers = layers
        inputs, self.blocks = 3, nn.ModuleList()
        for number, layer in enumerate(layers):
            if layer.beside is not None:
                inputs += layers[layer.beside].outputs
            self.blocks.append(self.block(inputs, layer, number == len(layers) - 1))
            inputs = layer.outputs

    @staticmethod
    def block(inputs, layer, is_last):
        convolution = nn.Conv2d(inputs, layer.outputs, layer.kernel, layer.stride, layer.padding, bias=is_last)
        if is_last:
            return convolution
        return nn.Sequential(convolution, nn.BatchNorm2d(layer.outputs), nn.ReLU(inplace=True))

    def forward(self, picture):
        results = []
        for layer, block in zip(self.layers, self.blocks):
            if layer.beside is not None:
                picture = torch.cat([doubled(picture, results[layer.beside]), results[layer.beside]], 1)
            picture = block(picture)
            results.append(picture)
        return picture


def multiplications(layers, height, width):
    sizes, inputs, total = [], 3, 0
    for layer in layers:
        if layer.beside is not None:
            height, width = sizes[layer.beside][:2]
            inputs += layers[layer.beside].outputs
        height = (height + 2 * layer.padding - layer.kernel) // layer.stride + 1
        width = (width + 2 * layer.padding - layer.kernel) // layer.stride + 1
        total += height * width * layer.kernel**2 * inputs * layer.outputs
        sizes.append((height, width))
        inputs = layer.outputs
    return total
