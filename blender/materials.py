# ---- Materials: one node material per row of MATERIALS, textures made by procedure. --------------------------------------------------
import base64
import math
import os
import tempfile

import bpy


def wood_grain(nodes, point, row, contrast=1.0, along=0.07, across=1.0):
    """Fibres along u with a slow change of tone; `across` growth rings per unit of the point."""
    base, second = row["color"], row["second"]
    fibres = nodes.noise(nodes.stretched(point, along, across), 1.0, detail=4.0, roughness=0.65, distortion=0.3)
    return nodes.ramp(fibres, (0.34, between(base, second, 0.8 * contrast)), (0.52, base),
                      (0.72, between(base, second, 0.3 * contrast)))


def paint_wood(nodes, point, row):
    return wood_grain(nodes, point, row)


def paint_planks(nodes, point, row):
    """Boards 1 long and 1/8 wide."""
    base, second = row["color"], row["second"]
    board, joint = nodes.bricks(point, 1.0, 1 / 8, 0.002, offset=0.37)
    grain = wood_grain(nodes, point, row, 0.5, along=3.0, across=45.0)
    tone = nodes.ramp(board, (0.0, between(base, second, 0.32)), (0.5, base), (1.0, between(base, (1, 1, 1), 0.10)))
    return nodes.mix(joint, nodes.mix(0.6, grain, tone), rgba(between(base, second, 0.9)))


def paint_parquet(nodes, point, row):
    """Herringbone of blocks 1 long and 1/5 wide, at 45°. In cells i, j of a block's width, (i - j) modulo 10 says which block it is."""
    base, second, math_node = row["color"], row["second"], nodes.math
    turned = nodes.add("ShaderNodeMapping")
    turned.inputs["Rotation"].default_value = (0, 0, math.radians(45))
    turned.inputs["Scale"].default_value = (5, 5, 1)
    nodes.tree.links.new(point.outputs[0], turned.inputs["Vector"])
    split = nodes.add("ShaderNodeSeparateXYZ")
    nodes.tree.links.new(turned.outputs[0], split.inputs[0])
    x, y = split.outputs[0], split.outputs[1]
    i, j = math_node("FLOOR", x), math_node("FLOOR", y)
    in_x, in_y = math_node("SUBTRACT", x, i), math_node("SUBTRACT", y, j)
    k = math_node("WRAP", math_node("SUBTRACT", i, j), 10.0, 0.0)
    lies = math_node("LESS_THAN", k, 4.5)
    rest = math_node("SUBTRACT", 9.0, k)

    def choose(lying, standing):
        return math_node("ADD", math_node("MULTIPLY", lies, lying),
                         math_node("MULTIPLY", math_node("SUBTRACT", 1.0, lies), standing))

    across = choose(in_y, in_x)
    along = choose(math_node("ADD", k, in_x), math_node("ADD", rest, in_y))
    edge = math_node("MINIMUM", math_node("MINIMUM", across, math_node("SUBTRACT", 1.0, across)),
                     math_node("MINIMUM", along, math_node("SUBTRACT", 5.0, along)))
    block = nodes.add("ShaderNodeTexWhiteNoise", noise_dimensions="3D")
    nodes.link(nodes.vector(choose(math_node("SUBTRACT", i, k), i), choose(j, math_node("SUBTRACT", j, rest)), lies), block, "Vector")
    grain_point = nodes.vector(
        math_node("MULTIPLY", along, 0.6), math_node("MULTIPLY", across, 9.0), math_node("MULTIPLY", block.outputs[0], 50.0)
    )
    noise = nodes.add("ShaderNodeTexNoise")
    noise.inputs["Scale"].default_value, noise.inputs["Detail"].default_value = 1.0, 4.0
    nodes.link(grain_point, noise, "Vector")
    grain = nodes.ramp(noise.outputs[0], (0.34, between(base, second, 0.4)), (0.52, base), (0.72, between(base, second, 0.15)))
    tone = nodes.ramp(block.outputs[0], (0.0, between(base, second, 0.4)), (0.5, base), (1.0, between(base, (1, 1, 1), 0.08)))
    return nodes.mix(math_node("LESS_THAN", edge, 0.025), nodes.mix(0.6, grain, tone), rgba(between(base, second, 0.9)))


