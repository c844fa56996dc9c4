# SPDX-License-Identifier: MIT
"""The `paper` descriptor written a second time, from its definition, with numpy alone.

hog_reference.py PICTURES OUT: PICTURES holds records of int32 width, int32 height, the grey picture
and its mask (width * height bytes each); OUT gets 512 bytes a record.
"""
import sys

import numpy as np


def sobel(padded):
    """Horizontal and vertical 3x3 Sobel of the interior of `padded`."""
    smooth_y = padded[:-2] + 2 * padded[1:-1] + padded[2:]
    smooth_x = padded[:, :-2] + 2 * padded[:, 1:-1] + padded[:, 2:]
    return smooth_y[:, 2:] - smooth_y[:, :-2], smooth_x[2:] - smooth_x[:-2]


def describe(gray, mask):
    result = np.zeros((8, 8, 8), np.uint8)
    inside = mask != 0
    if not inside.any():
        return result
    rows, columns = np.nonzero(inside)
    window = np.s_[rows.min() : rows.max() + 1, columns.min() : columns.max() + 1]
    inside = inside[window]
    padded = np.pad(np.where(inside, gray[window], 0).astype(np.int64), 1)
    gx, gy = sobel(padded)
    angle = np.degrees(np.arctan2(gy, gx)) % 180.0
    bins = np.floor(angle / 22.5).astype(int) % 8
    neighbours = np.lib.stride_tricks.sliding_window_view(padded, (3, 3))
    valid = inside & (neighbours.max((2, 3)) - neighbours.min((2, 3)) >= 1)
    edges = [[i * (size // 8) for i in range(8)] + [size] for size in inside.shape]
    for r in range(8):
        for c in range(8):
            cell = np.s_[edges[0][r] : edges[0][r + 1], edges[1][c] : edges[1][c + 1]]
            votes = np.bincount(bins[cell][valid[cell]], minlength=8)
            if votes.sum() == 0:
                continue
            share = votes * int(inside[cell].sum())
            whole = int(votes.sum()) * inside[cell].size
            result[r, c] = (2 * 255 * share + whole) // (2 * whole)
    return result


def main():
    data = open(sys.argv[1], "rb").read()
    with open(sys.argv[2], "wb") as out:
        while data:
            width, height = np.frombuffer(data, "<i4", 2)
            size = int(width) * int(height)
            pictures = np.frombuffer(data, np.uint8, 2 * size, 8).reshape(2, height, width)
            out.write(describe(*pictures).tobytes())
            data = data[8 + 2 * size :]


main()
