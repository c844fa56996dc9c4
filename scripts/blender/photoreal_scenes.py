# SPDX-License-Identifier: MIT
"""Renders scenes of `graspdb scenes` as photographs, each with a drawn look of its own: for training a finder of
hands.

blender -b --factory-startup --python-exit-code 1 --python photoreal_scenes.py -- SCENES LOOKS.toml OUT

Of every scene SCENES/NUMBER comes OUT/NUMBER: photo0.jpg ..., the pictures; what they are made of, room.png and
front0.png ... (the light's root, 65535 = 4; front has an alpha), so that other rooms can be put behind; and
labels0.png ...: 0 rest, 1 hand, 2 forearm, 3 object, 4 sleeve. Folders that are there are kept.
"""
import argparse
import math
import sys
import time
import tomllib
import zlib
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
sys.dont_write_bytecode = True
# pylint: disable=wrong-import-position
import cv2
import numpy as np
import photoreal_looks
import photoreal_picture as picture
import photoreal_stage as stage
from photoreal_meshes import Meshes

BRIGHTEST = 4
FOREARM, SLEEVE = 2, 4
LOOKS = 1  # number of a stream of random numbers
QUICK = {"samples": 4, "plate_samples": 8, "threads": 1}


def parse_arguments(arguments):
    parser = argparse.ArgumentParser(prog="photoreal_scenes.py --", description=__doc__)
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.add_argument("scenes", type=Path)
    parser.add_argument("looks", type=Path, help="whose skins are in no picture")
    parser.add_argument("out", type=Path)
    parser.add_argument("--part", type=part, default=(0, 1), metavar="I/N", help="every Nth scene from the Ith on")
    return parser.parse_args(arguments)


def part(text):
    number, count = map(int, text.split("/"))
    return number, count


def half_height_deg(camera):
    return math.degrees(math.atan(camera["height_px"] / 2 / camera["fy_px"]))


def skins_of(looks):
    return [look["skin"] for set_name in ("train", "test") for look in looks[set_name].values()]


def rooted(linear, exposure):
    """16 bits, in OpenCV's order of channels. An alpha stays as it is."""
    light = exposure * linear[:, :, :3]
    levels = 65535 * np.sqrt(np.clip(light, 0, BRIGHTEST) / BRIGHTEST)[:, :, ::-1]
    if linear.shape[2] == 4:
        levels = np.dstack([levels, 65535 * np.clip(linear[:, :, 3], 0, 1)])
    return np.rint(levels).astype(np.uint16)


def with_arm(labels, studio, frame):
    """The labels with what hides the hand in some views: the arm beyond the drawn forearm."""
    arm = studio.visible_sleeve(frame) > 0.5
    return np.where(arm, FOREARM if studio.look["arm"] == "bare" else SLEEVE, labels).astype(np.uint8)


def write(path, image, *options):
    if not cv2.imwrite(str(path), image, *options):
        sys.exit(f"photoreal_scenes: {path}: cannot be written")


def smoothed(light):
    """Without the grain of few samples, which would tell room from hand; edges stay."""
    return cv2.bilateralFilter(np.sqrt(np.ascontiguousarray(light)), 5, 0.1, 1.5) ** 2


def render(meshes, labels, look, out):
    studio = stage.Studio(meshes, look)
    room = smoothed(studio.plate())
    camera = picture.Camera(studio.seed, look, room, studio.meter())
    write(out / "room.png", rooted(room, camera.exposure))
    for frame in range(meshes.frame_count):
        front = studio.foreground(frame)
        seen = cv2.imread(str(labels / f"{frame:06}.png"), cv2.IMREAD_GRAYSCALE)
        write(out / f"front{frame}.png", rooted(front, camera.exposure))
        write(out / f"labels{frame}.png", with_arm(seen, studio, frame))
        photo = camera.photograph(front, frame)
        write(out / f"photo{frame}.jpg", photo, picture.jpeg_options(90))


def render_scene(folder, looks, out):
    meshes = Meshes(folder)
    # A stream of its own: the room draws from the name's number alone, and must not follow the skin.
    rng = np.random.default_rng([zlib.crc32(meshes.name.encode()), LOOKS])
    look = photoreal_looks.draw(looks["common"] | QUICK, rng, skins_of(looks), half_height_deg(meshes.camera))
    aside = out.with_suffix(".aside")
    aside.mkdir(parents=True, exist_ok=True)
    render(meshes, folder / "labels", look, aside)
    aside.rename(out)


def main():
    arguments = parse_arguments(sys.argv[sys.argv.index("--") + 1 :])
    looks = tomllib.loads(arguments.looks.read_text())
    scenes = sorted(folder for folder in arguments.scenes.iterdir() if (folder / "meshes.json").exists())
    first, step = arguments.part
    scenes = scenes[first::step]
    for done, folder in enumerate(scenes, 1):
        out = arguments.out / folder.name
        if out.exists():
            continue
        begin = time.time()
        render_scene(folder, looks, out)
        print(f"scenes: {done} of {len(scenes)}, {time.time() - begin:.2f} s", flush=True)


main()