def paint_tiles(nodes, point, row):
    base, second = row["color"], row["second"]
    tile, joint = nodes.bricks(point, 1.0, 1.0, 1 / 90, offset=0.0)
    body = nodes.ramp(tile, (0.0, between(base, second, 0.10)), (1.0, base))
    return nodes.mix(joint, body, rgba(second))


def paint_checker(nodes, point, row):
    node = nodes.add("ShaderNodeTexChecker")
    node.inputs["Scale"].default_value = 1.0
    node.inputs["Color1"].default_value, node.inputs["Color2"].default_value = rgba(row["color"]), rgba(row["second"])
    nodes.tree.links.new(point.outputs[0], node.inputs["Vector"])
    return node.outputs[0]


def paint_bricks(nodes, point, row):
    """Running bond, 1 long and 1/3 high."""
    base, second = row["color"], row["second"]
    brick, joint = nodes.bricks(point, 1.0, 1 / 3, 0.025)
    tone = nodes.ramp(brick, (0.0, between(base, (0, 0, 0), 0.18)), (1.0, base))
    rough = nodes.ramp(nodes.noise(point, 12.0), (0.3, between(base, (0, 0, 0), 0.2)), (0.7, base))
    nodes.bump(nodes.ramp(joint, (0.0, (1, 1, 1)), (1.0, (0, 0, 0))), 4.0, 0.6)
    return nodes.mix(joint, nodes.mix(0.5, tone, rough), rgba(second))


def paint_tatami(nodes, point, row):
    """Mats 1 long and 1/2 wide with cloth edges; the rush runs along them."""
    base, second = row["color"], row["second"]
    mat, joint = nodes.bricks(point, 1.0, 0.5, 0.015)
    rush = nodes.ramp(nodes.noise(nodes.stretched(point, 2.0, 160.0), 1.0), (0.3, between(base, second, 0.16)), (0.7, base))
    tone = nodes.ramp(mat, (0.0, between(base, second, 0.10)), (1.0, base))
    return nodes.mix(joint, nodes.mix(0.5, rush, tone), rgba(second))


def paint_flags(nodes, point, row):
    """Slabs 1 long and 0.6 wide."""
    base, second = row["color"], row["second"]
    slab, joint = nodes.bricks(point, 1.0, 0.6, 0.012)
    tone = nodes.ramp(slab, (0.0, between(base, second, 0.35)), (0.5, base), (1.0, between(base, (1, 1, 1), 0.1)))
    rough = nodes.ramp(nodes.noise(point, 5.0, detail=6.0), (0.3, between(base, second, 0.4)), (0.7, base))
    nodes.bump(nodes.ramp(joint, (0.0, (1, 1, 1)), (1.0, (0, 0, 0))), 4.0, 0.4)
    return nodes.mix(joint, nodes.mix(0.5, tone, rough), rgba(second))


def paint_flowers(nodes, point, row):
    """A blossom of five petals about the middle of each cell of edge 1."""
    base, second, math_node = row["color"], row["second"], nodes.math
    cells = nodes.add("ShaderNodeTexVoronoi", feature="F1", voronoi_dimensions="2D")
    cells.inputs["Scale"].default_value, cells.inputs["Randomness"].default_value = 1.0, 0.55
    nodes.tree.links.new(point.outputs[0], cells.inputs["Vector"])
    away = nodes.add("ShaderNodeVectorMath", operation="SUBTRACT")
    nodes.tree.links.new(point.outputs[0], away.inputs[0])
    nodes.tree.links.new(cells.outputs["Position"], away.inputs[1])
    split = nodes.add("ShaderNodeSeparateXYZ")
    nodes.tree.links.new(away.outputs[0], split.inputs[0])
    turn = math_node("MULTIPLY", math_node("ARCTAN2", split.outputs[1], split.outputs[0]), 5.0)
    petals = math_node("ADD", 0.22, math_node("MULTIPLY", math_node("COSINE", turn, 0.0), 0.085))
    far = cells.outputs["Distance"]
    blossom = nodes.mix(math_node("LESS_THAN", far, petals), rgba(base), rgba(second))
    return nodes.mix(math_node("LESS_THAN", far, 0.06), blossom, rgba(between(second, (1.0, 0.85, 0.4), 0.6)))


