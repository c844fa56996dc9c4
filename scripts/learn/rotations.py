# SPDX-License-Identifier: MIT
"""Rotations as matrices: angles between them, means, and an even set that serves as classes."""

import math

import torch

DIRECTIONS, ROLLS = 54, 12
GOLDEN_ANGLE = math.pi * (3 - math.sqrt(5))


def even_rotations():
    """[648, 3, 3]: directions on a Fibonacci sphere, each turned about itself."""
    place = torch.arange(DIRECTIONS, dtype=torch.float64)
    z = 1 - (2 * place + 1) / DIRECTIONS
    radius, turn = torch.sqrt(1 - z * z), place * GOLDEN_ANGLE
    forward = torch.stack([radius * torch.cos(turn), radius * torch.sin(turn), z], 1)
    aside = torch.zeros_like(forward)
    along_x = forward[:, 0].abs() > 0.9
    aside[along_x, 1] = 1
    aside[~along_x, 0] = 1
    right = torch.cross(aside, forward, dim=1)
    right = right / right.norm(dim=1, keepdim=True)
    frames = torch.stack([right, torch.cross(forward, right, dim=1), forward], 1)
    roll = torch.arange(ROLLS, dtype=torch.float64) * 2 * math.pi / ROLLS
    c, s, zero, one = roll.cos(), roll.sin(), torch.zeros_like(roll), torch.ones_like(roll)
    rolls = torch.stack([c, -s, zero, s, c, zero, zero, zero, one], 1).view(-1, 3, 3)
    return (rolls[None] @ frames[:, None]).reshape(-1, 3, 3).float()


def radians(cosines3):
    """The angle of a rotation whose matrix has the trace `cosines3`."""
    return torch.arccos(((cosines3 - 1) / 2).clamp(-1, 1))


def angle_between(a, b):
    """Radians between rotations [..., 3, 3] one by one."""
    return radians((a * b).sum((-1, -2)))


def angles_to_all(a, b):
    """Radians between each of `a` [N, 3, 3] and each of `b` [M, 3, 3]."""
    return radians(a.reshape(-1, 9) @ b.reshape(-1, 9).T)


def nearest_rotation(matrices):
    """The rotation nearest to each [..., 3, 3]: of a weighted sum, the chordal mean."""
    u, _, vh = torch.linalg.svd(matrices)
    turned = torch.det(u @ vh)
    u = torch.cat([u[..., :2], u[..., 2:] * turned[..., None, None]], -1)
    return u @ vh
