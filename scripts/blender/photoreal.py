# SPDX-License-Identifier: MIT
"""Renders a sequence as photographs: the hand, object and camera of `graspdb sequence --meshes`, with
skin, room and light of their own.

blender -b --factory-startup --python-exit-code 1 --python photoreal.py -- MESHES LOOKS.toml SET OUT
    [--frames 0,40,80]      these, though they are there; otherwise those that OUT lacks
    [--check MASKS]         renders nothing: holds silhouettes (of four frames, or --frames) against
                            the masks of `graspdb sequence --out`

SET is train or test; the look is the one of LOOKS.toml with the sequence's name. Pictures are JPEG.
"""
import argparse
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
sys.dont_write_bytecode = True
# pylint: disable=wrong-import-position
import cv2
import photoreal_picture as picture
import photoreal_stage as stage
import tomllib
from photoreal_meshes import Meshes

LOWEST_IOU = 0.98


def parse_arguments(arguments):
    parser = argparse.ArgumentParser(prog="photoreal.py --", description=__doc__)
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.add_argument("meshes", type=Path)
    parser.add_argument("looks", type=Path)
    parser.add_argument("set", choices=("train", "test"))
    parser.add_argument("out", type=Path, help="the folder for 000000.jpg ...")
    parser.add_argument("--frames", type=lambda text: [int(n) for n in text.split(",")])
    parser.add_argument("--check", type=Path, metavar="MASKS")
    return parser.parse_args(arguments)


def read_look(file, set_name, name):
    looks = tomllib.loads(file.read_text())
    if name not in looks[set_name]:
        sys.exit(f"photoreal: {file}: no look for {name} in {set_name}")
    return looks["common"] | looks[set_name][name]


def missing_frames(meshes, out):
    return [i for i in range(meshes.frame_count) if not (out / f"{i:06}.jpg").exists()]


def some_frames(meshes):
    last = meshes.frame_count - 1
    return [0, last // 3, 2 * last // 3, last]


def check(studio, frames, masks):
    """The hand that Blender sees is the hand that graspdb sees."""
    worst = 1.0
    for frame in frames:
        seen = studio.hand_silhouette(frame) > 0.5
        truth = cv2.imread(str(masks / f"{frame:06}.png"), cv2.IMREAD_GRAYSCALE) > 127
        iou = (seen & truth).sum() / (seen | truth).sum()
        hidden = studio.hidden_by_sleeve(frame)
        print(f"frame {frame}: IoU {iou:.4f}, the sleeve hides {100 * hidden:.1f} % of the hand")
        worst = min(worst, iou)
    if worst < LOWEST_IOU:
        sys.exit(f"photoreal: {studio.meshes.name}: IoU {worst:.4f} is below {LOWEST_IOU}")


def render(studio, look, frames, out):
    out.mkdir(parents=True, exist_ok=True)
    camera = picture.Camera(studio.seed, look, studio.plate(), studio.meter())
    for done, frame in enumerate(frames, 1):
        begin = time.time()
        photo = camera.photograph(studio.foreground(frame), frame)
        aside = out / f"{frame:06}.aside.jpg"
        if not cv2.imwrite(str(aside), photo, picture.jpeg_options(look["jpeg_quality"])):
            sys.exit(f"photoreal: {aside}: cannot be written")
        aside.rename(out / f"{frame:06}.jpg")
        seconds = time.time() - begin
        print(f"{studio.meshes.name}: {done} of {len(frames)} frames, {seconds:.2f} s", flush=True)


def main():
    arguments = parse_arguments(sys.argv[sys.argv.index("--") + 1 :])
    meshes = Meshes(arguments.meshes)
    look = read_look(arguments.looks, arguments.set, meshes.name)
    frames = arguments.frames
    if frames is None:
        frames = some_frames(meshes) if arguments.check else missing_frames(meshes, arguments.out)
    if not frames:
        return
    studio = stage.Studio(meshes, look)
    if arguments.check:
        check(studio, frames, arguments.check)
    else:
        render(studio, look, frames, arguments.out)


main()
