# SPDX-License-Identifier: MIT
"""What the net is trained for. Each is a mean over the batch; the weights are the recipe's."""

import dataclasses
import math

import torch
import torch.nn.functional as F

from rotations import angles_to_all, even_rotations

VIEW_SIGMA = math.radians(9)


@dataclasses.dataclass(frozen=True)
class Weights:
    view: float = 1
    angles: float = 3
    joints: float = 5
    contrast: float = 0.5
    # A pair is like by a normal curve of these widths; `temperature` is that of the codes' cosine.
    contrast_turn_deg: float = 12
    contrast_angles_deg: float = 12
    temperature: float = 0.07


class Losses:
    def __init__(self, weights, device="cpu"):
        self.weights = weights
        self.views = even_rotations().to(device)

    def view(self, scores, rotation):
        """Classes with soft targets: two answers may both be likely, where a regression takes their mean."""
        far = angles_to_all(rotation, self.views) / VIEW_SIGMA
        return -(F.softmax(-far * far / 2, 1) * F.log_softmax(scores, 1)).sum(1).mean()

    def contrast(self, code, rotation, angles):
        """Codes lie as near to each other, within the batch, as their poses do."""
        turn = angles_to_all(rotation, rotation) / math.radians(self.weights.contrast_turn_deg)
        bend = torch.cdist(angles, angles) / math.sqrt(angles.shape[1])
        bend = bend / math.radians(self.weights.contrast_angles_deg)
        itself = torch.eye(len(code), dtype=torch.bool, device=code.device)
        likeness = (-(turn ** 2 + bend ** 2) / 2).masked_fill(itself, -1e4)
        scores = (code @ code.T / self.weights.temperature).masked_fill(itself, -1e4)
        return -(F.softmax(likeness, 1) * F.log_softmax(scores, 1)).sum(1).mean()

    def __call__(self, out, truth):
        """(the sum, each part by name)."""
        parts = {"view": self.view(out["view"], truth["rotation"]),
                 "angles": F.smooth_l1_loss(out["angles"], truth["angles"], beta=0.1),
                 # In tenths of a metre, so that their size is like that of the angles.
                 "joints": F.smooth_l1_loss(out["joints"], truth["joints"] * 10, beta=0.1)}
        if self.weights.contrast:
            parts["contrast"] = self.contrast(out["code"], truth["rotation"], truth["angles"])
        total = sum(getattr(self.weights, name) * part for name, part in parts.items())
        return total, {name: part.item() for name, part in parts.items()}
