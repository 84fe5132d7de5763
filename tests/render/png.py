"""The pixels of a PNG."""

from PIL import Image


def read_png(path):
    """(width, height, pixels): pixels[y][x] is (r, g, b)."""
    with Image.open(path) as picture:
        assert picture.format == "PNG" and picture.mode in ("RGB", "RGBA"), (path, picture.format, picture.mode)
        width, height = picture.size
        values = picture.convert("RGB").tobytes()
    rows = (values[3 * width * y : 3 * width * (y + 1)] for y in range(height))
    return width, height, [[tuple(row[x : x + 3]) for x in range(0, 3 * width, 3)] for row in rows]
