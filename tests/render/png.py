"""Reads a PNG of 8-bit RGB or RGBA pixels without any library."""

import struct
import zlib


def read_png(path):
    """(width, height, pixels): pixels[y][x] is (r, g, b)."""
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", path
    place, packed = 8, b""
    while place < len(data):
        length, kind = struct.unpack_from(">I4s", data, place)
        body = data[place + 8 : place + 8 + length]
        if kind == b"IHDR":
            width, height, bits, colour = struct.unpack_from(">IIBB", body)
            assert bits == 8 and colour in (2, 6), (bits, colour)
        elif kind == b"IDAT":
            packed += body
        place += length + 12
    channels = 3 if colour == 2 else 4
    lines, stride, rows, before = zlib.decompress(packed), width * channels, [], bytes(width * channels)
    for y in range(height):
        start = y * (stride + 1)
        before = unfilter(lines[start], bytearray(lines[start + 1 : start + 1 + stride]), before, channels)
        rows.append([tuple(before[x : x + 3]) for x in range(0, stride, channels)])
    return width, height, rows


def unfilter(kind, line, before, step):
    for i in range(len(line)):
        left = line[i - step] if i >= step else 0
        up = before[i]
        corner = before[i - step] if i >= step else 0
        if kind == 1:
            guess = left
        elif kind == 2:
            guess = up
        elif kind == 3:
            guess = (left + up) // 2
        elif kind == 4:
            p = left + up - corner
            guess = min((left, up, corner), key=lambda v: abs(p - v))
        else:
            guess = 0
        line[i] = (line[i] + guess) & 255
    return bytes(line)
