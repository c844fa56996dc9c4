#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Scores tracks of 21 keypoints against the truth of sequences, MediaPipe's and graspdb's alike (docs/peers.md).

    scripts/peers/score.py TRUTH NAME=TRACKS ... [--json FILE]

TRUTH holds a folder for each sequence with truth.jsonl and sequence.json, as `graspdb sequence` writes them. TRACKS
holds SEQUENCE.jsonl for each of them: of mediapipe.mjs or of `graspdb track --json`. In the table, "all" counts a
frame without an answer with the last answer's error, at first that of a flat hand; "answered" leaves it out.
Scores are means over sequences; those by how much of the hand is hidden are rotation errors, means over frames.
"""

import argparse
import collections
import json
import pathlib

import numpy

METRICS = {"rotation_deg": "rotation", "flips": ">90 %", "pa_mpjpe_mm": "PA mm", "error_2d_palms": "2D palms",
           "flexion_deg": "flexion"}
HIDDEN = (0, 16, 32, 48, 64, 100)  # bins of how much of the hand the object hides, percent
BINS = [f"{low}-{high}" for low, high in zip(HIDDEN, HIDDEN[1:])]

# Keypoints: the wrist, then thumb, index, middle, ring and little finger, four each from the palm to the tip.
WRIST, INDEX, MIDDLE, LITTLE = 0, 5, 9, 17

# Of a right hand whose palm faces the camera, fingers down in the picture: graspdb's flat hand without a turn.
# Millimetres to the right and down from the wrist; all are as far from the camera.
FLAT_MM = [(0, 0),
           (-22, 22), (-50, 56), (-70, 80), (-86, 100),
           (-24, 90), (-24, 132), (-24, 157), (-24, 178),
           (-2, 91), (-2, 137), (-2, 165), (-2, 187),
           (17, 85), (17, 127), (17, 153), (17, 175),
           (34, 76), (34, 109), (34, 128), (34, 148)]
FLAT_DISTANCE_M = 0.7

Camera = collections.namedtuple("Camera", "focal_px centre_px")
Answer = collections.namedtuple("Answer", "points pixels")  # [21, 3] metres; [21, 2]
Truth = collections.namedtuple("Truth", "points hidden camera")  # [N, 21, 3] metres, camera frame; [N]


def unit(vector):
    return vector / numpy.linalg.norm(vector, axis=-1, keepdims=True)


def degrees(cosine):
    return numpy.degrees(numpy.arccos(numpy.clip(cosine, -1, 1)))


def palm_frame(points):
    """Rotation of the palm: x to the little finger's side, y to the fingers, z out of a right hand's back."""
    to_index, to_middle, to_little = (points[joint] - points[WRIST] for joint in (INDEX, MIDDLE, LITTLE))
    y = unit(to_middle)
    across = numpy.cross(to_index, to_little)
    z = unit(across - y * (across @ y))
    return numpy.stack([numpy.cross(y, z), y, z], 1)


def turn_deg(a, b):
    """The angle between two rotations."""
    return degrees((numpy.trace(a @ b.T) - 1) / 2)


def aligned(points, truth):
    """The points after the similarity transform that takes them nearest to the truth (Umeyama 1991)."""
    centred, target = points - points.mean(0), truth - truth.mean(0)
    u, stretch, v = numpy.linalg.svd(target.T @ centred)
    signs = numpy.array([1, 1, numpy.linalg.det(u @ v)])  # a hand is not mirrored
    scale = (stretch * signs).sum() / (centred ** 2).sum()
    return scale * centred @ (u * signs @ v).T + truth.mean(0)


def bends_deg(points):
    """[5]: how far each finger is bent at its three joints together."""
    chains = points[1:].reshape(5, 4, 3)
    wrists = numpy.broadcast_to(points[WRIST], (5, 1, 3))
    bones = unit(numpy.diff(numpy.concatenate([wrists, chains], 1), axis=1))
    return degrees((bones[:, 1:] * bones[:, :-1]).sum(2)).sum(1)


def projected(points, camera):
    return points[:, :2] / points[:, 2:] * camera.focal_px + camera.centre_px


def mean_distance(a, b):
    return numpy.linalg.norm(a - b, axis=1).mean()


def errors(answer, truth, camera):
    """Of one frame: a value for each of METRICS, as docs/evaluation.md defines them."""
    rotation = turn_deg(palm_frame(answer.points), palm_frame(truth))
    palm_px = numpy.linalg.norm(truth[MIDDLE] - truth[WRIST]) * camera.focal_px / truth[WRIST, 2]
    return {"rotation_deg": rotation,
            "flips": float(rotation > 90),
            "pa_mpjpe_mm": 1000 * mean_distance(aligned(answer.points, truth), truth),
            "error_2d_palms": mean_distance(answer.pixels, projected(truth, camera)) / palm_px,
            "flexion_deg": numpy.abs(bends_deg(answer.points) - bends_deg(truth)).mean()}


def flat_hand(camera):
    points = numpy.array([(x, y, 1000 * FLAT_DISTANCE_M) for x, y in FLAT_MM]) / 1000
    return Answer(points, projected(points, camera))


def score(answers, truth):
    """Errors of every frame. None in `answers` is a frame without one: it has the error of the last answer."""
    last, frames = flat_hand(truth.camera), []
    for answer, points, hidden in zip(answers, truth.points, truth.hidden, strict=True):
        last = last if answer is None else answer
        told = {"answered": answer is not None, "hidden": hidden}
        frames.append(told | errors(last, points, truth.camera))
    return frames


def read_answer(line):
    """Of a line of mediapipe.mjs or of `graspdb track --json`."""
    if not (line["world"] if "world" in line else line["valid"]):
        return None
    if "world" not in line:
        return Answer(*(numpy.reshape(line[key], (21, -1)) for key in ("joints_m", "joints_px")))
    # MediaPipe counts from the picture's corner, graspdb from the middle of its first pixel.
    pixels = numpy.array(line["landmarks"][0])[:, :2] * (line["width"], line["height"]) - 0.5
    return Answer(numpy.array(line["world"][0]), pixels)


def read_lines(path):
    with path.open(encoding="utf-8") as file:
        return [json.loads(line) for line in file]


def read_truth(folder):
    camera = json.loads((folder / "sequence.json").read_text())["camera"]
    lines = read_lines(folder / "truth.jsonl")
    return Truth(numpy.array([numpy.reshape(line["joints_m"], (21, 3)) for line in lines]),
                 numpy.array([line["occlusion"] for line in lines]),
                 Camera(camera["fx_px"], numpy.array([camera["cx_px"], camera["cy_px"]])))


def score_file(path, truth):
    lines = read_lines(path)
    if len(lines) != len(truth.points):
        raise SystemExit(f"{path}: expected {len(truth.points)} lines, a frame each; found {len(lines)}")
    return score([read_answer(line) for line in lines], truth)


def mean(values):
    values = list(values)
    return float(numpy.mean(values)) if values else None


def mean_errors(frames):
    return {metric: mean(frame[metric] for frame in frames) for metric in METRICS}


def by_hidden_share(frames):
    """The mean rotation error in each of BINS; the last bin has its end, too."""
    places = numpy.digitize([100 * frame["hidden"] for frame in frames], HIDDEN[1:-1])
    return {name: mean(frame["rotation_deg"] for frame, place in zip(frames, places) if place == number)
            for number, name in enumerate(BINS)}


def summary(sequences):
    """Of one track's frames by sequence: means over sequences, and by how much of the hand is hidden."""
    per_sequence = {name: mean_errors(frames) for name, frames in sequences.items() if frames}
    means = {metric: mean(one[metric] for one in per_sequence.values()) for metric in METRICS}
    frames = [frame for frames in sequences.values() for frame in frames]
    return means | {"rotation_deg_by_hidden_percent": by_hidden_share(frames), "sequences": per_sequence}


