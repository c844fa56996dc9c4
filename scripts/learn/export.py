# SPDX-License-Identifier: MIT
"""Turns a trained net into whole numbers and writes the file that the program reads."""

import json

import numpy
import torch
import torch.nn.functional as F

import safetensors
from integer_net import MIDDLE, SHIFT, IntegerNet
from net import planes_of

FORMAT = {"format": "graspdb descriptor", "format_version": "2"}
LARGEST_WEIGHT, LARGEST_BYTE = 127, 255
LAST_FACTOR = 1 / 4  # of the last layer's sums: as fine as may be, and squares stay small
CLIPPED = 1e-4  # share of a code's values beyond what a byte holds
RANGES = numpy.linspace(0.3, 1, 36)  # of a layer's largest output, that are tried


def with_norm(convolution, norm):
    """(weight, bias) of a convolution, the batch norm after it taken in."""
    factor = norm.weight / torch.sqrt(norm.running_var + norm.eps)
    return convolution.weight * factor[:, None, None, None], norm.bias - norm.running_mean * factor


def folded(body):
    """(weight, bias) of each convolution."""
    blocks = list(body.blocks)
    pairs = [with_norm(convolution, norm) for convolution, norm in zip(blocks[0::3], blocks[1::3])]
    pairs.append((body.code.weight, body.code.bias))
    return [(weight.detach().cpu().float(), bias.detach().cpu().float()) for weight, bias in pairs]


def best_range(values):
    """The output that becomes 255: cut too low it loses the largest, too high it rounds the rest."""
    values = values.flatten()[:: max(1, values.numel() // 500_000)].numpy()
    largest = max(float(values.max()), 1e-6)
    def lost(share):
        step = share * largest / LARGEST_BYTE
        return numpy.square(numpy.minimum(numpy.round(values / step), LARGEST_BYTE) * step - values).mean()
    return largest * min(RANGES, key=lost)


def quantised(weight):
    """(whole weights [out, in, k, k], the step of each output)."""
    step = weight.abs().amax((1, 2, 3)).clamp(min=1e-12) / LARGEST_WEIGHT
    return torch.round(weight / step[:, None, None, None]), step


def factors(step, last):
    if last:  # all of its outputs by one measure; which one does not matter
        return step / step.max() * LAST_FACTOR
    return step


def add_layer(tensors, number, whole, bias, factor):
    tensors[f"layer{number}.weight"] = numpy.ascontiguousarray(whole.permute(0, 2, 3, 1).numpy().astype(numpy.int8))
    tensors[f"layer{number}.bias"] = numpy.round(bias.double().numpy()).astype(numpy.int32)
    tensors[f"layer{number}.multiplier"] = numpy.round(factor.double().numpy() * 2.0 ** SHIFT).astype(numpy.int32)


def whole_numbers(body, planes):
    """(tensors, scale of the codes). `planes` are some thousand crops that show how large outputs become."""
    geometry = [(layer.stride, layer.padding) for layer in body.layers] + [(1, 0)]
    tensors, pairs, in_step = {}, folded(body), 1 / LARGEST_BYTE
    for number, ((weight, bias), (stride, padding)) in enumerate(zip(pairs, geometry)):
        last = number == len(pairs) - 1
        whole, step = quantised(weight)
        planes = F.conv2d(planes, weight, bias, stride, padding)
        out_step = 1
        if not last:
            planes = planes.relu()
            out_step = best_range(planes) / LARGEST_BYTE
        add_layer(tensors, number, whole, bias / (step * in_step), factors(step * in_step / out_step, last))
        in_step = out_step
    directions = F.normalize(planes.flatten(1), dim=1).abs().flatten().numpy()
    scale = int((LARGEST_BYTE - MIDDLE) / numpy.quantile(directions, 1 - CLIPPED))
    table = json.dumps([{"stride": stride, "padding": padding} for stride, padding in geometry])
    return tensors, {"layers": table, "embedding_scale": str(scale)}


def fast_sums(picture, weight, stride, padding):
    """As integer_net's, but by oneDNN: exact, since floats of 32 bits hold whole numbers up to 2^24,
    which these sums stay below (the test compares the two)."""
    planes = torch.as_tensor(picture).permute(0, 3, 1, 2).float()
    kernel = torch.as_tensor(numpy.array(weight)).permute(0, 3, 1, 2).float()
    return F.conv2d(planes, kernel, None, stride, padding).permute(0, 2, 3, 1).numpy().astype(numpy.int32)


def directions_of(codes):
    """Codes as the searches see them: distances of bytes, of length about 1."""
    return F.normalize(torch.as_tensor(codes).float() - MIDDLE, dim=1)


def integer_codes(tensors, metadata, samples, batch=512):
    net = IntegerNet(tensors, metadata, fast_sums)
    count = len(samples["rotation"])
    parts = [net.codes({name: numpy.asarray(samples[name][i:i + batch]) for name in net.planes})
             for i in range(0, count, batch)]
    return directions_of(numpy.concatenate(parts))


def export(net, recipe, calibration, extra):
    """(tensors, metadata) of the file."""
    net.eval()
    with torch.no_grad():
        tensors, computed = whole_numbers(net.body.cpu(), planes_of(calibration, recipe.planes))
    metadata = {**FORMAT, "licence": "MIT", "planes": json.dumps(list(recipe.planes)), "recipe": recipe.json(),
                **computed, **extra}
    return tensors, metadata


def write(path, tensors, metadata):
    safetensors.write(path, tensors, metadata)
