# SPDX-License-Identifier: GPL-2.0-or-later
"""Small, smooth PNGs from the large PPMs that LAMMPS draws: halved, cropped, put side by side, few colours."""

import struct
import zlib


def read_ppm(path):
    """Width and rows of a binary PPM, a row as bytes of red, green and blue."""
    data = path.read_bytes()
    magic, width, height, depth = data.split(maxsplit=4)[:4]
    if magic != b"P6" or depth != b"255":
        raise ValueError(f"{path}: not a PPM of 8 bits")
    width, height = int(width), int(height)
    start = len(data) - 3 * width * height
    return [data[start + 3 * width * y:start + 3 * width * (y + 1)] for y in range(height)]


def halved(rows):
    """Every four pixels averaged, which smooths edges."""
    result = []
    for upper, lower in zip(rows[::2], rows[1::2]):
        row = bytearray(len(upper) // 2)
        for channel in range(3):
            sums = (a + b + c + d for a, b, c, d in zip(upper[channel::6], upper[channel + 3::6], lower[channel::6],
                                                        lower[channel + 3::6]))
            row[channel::3] = bytes(s // 4 for s in sums)
        result.append(bytes(row))
    return result


def cropped(pictures, border=6):
    """Pictures of one size without the white that is around all of them."""
    white = [bytes([255]) * len(rows[0]) for rows in pictures]
    filled = [y for y in range(len(pictures[0])) if any(rows[y] != w for rows, w in zip(pictures, white))]
    if not filled:
        return pictures
    columns = []
    for rows in pictures:
        for row in rows:
            if row.count(255) != len(row):
                left = len(row) - len(row.lstrip(b"\xff"))
                columns += [left // 3, (len(row.rstrip(b"\xff")) - 1) // 3]
    top, bottom = max(0, filled[0] - border), min(len(pictures[0]), filled[-1] + 1 + border)
    left, right = max(0, min(columns) - border), max(columns) + 1 + border
    return [[row[3 * left:3 * right] for row in rows[top:bottom]] for rows in pictures]


def beside(pictures):
    return [b"".join(rows) for rows in zip(*pictures)]


def write_png(path, rows):
    """With a palette of at most 256 colours: greys in steps of 4, others as finely as there is room for."""
    def shade(r, g, b, step):
        if max(r, g, b) - min(r, g, b) < 12:
            grey = min(255, (r + g + b + 6) // 12 * 4)
            return grey, grey, grey
        return tuple(min(255, (c + step // 2) // step * step) for c in (r, g, b))

    pixels = {pixel for row in rows for pixel in zip(row[::3], row[1::3], row[2::3])}
    step = next(s for s in (8, 16, 24, 32, 48, 64, 96, 128) if len({shade(*p, s) for p in pixels}) <= 256)

    palette, known, lines = {}, {}, []
    for row in rows:
        line = bytearray(1)  # filter: none
        for pixel in zip(row[::3], row[1::3], row[2::3]):
            if pixel not in known:
                known[pixel] = palette.setdefault(shade(*pixel, step), len(palette))
            line.append(known[pixel])
        lines.append(bytes(line))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", len(rows[0]) // 3, len(rows), 8, 3, 0, 0, 0)
    colours = b"".join(bytes(colour) for colour in palette)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"PLTE", colours)
                     + chunk(b"IDAT", zlib.compress(b"".join(lines), 9)) + chunk(b"IEND", b""))
