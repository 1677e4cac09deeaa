#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Writes a period of the gyroid as a scalar field of N x N x N values (VTK image), to time readers of large fields:

    gyroid_field.py 200 gyroid.vti
    /usr/bin/time -v nanocarbon inspect gyroid.vti --level 0 --periodic xyz
    /usr/bin/time -v nanocarbon build gyroid.vti --level 0 --periodic xyz --atoms 4000 --quality draft -o gyroid.data
"""

import argparse
import array
import base64
import math
import struct
import sys


def values(count):
    """sin x cos y + sin y cos z + sin z cos x, x fastest."""
    sines = [math.sin(2 * math.pi * i / count) for i in range(count)]
    cosines = [math.cos(2 * math.pi * i / count) for i in range(count)]
    field = array.array("f")
    for sz, cz in zip(sines, cosines):
        for sy, cy in zip(sines, cosines):
            field.extend([sx * cy + sy * cz + sz * cx for sx, cx in zip(sines, cosines)])
    return field


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("count", type=int)
    parser.add_argument("file")
    args = parser.parse_args()
    field = values(args.count)
    if sys.byteorder == "big":
        field.byteswap()
    extent = f"0 {args.count - 1} " * 3
    step = 2 * math.pi / args.count
    data = struct.pack("<Q", 4 * len(field)) + field.tobytes()
    with open(args.file, "w", encoding="ascii") as out:
        out.write('<?xml version="1.0"?>\n'
                  '<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt64">\n'
                  f'<ImageData WholeExtent="{extent}" Origin="0 0 0" Spacing="{step!r} {step!r} {step!r}">\n'
                  f'<Piece Extent="{extent}"><PointData Scalars="field">'
                  '<DataArray type="Float32" Name="field" format="binary">\n')
        out.write(base64.b64encode(data).decode("ascii"))
        out.write("\n</DataArray></PointData></Piece></ImageData></VTKFile>\n")


if __name__ == "__main__":
    main()
