# SPDX-License-Identifier: MIT
"""Exports a rigged hand or an object from a .blend for graspdb.

blender -b SCENE.blend --factory-startup --python-exit-code 1 --python export_for_graspdb.py -- ...
    hand OUT.glb [--armature NAME] [--side left|right] [--nail selected] [--nail=X,Y,Z]
    object OUT.glb [--object NAME]      or OUT.obj

The .blend stays as it is. Files are in metres, whatever the scene's unit.
"""
import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
sys.dont_write_bytecode = True
# pylint: disable=wrong-import-position
import bpy
import export_hand
import export_object
import scene


def direction(text):
    """selected, or a vector as in 0,-1,0.5"""
    if text == "selected":
        return text
    numbers = tuple(float(part) for part in text.split(","))
    if len(numbers) != 3 or not any(numbers):
        raise ValueError(text)
    return numbers


def parse_arguments(arguments):
    parser = argparse.ArgumentParser(prog="export_for_graspdb.py --", description=__doc__)
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    kinds = parser.add_subparsers(dest="kind", required=True)
    hand = kinds.add_parser("hand", help="an armature and its skin, and a draft of its rig map")
    hand.add_argument("out", type=Path, help="the .glb; OUT.rig.toml is written beside it")
    hand.add_argument("--armature", help="its name, when the scene has several")
    hand.add_argument("--side", choices=("left", "right"), help="when the rig has two hands")
    hand.add_argument(
        "--nail",
        type=direction,
        help="the way the thumb's nail faces at rest, in Blender's axes (--nail=X,Y,Z); or"
        " 'selected': the mean way that the vertices selected in Edit Mode face",
    )
    solid = kinds.add_parser("object", help="a closed mesh")
    solid.add_argument("out", type=Path, help="a .glb or .obj")
    solid.add_argument("--object", help="its name, when the scene has several meshes")
    return parser.parse_args(arguments)


def main():
    start = sys.argv.index("--") + 1 if "--" in sys.argv else len(sys.argv)
    arguments = parse_arguments(sys.argv[start:])
    if not arguments.out.parent.is_dir():
        scene.fail(f"{arguments.out.parent}: no such folder")
    bpy.context.view_layer.update()
    export = export_hand.export if arguments.kind == "hand" else export_object.export
    export(arguments)


main()
