# SPDX-License-Identifier: MIT
"""Makes of one of our hands a .blend as others might have it, for export_hand_test.cpp.

blender ... -- HAND.glb OUT.blend KIND NAIL

KIND is "left": a left hand in centimetres under Unreal's names, with an idle bone, without bones at
the tips; or "turned": under WebXR's names, armature and skin scaled, turned and moved, neither the
other's child. NAIL, X,Y,Z, is the way that the thumb's nail faces in HAND.glb: what skin of the
last bone faces that way is selected.
"""
import math
import sys

import bpy
import numpy
from mathutils import Matrix, Vector

DIGITS = ("thumb", "index", "middle", "ring", "little")
BONES = {"thumb": ("metacarpal", "proximal", "distal")}
FINGER_BONES = ("metacarpal", "proximal", "middle", "distal")


def import_hand(path):
    if "bool" not in numpy.__dict__:
        numpy.bool = bool  # see scripts/blender/check_skinning.py
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=path)
    armature = next(o for o in bpy.data.objects if o.type == "ARMATURE")
    skin = next(o for o in bpy.data.objects if o.type == "MESH")
    bpy.context.view_layer.objects.active = skin
    bpy.ops.mesh.customdata_custom_splitnormals_clear()
    return armature, skin


def unreal_names():
    names = {"palm": "hand_l", "forearm": "lowerarm_l"}
    for digit in DIGITS:
        theirs = "pinky" if digit == "little" else digit
        for number, bone in enumerate(BONES.get(digit, FINGER_BONES[1:]), 1):
            names[f"{digit}_{bone}"] = f"{theirs}_{number:02}_l"
        names.setdefault(f"{digit}_metacarpal", f"{theirs}_metacarpal_l")
    return names


def webxr_names():
    names = {"palm": "wrist", "forearm": "elbow"}
    for digit in DIGITS:
        theirs = {"thumb": "thumb", "little": "pinky-finger"}.get(digit, f"{digit}-finger")
        for bone in BONES.get(digit, FINGER_BONES)[1:]:
            called = "intermediate" if bone == "middle" else bone
            names[f"{digit}_{bone}"] = f"{theirs}-phalanx-{called}"
        names[f"{digit}_metacarpal"] = f"{theirs}-metacarpal"
        names[f"{digit}_tip"] = f"{theirs}-tip"
    return names


def rename(armature, names):
    for bone in armature.data.bones:
        bone.name = names.get(bone.name, bone.name)  # the skin's groups follow


def select_nail(skin, nail):
    """Selects the skin of the last thumb bone that faces as the nail does."""
    distal = skin.vertex_groups["thumb_distal"].index
    towards = Vector((nail[0], -nail[2], nail[1])).normalized()
    for part in (skin.data.edges, skin.data.polygons):
        part.foreach_set("select", [False] * len(part))
    for vertex in skin.data.vertices:
        weight = sum(g.weight for g in vertex.groups if g.group == distal)
        vertex.select = weight > 0.9 and vertex.normal.dot(towards) > 0.98


def edit_bones(armature):
    bpy.context.view_layer.objects.active = armature
    bpy.ops.object.mode_set(mode="EDIT")
    for bone in armature.data.edit_bones:
        bone.use_connect = False
    return armature.data.edit_bones


def drop_tips(armature):
    bones = edit_bones(armature)
    for digit in DIGITS:
        tip = bones[f"{digit}_tip"]
        tip.parent.tail = tip.head
        bones.remove(tip)
    bpy.ops.object.mode_set(mode="OBJECT")


def add_idle_bone(armature):
    bone = edit_bones(armature).new("ik_hand_l")
    bone.tail = (0, 0, 1)
    bpy.ops.object.mode_set(mode="OBJECT")


def transform(armature, skin, matrix):
    """Of the data itself; the objects stay where they are."""
    bones = edit_bones(armature)
    ends = [(bone, matrix @ bone.head, matrix @ bone.tail) for bone in bones]
    for bone, head, tail in ends:
        bone.head, bone.tail = head, tail
    bpy.ops.object.mode_set(mode="OBJECT")
    skin.data.transform(matrix)
    if matrix.determinant() < 0:
        skin.data.flip_normals()


def make_left(armature, skin):
    drop_tips(armature)
    rename(armature, unreal_names())
    add_idle_bone(armature)
    transform(armature, skin, Matrix.Diagonal((-100, 100, 100, 1)))
    bpy.context.scene.unit_settings.scale_length = 0.01


def make_turned(armature, skin):
    rename(armature, webxr_names())
    transform(armature, skin, Matrix.Scale(0.01, 4))
    skin.parent = None  # its modifier holds it
    armature.matrix_world = skin.matrix_world = (
        Matrix.Translation((1, 2, 3))
        @ Matrix.Rotation(math.radians(70), 4, Vector((1, 2, -1)))
        @ Matrix.Scale(100, 4)
    )


def main():
    hand, out, kind, nail = sys.argv[sys.argv.index("--") + 1 :]
    armature, skin = import_hand(hand)
    select_nail(skin, [float(part) for part in nail.split(",")])
    {"left": make_left, "turned": make_turned}[kind](armature, skin)
    bpy.ops.wm.save_as_mainfile(filepath=out)


main()
