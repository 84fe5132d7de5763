# ---- The turntable: iso turned once round the room, as a GIF or an MP4. --------------------------------------------------------------
import os
import tempfile

import bpy

TURNTABLE = {"frames": 36, "seconds": 6.0, "width": 960, "samples": {"denoised": 4, "filtered": 10}}


def keep_still():
    """One scale and one middle for all frames: the widest of them decides, so that the room turns and does not breathe."""
    xs, ys = zip(*outer_outline())
    USUAL_CAMERA["about"] = ((min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2, 0.3 * ROOM["height"])
    widths = []
    for number in range(TURNTABLE["frames"]):
        use_view("iso", 360.0 * number / TURNTABLE["frames"])
        widths.append(frame(walls_that_stay())[1])
    USUAL_CAMERA["least_width"] = max(widths)


def write_turntable(kind, engine, meshes, path):
    """Walls are cut away anew for each frame. The scene is the last frame's afterwards."""
    usual_size = USUAL_CAMERA["width"], USUAL_CAMERA["height"]
    width = min(TURNTABLE["width"], usual_size[0])
    USUAL_CAMERA.update(width=width // 2 * 2, height=max(2, round(width * usual_size[1] / usual_size[0] / 2) * 2))
    keep_still()
    with tempfile.TemporaryDirectory() as folder:
        frames = []
        for number in range(TURNTABLE["frames"]):
            build("iso", meshes, 360.0 * number / TURNTABLE["frames"])
            set_up_render(engine)
            render = bpy.context.scene.render
            render.dither_intensity = 0.0  # its grain would flicker, and spoil the GIF's few colours
            if kind == "gif":  # what is behind the room is laid under it afterwards, as one plain colour
                render.film_transparent, render.image_settings.color_mode = True, "RGBA"
            if engine != "workbench":
                cycles = bpy.context.scene.cycles
                cycles.samples = min(cycles.samples, TURNTABLE["samples"]["denoised" if has_denoiser() else "filtered"])
            PROGRESS.update(before=number / TURNTABLE["frames"], share=1 / TURNTABLE["frames"])
            frames.append(os.path.join(folder, f"frame{number:03}.png"))
            render_picture(frames[-1])
        (write_mp4 if kind == "mp4" else write_gif)(frames, path)
    USUAL_CAMERA.update(width=usual_size[0], height=usual_size[1], about=None, least_width=0.0)


def write_mp4(frames, path):
    """By Blender's own sequencer and FFmpeg."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    editor = scene.sequence_editor_create()
    strips = editor.strips if hasattr(editor, "strips") else editor.sequences  # renamed in 4.4
    strip = strips.new_image(name="turn", filepath=frames[0], channel=1, frame_start=1)
    for frame in frames[1:]:
        strip.elements.append(os.path.basename(frame))
    render = scene.render
    render.resolution_x, render.resolution_y, render.resolution_percentage = USUAL_CAMERA["width"], USUAL_CAMERA["height"], 100
    scene.frame_start, scene.frame_end = 1, len(frames)
    render.fps = max(1, round(len(frames) / TURNTABLE["seconds"]))
    set_first(scene.view_settings, "view_transform", ("Standard",))
    if hasattr(render.image_settings, "media_type"):  # from 5.0
        render.image_settings.media_type = "VIDEO"
    render.image_settings.file_format = "FFMPEG"
    render.ffmpeg.format, render.ffmpeg.codec = "MPEG4", "H264"
    render.ffmpeg.constant_rate_factor = "HIGH"
    render.use_file_extension = False
    render.filepath = path
    bpy.ops.render.render(animation=True)


def coarse(frame):
    """A picture's size and, for each pixel from the top left, its colour over the background in steps of 1/63: one number, six bits a
    channel."""
    import numpy

    image = bpy.data.images.load(frame)
    width, height = image.size
    values = numpy.empty(len(image.pixels), numpy.float32)
    image.pixels.foreach_get(values)
    bpy.data.images.remove(image)
    values = values.reshape(height, width, 4)[::-1]
    alpha = values[:, :, 3:]
    values = values[:, :, :3] * alpha + numpy.array(LIGHT["background"], numpy.float32) * (1 - alpha)
    steps = numpy.clip(numpy.rint(values * 63), 0, 63).astype(numpy.int64)
    return width, height, (steps[:, :, 0] * 4096 + steps[:, :, 1] * 64 + steps[:, :, 2]).ravel()


def best_colors(colors, weights, count=256):
    """So many colours that stand for the given ones: boxes cut at the middle of their longest side, then moved to what is nearest them."""
    import numpy

    boxes = [numpy.arange(len(colors))]
    while len(boxes) < min(count, len(colors)):
        worth = [numpy.ptp(colors[box], axis=0).max() * weights[box].sum() ** 0.5 if len(box) > 1 else -1 for box in boxes]
        box = boxes.pop(int(numpy.argmax(worth)))
        order = box[numpy.argsort(colors[box][:, int(numpy.argmax(numpy.ptp(colors[box], axis=0)))], kind="stable")]
        half = numpy.searchsorted(numpy.cumsum(weights[order]), weights[order].sum() / 2)
        half = min(max(int(half), 1), len(order) - 1)
        boxes += [order[:half], order[half:]]
    palette = numpy.array([numpy.average(colors[box], axis=0, weights=weights[box]) for box in boxes])
    for _ in range(3):
        near = nearest(colors, palette)
        for number in range(len(palette)):
            mine = near == number
            if mine.any():
                palette[number] = numpy.average(colors[mine], axis=0, weights=weights[mine])
    return palette


def nearest(colors, palette):
    """For each colour the number of the palette's nearest one."""
    import numpy

    parts = [colors[place:place + 4096] for place in range(0, len(colors), 4096)]
    return numpy.concatenate([((part[:, None, :] - palette[None]) ** 2).sum(axis=2).argmin(axis=1) for part in parts])


def write_gif(frames, path):
    """One palette for all frames, made of their own colours; no dots."""
    import numpy

    pictures = [coarse(frame) for frame in frames]
    width, height = pictures[0][:2]
    counts = sum(numpy.bincount(codes, minlength=64 ** 3) for _, _, codes in pictures)
    used = numpy.flatnonzero(counts)
    colors = numpy.stack([used >> 12, used >> 6 & 63, used & 63], axis=1) / 63.0
    palette = best_colors(colors, counts[used].astype(float))
    number_of = numpy.zeros(64 ** 3, numpy.uint8)
    number_of[used] = nearest(colors, palette)
    delay = max(2, round(100 * TURNTABLE["seconds"] / len(frames)))
    table = numpy.rint(255 * palette).astype(numpy.uint8).tobytes().ljust(768, b"\0")
    with open(path, "wb") as file:
        file.write(b"GIF89a" + struct.pack("<HHBBB", width, height, 0xF7, 0, 0) + table)
        file.write(b"\x21\xff\x0bNETSCAPE2.0\x03\x01\x00\x00\x00")  # again and again
        for _, _, codes in pictures:
            file.write(struct.pack("<BBBBHBB", 0x21, 0xF9, 4, 0, delay, 0, 0))
            file.write(struct.pack("<BHHHHB", 0x2C, 0, 0, width, height, 0) + b"\x08")
            packed = lzw(number_of[codes].tobytes())
            for place in range(0, len(packed), 255):
                part = packed[place:place + 255]
                file.write(bytes([len(part)]) + part)
            file.write(b"\x00")
        file.write(b"\x3b")


def lzw(data):
    """GIF's compression, for symbols of 8 bits."""
    out, bits, count = bytearray(), 0, 0
    clear, table, size, following = 256, {}, 9, 258

    def put(code):
        nonlocal bits, count
        bits |= code << count
        count += size
        while count >= 8:
            out.append(bits & 255)
            bits >>= 8
            count -= 8

    put(clear)
    last = data[0]
    for symbol in data[1:]:
        key = last << 8 | symbol
        found = table.get(key)
        if found is not None:
            last = found
            continue
        put(last)
        table[key] = following
        following += 1
        if following > 1 << size:
            if size < 12:
                size += 1
            else:
                put(clear)
                table, size, following = {}, 9, 258
        last = symbol
    put(last)
    put(257)
    if count:
        out.append(bits & 255)
    return bytes(out)
