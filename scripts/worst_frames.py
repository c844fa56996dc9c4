#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Five frames of the sequence that was read worst, to look at what went wrong.

    scripts/worst_frames.py DIR --db DB --out worst.jpg [--sequences sequences/test]

DIR is what `graspdb eval --out` wrote. Worst is the greatest mean rotation error of kde at alpha 0.
The sequence is rendered and tracked once more; each line of the picture is a frame of
`graspdb track --video`: the frame with the estimate, mask, descriptor, and the row that was chosen.
Needs OpenCV: scripts/install.sh python3-opencv
"""

import argparse
import pathlib
import subprocess
import tempfile

import cv2
import numpy

from evaluation_tables import number, read_columns

FRAMES = (10, 30, 50, 70, 90)
WIDTH_PX = 1120


def worst(directory):
    runs = read_columns(directory / "runs.csv")
    errors = {name: number(error)
              for name, temporal, alpha, error in zip(
                  runs["sequence"], runs["temporal"], runs["alpha"], runs["rotation_deg"])
              if temporal == "kde" and number(alpha) == 0}
    if not errors:
        raise SystemExit(f"{directory}/runs.csv: no run of kde at alpha 0")
    return max(errors.items(), key=lambda item: item[1])


def overlays(graspdb, database, sequence):
    """Every frame of what `track --video` shows of the sequence."""
    with tempfile.TemporaryDirectory() as folder:
        rendered, video = f"{folder}/sequence", f"{folder}/overlay.mp4"
        for command in ([graspdb, "sequence", sequence, "--alpha", "0", "--out", rendered],
                        [graspdb, "track", database, rendered, "--search", "exact",
                         "--video", video]):
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        reader, frames = cv2.VideoCapture(video), []
        while (frame := reader.read()[1]) is not None:
            frames.append(frame)
    return frames


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("directory", type=pathlib.Path)
    parser.add_argument("--db", required=True)
    parser.add_argument("--out", required=True)
    parser.add_argument("--sequences", default="sequences/test")
    parser.add_argument("--graspdb", default="build/release/cli/graspdb")
    arguments = parser.parse_args()
    name, error = worst(arguments.directory)
    frames = overlays(arguments.graspdb, arguments.db, f"{arguments.sequences}/{name}.seq.toml")
    picture = numpy.vstack([frames[i] for i in FRAMES])
    height = round(picture.shape[0] * WIDTH_PX / picture.shape[1])
    picture = cv2.resize(picture, (WIDTH_PX, height), interpolation=cv2.INTER_AREA)
    if not cv2.imwrite(arguments.out, picture, [cv2.IMWRITE_JPEG_QUALITY, 80]):
        raise SystemExit(f"{arguments.out}: cannot be written")
    print(f"{arguments.out}: frames {', '.join(map(str, FRAMES))} of {name}, "
          f"{error:.0f} degrees on average")


if __name__ == "__main__":
    main()