def scores(sequences):
    answered = {name: [frame for frame in frames if frame["answered"]] for name, frames in sequences.items()}
    shares = {name: len(answered[name]) / len(frames) for name, frames in sequences.items()}
    return {"answered_share": mean(shares.values()), "answered_share_by_sequence": shares,
            "all": summary(sequences), "answered": summary(answered)}


def cell(value, decimals):
    return "-" if value is None else f"{value:.{decimals}f}"


def table_row(name, share, one):
    flips = None if one["flips"] is None else 100 * one["flips"]
    hidden = [cell(value, 0) for value in one["rotation_deg_by_hidden_percent"].values()]
    return [name, cell(100 * share, 0), cell(one["rotation_deg"], 1), cell(flips, 1), cell(one["pa_mpjpe_mm"], 1),
            cell(one["error_2d_palms"], 2), cell(one["flexion_deg"], 1), *hidden]


def table(results):
    rows = [["", "answered %", *METRICS.values(), *BINS]]
    for name, result in results.items():
        for which in ("all", "answered"):
            rows.append(table_row(f"{name}, {which}", result["answered_share"], result[which]))
    widths = [max(map(len, column)) for column in zip(*rows)]
    aligned_rows = [[row[0].ljust(widths[0]), *map(str.rjust, row[1:], widths[1:])] for row in rows]
    return "\n".join("  ".join(row) for row in aligned_rows)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("truth", type=pathlib.Path, metavar="TRUTH")
    parser.add_argument("tracks", nargs="+", metavar="NAME=TRACKS")
    parser.add_argument("--json", type=pathlib.Path, metavar="FILE", help="write the scores, of each sequence too")
    options = parser.parse_args()
    if not all("=" in track for track in options.tracks):
        parser.error("expected NAME=TRACKS")
    return options


def main():
    options = arguments()
    truths = {folder.name: read_truth(folder) for folder in sorted(options.truth.iterdir())}
    results = {}
    for name, folder in (track.rsplit("=", 1) for track in options.tracks):
        results[name] = scores({sequence: score_file(pathlib.Path(folder) / f"{sequence}.jsonl", truth)
                                for sequence, truth in truths.items()})
    print(table(results))
    if options.json:
        options.json.write_text(json.dumps(results, indent=1) + "\n")


if __name__ == "__main__":
    main()
