# SPDX-License-Identifier: MIT
"""Turns a trained finder into whole numbers, and works those out slowly: what the program's own code must agree with.

A layer reads the result before it, or, with "beside": n, that result doubled in size (each pixel four times, cut to
the other's size) followed by the result of layer n. Its own is (sum of products + bias) * multiplier / 2^32, rounded, a half
upwards; all but the last layer's are then cut to 0..255.
"""

import json

import numpy
import torch
import torch.nn.functional as F

from export import LARGEST_BYTE, add_layer, best_range, quantised, with_norm
from finder_net import CLASSES, doubled
from integer_net import scaled

FORMAT = {"format": "graspdb finder", "format_version": "1"}
SCORE_STEP = 1 / 16  # of the last layer's results


def folded(block):
    """(weight, bias) of a layer, of which the last has no norm."""
    is_last = isinstance(block, torch.nn.Conv2d)
    weight, bias = (block.weight, block.bias) if is_last else with_norm(block[0], block[1])
    return weight.detach().float(), bias.detach().float()


def whole_numbers(net, pictures):
    """Tensors of the file. `pictures` [N, 3, H, W] of 0..1 show how large results become."""
    tensors, results, steps, picture, step = {}, [], [], pictures, torch.full((3,), 1 / LARGEST_BYTE)
    for number, (layer, block) in enumerate(zip(net.layers, net.blocks)):
        if layer.beside is not None:
            picture = torch.cat([doubled(picture, results[layer.beside]), results[layer.beside]], 1)
            step = torch.cat([step, steps[layer.beside]])
        weight, bias = folded(block)
        picture = F.conv2d(picture, weight, bias, layer.stride, layer.padding)
        out_step = SCORE_STEP
        if number < len(net.layers) - 1:
            picture = picture.relu()
            out_step = best_range(picture) / LARGEST_BYTE
        whole, unit = quantised(weight * step[None, :, None, None])  # the weights of whole inputs
        factor = unit / out_step
        assert factor.max() < 1 / 2, f"layer {number}: results too fine for a multiplier of 31 bits"
        add_layer(tensors, number, whole, bias / unit, factor)
        step = torch.full((layer.outputs,), out_step)
        results.append(picture)
        steps.append(step)
    return tensors


def export(net, pictures, extra):
    """(tensors, metadata) of the file."""
    net.eval()
    with torch.no_grad():
        tensors = whole_numbers(net, pictures)
    layers = [{"stride": layer.stride, "padding": layer.padding}
              | ({} if layer.beside is None else {"beside": layer.beside}) for layer in net.layers]
    return tensors, {**FORMAT, "licence": "MIT", "layers": json.dumps(layers), "parts": json.dumps(CLASSES),
                     "score_step": json.dumps(SCORE_STEP), **extra}


def integer_scores(tensors, metadata, pictures):
    """Scores [N, classes, h, w] of BGR bytes [N, H, W, 3]. Doubles hold all sums exactly."""
    picture, results = torch.as_tensor(pictures).permute(0, 3, 1, 2).double(), []
    layers = json.loads(metadata["layers"])
    for number, layer in enumerate(layers):
        if "beside" in layer:
            picture = torch.cat([doubled(picture, results[layer["beside"]]), results[layer["beside"]]], 1)
        weight = torch.as_tensor(numpy.array(tensors[f"layer{number}.weight"])).permute(0, 3, 1, 2).double()
        bias = torch.as_tensor(numpy.array(tensors[f"layer{number}.bias"])).double()
        sums = F.conv2d(picture, weight, bias, layer["stride"], layer["padding"]).long()
        multiplier = numpy.array(tensors[f"layer{number}.multiplier"])[None, :, None, None]
        picture = torch.as_tensor(scaled(sums.numpy(), multiplier))
        if number < len(layers) - 1:
            picture = picture.clamp(0, LARGEST_BYTE).double()
        results.append(picture)
    return picture
