# ---- The picture: engine, samples, noise, colours. -----------------------------------------------------------------------------------
import os
import sys

import bpy


def has_denoiser():
    """True where this Blender was built with OpenImageDenoise."""
    if hasattr(bpy.app.build_options, "openimagedenoise"):  # gone in 5.0
        return bpy.app.build_options.openimagedenoise
    return set_first(bpy.context.scene.cycles, "denoiser", ("OPENIMAGEDENOISE",)) is not None


def set_first(target, name, values):
    """Sets an enum to the first of the values that this Blender knows."""
    for value in values:
        try:
            setattr(target, name, value)
            return value
        except TypeError:
            continue
    return None


def set_colours(scene):
    view = scene.view_settings
    chosen = set_first(view, "view_transform", ("Khronos PBR Neutral", "Standard"))
    if chosen == "AgX":
        set_first(view, "look", ("AgX - Medium High Contrast", "None"))
    elif chosen == "Filmic":
        set_first(view, "look", ("Medium High Contrast", "None"))
    view.exposure = LIGHT["exposure"].get(chosen, 0.0)


def filter_noise(scene):
    """Without OpenImageDenoise: the light alone is smoothed in the compositor, not across edges of depth or direction; the colours of
    surfaces, which have no noise, are multiplied in afterwards."""
    layer = scene.view_layers[0]
    for name in ("normal", "z", "emit", "environment", "diffuse_direct", "diffuse_indirect", "diffuse_color", "glossy_direct",
                 "glossy_indirect", "glossy_color", "transmission_direct", "transmission_indirect", "transmission_color"):
        setattr(layer, f"use_pass_{name}", True)
    scene.use_nodes = True
    tree = scene.node_tree
    tree.nodes.clear()
    layers, output = tree.nodes.new("CompositorNodeRLayers"), tree.nodes.new("CompositorNodeComposite")

    def combine(operation, first, second):
        node = tree.nodes.new("CompositorNodeMixRGB")
        node.blend_type = operation
        tree.links.new(first, node.inputs[1])
        tree.links.new(second, node.inputs[2])
        return node.outputs[0]

    def smooth(light, width):
        node = tree.nodes.new("CompositorNodeBilateralblur")
        node.iterations, node.sigma_color, node.sigma_space = 1, 0.12, width
        tree.links.new(light, node.inputs["Image"])
        tree.links.new(guide, node.inputs["Determinator"])
        return node.outputs[0]

    depth = tree.nodes.new("CompositorNodeMath")  # so that a step of 10 cm in a room of usual size counts as an edge
    depth.operation = "MULTIPLY"
    depth.inputs[1].default_value = 8.0 / frame(walls_that_stay())[1] if CAMERA["orthographic"] else 1.0
    tree.links.new(layers.outputs["Depth"], depth.inputs[0])
    guide = combine("ADD", layers.outputs["Normal"], depth.outputs[0])
    total = combine("ADD", layers.outputs["Emit"], layers.outputs["Env"])
    width = 5.0 * CAMERA["width"] / 1920
    for kind in ("Diff", "Gloss", "Trans"):
        light = smooth(combine("ADD", layers.outputs[kind + "Dir"], layers.outputs[kind + "Ind"]), width)
        total = combine("ADD", total, combine("MULTIPLY", light, layers.outputs[kind + "Col"]))
    tree.links.new(total, output.inputs["Image"])


BOUNCES = {"draft": (3, 2, 1), "preview": (6, 4, 2), "final": (12, 6, 4)}  # in all, diffuse, glossy


def wished_device():
    """What draws: --device=gpu or --device=cpu, else LAYOUTBOX_DEVICE, else the processor."""
    return next((word.split("=")[1] for word in sys.argv if word.startswith("--device=")), os.environ.get("LAYOUTBOX_DEVICE", "cpu"))