def split_point(nodes, point):
    split = nodes.add("ShaderNodeSeparateXYZ")
    nodes.tree.links.new(point.outputs[0], split.inputs[0])
    return split.outputs[0], split.outputs[1]


def paint_rosettes(nodes, point, row):
    """Square tiles of edge 1: a diamond in the middle of each, rings and discs about the corners where four meet."""
    math_node = nodes.math
    x, y = (math_node("ABSOLUTE", math_node("SUBTRACT", math_node("FRACT", v, 0.0), 0.5), 0.0) for v in split_point(nodes, point))
    to_corner = [math_node("POWER", math_node("SUBTRACT", 0.5, v), 2.0) for v in (x, y)]
    far = math_node("SQRT", math_node("ADD", *to_corner), 0.0)
    ring = math_node("SUBTRACT", math_node("LESS_THAN", far, 0.36), math_node("LESS_THAN", far, 0.25))
    inside = math_node("MAXIMUM", math_node("LESS_THAN", math_node("ADD", x, y), 0.2), math_node("LESS_THAN", far, 0.14))
    figure = nodes.mix(math_node("MAXIMUM", ring, inside), rgba(row["color"]), rgba(row["second"]))
    joint = math_node("GREATER_THAN", math_node("MAXIMUM", x, y), 0.492)
    return nodes.mix(joint, figure, rgba(between(row["color"], (0.4, 0.4, 0.4), 0.4)))


def paint_logs(nodes, point, row):
    """Round logs along u, each 1 high: pale where they bulge, dark where two meet."""
    base, second, math_node = row["color"], row["second"], nodes.math
    _, y = split_point(nodes, point)
    bulge = math_node("SINE", math_node("MULTIPLY", math_node("FRACT", y, 0.0), math.pi), 0.0)
    nodes.bump(bulge, 6.0, 0.8)
    dark, pale = between(second, (0, 0, 0), 0.5), between(base, (1, 1, 1), 0.12)
    round_tone = nodes.ramp(bulge, (0.0, dark), (0.22, second), (0.6, base), (1.0, pale))
    return nodes.mix(0.4, round_tone, wood_grain(nodes, point, row, 0.8, along=0.6, across=9.0))


def paint_glazed(nodes, point, row):
    """Square tiles of edge 1 made by hand: each of a shade of its own, joints of second."""
    base, second = row["color"], row["second"]
    tile, joint = nodes.bricks(point, 1.0, 1.0, 1 / 40, offset=0.0)
    body = nodes.ramp(tile, (0.0, between(base, (0, 0, 0), 0.16)), (0.5, base), (1.0, between(base, (1, 1, 1), 0.16)))
    return nodes.mix(joint, body, rgba(second))


def paint_marble(nodes, point, row):
    base, second = row["color"], row["second"]
    veins = nodes.wave(point, math.pi / 20, distortion=6.0, direction="DIAGONAL", detail=5.0)
    clouds = nodes.noise(point, 1.3, detail=6.0)
    return nodes.mix(0.3, nodes.ramp(veins, (0.40, base), (0.48, between(base, second, 0.5)), (0.5, second), (0.54, base)),
                     nodes.ramp(clouds, (0.35, between(base, second, 0.35)), (0.65, base)))


def paint_terrazzo(nodes, point, row):
    base, second = row["color"], row["second"]
    node = nodes.add("ShaderNodeTexVoronoi", feature="F1")
    node.inputs["Scale"].default_value = 0.8
    nodes.tree.links.new(point.outputs[0], node.inputs["Vector"])
    chip = nodes.ramp(node.outputs[0], (0.0, (1, 1, 1)), (0.30, (1, 1, 1)), (0.34, (0, 0, 0)))
    tone = nodes.ramp(node.outputs[1], (0.3, second), (0.7, between(second, (0, 0, 0), 0.45)))
    return nodes.mix(chip, rgba(base), tone)


