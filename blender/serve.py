# A Blender that draws many rooms: a job per line on stdin, {"script": "…/blender.py", "words": ["…/folder", "--no-blend"]}; the answer is
# `layoutbox: done` or `layoutbox: failed …`, after what the script itself printed. It ends with its stdin or with its parent.
import json
import os
import runpy
import sys
import threading
import time
import traceback

import bpy


def end_with_parent():
    """A render cannot notice that nobody waits for it any more; this does."""
    parent = os.getppid()
    while os.getppid() == parent:
        time.sleep(0.5)
    os._exit(1)


def draw(job):
    sys.argv = [job["script"], *job["words"], "--stay"]
    try:
        runpy.run_path(job["script"], run_name="__main__")
    finally:
        for handlers in (bpy.app.handlers.render_stats, bpy.app.handlers.frame_change_pre):
            handlers.clear()


def main():
    threading.Thread(target=end_with_parent, daemon=True).start()
    for line in sys.stdin:
        try:
            draw(json.loads(line))
        except Exception as error:
            traceback.print_exc()
            words = " ".join(str(error).split())
            print(f"layoutbox: failed {type(error).__name__}: {words}", flush=True)
        else:
            print("layoutbox: done", flush=True)
    if not bpy.app.binary_path:
        os._exit(0)  # see leave() in main.py


main()