def use_graphics_card():
    """Lets Cycles use the graphics cards of the first kind that is here; False where there is none."""
    addon = bpy.context.preferences.addons.get("cycles")
    if addon is None:
        return False
    preferences = addon.preferences
    for kind in ("OPTIX", "CUDA", "HIP", "METAL", "ONEAPI"):
        if set_first(preferences, "compute_device_type", (kind,)) is None:
            continue
        preferences.get_devices()
        if any(device.type == kind for device in preferences.devices):
            for device in preferences.devices:
                device.use = device.type == kind
            return True
    return False


def use_cycles(scene):
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.device = "CPU"
    if wished_device() == "gpu":
        if use_graphics_card():
            cycles.device = "GPU"
        else:
            print("layoutbox: note: no graphics card that Cycles can use, the processor draws instead", flush=True)
    denoiser = has_denoiser()
    cycles.samples = SAMPLES[QUALITY]["denoised" if denoiser else "filtered"]
    cycles.use_adaptive_sampling = QUALITY == "final" or not denoiser
    cycles.adaptive_threshold = 0.01 if QUALITY == "final" else 0.02
    cycles.use_denoising = denoiser
    cycles.max_bounces, cycles.diffuse_bounces, cycles.glossy_bounces = BOUNCES[QUALITY]
    cycles.sample_clamp_indirect = 3.0
    cycles.caustics_reflective = cycles.caustics_refractive = False
    cycles.seed = 1
    if denoiser:
        set_first(cycles, "denoiser", ("OPENIMAGEDENOISE",))
        set_first(cycles, "denoising_prefilter", ("FAST",) if QUALITY == "draft" else ("ACCURATE",))
    else:
        if bpy.app.version < (5, 0, 0):
            filter_noise(scene)
        else:  # the compositor is another one there; more samples instead
            cycles.samples *= 6


def use_workbench(scene):
    """Flat and quick, no light and no textures; needs GL."""
    scene.render.engine = "BLENDER_WORKBENCH"
    shading = scene.display.shading
    shading.light, shading.color_type = "STUDIO", "MATERIAL"
    shading.show_shadows = shading.show_cavity = True
    shading.shadow_intensity = 0.25
    scene.display.render_aa = "8"
    scene.render.film_transparent = False
    scene.world.color = linear(LIGHT["background"])


PROGRESS = {"before": 0.0, "share": 1.0}  # what earlier pictures of this run took of the whole, and what this one takes


def report_progress():
    """Prints `progress 0.25` lines, for whoever runs this script."""
    last = [-1.0]

    def tell(text, *_):
        words = str(text).split("Sample ")
        if len(words) < 2 or "/" not in words[1]:
            return
        done, total = words[1].split("|")[0].strip().split("/")[:2]
        share = round(PROGRESS["before"] + PROGRESS["share"] * int(done) / max(1, int(total.split()[0])), 2)
        if share != last[0]:
            last[0] = share
            print(f"layoutbox: progress {share}", flush=True)

    bpy.app.handlers.render_stats.append(tell)


def set_up_render(engine):
    scene = bpy.context.scene
    scene.render.resolution_x, scene.render.resolution_y = CAMERA["width"], CAMERA["height"]
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "PNG"
    scene.render.image_settings.color_mode = "RGB"
    scene.render.image_settings.compression = 30
    scene.render.use_stamp = False
    scene.render.use_persistent_data = False
    set_colours(scene)
    if engine == "workbench":
        use_workbench(scene)
    else:
        use_cycles(scene)
    bpy.app.handlers.render_stats.clear()
    report_progress()


def write_thumbnail(picture, path):
    """A picture that is there already as a small JPEG."""
    image = bpy.data.images.load(picture)
    width = min(480, image.size[0])
    image.scale(width, max(1, round(image.size[1] * width / image.size[0])))
    image.filepath_raw, image.file_format = path, "JPEG"
    image.save()
    bpy.data.images.remove(image)


def render_picture(path):
    scene = bpy.context.scene
    scene.render.filepath = path
    bpy.ops.render.render(write_still=True)
    if not os.path.isfile(path):
        raise RuntimeError(f"Blender wrote no picture to {path}")
