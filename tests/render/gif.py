"""Reads GIF files: enough to look at the frames of a turntable."""

import struct


def read_gif(path):
    """(width, height, frames): each frame (hundredths of a second, rows of RGB)."""
    data = path.read_bytes()
    assert data[:6] == b"GIF89a", data[:6]
    width, height, flags = struct.unpack_from("<HHB", data, 6)
    colors = 2 << (flags & 7)
    palette = [tuple(data[13 + 3 * i : 16 + 3 * i]) for i in range(colors)]
    place, frames, delay = 13 + 3 * colors, [], 0

    def blocks(place):
        joined = b""
        while data[place]:
            joined += data[place + 1 : place + 1 + data[place]]
            place += 1 + data[place]
        return joined, place + 1

    while data[place] != 0x3B:
        if data[place] == 0x21:
            body, after = blocks(place + 2)
            if data[place + 1] == 0xF9:
                delay = struct.unpack_from("<H", body, 1)[0]
            place = after
        else:
            assert data[place] == 0x2C, hex(data[place])
            size = struct.unpack_from("<HH", data, place + 5)
            assert size == (width, height), size
            packed, place = blocks(place + 11)
            numbers = unpack(packed)
            assert len(numbers) == width * height, len(numbers)
            frames.append((delay, [[palette[n] for n in numbers[y * width : (y + 1) * width]] for y in range(height)]))
    return width, height, frames


def unpack(packed):
    """The numbers of an LZW stream of 8-bit symbols."""
    bits = count = 0
    size, table, last, out = 9, [], None, []
    for byte in packed:
        bits |= byte << count
        count += 8
        while count >= size:
            code, bits, count = bits & (1 << size) - 1, bits >> size, count - size
            if code == 256:
                size, table, last = 9, [bytes([i]) for i in range(256)] + [b"", b""], None
                continue
            if code == 257:
                return out
            word = table[code] if code < len(table) else last + last[:1]
            out.extend(word)
            if last is not None and len(table) < 4096:
                table.append(last + word[:1])
            if len(table) >= 1 << size and size < 12:
                size += 1
            last = word
    return out
