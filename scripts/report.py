#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""One HTML page in which the sequences of an evaluation play frame by frame (docs/evaluation.md).

    scripts/report.py EVAL_DIR --db hands.graspdb --sequences out/mug out/pen --out report.html

EVAL_DIR is what `graspdb eval --out` wrote, the sequences are what `graspdb sequence --alpha --out`
wrote, with an alpha and the seed of that evaluation. Each is tracked once more to get its pictures;
every answer must be the one that the evaluation gave, or the page is not written.
"""

import argparse
import base64
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

import cv2
import numpy

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "python"))
from graspdb_reader import Database  # pylint: disable=wrong-import-position

WIDTH = 320  # of a frame in the page, pixels
MASK_WIDTH = 260
SIDE = 200  # of the descriptor and of the estimate
LARGEST = 40_000_000  # bytes of the page
METRICS = ("pose_error", "rotation_deg", "joint_deg", "mpjpe_mm", "pa_mpjpe_mm", "error_2d_palms")


def as_base64(picture, extension, options):
    return base64.b64encode(cv2.imencode(extension, picture, options)[1]).decode()


def as_webp(picture, size, quality):
    small = cv2.resize(picture, size, interpolation=cv2.INTER_AREA)
    return as_base64(small, ".webp", [cv2.IMWRITE_WEBP_QUALITY, quality])


def as_bitmap(mask, size):
    small = cv2.resize(mask, size, interpolation=cv2.INTER_AREA)
    return as_base64((small > 127).astype("u1") * 255, ".png", [cv2.IMWRITE_PNG_BILEVEL, 1])


def size_of(camera, width):
    return width, round(camera["height_px"] * width / camera["width_px"])


def number(text):
    """An empty cell is a value that does not apply."""
    return None if text == "" else round(float(text), 3)


class Evaluation:
    """eval.json and frames.csv of one `graspdb eval`."""

    def __init__(self, directory):
        self.json = json.loads((directory / "eval.json").read_text())
        self.lines = {}  # of (sequence, alpha): of each temporal model
        with open(directory / "frames.csv", newline="") as file:
            for line in csv.DictReader(file):
                runs = self.lines.setdefault((line["sequence"], float(line["alpha"])), {})
                runs.setdefault(line["temporal"], []).append(line)

    def runs_of(self, directory, header):
        noise = header["noise"]
        runs = self.lines.get((header["name"], noise["alpha_percent"]))
        if runs is None:
            raise SystemExit(f"{directory}: the evaluation has no sequence {header['name']} "
                             f"at alpha {noise['alpha_percent']:g} %")
        if noise["alpha_percent"] > 0 and noise["seed"] != self.json["seed"]:
            raise SystemExit(f"{directory}: noise of seed {noise['seed']}; the evaluation's is "
                             f"{self.json['seed']}")
        return runs

    def options_of(self, temporal):
        return {**self.json["trackers"][temporal], "search": self.json["search"]}


class Tracked:
    """One more run of the tracker: its answers, and the pictures that it draws."""

    def __init__(self, arguments, options, directory, frame_size):
        with tempfile.TemporaryDirectory() as folder:
            answers = pathlib.Path(folder, "answers.jsonl")
            video = pathlib.Path(folder, "video.mp4")
            command = [arguments.graspdb, "track", arguments.db, directory, "--temporal",
                       arguments.temporal, "--json", answers, "--video", video]
            for name, value in options.items():
                command += ["--" + name.replace("_", "-"), str(value)]
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            if done.returncode:
                raise SystemExit(done.stderr)
            self.answers = [json.loads(line) for line in answers.read_text().splitlines()]
            self.panels = list(panels_of(video, frame_size))

    def check_against(self, lines, directory):
        """The page would show pictures beside errors of other answers."""
        found = [str(a["row"]) if a["valid"] else "" for a in self.answers]
        if found != [line["row"] for line in lines]:
            raise SystemExit(f"{directory}: the tracker's answers are not those of the evaluation; "
                             "was it made with this program, database and these sequences?")


def panels_of(video, frame_size):
    """Descriptor and estimate of each frame; they stand beside frame and mask in the video."""
    capture = cv2.VideoCapture(str(video))
    while True:
        more, picture = capture.read()
        if not more:
            return
        height = picture.shape[0]
        width = round(frame_size[0] * height / frame_size[1])
        hog = picture[:, 2 * width:2 * width + height]
        estimate = picture[:, 2 * width + height:]
        yield (as_webp(cv2.cvtColor(hog, cv2.COLOR_BGR2GRAY), (SIDE, SIDE), 40),
               as_webp(estimate, (SIDE, SIDE), 65))


def projected(truth, camera, scale):
    """The true joints, in pixels of the page's frame."""
    x, y, z = numpy.reshape(truth["joints_m"], (-1, 3)).T
    u = camera["fx_px"] * x / z + camera["cx_px"]
    v = camera["fy_px"] * y / z + camera["cy_px"]
    return scaled(numpy.stack([u, v], 1), scale)