def clouds(nodes, point, row, contrast):
    base, second = row["color"], row["second"]
    return nodes.ramp(nodes.noise(point, 1.0, detail=6.0, roughness=0.6), (0.3, between(base, second, contrast)), (0.7, base))


def paint_concrete(nodes, point, row):
    return clouds(nodes, point, row, 1.0)


def paint_plaster(nodes, point, row):
    return clouds(nodes, point, row, 0.1)


def paint_fabric(nodes, point, row):
    """Threads are finer than a pixel: a mottle of a few threads, and a slow one."""
    base, second = row["color"], row["second"]
    weave = nodes.noise(point, 0.25, detail=2.0, roughness=0.7)
    nodes.bump(weave, 0.6, 0.4)
    fine = nodes.ramp(weave, (0.3, between(base, second, 0.5)), (0.65, base))
    return nodes.mix(0.3, fine, nodes.ramp(nodes.noise(point, 0.02), (0.3, between(base, second, 0.4)), (0.7, base)))


def paint_carpet(nodes, point, row):
    base, second = row["color"], row["second"]
    pile = nodes.noise(point, 0.6, detail=2.0, roughness=0.8)
    nodes.bump(pile, 2.5, 0.6)
    return nodes.mix(0.35, nodes.ramp(pile, (0.3, between(base, second, 0.8)), (0.7, base)),
                     nodes.ramp(nodes.noise(point, 0.03), (0.35, between(base, second, 0.4)), (0.65, base)))


def paint_leather(nodes, point, row):
    base, second = row["color"], row["second"]
    grain = nodes.noise(point, 1.0, detail=4.0, roughness=0.6)
    nodes.bump(grain, 0.6, 0.3)
    return nodes.mix(0.4, nodes.ramp(grain, (0.3, between(base, second, 0.6)), (0.6, base)),
                     nodes.ramp(nodes.noise(point, 0.1), (0.3, between(base, second, 0.5)), (0.7, base)))


def paint_wicker(nodes, point, row):
    base, second = row["color"], row["second"]
    strip, joint = nodes.bricks(point, 2.0, 1.0, 0.12, offset=0.5)
    nodes.bump(nodes.ramp(joint, (0.0, (1, 1, 1)), (1.0, (0, 0, 0))), 3.0, 0.6)
    return nodes.mix(joint, nodes.ramp(strip, (0.0, between(base, second, 0.3)), (1.0, base)), rgba(second))


def paint_stripes(nodes, point, row):
    """A band of base, a band of second, each 1 wide: half a period of the wave each."""
    return nodes.ramp(nodes.wave(point, math.pi / 20), (0.48, row["color"]), (0.52, row["second"]))


def paint_brushed(nodes, point, row):
    base, second = row["color"], row["second"]
    return nodes.ramp(nodes.noise(nodes.stretched(point, 2.0, 120.0), 1.0), (0.3, between(base, second, 0.5)), (0.7, base))


PAINTERS = {"wood": paint_wood, "planks": paint_planks, "parquet": paint_parquet, "tiles": paint_tiles, "checker": paint_checker,
            "bricks": paint_bricks, "tatami": paint_tatami, "flags": paint_flags, "flowers": paint_flowers,
            "rosettes": paint_rosettes, "logs": paint_logs, "glazed": paint_glazed,
            "marble": paint_marble, "terrazzo": paint_terrazzo, "concrete": paint_concrete,
            "plaster": paint_plaster, "fabric": paint_fabric, "carpet": paint_carpet, "leather": paint_leather,
            "wicker": paint_wicker, "stripes": paint_stripes, "brushed": paint_brushed}


