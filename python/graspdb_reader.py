# SPDX-License-Identifier: MIT
"""Reads a graspdb database with nothing but json and numpy (docs/format.md).

    database = graspdb_reader.Database("hands.graspdb")
    database.rows, database.columns["hog"].shape, database.grasps
    database.angles()               # [N, 28] radians, named by database.label_names[3:]

Columns are mapped, not read. Checksums are not checked here: `graspdb verify` does that.
"""

import json
import os

import numpy

DTYPES = {"F32": "<f4", "U32": "<u4", "U16": "<u2", "U8": "u1"}


class Database:
    """columns: name -> array of N rows; metadata: name -> text; grasps: id -> name; hands: dicts."""

    def __init__(self, path):
        header, data_start = read_header(path)
        self.metadata = header.pop("__metadata__")
        self.rows = header["label"]["shape"][0]
        size = os.path.getsize(path) - data_start
        # An empty file range cannot be mapped.
        data = numpy.memmap(path, "u1", "r", data_start) if size else numpy.empty(0, "u1")
        self.columns = {name: column(data, entry) for name, entry in header.items()}
        self.grasps = {g["id"]: g["name"] for g in json.loads(self.metadata["grasps"])}
        self.hands = json.loads(self.metadata["hands"])
        self.variants = json.loads(self.metadata["variants"])
        self.steps = int(self.metadata["steps"])
        self.views = int(self.metadata["views"])
        self.data_card = json.loads(self.metadata.get("data_card", "{}"))
        self.label_names = json.loads(self.metadata["columns"])["label"]["names"]

    def rotation_vectors(self):
        """[N, 3] radians: the rotation of camera_from_hand."""
        return self.columns["label"][:, :3]

    def angles(self):
        """[N, 28] radians: the joint angles."""
        return self.columns["label"][:, 3:]


def read_header(path):
    """The header and where the data starts, in bytes."""
    with open(path, "rb") as file:
        length = int.from_bytes(file.read(8), "little")
        if length > os.path.getsize(path) - 8:
            raise ValueError(f"{path}: not a graspdb database, or cut short")
        header = json.loads(file.read(length))
    metadata = header.get("__metadata__", {})
    if metadata.get("format") != "graspdb" or metadata.get("format_version") not in ("1", "2"):
        raise ValueError(f"{path}: not a graspdb database of version 1 or 2")
    return header, 8 + length


def column(data, entry):
    start, end = entry["data_offsets"]
    return data[start:end].view(DTYPES[entry["dtype"]]).reshape(entry["shape"])