def scaled(points, scale):
    return numpy.round((numpy.asarray(points) + 0.5) * scale, 1).tolist()


def columns_of(lines, prefix=""):
    return {metric: [number(line[prefix + metric]) for line in lines] for metric in METRICS}


def frames_of(directory, header, tracked):
    """What the page shows of each frame."""
    camera = header["camera"]
    scale = WIDTH / camera["width_px"]
    truth = [json.loads(line) for line in (directory / "truth.jsonl").read_text().splitlines()]
    for true, answer, (hog, estimate) in zip(truth, tracked.answers, tracked.panels, strict=True):
        name = f"{true['frame']:06}.png"
        frame = cv2.imread(str(directory / "frames" / name))
        mask = cv2.imread(str(directory / "noisy" / name), cv2.IMREAD_GRAYSCALE)
        valid = answer["valid"]
        yield {
            "time": true["time_s"],
            "picture": as_webp(frame, size_of(camera, WIDTH), 65),
            "mask": as_bitmap(mask, size_of(camera, MASK_WIDTH)),
            "hog": hog,
            "estimate": estimate if valid else None,
            "truth_px": projected(true, camera, scale),
            "estimate_px": scaled(answer["joints_px"], scale) if valid else None,
            "grasp": f"{answer['grasp']['id']} {answer['grasp']['name']}" if valid else None,
            "step": answer["step"] if valid else None,
            "row": answer["row"] if valid else None,
            "confidence": round(answer["confidence"], 2),
            "occlusion": round(true["occlusion"], 3),
            "closure": round(true["closure"], 3),
        }


def sequence_of(arguments, evaluation, directory):
    header = json.loads((directory / "sequence.json").read_text())
    runs = evaluation.runs_of(directory, header)
    camera = header["camera"]
    options = evaluation.options_of(arguments.temporal)
    tracked = Tracked(arguments, options, directory, (camera["width_px"], camera["height_px"]))
    tracked.check_against(runs[arguments.temporal], directory)
    return {
        "name": header["name"],
        "object": header["object"],
        "hand": header["hand"],
        "grasp_type": header["grasp_type"],
        "alpha": header["noise"]["alpha_percent"],
        "frames_per_second": header["frames_per_second"],
        "size": size_of(camera, WIDTH),
        "errors": {model: columns_of(lines) for model, lines in runs.items()},
        "valid": {model: [line["valid"] == "1" for line in lines] for model, lines in runs.items()},
        "oracle": columns_of(next(iter(runs.values())), "oracle_"),
        "frames": list(frames_of(directory, header, tracked)),
    }


def page_of(evaluation, temporal, sequences):
    units = {metric["name"]: metric["unit"] for metric in evaluation.json["metrics"]}
    data = {
        "temporal": temporal,
        "metrics": [{"name": name, "unit": units[name]} for name in METRICS],
        "database": evaluation.json["database"],
        "tracker": evaluation.options_of(temporal),
        "seed": evaluation.json["seed"],
        "sequences": sequences,
    }
    template = pathlib.Path(__file__).with_name("report_template.html").read_text()
    # A name must not end the script that the data stands in.
    text = json.dumps(data, separators=(",", ":")).replace("</", "<\\/")
    return template.replace("{{data}}", text)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("directory", type=pathlib.Path, help="what graspdb eval --out wrote")
    parser.add_argument("--db", required=True, help="the database that was evaluated")
    parser.add_argument("--sequences", type=pathlib.Path, nargs="+", required=True,
                        help="folders that graspdb sequence wrote")
    parser.add_argument("--out", type=pathlib.Path, required=True, help="the page")
    parser.add_argument("--temporal", default="kde",
                        choices=("none", "gaussian", "kde", "successors"),
                        help="whose answers are drawn [kde]")
    parser.add_argument("--graspdb", default=ROOT / "build/release/cli/graspdb", help="the program")
    arguments = parser.parse_args()
    evaluation = Evaluation(arguments.directory)
    found = Database(arguments.db).metadata["content_hash"]
    if found != evaluation.json["database"]["content_hash"]:
        raise SystemExit(f"{arguments.db}: not the database of this evaluation")
    sequences = []
    for directory in arguments.sequences:
        sequences.append(sequence_of(arguments, evaluation, directory))
        print(f"{directory}: {len(sequences[-1]['frames'])} frames")
    page = page_of(evaluation, arguments.temporal, sequences)
    if len(page) > LARGEST:
        raise SystemExit(f"{len(page) / 1e6:.0f} MB, more than {LARGEST / 1e6:.0f} MB: name fewer "
                         "sequences")
    arguments.out.write_text(page)
    print(f"{arguments.out}: {len(page) / 1e6:.1f} MB")


if __name__ == "__main__":
    main()
