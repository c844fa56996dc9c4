# SPDX-License-Identifier: MIT
"""The hand as a mesh of Blender, and what its skin has to know of every vertex."""
import bpy
import numpy as np

FINGERS = ("thumb", "index", "middle", "ring", "little")


def add_mesh(name, vertices, triangles, material):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([], [], [])
    mesh.vertices.add(len(vertices))
    mesh.vertices.foreach_set("co", np.asarray(vertices, np.float32).ravel())
    mesh.loops.add(triangles.size)
    mesh.loops.foreach_set("vertex_index", triangles.astype(np.int32).ravel())
    mesh.polygons.add(len(triangles))
    mesh.polygons.foreach_set("loop_start", np.arange(0, triangles.size, 3, dtype=np.int32))
    mesh.polygons.foreach_set("loop_total", np.full(len(triangles), 3, np.int32))
    mesh.polygons.foreach_set("use_smooth", np.ones(len(triangles), bool))
    mesh.update(calc_edges=True)
    mesh.materials.append(material)
    thing = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(thing)
    return thing


def move_vertices(thing, vertices):
    thing.data.vertices.foreach_set("co", np.asarray(vertices, np.float32).ravel())
    thing.data.update()


def add_hand(meshes, material):
    hand = add_mesh("hand", meshes.hand_vertices[0], meshes.hand_triangles, material)
    normals = normals_of(meshes.hand_bind, meshes.hand_triangles)
    dorsal = facing_dorsally(meshes, normals)
    store(hand, "bind", meshes.hand_bind)
    store(hand, "flush", flush(meshes, dorsal))
    store(hand, "lines", near_joints(meshes, 0.006))
    store(hand, "palmar", palmar(meshes, dorsal))
    store(hand, "nail", places_on_nails(meshes, dorsal))
    return hand


def store(thing, name, values):
    values = np.asarray(values, np.float32)
    kind, key = ("FLOAT", "value") if values.ndim == 1 else ("FLOAT_VECTOR", "vector")
    attribute = thing.data.attributes.new(name, kind, "POINT")
    attribute.data.foreach_set(key, values.ravel())


def normals_of(vertices, triangles):
    a, b, c = (vertices[triangles[:, i]].astype(float) for i in range(3))
    face = np.cross(b - a, c - a)
    normals = np.zeros(vertices.shape)
    for i in range(3):
        np.add.at(normals, triangles[:, i], face)
    return normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)


def facing_dorsally(meshes, normals):
    """Cosine of each vertex's normal to the back of its own bone."""
    backs = np.array([pose[:, 2] for pose in meshes.bones.values()])
    return (normals * backs[meshes.hand_bones]).sum(axis=1)


def of_bones(meshes, names):
    numbers = [i for i, bone in enumerate(meshes.bones) if bone in names]
    return np.isin(meshes.hand_bones, numbers)


def knuckles(meshes):
    """The joints of fingers and thumb, hand frame."""
    parts = ("proximal", "middle", "distal")
    names = [f"{finger}_{part}" for finger in FINGERS for part in parts]
    return np.array([meshes.bones[name][:, 3] for name in names if name in meshes.bones])


def near_joints(meshes, reach):
    offsets = meshes.hand_bind[:, None, :] - knuckles(meshes)[None, :, :]
    # Skin is a finger's radius from the joint; what counts is how far along the finger.
    nearest = np.maximum(np.linalg.norm(offsets, axis=2).min(axis=1) - 0.008, 0)
    return np.exp(-((nearest / reach) ** 2))


def flush(meshes, dorsal):
    """Where blood shows: over the knuckles and in the fingertips."""
    knuckle = near_joints(meshes, 0.007) * np.clip(dorsal + 0.2, 0, 1) * 0.8
    tips = np.zeros(len(knuckle))
    for finger in FINGERS:
        name = f"{finger}_distal"
        own = of_bones(meshes, [name])
        y = in_bone(meshes, name)[:, 1]
        tips[own] = np.clip((y[own] - 0.4 * y[own].max()) / (0.6 * y[own].max()), 0, 1)
    return np.maximum(knuckle, 0.7 * tips)


def palmar(meshes, dorsal):
    """The skin of palm and fingers, which ends softly at the wrist."""
    beyond_wrist = np.clip((meshes.hand_bind[:, 1] + 0.012) / 0.04, 0, 1)
    return np.clip(-1.4 * dorsal, 0, 1) * beyond_wrist


def in_bone(meshes, name):
    pose = meshes.bones[name]
    return (meshes.hand_bind - pose[:, 3]) @ pose[:, :3]


def places_on_nails(meshes, dorsal):
    """x and y run from -1 to 1 across the nail; z is 1 on the back of a finger."""
    places = np.tile([9.0, 9.0, 0.0], (len(dorsal), 1))
    for finger in FINGERS:
        name = f"{finger}_distal"
        own = of_bones(meshes, [name]) & (dorsal > -0.2)
        local = in_bone(meshes, name)[own]
        length, width = local[:, 1].max(), np.abs(local[:, 0]).max()
        places[own, 0] = local[:, 0] / (0.68 * width)
        places[own, 1] = (local[:, 1] - 0.68 * length) / (0.27 * length)
        places[own, 2] = np.clip(3 * dorsal[own], 0, 1)
    return places
