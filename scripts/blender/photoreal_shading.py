# SPDX-License-Identifier: MIT
"""Materials: skin that sticks to the hand as it moves, cloth, and what rooms and objects are made of."""
import bpy


def linear(srgb):
    """sRGB 0..1 to linear, with alpha."""
    return [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in srgb] + [1.0]


class Graph:
    """A material's nodes. Sockets are joined by passing one where a value is expected."""

    def __init__(self, name):
        self.material = bpy.data.materials.new(name)
        self.material.use_nodes = True
        self.tree = self.material.node_tree
        self.shader = self.tree.nodes["Principled BSDF"]

    def node(self, kind, output=0, values=None, **properties):
        node = self.tree.nodes.new("ShaderNode" + kind)
        for name, value in properties.items():
            setattr(node, name, value)
        for socket, value in (values or {}).items():
            self.set(node.inputs[socket], value)
        return node.outputs[output]

    def set(self, socket, value):
        if isinstance(value, bpy.types.NodeSocket):
            self.tree.links.new(value, socket)
        else:
            socket.default_value = value

    def surface(self, **inputs):
        for name, value in inputs.items():
            self.set(self.shader.inputs[name.replace("_", " ")], value)

    def math(self, operation, a, b=0.0, clamp=False):
        return self.node("Math", values={0: a, 1: b}, operation=operation, use_clamp=clamp)

    def mix(self, share, a, b, blend="MIX"):
        return self.node("MixRGB", values={0: share, 1: a, 2: b}, blend_type=blend)

    def noise(self, where, scale, detail=2.0, distortion=0.0):
        values = {"Vector": where, "Scale": scale, "Detail": detail, "Distortion": distortion}
        return self.node("TexNoise", values=values)

    def ramp(self, value, low, high):
        """0 at low, 1 at high, smooth."""
        return self.node(
            "MapRange",
            values={"Value": value, 1: low, 2: high},
            interpolation_type="SMOOTHSTEP",
        )

    def bump(self, height, distance, strength=1.0):
        return self.node("Bump", values={"Height": height, "Distance": distance, "Strength": strength})

    def attribute(self, name, output="Fac"):
        node = self.tree.nodes.new("ShaderNodeAttribute")
        node.attribute_name = name
        return node.outputs[output]


def skin(look):
    """Reads what photoreal_hand.py stores with every vertex."""
    g = Graph("skin")
    where = g.attribute("bind", "Vector")
    tone, flush = linear(look["skin"]), linear(look["skin_red"])
    blotches = g.ramp(g.noise(where, 70, 2), 0.35, 0.75)
    colour = g.mix(g.math("MULTIPLY", blotches, look["blotches"]), tone, flush)
    colour = g.mix(g.math("MULTIPLY", g.attribute("flush"), 0.75, clamp=True), colour, flush)
    palmar = linear(look["skin_palm"])
    colour = g.mix(g.math("MULTIPLY", g.attribute("palmar"), 0.7), colour, palmar)
    grain = g.noise(where, 400, 1)
    if look["freckles"]:
        share = g.math("MULTIPLY", g.ramp(grain, 0.62, 0.75), look["freckles"])
        colour = g.mix(share, colour, linear([0.36, 0.2, 0.13]))
    shade = g.node("MapRange", values={"Value": grain, 3: 0.86, 4: 1.14})
    colour = g.mix(1.0, colour, shade, "MULTIPLY")
    creases = crease_pattern(g, where)
    dark = g.math("MULTIPLY", creases, g.math("MULTIPLY", g.attribute("lines"), 0.3))
    colour = g.mix(dark, colour, g.mix(1.0, colour, linear([0.6, 0.42, 0.4]), "MULTIPLY"))
    nail, rim = nails(g)
    colour = g.mix(nail, colour, linear(look["nail"]))
    colour = g.mix(rim, colour, g.mix(1.0, colour, linear([0.75, 0.6, 0.58]), "MULTIPLY"))
    lines = g.math("MULTIPLY", creases, g.math("MULTIPLY", g.attribute("lines"), -1.3))
    height = g.math("ADD", g.math("MULTIPLY", grain, 0.6), lines)
    height = g.math("MULTIPLY", height, g.math("SUBTRACT", 1.0, nail))
    g.surface(
        Base_Color=colour,
        Roughness=g.math("SUBTRACT", look["skin_roughness"], g.math("MULTIPLY", nail, 0.22)),
        Specular=0.35,
        Normal=g.bump(height, 0.0007, look["wrinkles"]),
    )
    return g.material


