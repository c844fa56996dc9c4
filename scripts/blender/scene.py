# SPDX-License-Identifier: MIT
"""What the exports of hands and objects share: finding things in a scene, its unit, its axes."""
import sys

import bpy
from mathutils import Matrix

# Blender has z up, glTF y: the exporter turns everything by this.
GLTF_FROM_BLENDER = Matrix(((1, 0, 0, 0), (0, 0, 1, 0), (0, -1, 0, 0), (0, 0, 0, 1)))


def fail(message):
    """Ends Blender with exit code 1."""
    sys.exit(f"export_for_graspdb: {bpy.data.filepath or 'unsaved scene'}: {message}")


def pick(objects, what, name, option):
    """The one of `objects` called `name`, or the only one."""
    names = ", ".join(sorted(o.name for o in objects))
    if name is not None:
        objects = [o for o in objects if o.name == name]
        if not objects:
            fail(f"no {what} named {name}; there is: {names or 'none'}")
    if not objects:
        fail(f"no {what}")
    if len(objects) > 1:
        fail(f"{len(objects)} of kind {what}: choose with {option}: {names}")
    return objects[0]


def metres_per_unit():
    unit = bpy.context.scene.unit_settings
    return 1.0 if unit.system == "NONE" else unit.scale_length


def select_only(objects):
    """Selects them, hidden ones too."""
    for other in bpy.context.view_layer.objects:
        other.select_set(False)
    for one in objects:
        one.hide_viewport = False
        one.hide_set(False)
        one.select_set(True)


def export_glb(path, objects, **options):
    select_only(objects)
    bpy.ops.export_scene.gltf(
        filepath=str(path.resolve()),
        export_format="GLB",
        use_selection=True,
        export_apply=True,
        export_texcoords=False,
        export_materials="NONE",
        export_animations=False,
        export_morph=False,
        **options,
    )
