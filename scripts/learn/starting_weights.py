# SPDX-License-Identifier: MIT
"""Puts a file of weights back into a net, so that a training goes on from it: for longer, or on other pictures.

Whole numbers hold each convolution with its batch norm in one. To be trained they are parted again: every
convolution's outputs get the variance 1 on some crops, as in a fresh net, and the norm after it gives back what
they were. Outputs are no longer cut at what was the largest byte. The heads are not in the file and begin anew.
"""

import hashlib
import json
import pathlib

import torch
import torch.nn.functional as F

import safetensors
from export import FORMAT, LARGEST_BYTE
from integer_net import SHIFT, IntegerNet
from net import planes_of
from recipe import Recipe
from shards import HELD, round_steps

SMALLEST_VARIANCE = 1e-8


def read(path):
    """(tensors, metadata) of weights that this program trained."""
    tensors, metadata = safetensors.read(path)
    for key, expected in FORMAT.items():
        if metadata.get(key) != expected:
            raise SystemExit(f"{path}: {key}: expected {expected}, found {metadata.get(key)}")
    for key in ("recipe", "crops_seen", "assets"):
        if key not in metadata:
            raise SystemExit(f"{path}: {key}: expected what the weights were made with, found nothing")
    return tensors, metadata


def provenance(path):
    """What weights that began as those of `path` say of them."""
    _, metadata = read(path)
    told = {key: json.loads(metadata[key]) for key in ("recipe", "assets", "started_from") if key in metadata}
    return {"sha256": sha256(path), "crops_seen": int(metadata["crops_seen"]), **told}


def sha256(path):
    return hashlib.sha256(pathlib.Path(path).read_bytes()).hexdigest()


def first_unseen(path):
    """Number of the first training picture that these weights have not seen."""
    _, metadata = read(path)
    recipe = Recipe.parse(metadata["recipe"])
    rounds = -(-int(metadata["crops_seen"]) // (round_steps(recipe) * recipe.batch))
    return recipe.first + (rounds - 1 + HELD) * recipe.shard


def check_fits(path, recipe):
    _, metadata = read(path)
    theirs = Recipe.parse(metadata["recipe"])
    for key in ("layers", "planes", "size"):
        expected, found = getattr(recipe, key), getattr(theirs, key)
        if found != expected:
            raise SystemExit(f"{path}: {key}: expected {expected}, found {found}")


def convolution(layer):
    """(weight, bias) of an IntegerNet's layer on inputs of 0..1, where 1 is what the largest byte stands for."""
    whole, bias, multiplier = (torch.tensor(values).double() for values in layer[2:])
    step = multiplier / 2 ** SHIFT
    return (whole * step[:, None, None, None]).permute(0, 3, 1, 2).float(), (bias * step / LARGEST_BYTE).float()


def put_into(net, recipe, path, crops):
    """`crops` are some thousand samples of what the net will see."""
    check_fits(path, recipe)
    convolutions = [convolution(layer) for layer in IntegerNet(*read(path)).layers]
    body, blocks, unit = net.body, list(net.body.blocks), 1.0
    with torch.no_grad():
        planes = planes_of(crops, recipe.planes)
        for (weight, bias), conv, norm, layer in zip(convolutions, blocks[0::3], blocks[1::3], body.layers):
            sums = F.conv2d(planes, weight * unit, None, layer.stride, layer.padding)
            variance, mean = torch.var_mean(sums, (0, 2, 3), unbiased=False)
            width = variance.clamp(min=SMALLEST_VARIANCE).sqrt()
            conv.weight.copy_(weight * (unit / width)[:, None, None, None])
            planes = (sums + bias[:, None, None]).relu()
            unit = width.mean()
            planes /= unit
            norm.weight.copy_(width / unit)
            norm.bias.copy_((mean + bias) / unit)
            norm.running_mean.copy_(mean / width)
            norm.running_var.fill_(1)
        weight, bias = convolutions[-1]
        code = F.conv2d(planes, weight * unit, bias)
        body.code.weight.copy_(weight * (unit / code.std()))
        body.code.bias.copy_(bias / code.std())