def crease_pattern(g, where):
    """Lines across the fingers, 1.6 mm apart and far from straight."""
    wave = g.node(
        "TexWave",
        output=1,
        values={"Vector": where, "Scale": 95.0, "Distortion": 4.0, "Detail": 0.0, "Detail Scale": 2.0},
        wave_type="BANDS",
        bands_direction="Y",
    )
    return g.ramp(wave, 0.75, 1.0)


def nails(g):
    """Masks of nails and of the fold around them, from each vertex's place on its nail."""
    split = g.tree.nodes.new("ShaderNodeSeparateXYZ")
    g.set(split.inputs[0], g.attribute("nail", "Vector"))
    x, y, above = split.outputs
    fourth = [g.math("POWER", g.math("ABSOLUTE", axis), 3.0) for axis in (x, y)]
    radius = g.math("ADD", *fourth)
    inside = g.math("MULTIPLY", g.ramp(radius, 1.05, 0.85), above)
    rim = g.math("MULTIPLY", g.math("MULTIPLY", g.ramp(radius, 1.9, 1.1), above), 0.8)
    return inside, g.math("MULTIPLY", rim, g.math("SUBTRACT", 1.0, inside))


def cloth(colour):
    g = Graph("cloth")
    where = g.node("TexCoord", output="Object")
    weave = g.noise(where, 160, 2)
    shade = g.node("MapRange", values={"Value": weave, 3: 0.75, 4: 1.2})
    g.surface(
        Base_Color=g.mix(1.0, linear(colour), shade, "MULTIPLY"),
        Roughness=0.95,
        Specular=0.1,
        Normal=g.bump(weave, 0.004, 0.5),
    )
    return g.material


def daylight(colour, strength):
    """Light from all around, more of it from above. Only bounces find it, so that lamps, of which
    there is one, are asked for at every step: that is what keeps few samples smooth."""
    world = bpy.data.worlds.new("world")
    world.use_nodes = True
    world.cycles.sampling_method = "NONE"
    tree = world.node_tree
    split = tree.nodes.new("ShaderNodeSeparateXYZ")
    tree.links.new(tree.nodes.new("ShaderNodeTexCoord").outputs["Generated"], split.inputs[0])
    height = tree.nodes.new("ShaderNodeMapRange")
    height.inputs[1].default_value, height.inputs[3].default_value = -1.0, 0.35 * strength
    height.inputs[4].default_value = 1.65 * strength
    tree.links.new(split.outputs[2], height.inputs[0])
    background = tree.nodes["Background"]
    background.inputs[0].default_value = linear(colour)
    tree.links.new(height.outputs[0], background.inputs[1])
    return world


def plain(colour, roughness=0.5, metallic=0.0, mottled=0.15, bumps=0.0, scale=30.0, specular=0.5):
    g = Graph("plain")
    where = g.node("TexCoord", output="Object")
    dirt = g.noise(where, scale, 4)
    shade = g.node("MapRange", values={"Value": dirt, 3: 1 - mottled, 4: 1 + mottled})
    g.surface(
        Base_Color=g.mix(1.0, linear(colour), shade, "MULTIPLY"),
        Roughness=roughness,
        Metallic=metallic,
        Specular=specular,
    )
    if bumps:
        g.surface(Normal=g.bump(g.noise(where, scale * 8, 3), 0.002, bumps))
    return g.material


