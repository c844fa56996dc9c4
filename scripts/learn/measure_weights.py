#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Measures files of weights by retrieval, without a training: how well their codes find drawn pictures, or the
frames of sequences, among drawn references.

    measure_weights.py --program GRASPDB --work DIR (--config FILE | --sequences DIR [--photoreal DIR]) WEIGHTS ...

--config is that of the samples that are looked for (docs/samples.md); they are drawn each time. References and
frames are kept in --work.
"""

import argparse
import pathlib

import export
import safetensors
from measure import Frames, Measurement, made, tell

QUERIES = 5000
UNSEEN = 10 ** 9  # number of a picture that no training comes to


def measurement_of(options):
    if options.sequences:
        return Measurement(options.program, options.work, options.sequences, options.photoreal)
    measurement = Measurement(options.program, options.work)
    queries = options.work / "queries.safetensors"
    queries.unlink(missing_ok=True)  # perhaps of another configuration
    measurement.frames[""] = Frames(made(options.program, queries,
                                         ["--config", options.config, "--first", UNSEEN, "--count", QUERIES]))
    return measurement


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--work", required=True, type=pathlib.Path)
    asked = parser.add_mutually_exclusive_group(required=True)
    asked.add_argument("--config")
    asked.add_argument("--sequences")
    parser.add_argument("--photoreal")
    parser.add_argument("weights", nargs="+", type=pathlib.Path)
    options = parser.parse_args()
    if options.photoreal and not options.sequences:
        parser.error("--photoreal: only with --sequences")
    measurement = measurement_of(options)
    for path in options.weights:
        tensors, metadata = safetensors.read(path)
        print(path.stem, flush=True)
        tell(measurement.of_codes(lambda samples: export.integer_codes(tensors, metadata, samples)))


if __name__ == "__main__":
    main()
