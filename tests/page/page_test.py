#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Opens pages of `nanocarbon build --page` and `analyse --page` in Chromium and looks at what is there.

    page_test.py PROGRAM MESH FOLDER

Pictures are left in FOLDER. Ends with 77 where there is no Chromium.
"""

import pathlib
import subprocess
import sys

import browser as chromium

BENZENE = [("C", 1.39, 0), ("C", 0.695, 1.204), ("C", -0.695, 1.204), ("C", -1.39, 0), ("C", -0.695, -1.204),
           ("C", 0.695, -1.204)]

# How many pixels of the picture are of which kind.
COUNT = """(async () => {
  await new Promise((r) => requestAnimationFrame(() => requestAnimationFrame(r)));
  const c = document.querySelector('#stage canvas'), d = document.createElement('canvas');
  d.width = c.width; d.height = c.height;
  const g = d.getContext('2d'); g.drawImage(c, 0, 0);
  const p = g.getImageData(0, 0, d.width, d.height).data, n = { all: p.length / 4, drawn: 0, blue: 0, red: 0, gold: 0, left: 0, right: 0 };
  for (let i = 0; i < p.length; i += 4) {
    const [r, gr, b] = [p[i], p[i + 1], p[i + 2]];
    if (r > 250 && gr > 250 && b > 250) continue;
    ++n.drawn;
    ++n[(i / 4) % d.width < d.width / 2 ? 'left' : 'right'];
    if (b > r + 50) ++n.blue;
    if (r > b + 50 && r > gr + 50) ++n.red;
    if (r > b + 30 && gr > b + 20) ++n.gold;
  }
  return n;
})()"""

# The same without waiting for another frame.
COUNT_NOW = COUNT.replace("  await new Promise((r) => requestAnimationFrame(() => requestAnimationFrame(r)));\n", "")

# The same of the left and of the right half.
HALVES = COUNT.replace("n = { all: p.length / 4, drawn: 0, blue: 0, red: 0, gold: 0, left: 0, right: 0 };",
                       "both = [0, 1].map(() => ({ drawn: 0, blue: 0, red: 0, gold: 0, left: 0, right: 0 }));").replace(
    "++n.drawn;", "const n = both[(i / 4) % d.width < d.width / 2 ? 0 : 1]; ++n.drawn;").replace("return n;", "return both;")

# Where the hydrogen atom nearest to the eye is on the screen.
NEAREST_HYDROGEN = """(() => {
  let best = null;
  for (let a = 0; a < nanocarbonPage.atoms(); ++a) {
    if (!nanocarbonPage.value(a, 'element')) continue;
    const at = nanocarbonPage.atomOnScreen(a);
    if (!best || at.depth < best.depth) best = at;
  }
  return best;
})()"""


# The middle of the picture.
MIDDLE = """(() => {
  const b = document.querySelector('#stage canvas').getBoundingClientRect();
  return { x: b.left + b.width / 2, y: b.top + b.height / 2 };
})()"""


def benzene(folder):
    file = folder / "benzene.xyz"
    hydrogen = [("H", 2.48 / 1.39 * x, 2.48 / 1.39 * y) for _, x, y in BENZENE]
    file.write_text("12\n\n" + "".join(f"{s} {x} {y} 0\n" for s, x, y in BENZENE + hydrogen))
    return file


def torn_c60(program, folder):
    """C60, and a frame of it with an atom 3 Angstrom away."""
    start, file = folder / "c60.xyz", folder / "torn.xyz"
    subprocess.run([program, "make", "fullerene", "1", "1", "-q", "-o", start], check=True)
    lines = start.read_text().splitlines()
    atoms = [line.split() for line in lines[2:62]]
    away = [[a[0]] + [str(float(x) * (2.0 if n == 7 else 1.0)) for x in a[1:4]] for n, a in enumerate(atoms)]
    frames = [[a[:4] for a in atoms], away]
    file.write_text("".join("60\n\n" + "".join(" ".join(a) + "\n" for a in frame) for frame in frames))
    return file


class Pages:
    def __init__(self, program, folder):
        self.program, self.folder, self.browser = program, folder, chromium.Browser()

    def show(self, name, *arguments):
        page = self.folder / f"{name}.html"
        subprocess.run([self.program, *arguments, "-q", "--page", page], check=True)
        self.browser.open(page)
        assert self.browser.evaluate("window.nanocarbonPage && window.nanocarbonPage.ready") is True, name
        count = self.browser.evaluate(COUNT)
        assert count["drawn"] > 0.02 * count["all"], (name, count)
        self.browser.screenshot(self.folder / f"{name}.png")
        return count, page.stat().st_size

    def sound(self, name):
        assert not self.browser.messages, (name, self.browser.messages)
        outside = [u for u in self.browser.requests if not u.startswith(("file:", "data:"))]
        assert not outside, (name, outside)

    def text(self, selector):
        return self.browser.evaluate(f"document.querySelector('{selector}').textContent")

    def choose(self, element, value):
        self.browser.evaluate(f"(() => {{ const e = document.getElementById('{element}'); "
                              f"if (e.type === 'checkbox') e.checked = {value}; else e.value = {value}; "
                              "e.dispatchEvent(new Event('input')); e.dispatchEvent(new Event('change')); })()")

    def colour_by(self, name):
        index = self.browser.evaluate("[...document.querySelectorAll('#colour option')].map((o) => o.text)").index(name)
        self.choose("colour", index)

    def click_nearest_atom(self):
        at = self.browser.evaluate("(() => { const n = nanocarbonPage.nearestAtom(); "
                                   "return { n, ...nanocarbonPage.atomOnScreen(n) }; })()")
        self.browser.click(at["x"], at["y"])
        return at["n"]


def a_build(pages, mesh, folder):
    count, _ = pages.show("build", "build", mesh, "--atoms", "400", "--quality", "draft", "-o", folder / "built.data")
    assert count["gold"] > 0.02 * count["all"], count  # the mesh, on the left
    assert min(count["left"], count["right"]) > 0.01 * count["all"], count
    assert pages.text("#verdict") == "holds"
    assert "nanocarbon build" in pages.text("#command")
    for name in ["distance to surface", "energy", "mean curvature"]:
        pages.colour_by(name)
        assert " to " in pages.text("#legend"), name
    pages.choose("mesh", "'none'")
    assert pages.browser.evaluate(COUNT)["gold"] < count["gold"]
    pages.choose("mesh", "'over'")
    assert pages.browser.evaluate("document.querySelectorAll('#plots svg').length") >= 5
    pages.colour_by("ring")
    pages.choose("mesh", "'half'")
    left, right = pages.browser.evaluate(HALVES)
    assert left["gold"] > 0.8 * left["drawn"] > 0, left  # the mesh only
    assert right["gold"] < 0.02 * right["drawn"], right  # atoms only
    pages.browser.screenshot(pages.folder / "build-halves.png")
    pages.sound("build")


def open_surfaces(pages, mesh, folder):
    """A bowl with a rim; and a tube whose ends have hydrogen: both elements can be told, a click names a hydrogen atom."""
    pages.show("bowl", "build", mesh, "--atoms", "300", "--quality", "draft", "-o", folder / "bowl.data")
    assert "boundary loops 1" in pages.text("#facts"), pages.text("#facts")
    pages.colour_by("bonds")
    assert "1 bonds (" in pages.text("#legend"), pages.text("#legend")  # of the hydrogens at the boundary
    assert "2 bonds (" not in pages.text("#legend"), pages.text("#legend")
    pages.sound("bowl")
    subprocess.run([pages.program, "make", "tube", "6", "6", "--length", "15", "-q", "-o", folder / "tube.data"], check=True)
    pages.show("tube", "analyse", folder / "tube.data")
    assert "boundary loops 2" in pages.text("#facts"), pages.text("#facts")
    pages.colour_by("element")
    assert "hydrogen (24)" in pages.text("#legend"), pages.text("#legend")  # twelve at each end of an armchair tube (6, 6)
    pages.choose("style", "'spheres'")
    at = pages.browser.evaluate(NEAREST_HYDROGEN)
    pages.browser.click(at["x"], at["y"])
    assert "elementhydrogen" in pages.text("#picked-text"), pages.text("#picked-text")
    assert pages.browser.evaluate(COUNT)["gold"] > 0  # it is marked
    pages.sound("tube")


def picking(pages):
    """C60: atoms, rings, turning."""
    count, _ = pages.show("c60", "analyse", pages.folder / "c60.xyz")
    assert count["blue"] > 0.01 * count["all"], count  # every atom is in a pentagon
    atom = pages.click_nearest_atom()
    assert f"atom ID{atom + 1}" in pages.text("#picked-text"), pages.text("#picked-text")
    assert "pyramidalisation11.6" in pages.text("#picked-text"), pages.text("#picked-text")
    pages.browser.evaluate("document.querySelector('button.defect').click()")
    assert "pentagon" in pages.text("#picked-text")
    pages.choose("show-rings", "true")
    filled = pages.browser.evaluate(COUNT)  # pentagons, and hexagons that hide what is behind
    assert filled["drawn"] > 1.3 * count["drawn"] and filled["blue"] > 0.01 * filled["all"], (count, filled)
    # The middle of the first ring, seen from in front of it.
    before = pages.browser.evaluate("JSON.stringify(nanocarbonPage.atomOnScreen(0))")
    middle = pages.browser.evaluate(MIDDLE)
    pages.browser.drag(middle["x"], middle["y"], 120, 40)
    assert pages.browser.evaluate("JSON.stringify(nanocarbonPage.atomOnScreen(0))") != before
    pages.browser.screenshot(pages.folder / "c60-rings.png")
    pages.sound("c60")


def a_ring(pages, file):
    count, _ = pages.show("benzene", "analyse", file)
    middle = pages.browser.evaluate(
        "(() => { const at = [0, 1, 2, 3, 4, 5].map((a) => nanocarbonPage.atomOnScreen(a)); "
        "return { x: at.reduce((s, p) => s + p.x, 0) / 6, y: at.reduce((s, p) => s + p.y, 0) / 6 }; })()")
    pages.browser.click(middle["x"], middle["y"])
    text = pages.text("#picked-text")
    assert "ringof 6 atoms" in text and all(str(n) in text for n in range(1, 7)), text
    pages.colour_by("element")
    assert "hydrogen (6)" in pages.text("#legend"), pages.text("#legend")
    pages.sound("benzene")


def a_cell(pages):
    data = pages.folder / "crystal.data"
    subprocess.run([pages.program, "make", "schwarzite", "p688", "--cells", "1", "-q", "-o", data], check=True)
    count, _ = pages.show("cell", "analyse", data)
    assert not pages.browser.evaluate("document.getElementById('show-cell').parentElement.hidden")
    blue = count["blue"]
    pages.choose("show-cell", "false")
    assert pages.browser.evaluate(COUNT)["blue"] < blue  # the lines of the cell
    pages.choose("show-rings", "true")
    assert pages.browser.evaluate(COUNT)["gold"] > 0.01 * count["all"]  # octagons
    pages.sound("cell")


def a_broken_one(pages, file):
    count, _ = pages.show("torn", "analyse", file)
    assert pages.text("#verdict") == "broken"
    assert "3 bonds broken, 0 formed, 1 atoms repelled" in pages.text("#facts")
    pages.colour_by("state")
    assert "repelled (1)" in pages.text("#legend"), pages.text("#legend")
    assert pages.browser.evaluate(COUNT)["red"] > 0
    assert "frame 2: broken" in pages.text("#frame-text")
    pages.choose("frame", "0")
    assert "frame 1: intact" in pages.text("#frame-text")
    assert "repelled" not in pages.text("#legend")
    assert pages.browser.evaluate(COUNT)["red"] == 0
    pages.sound("torn")


def large_ones(pages):
    data = pages.folder / "c10580.data"
    subprocess.run([pages.program, "make", "fullerene", "23", "0", "-q", "-o", data], check=True)
    _, size = pages.show("c10580", "analyse", data, "--potential", "none")
    assert size < 5e6, size
    pages.sound("c10580")
    print(f"10,580 atoms: {size / 1e6:.2f} MB; {turning(pages)}")
    subprocess.run([pages.program, "make", "fullerene", "71", "0", "-q", "-o", data], check=True)
    pages.show("c100820", "analyse", data, "--potential", "none")
    pages.sound("c100820")
    # Ten frames a second are asked, which are 200 ms of CPU each on two cores. Where other work slows them, fewer atoms are
    # drawn; how long that work keeps a frame waiting is not the page's doing.
    said = turning(pages)
    print(f"100,820 atoms: {said}")
    assert said.cpu < 200, said
    print(f"100,820 atoms: {dragging(pages):.1f} frames a second while dragged for five seconds")
    # It must still look like the molecule at rest: about as much of the picture is drawn.
    resting = pages.browser.evaluate(COUNT)
    pages.browser.evaluate("nanocarbonPage.turnAndStay()")
    moving = pages.browser.evaluate(COUNT_NOW)
    pages.browser.screenshot(pages.folder / "c100820-turning.png")
    assert 0.6 * resting["drawn"] < moving["drawn"] < 1.5 * resting["drawn"], (resting, moving)


class Turning:
    def __init__(self, times, cpu, whole, share):
        self.times, self.cpu, self.whole, self.share = sorted(times), cpu, whole, share
        self.median = self.times[len(self.times) // 2]

    def __str__(self):
        how = "whole" if self.whole else f"as points, {100 * self.share:.0f}% of them"
        return f"{self.median:.0f} ms a frame (least {self.times[0]:.0f}), {self.cpu:.0f} ms of CPU, drawn {how}"


def turning(pages):
    """Turns until it is known how to draw, and measures then: the best of three."""
    for _ in range(6):
        pages.browser.evaluate("nanocarbonPage.turnFor(3)")
    best = None
    for _ in range(3):
        before = pages.browser.cpu_seconds()
        said = pages.browser.evaluate("nanocarbonPage.turnFor(10)")
        now = Turning(said["times"], 100 * (pages.browser.cpu_seconds() - before), said["whole"], said["share"])
        best = now if best is None or now.median < best.median else best
    return best


def dragging(pages):
    """Frames a second while the mouse turns the molecule."""
    middle = pages.browser.evaluate(MIDDLE)
    before = pages.browser.evaluate("nanocarbonPage.drawn()")
    took = pages.browser.drag_for(middle["x"], middle["y"], 5)
    return (pages.browser.evaluate("nanocarbonPage.drawn()") - before) / took


def main():
    program, mesh, folder = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    if not chromium.find():
        print("There is no Chromium: install chromium to have the pages tried")
        return 77
    folder.mkdir(parents=True, exist_ok=True)
    torn, ring = torn_c60(program, folder), benzene(folder)
    pages = Pages(program, folder)
    try:
        a_build(pages, mesh, folder)
        open_surfaces(pages, mesh.with_name("hemisphere.off"), folder)
        picking(pages)
        a_ring(pages, ring)
        a_cell(pages)
        a_broken_one(pages, torn)
        large_ones(pages)
    finally:
        pages.browser.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
