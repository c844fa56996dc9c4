# SPDX-License-Identifier: MIT
"""Safetensors files: eight bytes with the header's length, a header in JSON, then the numbers."""

import json
import os
import pathlib
import struct

import numpy

DTYPES = {"U8": numpy.uint8, "I8": numpy.int8, "I32": numpy.int32, "F32": numpy.float32}
NAMES = {numpy.dtype(dtype): name for name, dtype in DTYPES.items()}
ALIGNMENT = 8


def read(path):
    """(tensors by name, which stay on the disk until they are used; metadata)."""
    with open(path, "rb") as file:
        length = struct.unpack("<Q", file.read(8))[0]
        header = json.loads(file.read(length))
    metadata = header.pop("__metadata__", {})
    tensors = {}
    for name, entry in header.items():
        tensors[name] = numpy.memmap(path, DTYPES[entry["dtype"]], "r", 8 + length + entry["data_offsets"][0],
                                     tuple(entry["shape"]))
    return tensors, metadata


def to_bytes(tensors, metadata):
    header, start = {"__metadata__": metadata}, 0
    for name, values in tensors.items():
        header[name] = {"dtype": NAMES[values.dtype], "shape": list(values.shape),
                        "data_offsets": [start, start + values.nbytes]}
        start += values.nbytes
    text = json.dumps(header, separators=(",", ":")).encode()
    text += b" " * (-len(text) % ALIGNMENT)
    return struct.pack("<Q", len(text)) + text + b"".join(values.tobytes() for values in tensors.values())


def write(path, tensors, metadata):
    write_aside(path, to_bytes(tensors, metadata))


def write_aside(path, data):
    """A reader never sees half a file, whenever this is killed."""
    aside = pathlib.Path(f"{path}.part")
    aside.write_bytes(data)
    os.replace(aside, path)