def user_image(nodes, row):
    """The user's own picture as colour, if the file is there (relative names count from this script's folder)."""
    inside = IMAGES.get(row["image"])
    path = os.path.join(script_folder(), row["image"])
    if inside:  # the file is in this one: Blender reads files only
        data = base64.b64decode("".join(inside.split()))
        handle, path = tempfile.mkstemp(suffix=".png" if data.startswith(b"\x89PNG") else ".jpg")
        with os.fdopen(handle, "wb") as file:
            file.write(data)
    elif not os.path.isfile(path):
        print(f"layoutbox: note: no image {row['image']}, plain colour instead")
        return None
    image = bpy.data.images.load(path)
    image.name = row["image"]
    image.pack()
    if inside:
        os.remove(path)
    node = nodes.add("ShaderNodeTexImage", image=image)
    nodes.tree.links.new(nodes.surface_point(row["scale"]).outputs[0], node.inputs["Vector"])
    return node.outputs[0]


def make_material(name, row):
    material = bpy.data.materials.new(name)
    nodes = Nodes(material)
    shader = nodes.shader
    color = None
    if row["image"]:
        color = user_image(nodes, row)
    elif row["texture"] in PAINTERS:
        color = PAINTERS[row["texture"]](nodes, nodes.surface_point(row["scale"]), row)
    elif row["texture"]:
        print(f"layoutbox: note: no texture {row['texture']}, plain colour instead")
    socket(shader, "Base Color").default_value = rgba(row["color"])
    if color is not None:
        nodes.link(color, shader, "Base Color")
    socket(shader, "Roughness").default_value = row["roughness"]
    socket(shader, "Metallic").default_value = row["metallic"]
    socket(shader, "Specular IOR Level", "Specular").default_value = 0.35
    socket(shader, "Alpha").default_value = row["alpha"]
    if row["emission"] > 0:
        socket(shader, "Emission Color", "Emission").default_value = rgba(row["color"])
        socket(shader, "Emission Strength").default_value = row["emission"] * LIGHT["glow"]
    if row["alpha"] < 1 and hasattr(material, "blend_method"):
        material.blend_method = "BLEND"
    material.diffuse_color = (*linear(row["color"]), row["alpha"])  # what Workbench and the viewport show
    material.roughness, material.metallic = row["roughness"], row["metallic"]
    return material


def make_pane(name, row):
    """Clear glass in a window: the camera sees the sky's colour, all other rays go through; a share of alpha would be grain."""
    material = bpy.data.materials.new(f"{name} in windows")
    tree = Nodes(material).tree
    tree.nodes.clear()
    sky, clear = tree.nodes.new("ShaderNodeEmission"), tree.nodes.new("ShaderNodeBsdfTransparent")
    ray, choose = tree.nodes.new("ShaderNodeLightPath"), tree.nodes.new("ShaderNodeMixShader")
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    color = between(LIGHT["pane"], row["color"], 0.2)
    sky.inputs["Color"].default_value = rgba(color)
    for source, target in ((ray.outputs["Is Camera Ray"], 0), (clear.outputs[0], 1), (sky.outputs[0], 2)):
        tree.links.new(source, choose.inputs[target])
    tree.links.new(choose.outputs[0], output.inputs["Surface"])
    material.diffuse_color = (*linear(color), 1.0)
    return material


def make_ghost():
    """A faint pane: what is behind it darkened a little, and a little light of its own; without chance, which would be grain."""
    found = bpy.data.materials.get("ghost")
    if found:
        return found
    material = bpy.data.materials.new("ghost")
    tree = Nodes(material).tree
    tree.nodes.clear()
    clear, own, both = (tree.nodes.new(f"ShaderNode{kind}") for kind in ("BsdfTransparent", "Emission", "AddShader"))
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    clear.inputs["Color"].default_value = (0.80, 0.83, 0.87, 1.0)
    own.inputs["Color"].default_value, own.inputs["Strength"].default_value = (0.9, 0.95, 1.0, 1.0), 0.12
    tree.links.new(clear.outputs[0], both.inputs[0])
    tree.links.new(own.outputs[0], both.inputs[1])
    tree.links.new(both.outputs[0], output.inputs["Surface"])
    material.diffuse_color = (0.85, 0.9, 0.95, 0.3)
    return material
