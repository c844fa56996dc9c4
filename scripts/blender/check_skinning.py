# SPDX-License-Identifier: MIT
"""Compares graspdb's skinning of a hand with Blender's own.

blender -b --factory-startup --python-exit-code 1 --python check_skinning.py -- \
    HAND.glb POSES.json OUT.json

Blender reads joints, weights and skin from HAND.glb itself. POSES.json says what graspdb makes of
it, in the file's coordinates, metres: a list of poses, each with its "name"; for every joint that
has moved, in "bones", the 3x4 matrix (by rows) that takes it there from rest; and all "vertices",
in the order of the file. OUT.json gets for every pose the largest distance between a vertex of
graspdb and the same one of Blender, in millimetres.
"""
import json
import sys

import bpy
import numpy
from mathutils import Matrix

# glTF has y up, Blender z: the importer turns everything by this.
BLENDER_FROM_FILE = Matrix(((1, 0, 0, 0), (0, 0, -1, 0), (0, 1, 0, 0), (0, 0, 0, 1)))


def import_hand(path):
    """Opens the file in an empty scene; returns its armature and its skinned mesh."""
    if "bool" not in numpy.__dict__:
        numpy.bool = bool  # Debian 12: the importer of Blender 3.4 is older than its numpy
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=path)
    armatures = [o for o in bpy.data.objects if o.type == "ARMATURE"]
    skins = [o for o in bpy.data.objects if any(m.type == "ARMATURE" for m in o.modifiers)]
    if len(armatures) != 1 or len(skins) != 1:
        sys.exit(f"{path}: expected 1 armature and 1 skin, found {len(armatures)} and {len(skins)}")
    return armatures[0], skins[0]


def posed_bones(armature, file_moved):
    """Where every bone's matrix lies, in the armature; the unnamed follow their parents."""
    armature_from_file = armature.matrix_world.inverted() @ BLENDER_FROM_FILE
    posed = {}
    for bone in armature.data.bones:  # parents come first
        if bone.name in file_moved:
            moved = Matrix(file_moved[bone.name])
            moved.resize_4x4()
            moved = armature_from_file @ moved @ armature_from_file.inverted()
        elif bone.parent:
            moved = posed[bone.parent.name] @ bone.parent.matrix_local.inverted()
        else:
            moved = Matrix()
        posed[bone.name] = moved @ bone.matrix_local
    return posed


def set_pose(armature, file_moved):
    """Poses the armature as graspdb's bones are, through Blender's own hierarchy."""
    unknown = set(file_moved) - set(armature.pose.bones.keys())
    if unknown:
        sys.exit(f"no bones {sorted(unknown)} in the file")
    posed = posed_bones(armature, file_moved)
    for bone in armature.pose.bones:
        parent = {}
        if bone.parent:
            parent = {
                "parent_matrix": posed[bone.parent.name],
                "parent_matrix_local": bone.parent.bone.matrix_local,
            }
        bone.rotation_mode = "QUATERNION"
        bone.matrix_basis = bone.bone.convert_local_to_pose(
            posed[bone.name], bone.bone.matrix_local, invert=True, **parent
        )


def evaluated_vertices(skin):
    """The vertices as the armature modifier puts them, in the file's coordinates."""
    skin = skin.evaluated_get(bpy.context.evaluated_depsgraph_get())
    vertices = numpy.empty(3 * len(skin.data.vertices), numpy.float32)
    skin.data.vertices.foreach_get("co", vertices)
    file_from_skin = numpy.array(BLENDER_FROM_FILE.inverted() @ skin.matrix_world)
    return vertices.reshape(-1, 3) @ file_from_skin[:3, :3].T + file_from_skin[:3, 3]


def largest_difference_mm(ours, theirs):
    if ours.shape != theirs.shape:
        sys.exit(f"{len(ours)} vertices from graspdb, {len(theirs)} in Blender")
    return float(1000 * numpy.linalg.norm(ours - theirs, axis=1).max())


def main():
    hand, poses, out = sys.argv[sys.argv.index("--") + 1 :]
    armature, skin = import_hand(hand)
    differences = {}
    with open(poses) as file:
        for pose in json.load(file):
            set_pose(armature, pose["bones"])
            ours = numpy.array(pose["vertices"])
            differences[pose["name"]] = largest_difference_mm(ours, evaluated_vertices(skin))
    for name, difference in differences.items():
        print(f"{name}: {difference:.6f} mm")
    with open(out, "w") as file:
        json.dump(differences, file)


main()
