# SPDX-License-Identifier: MIT
"""How well codes find poses: for each frame the nearest of a set of references, and how far it is off."""

import math

import numpy
import torch
import torch.nn.functional as F

from net import JOINTS
from rotations import angle_between, angles_to_all, even_rotations, nearest_rotation

NEAREST = 50
SOFTNESS = 0.02  # of squared distances between codes of length 1, in the mean of the nearest
FLIP_DEG = 90
REFINED = math.radians(40)  # views that far from the heaviest make the heads' own mean
WRIST = 2  # the first angles, which are no digit's


def nearest(queries, references, count):
    """(squared distances, places) of the nearest codes, of length 1. As a convolution, because
    Debian's BLAS is ten times slower than oneDNN."""
    kernels = references[:, :, None, None]
    found = [torch.topk(F.conv2d(part[:, :, None, None], kernels)[:, :, 0, 0], count, 1)
             for part in queries.split(256)]
    return 2 - 2 * torch.cat([cosine for cosine, _ in found]), torch.cat([place for _, place in found])


def labels_of(samples):
    return {name: torch.as_tensor(numpy.array(samples[name])) for name in ("rotation", "angles", "joints")}


def answers_by_codes(queries, references, labels):
    """What the nearest reference says, and the mean of the NEAREST by weight."""
    far, place = nearest(queries, references, NEAREST)
    weight = F.softmax(-far / SOFTNESS, 1)
    one = {name: values[place[:, 0]] for name, values in labels.items()}
    mean = {name: (values[place] * weight.view(*weight.shape, *[1] * (values.dim() - 1))).sum(1)
            for name, values in labels.items()}
    mean["rotation"] = nearest_rotation(mean["rotation"])
    return {"nearest": one, "mean of 50": mean}


def answer_of_heads(out):
    views = even_rotations()
    share = F.softmax(out["view"], 1)
    best = views[share.argmax(1)]
    share = share * (angles_to_all(best, views) < REFINED)
    mean = (share @ views.view(-1, 9)).view(-1, 3, 3)
    return {"rotation": nearest_rotation(mean), "angles": out["angles"], "joints": out["joints"] / 10}


def errors(answer, truth):
    """Of each frame: degrees of rotation, degrees of the digits' angles, millimetres of the joints."""
    joints = answer["joints"] - truth["joints"]
    joints = joints - joints[:, :1]
    return torch.stack([torch.rad2deg(angle_between(answer["rotation"], truth["rotation"])),
                        torch.rad2deg((answer["angles"] - truth["angles"])[:, WRIST:].abs().mean(1)),
                        joints.view(-1, JOINTS, 3).norm(dim=2).mean(1) * 1000], 1)


def summary(error, sequence):
    """Means over sequences, since these differ in length; the median over frames."""
    per = torch.stack([torch.cat([part.mean(0), (part[:, :1] > FLIP_DEG).float().mean(0)])
                       for part in (error[sequence == i] for i in sequence.unique())])
    turn, angles, joints, flips = per.mean(0).tolist()
    return {"rotation_deg": turn, "median_deg": error[:, 0].median().item(), "flips": flips,
            "angles_deg": angles, "mpjpe_mm": joints}


def told(figures):
    return (f"{figures['rotation_deg']:5.1f} deg, median {figures['median_deg']:4.1f}, "
            f"flips {figures['flips']:5.1%}, joints {figures['angles_deg']:4.1f} deg, "
            f"{figures['mpjpe_mm']:3.0f} mm")
