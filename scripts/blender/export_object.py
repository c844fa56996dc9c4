# SPDX-License-Identifier: MIT
"""Exports a closed mesh as .glb or .obj and prints what it measures."""
import bmesh
import bpy
from mathutils import Matrix, Vector
from scene import export_glb, fail, metres_per_unit, pick, select_only


def solid_of(thing):
    """Its mesh after all modifiers, in metres, turned and scaled as in the scene; its own origin
    stays the origin."""
    evaluated = thing.evaluated_get(bpy.context.evaluated_depsgraph_get())
    solid = bmesh.new()
    solid.from_mesh(evaluated.to_mesh())
    turned = thing.matrix_world.to_3x3().to_4x4()
    solid.transform(Matrix.Scale(metres_per_unit(), 4) @ turned)
    bmesh.ops.triangulate(solid, faces=solid.faces)
    if turned.determinant() < 0:
        bmesh.ops.reverse_faces(solid, faces=solid.faces)
    return solid


def check_watertight(name, solid):
    """Fails unless every edge joins two faces that agree on what is outside."""
    faults = {
        "with one face": sum(edge.is_boundary for edge in solid.edges),
        "without a face": sum(edge.is_wire for edge in solid.edges),
        "with more than two faces": sum(len(edge.link_faces) > 2 for edge in solid.edges),
        "whose faces look opposite ways": sum(
            edge.is_manifold and not edge.is_contiguous for edge in solid.edges
        ),
    }
    found = [f"{count} edges {fault}" for fault, count in faults.items() if count]
    if found or not solid.faces:
        fail(f"{name} is not watertight: {', '.join(found) or 'it has no faces'}")
    if solid.calc_volume(signed=True) <= 0:
        fail(f"{name} is inside out: its faces look inwards (Mesh > Normals > Recalculate Outside)")


def print_measures(name, solid, axes):
    """`axes` are those of the file, each by the name and sign of Blender's."""
    corners = list(zip(*(vertex.co for vertex in solid.verts)))
    low, high = Vector(map(min, corners)), Vector(map(max, corners))
    in_file = axes @ Matrix.Scale(1000, 3)
    size, centre = in_file @ (high - low), in_file @ ((high + low) / 2)
    print(f"{name}: watertight, {len(solid.faces)} triangles, {1e6 * solid.calc_volume():.1f} cm3")
    print("unit: metre")
    print("size along the file's x, y, z: {:.1f} x {:.1f} x {:.1f} mm".format(*map(abs, size)))
    print("centre of its box: [{:.1f}, {:.1f}, {:.1f}] mm from the origin".format(*centre))


def write_obj(path, thing):
    """With Blender's own axes: a .obj has no up."""
    select_only([thing])
    bpy.ops.wm.obj_export(
        filepath=str(path.resolve()),
        export_selected_objects=True,
        forward_axis="Y",
        up_axis="Z",
        export_normals=False,
        export_uv=False,
        export_materials=False,
    )


def export(arguments):
    if arguments.out.suffix not in (".glb", ".obj"):
        fail(f"{arguments.out}: expected a name that ends in .glb or .obj")
    meshes = [thing for thing in bpy.context.view_layer.objects if thing.type == "MESH"]
    thing = pick(meshes, "mesh", arguments.object, "--object")
    solid = solid_of(thing)
    check_watertight(thing.name, solid)
    mesh = bpy.data.meshes.new(thing.name)
    solid.to_mesh(mesh)
    copy = bpy.data.objects.new(thing.name, mesh)
    bpy.context.scene.collection.objects.link(copy)
    axes = Matrix.Identity(3)
    if arguments.out.suffix == ".obj":
        write_obj(arguments.out, copy)
    else:
        # Normals would split vertices, and the mesh in the file would be open.
        export_glb(arguments.out, [copy], export_normals=False)
        axes = Matrix(((1, 0, 0), (0, 0, 1), (0, -1, 0)))  # y up
    print_measures(thing.name, solid, axes)
    print(f"wrote {arguments.out}")
