# ---- The run: python or blender, a folder, and what is wished. -----------------------------------------------------------------------
import os
import sys

import bpy


def script_folder():
    return os.path.dirname(os.path.abspath(__file__))


def wishes():
    """The words after `--` (Blender), or after the script's name (Python with bpy)."""
    if "--" in sys.argv:
        return sys.argv[sys.argv.index("--") + 1:]
    return sys.argv[1:] if os.path.basename(sys.argv[0]) == os.path.basename(__file__) else []


def build(view, meshes, turn=0.0):
    """The scene for one view, turned so many degrees; gives what stays of the walls and what is left out."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    use_view(view, turn)
    if view == "eye":
        stand_in_the_room(meshes)
    elif view == "door":
        stand_in_the_door(meshes)
    stay = walls_that_stay()
    out = left_out(stay)
    out |= hangers_in_the_way(stay, out, meshes)
    materials = {name: make_material(name, row) for name, row in MATERIALS.items()}
    build_base(stay)
    build_ghosts(stay, out)
    build_rows(SHELL + OBJECTS, out, meshes, materials)
    build_light()
    build_beams(stay)
    build_camera(stay)
    hidden = bpy.data.collections.get("Left out")
    if hidden:
        bpy.context.view_layer.layer_collection.children[hidden.name].exclude = True
    return stay, out


def main():
    words = wishes()
    folder = os.path.abspath(next((word for word in words if not word.startswith("--")), script_folder()))
    os.makedirs(folder, exist_ok=True)
    engine = next((word.split("=")[1] for word in words if word.startswith("--engine=")), "cycles")
    print(f"layoutbox: blender {bpy.app.version_string}", flush=True)
    meshes = read_meshes()
    for number, view in enumerate(VIEWS):
        stay, out = build(view, meshes)
        set_up_render(engine)
        if number == 0 and "--mask" in words:
            write_mask(stay, out, meshes, os.path.join(folder, OUTPUT["mask"]), os.path.join(folder, OUTPUT["mask_index"]))
            print("layoutbox: wrote mask", flush=True)
        if number == 0 and "--no-blend" not in words and OUTPUT["blend"]:
            bpy.ops.wm.save_as_mainfile(filepath=os.path.join(folder, OUTPUT["blend"]), compress=True)
            print("layoutbox: wrote blend", flush=True)
        if "--no-picture" not in words:
            PROGRESS.update(before=number / len(VIEWS), share=1 / len(VIEWS))
            render_picture(os.path.join(folder, picture_of(view)))
            print(f"layoutbox: wrote {view}", flush=True)
        if number == 0 and "--overlay" in words and "--no-picture" not in words:
            write_overlay(stay, out, meshes, os.path.join(folder, picture_of(view)), os.path.join(folder, OUTPUT["overlay"]))
            print("layoutbox: wrote overlay", flush=True)
        if number == 0 and "--thumbnail" in words and "--no-picture" not in words:
            shown = os.path.join(folder, OUTPUT["overlay"] if "--overlay" in words else picture_of(view))
            write_thumbnail(shown, os.path.join(folder, OUTPUT["thumbnail"]))
            print("layoutbox: wrote thumbnail", flush=True)
    kind = next((word.split("=")[1] for word in words if word.startswith("--turntable=")), "")
    if kind:
        write_turntable(kind, engine, meshes, os.path.join(folder, f"{OUTPUT['turntable']}.{kind}"))
        print("layoutbox: wrote turntable", flush=True)


def leave():
    """A Python with bpy 4.2 or 4.5 may crash or hang while it ends, though every file is whole: it ends at once instead. With --stay
    (serve.py) the process goes on."""
    if not bpy.app.binary_path and "--stay" not in sys.argv:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(0)
