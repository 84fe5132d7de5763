# ---- Node trees of materials, with names that hold from Blender 3.4 to 5.x. ----------------------------------------------------------


def linear(color):
    """sRGB 0–1, as in the tables, to the linear values that nodes take."""
    return tuple(c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in color)


def rgba(color):
    return (*linear(color), 1.0)


class Nodes:
    """A material's node tree, with names that hold from Blender 3.4 to 5.x."""

    def __init__(self, material):
        if not material.node_tree:
            material.use_nodes = True
        self.tree = material.node_tree
        self.shader = next(node for node in self.tree.nodes if node.type == "BSDF_PRINCIPLED")

    def add(self, kind, **settings):
        node = self.tree.nodes.new(kind)
        for name, value in settings.items():
            setattr(node, name, value)
        return node

    def link(self, output, node, *names):
        self.tree.links.new(output, socket(node, *names))

    def surface_point(self, scale):
        """Coordinates on the surface in units of the pattern's own length; the meshes' UVs are metres."""
        uv = self.add("ShaderNodeUVMap")
        mapping = self.add("ShaderNodeMapping")
        mapping.inputs["Scale"].default_value = (1 / scale, 1 / scale, 1)
        self.tree.links.new(uv.outputs[0], mapping.inputs["Vector"])
        return mapping

    def stretched(self, point, x, y):
        mapping = self.add("ShaderNodeMapping")
        mapping.inputs["Scale"].default_value = (x, y, 1)
        self.tree.links.new(point.outputs[0], mapping.inputs["Vector"])
        return mapping

    def noise(self, point, scale, detail=3.0, roughness=0.55, distortion=0.0):
        node = self.add("ShaderNodeTexNoise")
        for name, value in (("Scale", scale), ("Detail", detail), ("Roughness", roughness), ("Distortion", distortion)):
            node.inputs[name].default_value = value
        self.tree.links.new(point.outputs[0], node.inputs["Vector"])
        return node.outputs[0]

    def bricks(self, point, width, height, joint, offset=0.5, every=2):
        """Color: black and white by brick at random; second output: 1 in the joints."""
        node = self.add("ShaderNodeTexBrick", offset=offset, offset_frequency=every, squash=1.0)
        for name, value in (("Scale", 1.0), ("Mortar Size", joint), ("Mortar Smooth", 0.1), ("Bias", 0.0),
                            ("Brick Width", width), ("Row Height", height)):
            node.inputs[name].default_value = value
        node.inputs["Color1"].default_value = (0, 0, 0, 1)
        node.inputs["Color2"].default_value = (1, 1, 1, 1)
        node.inputs["Mortar"].default_value = (0.5, 0.5, 0.5, 1)
        self.tree.links.new(point.outputs[0], node.inputs["Vector"])
        return node.outputs[0], node.outputs[1]

    def wave(self, point, scale, distortion=0.0, direction="X", detail=2.0):
        node = self.add("ShaderNodeTexWave", wave_type="BANDS", bands_direction=direction)
        for name, value in (("Scale", scale), ("Distortion", distortion), ("Detail", detail), ("Detail Scale", 1.5)):
            node.inputs[name].default_value = value
        self.tree.links.new(point.outputs[0], node.inputs["Vector"])
        return node.outputs[1]

    def ramp(self, value, *stops):
        """Colours by value: stops of (place, sRGB colour)."""
        node = self.add("ShaderNodeValToRGB")
        elements = node.color_ramp.elements
        while len(elements) < len(stops):
            elements.new(0.5)
        for element, (place, color) in zip(elements, stops):
            element.position, element.color = place, rgba(color)
        self.tree.links.new(value, node.inputs[0])
        return node.outputs[0]

    def mix(self, factor, a, b):
        node = self.add("ShaderNodeMix", data_type="RGBA")
        for identifier, value in (("Factor_Float", factor), ("A_Color", a), ("B_Color", b)):
            target = next(s for s in node.inputs if s.identifier == identifier)
            if isinstance(value, (tuple, float)):
                target.default_value = value
            else:
                self.tree.links.new(value, target)
        return next(s for s in node.outputs if s.identifier == "Result_Color")

    def math(self, operation, *values):
        node = self.add("ShaderNodeMath", operation=operation)
        for target, value in zip(node.inputs, values):
            if isinstance(value, float):
                target.default_value = value
            else:
                self.tree.links.new(value, target)
        return node.outputs[0]

    def vector(self, x, y, z):
        node = self.add("ShaderNodeCombineXYZ")
        for target, value in zip(node.inputs, (x, y, z)):
            self.tree.links.new(value, target)
        return node.outputs[0]

    def bump(self, height, millimetres, strength=1.0):
        node = self.add("ShaderNodeBump")
        node.inputs["Strength"].default_value = strength
        node.inputs["Distance"].default_value = millimetres / 1000
        self.link(height, node, "Height")
        self.link(node.outputs[0], self.shader, "Normal")


def socket(node, *names):
    """The first input that the node has under one of these names (they changed in 4.0)."""
    for name in names:
        if name in node.inputs:
            return node.inputs[name]
    raise KeyError(f"{node.name} has none of the inputs {names}")


def between(a, b, t):
    return tuple(x + (y - x) * t for x, y in zip(a, b))
