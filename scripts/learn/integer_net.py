# SPDX-License-Identifier: MIT
"""A file of weights worked out in whole numbers, slowly: what the program's own code must agree with.

A layer's output is (sum of products + bias) * multiplier / 2^32, rounded, a half upwards; all but the
last one's are then cut to 0..255. Of the last one's z, byte d of the code is 128 + z[d] * scale / |z|,
rounded, a half away from 0, and cut to 0..255, where |z| is the root of the sum of squares, rounded
down, and at least 1.
"""

import json
import math

import numpy

import safetensors

SHIFT = 32
MIDDLE = 128


def windows(picture, kernel, stride, padding):
    """[N, H, W, C] to [N, H', W', kernel * kernel * C]."""
    framed = numpy.pad(picture, ((0, 0), (padding, padding), (padding, padding), (0, 0)))
    seen = numpy.lib.stride_tricks.sliding_window_view(framed, (kernel, kernel), (1, 2))
    seen = seen[:, ::stride, ::stride].transpose(0, 1, 2, 4, 5, 3)
    return seen.reshape(*seen.shape[:3], -1)


def scaled(sums, multiplier):
    return (sums.astype(numpy.int64) * multiplier + (1 << (SHIFT - 1))) >> SHIFT


def exact_sums(picture, weight, stride, padding):
    rows = weight.reshape(len(weight), -1).astype(numpy.int32)
    return windows(picture, weight.shape[1], stride, padding).astype(numpy.int32) @ rows.T


def code_bytes(z, scale):
    result = numpy.empty(z.shape, numpy.uint8)
    for row, values in zip(result, z.tolist()):
        length = max(math.isqrt(sum(value * value for value in values)), 1)
        for d, value in enumerate(values):
            rounded = (2 * abs(value) * scale + length) // (2 * length)
            row[d] = min(max(MIDDLE + (rounded if value >= 0 else -rounded), 0), 255)
    return result


class IntegerNet:
    def __init__(self, tensors, metadata, sums=exact_sums):
        """`sums` may be a faster way to the same sums of products."""
        self.planes = json.loads(metadata["planes"])
        self.scale = int(metadata["embedding_scale"])
        self.sums = sums
        self.layers = [(entry["stride"], entry["padding"],
                        *(numpy.asarray(tensors[f"layer{i}.{part}"]) for part in ("weight", "bias", "multiplier")))
                       for i, entry in enumerate(json.loads(metadata["layers"]))]

    @staticmethod
    def load(path, sums=exact_sums):
        return IntegerNet(*safetensors.read(path), sums)

    def values(self, samples):
        """z [N, D] of the crops."""
        picture = numpy.stack([samples[name] for name in self.planes], -1)
        for stride, padding, weight, bias, multiplier in self.layers:
            picture = scaled(self.sums(picture, weight, stride, padding) + bias, multiplier)
            last = weight is self.layers[-1][2]
            picture = picture if last else picture.clip(0, 255).astype(numpy.uint8)
        return picture[:, 0, 0]

    def codes(self, samples):
        return code_bytes(self.values(samples), self.scale)
