# SPDX-License-Identifier: MIT
"""A table of what files of weights say was measured of them.

    tell_runs.py FILE.safetensors ...
"""

import json
import pathlib
import sys

import safetensors

COLUMNS = ("nearest, int8", "mean of 50, int8", "heads", "photoreal, mean of 50, int8", "photoreal, heads")


def cell(figures):
    return f"{figures['rotation_deg']:.1f} ({figures['angles_deg']:.1f})" if figures else ""


def main():
    print("| rotation (joints), degrees | " + " | ".join(COLUMNS) + " |")
    print("| --- |" + " --- |" * len(COLUMNS))
    for path in map(pathlib.Path, sys.argv[1:]):
        _, metadata = safetensors.read(path)
        figures = json.loads(metadata["figures"])
        print(f"| {path.stem} | " + " | ".join(cell(figures.get(name)) for name in COLUMNS) + " |")


if __name__ == "__main__":
    main()
