#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""A picture of a mesh that becomes its molecule: the left half is the one, the right half the other.

    half_and_half.py OUT.png MESH [--turn "X Y"] [--pixels N] [-- BUILD OPTIONS...]

Builds the molecule with a page of it (`nanocarbon build --page`) and takes the picture of that page in Chromium, which the
tests of pages know how to drive. Environment: NANOCARBON, the program (default: nanocarbon).
"""

import argparse
import base64
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/page"))

import browser  # noqa: E402

# The drawn part of the canvas, made smaller.
PICTURE = """(async () => {
  const choose = (id, property, value) => {
    document.getElementById(id)[property] = value;
    document.getElementById(id).dispatchEvent(new Event('change'));
  };
  choose('mesh', 'value', 'half');
  choose('show-rings', 'checked', true);
  nanocarbonPage.turn(%s, %s);
  await new Promise((r) => requestAnimationFrame(() => requestAnimationFrame(r)));
  const from = document.querySelector('#stage canvas'), flat = document.createElement('canvas');
  flat.width = from.width;
  flat.height = from.height;
  const pen = flat.getContext('2d', { willReadFrequently: true });
  pen.drawImage(from, 0, 0);
  const p = pen.getImageData(0, 0, flat.width, flat.height).data;
  let [left, right, top, bottom] = [flat.width, 0, flat.height, 0];
  for (let y = 0; y < flat.height; ++y)
    for (let x = 0; x < flat.width; ++x) {
      const i = 4 * (y * flat.width + x);
      if (p[i] + p[i + 1] + p[i + 2] > 750) continue;
      [left, right, top, bottom] = [Math.min(left, x), Math.max(right, x), Math.min(top, y), Math.max(bottom, y)];
    }
  const border = 0.02 * flat.width, wide = right - left + 2 * border, high = bottom - top + 2 * border;
  const out = document.createElement('canvas');
  out.width = %d;
  out.height = Math.round(out.width * high / wide);
  const last = out.getContext('2d');
  last.fillStyle = 'white';
  last.fillRect(0, 0, out.width, out.height);
  last.imageSmoothingQuality = 'high';
  last.drawImage(flat, left - border, top - border, wide, high, 0, 0, out.width, out.height);
  return out.toDataURL('image/png').split(',')[1];
})()"""


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("mesh", type=pathlib.Path)
    parser.add_argument("--turn", default="0 0", help="about the picture's x and y, radians")
    parser.add_argument("--pixels", type=int, default=800, help="how wide it is")
    words = sys.argv[1:]
    cut = words.index("--") if "--" in words else len(words)
    args = parser.parse_args(words[:cut])
    if not browser.find():
        sys.exit("half_and_half.py: there is no Chromium")
    with tempfile.TemporaryDirectory() as folder:
        page = pathlib.Path(folder) / "page.html"
        subprocess.run([os.environ.get("NANOCARBON", "nanocarbon"), "build", args.mesh, "-q", "-o", page.with_suffix(".data"),
                        "--page", page, *words[cut + 1:]], check=True)
        chromium = browser.Browser(width=3 * args.pixels, height=3 * args.pixels)
        try:
            chromium.open(page)
            # As large as the window: the page's other parts are not in the picture.
            chromium.evaluate("document.getElementById('stage').style.cssText = "
                              "'position: fixed; inset: 0; height: 100vh; z-index: 9'")
            x, y = map(float, args.turn.split())
            args.out.write_bytes(base64.b64decode(chromium.evaluate(PICTURE % (x, y, args.pixels))))
        finally:
            chromium.close()


if __name__ == "__main__":
    main()
