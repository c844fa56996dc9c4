# SPDX-License-Identifier: MIT
"""Exports an armature and its skin as .glb, and a draft of its rig map beside it."""
import bpy
import rig_draft
from bone_names import DIGITS, guess, side_of
from mathutils import Matrix, Vector
from scene import GLTF_FROM_BLENDER, export_glb, fail, metres_per_unit, pick

SMALLEST_WEIGHT = 1e-4  # the exporter drops what is smaller
MOST_WEIGHTS = 4  # the exporter keeps the largest


def is_skin_of(thing, armature):
    if thing.type != "MESH":
        return False
    if thing.parent == armature and thing.parent_type == "ARMATURE":
        return True
    return any(m.type == "ARMATURE" and m.object == armature for m in thing.modifiers)


def weights_of(skin, armature):
    """For every vertex {bone: weight}, after all modifiers."""
    groups = {group.index: group.name for group in skin.vertex_groups}
    posing = {b.name for b in armature.data.bones if b.use_deform}
    evaluated = skin.evaluated_get(bpy.context.evaluated_depsgraph_get())
    return [
        {
            groups[g.group]: g.weight
            for g in vertex.groups
            if g.weight > SMALLEST_WEIGHT and groups.get(g.group) in posing
        }
        for vertex in evaluated.data.vertices
    ]


def skinned_bones(skins, armature):
    """The bones that move skin. Fails where skin is moved by none."""
    skinned = set()
    for skin in skins:
        weights = weights_of(skin, armature)
        free = [v for v, bones in enumerate(weights) if not bones]
        if free:
            fail(f"mesh {skin.name}: {len(free)} vertices move with no bone, e.g. {free[0]}")
        many = sum(len(bones) > MOST_WEIGHTS for bones in weights)
        if many:
            print(f"{skin.name}: {many} vertices had more than 4 bones; the 4 strongest are kept")
        skinned.update(*weights)
    return skinned


def known_side(bones, side):
    """The side asked for, or the one that all names agree on, or None."""
    sides = {side_of(name) for name in bones} - {None}
    if side is None and len(sides) > 1:
        fail("bones of a left and a right hand: choose with --side")
    return side or (sides.pop() if sides else None)


def selected_normal(skins):
    """The mean direction of the vertices that were selected when the scene was saved."""
    total = Vector()
    for skin in skins:
        turned = skin.matrix_world.to_3x3().inverted().transposed()
        for vertex in skin.data.vertices:
            if vertex.select:
                total += (turned @ vertex.normal).normalized()
    if total.length < 1e-6:
        fail("--nail selected: no vertex is selected in Edit Mode, or they face all ways")
    return total


def file_direction(nail, skins):
    if nail is None:
        return None
    towards = selected_normal(skins) if nail == "selected" else Vector(nail)
    return (GLTF_FROM_BLENDER.to_3x3() @ towards).normalized()


def distal_tails(armature, bones):
    """Where the last bones of the digits end, in the file's coordinates."""
    file_from_armature = (
        GLTF_FROM_BLENDER @ Matrix.Scale(metres_per_unit(), 4) @ armature.matrix_world
    )
    distal = {digit: bones.get(f"{digit}_distal") for digit in DIGITS}
    return {
        digit: file_from_armature @ armature.data.bones[names[0]].tail_local
        for digit, names in distal.items()
        if names
    }


def hang(thing, parent):
    """Makes it a child of `parent`; it stays where it is in the coordinates of the scene."""
    in_scene = thing.matrix_world.copy()
    thing.constraints.clear()
    thing.parent, thing.parent_type = parent, "OBJECT"
    thing.matrix_parent_inverse = Matrix()
    thing.matrix_basis = parent.matrix_world.inverted() @ in_scene


def arranged(armature, skins):
    """What to export: the skins below their armature, as the exporter wants them, and this below a
    root that makes the scene's unit the metre."""
    root = bpy.data.objects.new("metres", None)
    bpy.context.scene.collection.objects.link(root)
    for skin in skins:
        hang(skin, armature)
    hang(armature, root)
    root.scale = [metres_per_unit()] * 3
    return [root, armature, *skins]


def print_size(skins):
    points = [skin.matrix_world @ vertex.co for skin in skins for vertex in skin.data.vertices]
    size = [1000 * metres_per_unit() * (max(axis) - min(axis)) for axis in zip(*points)]
    print("skin: {:.1f} x {:.1f} x {:.1f} mm (Blender's x, y, z)".format(*size))


def free_rig_map(glb):
    """Where the draft goes: beside the .glb; a map that a person may have filled in is kept."""
    rig_map = glb.with_suffix(".rig.toml")
    return glb.with_suffix(".draft.rig.toml") if rig_map.exists() else rig_map


def export(arguments):
    if arguments.out.suffix != ".glb":
        fail(f"{arguments.out}: expected a name that ends in .glb")
    things = bpy.context.view_layer.objects
    armatures = [thing for thing in things if thing.type == "ARMATURE"]
    armature = pick(armatures, "armature", arguments.armature, "--armature")
    armature.data.pose_position = "REST"
    bpy.context.view_layer.update()
    skins = [thing for thing in things if is_skin_of(thing, armature)]
    if not skins:
        fail(f"no mesh is skinned to armature {armature.name} (Armature modifier)")
    for thing in (armature, *skins):
        if thing.matrix_world.determinant() < 0:
            fail(f"{thing.name} is mirrored by a negative scale: apply it (Ctrl+A, Scale)")
    names = [bone.name for bone in armature.data.bones]
    skinned = skinned_bones(skins, armature)
    bones, tips = guess(names, skinned, arguments.side)
    side = known_side([name for named in bones.values() for name in named], arguments.side)
    nail = file_direction(arguments.nail, skins)
    title = f"Which bone of {arguments.out.name} is which of graspdb's (docs/hands.md): a draft."
    tails = distal_tails(armature, bones)
    draft = rig_draft.draft(title, side, nail, bones, tips, tails, names, skinned)
    print_size(skins)
    export_glb(arguments.out, arranged(armature, skins))
    rig_map = free_rig_map(arguments.out)
    rig_map.write_text(draft, encoding="utf-8")
    left = draft.count(rig_draft.FILL_IN)
    print(f"wrote {arguments.out} and {rig_map}; lines to fill in: {left}")