def wood(colour, along=(1.0, 9.0, 9.0), scale=6.0):
    g = Graph("wood")
    where = g.node("Mapping", values={"Vector": g.node("TexCoord", output="Object"), "Scale": along})
    rings = g.noise(where, scale, 6, 1.5)
    dark = [c * 0.6 for c in colour]
    colour = g.mix(g.ramp(rings, 0.35, 0.7), linear(dark), linear(colour))
    g.surface(Base_Color=colour, Roughness=0.45, Normal=g.bump(rings, 0.001, 0.4))
    return g.material


def bricks(colour, mortar, width, height, offset=0.5):
    """Bricks, or tiles without an offset; metres."""
    g = Graph("bricks")
    where = g.node("TexCoord", output="Object")
    brick = g.tree.nodes.new("ShaderNodeTexBrick")
    brick.offset = offset
    lighter = [min(1.0, c * 1.15) for c in colour]
    values = {
        "Vector": g.node("Mapping", values={"Vector": where, "Rotation": (1.5708, 0, 0)}),
        "Color1": linear(colour),
        "Color2": linear(lighter),
        "Mortar": linear(mortar),
        "Scale": 1.0,
        "Mortar Size": 0.004,
        "Brick Width": width,
        "Row Height": height,
    }
    for socket, value in values.items():
        g.set(brick.inputs[socket], value)
    shade = g.node("MapRange", values={"Value": g.noise(where, 25, 5), 3: 0.8, 4: 1.2})
    g.surface(
        Base_Color=g.mix(1.0, brick.outputs[0], shade, "MULTIPLY"),
        Roughness=0.6,
        Normal=g.bump(brick.outputs[1], -0.004, 0.8),
    )
    return g.material


def print_like(colours, scale):
    """Blots of a few colours, as a poster or a cover from afar."""
    g = Graph("print")
    where = g.node("TexCoord", output="Object")
    mixed = linear(colours[0])
    for i, colour in enumerate(colours[1:]):
        place = g.node("Mapping", values={"Vector": where, "Location": (3.7 * i + 1, 1.3 * i, 0.7)})
        mixed = g.mix(g.ramp(g.noise(place, scale, 4, 0.6), 0.42, 0.6), mixed, linear(colour))
    g.surface(Base_Color=mixed, Roughness=0.6)
    return g.material


def labelled(colour, half_extents):
    """A printed band around the longest side."""
    g = Graph("label")
    split = g.tree.nodes.new("ShaderNodeSeparateXYZ")
    where = g.node("TexCoord", output="Object")
    g.set(split.inputs[0], where)
    longest = max(range(3), key=lambda axis: half_extents[axis])
    along = g.math("DIVIDE", split.outputs[longest], half_extents[longest])
    edge = g.math("ABSOLUTE", g.math("SUBTRACT", along, 0.1))
    lines = g.ramp(g.math("SINE", g.math("MULTIPLY", split.outputs[longest], 700.0)), 0.1, 0.3)
    words = g.ramp(g.noise(where, 130, 0), 0.42, 0.45)
    text = g.math("MULTIPLY", g.math("MULTIPLY", lines, words), g.ramp(edge, 0.34, 0.33))
    band = g.mix(text, linear([0.9, 0.89, 0.85]), linear([c * 0.5 for c in colour]))
    g.surface(Base_Color=g.mix(g.ramp(edge, 0.42, 0.4), linear(colour), band), Roughness=0.35)
    return g.material


def held_object(kind, colour, half_extents):
    if kind == "metal":
        return plain(colour, 0.3, metallic=0.9, mottled=0.1)
    if kind == "wood":
        return wood(colour, scale=25.0)
    if kind == "glossy":
        return plain(colour, 0.15, mottled=0.03)
    if kind == "rubber":
        return plain(colour, 0.8, mottled=0.1, bumps=0.3, scale=120, specular=0.2)
    if kind == "labelled":
        return labelled(colour, half_extents)
    return plain(colour, 0.4, mottled=0.08)
