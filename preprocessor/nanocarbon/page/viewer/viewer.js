// SPDX-License-Identifier: GPL-2.0-or-later
// Shows a molecule in a page by itself: needs THREE, the JSON element #contents and the data elements that it names.
(function () {
  'use strict';
  const $ = (id) => document.getElementById(id);
  const contents = JSON.parse($('contents').textContent);

  // ---- data -----------------------------------------------------------------------------------------------------
  const decoded = new Map();
  function bytes(name) {
    if (!decoded.has(name)) {
      const text = atob($('data-' + name).textContent);
      const result = new Uint8Array(text.length);
      for (let i = 0; i < text.length; ++i) result[i] = text.charCodeAt(i);
      decoded.set(name, result);
    }
    return decoded.get(name);
  }
  // Little-endian, as every machine that runs a browser is.
  const as = (Type, name) => new Type(bytes(name).buffer);

  function positions(frame) {
    if (frame.positions.format === 'float32') return as(Float32Array, frame.positions.data);
    const packed = as(Uint16Array, frame.positions.data), { from, step } = frame.positions;
    const result = new Float32Array(packed.length);
    for (let i = 0; i < packed.length; ++i) result[i] = from[i % 3] + packed[i] * step[i % 3];
    return result;
  }
  const atomsOf = (frame) => bytes(frame.positions.data).length / (frame.positions.format === 'float32' ? 12 : 6);
  function column(description) {
    if (description.format === 'uint8') return as(Uint8Array, description.data);
    const packed = as(Uint16Array, description.data), { from, step } = description;
    const result = new Float32Array(packed.length);
    for (let i = 0; i < packed.length; ++i) result[i] = packed[i] === 65535 ? NaN : from + packed[i] * step;
    return result;
  }
  function ringRows(frame) {
    return { offsets: as(Uint32Array, frame.rings.offsets), atoms: as(Uint32Array, frame.rings.atoms) };
  }

  // ---- colours --------------------------------------------------------------------------------------------------
  const rgb = (hex) => [(hex >> 16) / 255, ((hex >> 8) & 255) / 255, (hex & 255) / 255];
  const css = (c) => `rgb(${c.map((v) => Math.round(255 * v)).join(',')})`;
  const unknown = rgb(0xb8bec6);
  const ringColours = { 3: 0x5e2a84, 4: 0x7a3fb0, 5: 0x2f6fd6, 6: 0x8d98a5, 7: 0xd9503f, 8: 0xe8a13a };
  const ringColour = (size) => rgb(size === 0 ? 0xc9ced6 : ringColours[size] || 0x8a5a20);
  const categories = {
    ring: { colour: ringColour, text: (v) => (v === 0 ? 'no ring' : `ring of ${v}`) },
    state: { colour: (v) => rgb([0x8d98a5, 0xe8a13a, 0xd9503f][v] || 0), text: (v) => ['as at the start', 'rebonded', 'repelled'][v] },
    bonds: { colour: (v) => rgb([0x1c2430, 0x7a3fb0, 0x2f6fd6, 0x8d98a5, 0xd9503f][v] || 0xe8a13a), text: (v) => `${v} bonds` },
    defect: { colour: (v) => rgb(v ? 0xd9503f : 0xa9b2bd), text: (v) => (v ? 'in a defect' : 'in none') },
    element: { colour: (v) => rgb(v ? 0xdfe6ee : 0x4a5563), text: (v) => (v ? 'hydrogen' : 'carbon') },
  };
  // Few stops of a ramp from dark blue over green to yellow, and of one with grey in its middle.
  const ramp = [0x433e85, 0x33638d, 0x23888e, 0x3dbc74, 0xb8de29].map(rgb);
  const twoSided = [0x2f5fd0, 0x9db7ea, 0xe4e6ea, 0xeea893, 0xc8412f].map(rgb);
  function along(stops, t) {
    const x = Math.min(Math.max(t, 0), 1) * (stops.length - 1), k = Math.min(Math.floor(x), stops.length - 2);
    return [0, 1, 2].map((c) => stops[k][c] + (x - k) * (stops[k + 1][c] - stops[k][c]));
  }
  // What most values lie between, so that a few do not wash out the others.
  function range(values) {
    const finite = Array.from(values).filter(Number.isFinite).sort((a, b) => a - b);
    if (finite.length === 0) return [0, 1];
    const at = (q) => finite[Math.min(finite.length - 1, Math.floor(q * finite.length))];
    let [low, high] = [at(0.01), at(0.99)];
    if (low < 0 && high > 0) [low, high] = [-Math.max(-low, high), Math.max(-low, high)];
    return high > low ? [low, high] : [low - 0.5, high + 0.5];
  }

  // ---- text -----------------------------------------------------------------------------------------------------
  $('title').textContent = contents.title;
  document.title = contents.title;
  $('command').textContent = contents.command;
  $('verdict').textContent = contents.verdict.text;
  $('verdict').className = 'verdict ' + contents.verdict.kind;
  $('verdict').hidden = !contents.verdict.text;
  function row(table, name, value) {
    const line = table.insertRow();
    line.insertCell().textContent = name;
    line.insertCell().textContent = value;
  }
  for (const [name, value] of contents.facts) row($('facts'), name, value);

  const short = (v) => (v === 0 ? '0' : Math.abs(v) >= 1e5 || Math.abs(v) < 1e-3 ? v.toExponential(1) : String(+v.toPrecision(4)));
  contents.plots.forEach((p) => nanocarbonPlot(p, $('plots'), short, (size) => css(ringColour(size))));

  // ---- the scene ------------------------------------------------------------------------------------------------
  const frames = contents.frames, stage = $('stage');
  let renderer;
  try {
    // Smooth edges take most of the time where there are many.
    renderer = new THREE.WebGLRenderer({ antialias: atomsOf(contents.frames[0]) < 30000, preserveDrawingBuffer: true });
  } catch (error) {
    $('message').textContent = 'This browser has no WebGL, so the molecule is not shown; the facts and plots are.';
    $('tools').hidden = true;
    return;
  }
  renderer.setClearColor(0xffffff);
  stage.insertBefore(renderer.domElement, stage.firstChild);
  const scene = new THREE.Scene(), camera = new THREE.PerspectiveCamera(28, 1, 0.1, 1e5);
  const world = new THREE.Group();
  scene.add(world);

  renderer.localClippingEnabled = true;
  const impostors = nanocarbonImpostors(THREE), uniforms = impostors.uniforms, coarse = nanocarbonCoarse(THREE);
  const spheres = new THREE.Mesh(new THREE.BufferGeometry(), impostors.sphereMaterial);
  const sticks = new THREE.Mesh(new THREE.BufferGeometry(), impostors.stickMaterial);
  const points = new THREE.Points(new THREE.BufferGeometry(), impostors.pointMaterial);
  // Half and half: the mesh to the left of the middle, the molecule to the right.
  const leftOnly = new THREE.Plane(new THREE.Vector3(-1, 0, 0), 0), rightOnly = new THREE.Plane(new THREE.Vector3(1, 0, 0), 0);
  const halves = () => !!surface && $('mesh').value === 'half';
  const molecule = new THREE.Group();
  for (const part of [sticks, spheres, points]) {
    part.frustumCulled = false;
    molecule.add(part);
  }
  world.add(molecule);

  // ---- the current frame ------------------------------------------------------------------------------------------
  const now = { index: -1, frame: null, positions: null, bonds: null, images: null, rings: null, colours: null, picked: null };
  const cellOf = (frame) => frame.cell && frame.cell.vectors;
  function imageVector(cell, i, j, k) {
    return [0, 1, 2].map((d) => i * cell[0][d] + j * cell[1][d] + k * cell[2][d]);
  }
  function inverse(cell) {  // rows: fractional coordinates from Cartesian ones
    const m = new THREE.Matrix3().set(cell[0][0], cell[1][0], cell[2][0], cell[0][1], cell[1][1], cell[2][1], cell[0][2], cell[1][2], cell[2][2]);
    return new THREE.Matrix3().getInverse(m);
  }
  // The vector to the nearest image, for small cells that are not too skewed; only pictures of rings use it.
  function nearest(frame, back, d) {
    const cell = cellOf(frame);
    if (!cell) return d;
    const f = d.clone().applyMatrix3(back);
    const image = [f.x, f.y, f.z].map((v, k) => (frame.cell.periodic[k] ? Math.round(v) : 0));
    const [x, y, z] = imageVector(cell, ...image);
    return d.sub(new THREE.Vector3(x, y, z));
  }

  let bondEnds = new Float32Array(0), bondAtoms = new Uint32Array(0);
  function layOutBonds() {
    const { positions: p, bonds, images } = now, cell = cellOf(now.frame);
    let crossing = 0;
    for (let b = 0; images && b < images.length; b += 3) if (images[b] || images[b + 1] || images[b + 2]) ++crossing;
    const count = bonds.length / 2 + crossing;
    bondEnds = new Float32Array(6 * count);
    bondAtoms = new Uint32Array(2 * count);
    let n = 0;
    const add = (i, j, start, end) => {
      bondEnds.set(start, 6 * n);
      bondEnds.set(end, 6 * n + 3);
      bondAtoms[2 * n] = i;
      bondAtoms[2 * n++ + 1] = j;
    };
    for (let b = 0; b < bonds.length / 2; ++b) {
      const i = bonds[2 * b], j = bonds[2 * b + 1];
      const a = p.subarray(3 * i, 3 * i + 3), c = p.subarray(3 * j, 3 * j + 3);
      if (!images || !(images[3 * b] || images[3 * b + 1] || images[3 * b + 2])) {
        add(i, j, a, c);
        continue;
      }
      const shift = imageVector(cell, images[3 * b], images[3 * b + 1], images[3 * b + 2]);  // two stubs
      add(i, i, a, [0, 1, 2].map((d) => (a[d] + c[d] + shift[d]) / 2));
      add(j, j, c, [0, 1, 2].map((d) => (a[d] + c[d] - shift[d]) / 2));
    }
  }

  function paint() {
    const choice = $('colour').value, description = now.frame.columns[choice], values = column(description);
    const count = now.positions.length / 3, colours = new Float32Array(3 * count), legend = $('legend');
    legend.textContent = '';
    const category = categories[description.category];
    if (category) {
      const present = new Map();
      legend.appendChild(document.createElement('span')).textContent = 'atoms:';
      for (let a = 0; a < count; ++a) {
        colours.set(category.colour(values[a]), 3 * a);
        present.set(values[a], (present.get(values[a]) || 0) + 1);
      }
      for (const value of [...present.keys()].sort((a, b) => a - b)) {
        const entry = legend.appendChild(document.createElement('span'));
        entry.appendChild(document.createElement('i')).style.background = css(category.colour(value));
        entry.appendChild(document.createTextNode(`${category.text(value)} (${present.get(value)})`));
      }
    } else {
      const [low, high] = range(values), stops = low < 0 && high > 0 ? twoSided : ramp;
      for (let a = 0; a < count; ++a)
        colours.set(Number.isFinite(values[a]) ? along(stops, (values[a] - low) / (high - low)) : unknown, 3 * a);
      const bar = legend.appendChild(document.createElement('span'));
      bar.className = 'bar';
      bar.style.background = `linear-gradient(to right, ${stops.map(css).join(',')})`;
      legend.appendChild(document.createTextNode(`${short(low)} to ${short(high)} ${description.unit}`));
    }
    now.colours = colours;
    upload();
  }

  let order = new Uint32Array(0);
  function upload() {
    const elements = column(now.frame.columns[contents.elementColumn]), picked = new Set(now.picked ? now.picked.atoms : []);
    const kind = (a) => (elements[a] ? 1 : 0) + (picked.has(a) ? 2 : 0);
    const replace = (part, geometry) => {
      part.geometry.dispose();
      part.geometry = geometry;
    };
    replace(spheres, impostors.sphereGeometry(now.positions, now.colours, kind));
    replace(sticks, impostors.stickGeometry(bondEnds, bondAtoms, now.colours));
    const count = now.positions.length / 3;
    if (order.length !== count) order = coarse.spread(count);
    replace(points, impostors.pointGeometry(now.positions, now.colours, kind, order));
    draw();
  }

  // ---- rings, the mesh and the cell -------------------------------------------------------------------------------
  let ringFaces = null, ringOfTriangle = [];
  function ringCorners(r) {
    const { offsets, atoms } = now.rings, back = cellOf(now.frame) && inverse(cellOf(now.frame));
    const at = (a) => new THREE.Vector3(now.positions[3 * a], now.positions[3 * a + 1], now.positions[3 * a + 2]);
    const corners = [at(atoms[offsets[r]])];
    for (let k = offsets[r] + 1; k < offsets[r + 1]; ++k) {
      const last = corners[corners.length - 1];
      corners.push(last.clone().add(nearest(now.frame, back, at(atoms[k]).sub(last))));
    }
    return corners;
  }
  function ringTriangles() {  // of all rings: places and which ring each triangle is of
    const triangles = [], of = [];
    for (let r = 0; r + 1 < now.rings.offsets.length; ++r) {
      const corners = ringCorners(r);
      const middle = corners.reduce((s, c) => s.add(c), new THREE.Vector3()).divideScalar(corners.length);
      for (let k = 0; k < corners.length; ++k) {
        triangles.push(middle, corners[k], corners[(k + 1) % corners.length]);
        of.push(r);
      }
    }
    return { triangles, of };
  }
  function showRings() {
    if (ringFaces) {
      molecule.remove(ringFaces);
      ringFaces.geometry.dispose();
      ringFaces = null;
    }
    if (!$('show-rings').checked || !now.rings) return draw();
    const { triangles, of } = ringTriangles();
    ringOfTriangle = of;
    const places = new Float32Array(3 * triangles.length), colours = new Float32Array(3 * triangles.length);
    triangles.forEach((v, i) => places.set([v.x, v.y, v.z], 3 * i));
    of.forEach((r, t) => {
      const c = ringColour(now.rings.offsets[r + 1] - now.rings.offsets[r]);
      for (let k = 0; k < 3; ++k) colours.set(c, 9 * t + 3 * k);
    });
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(places, 3));
    geometry.setAttribute('color', new THREE.BufferAttribute(colours, 3));
    ringFaces = new THREE.Mesh(geometry, new THREE.MeshPhongMaterial({ vertexColors: THREE.VertexColors, side: THREE.DoubleSide,
      clippingPlanes: halves() ? [rightOnly] : [], flatShading: true, shininess: 8, polygonOffset: true, polygonOffsetFactor: 1,
      polygonOffsetUnits: 1 }));
    molecule.add(ringFaces);
    draw();
  }

  scene.add(new THREE.HemisphereLight(0xffffff, 0x8890a0, 0.75));
  const light = new THREE.DirectionalLight(0xffffff, 0.5);
  light.position.set(0.35, 0.5, 0.8);
  scene.add(light);
  let surface = null, fineSurface = null, coarseSurface = null;
  if (contents.mesh) {
    const { from, step } = contents.mesh, packed = as(Uint16Array, contents.mesh.points), index = as(Uint32Array, contents.mesh.triangles);
    const points = new Float32Array(packed.length);
    for (let i = 0; i < packed.length; ++i) points[i] = from[i % 3] + packed[i] * step[i % 3];
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(points, 3));
    geometry.setIndex(new THREE.BufferAttribute(index, 1));
    geometry.computeVertexNormals();
    surface = new THREE.Mesh(geometry, new THREE.MeshPhongMaterial({ color: 0xc9b27c, side: THREE.DoubleSide, shininess: 12,
      flatShading: index.length < 60000 }));
    world.add(surface);
    fineSurface = geometry;
  } else {
    $('mesh-choice').hidden = true;
  }
  if (surface) $('mesh').value = 'beside';
  function placeMesh() {
    if (!surface) return;
    const choice = $('mesh').value, material = surface.material;
    surface.visible = choice !== 'none';
    material.transparent = choice === 'over';
    material.opacity = choice === 'over' ? 0.45 : 1;
    material.depthWrite = choice !== 'over';
    material.clippingPlanes = halves() ? [leftOnly] : [];
    if (ringFaces) ringFaces.material.clippingPlanes = halves() ? [rightOnly] : [];
    material.needsUpdate = true;
    frameView();
  }

  let cellLines = null;
  function showCell() {
    if (cellLines) molecule.remove(cellLines);
    cellLines = null;
    const cell = cellOf(now.frame);
    $('show-cell').parentElement.hidden = !cell;
    if (!cell || !$('show-cell').checked) return draw();
    const o = now.frame.cell.origin, corner = (i, j, k) => {
      const v = imageVector(cell, i, j, k);
      return new THREE.Vector3(o[0] + v[0], o[1] + v[1], o[2] + v[2]);
    };
    const geometry = new THREE.BufferGeometry(), ends = [];
    for (const [a, b] of [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7]])
      for (const c of [a, b]) ends.push(corner(c & 1, (c >> 1) & 1, c >> 2));
    geometry.setFromPoints(ends);
    cellLines = new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ color: 0x1f6feb }));
    molecule.add(cellLines);
    draw();
  }

  // ---- the view -----------------------------------------------------------------------------------------------------
  const view = { middle: new THREE.Vector3(), size: 1, distance: 10, turn: new THREE.Quaternion(), shift: new THREE.Vector2() };
  function bounds(values) {
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < values.length; ++i) {
      low[i % 3] = Math.min(low[i % 3], values[i]);
      high[i % 3] = Math.max(high[i % 3], values[i]);
    }
    return { low, high };
  }
  function frameView() {
    const { low, high } = bounds(now.positions), p = now.positions;
    view.middle.set((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2);
    let farthest = 0;
    for (let i = 0; i < p.length; i += 3)
      farthest = Math.max(farthest, Math.hypot(p[i] - view.middle.x, p[i + 1] - view.middle.y, p[i + 2] - view.middle.z));
    if (cellLines) {  // a cell that is not much larger is shown whole
      const ends = cellLines.geometry.getAttribute('position').array;
      let corner = 0;
      for (let i = 0; i < ends.length; i += 3)
        corner = Math.max(corner, Math.hypot(ends[i] - view.middle.x, ends[i + 1] - view.middle.y, ends[i + 2] - view.middle.z));
      if (corner < 1.5 * farthest) farthest = Math.max(farthest, corner);
    }
    view.size = 2 * Math.max(1.5, farthest);
    let wide = 1;
    molecule.position.copy(view.middle).negate();
    if (surface) {
      surface.position.copy(molecule.position);
      if ($('mesh').value === 'beside') wide = 2;
    }
    const need = Math.max(view.size, (wide * view.size * stage.clientHeight) / Math.max(1, stage.clientWidth));
    view.distance = (1.1 * need) / 2 / Math.tan((camera.fov * Math.PI) / 360);
    draw();
  }
  function resetView() {
    const { low, high } = bounds(now.positions), edges = [0, 1, 2].map((d) => high[d] - low[d]);
    // Looked at across the thinnest direction, a little from above.
    const thin = edges.indexOf(Math.min(...edges)), forward = [new THREE.Vector3(1, 0, 0), new THREE.Vector3(0, 1, 0), new THREE.Vector3(0, 0, 1)][thin];
    view.turn.setFromUnitVectors(forward, new THREE.Vector3(0, 0, 1));
    view.turn.premultiply(new THREE.Quaternion().setFromEuler(new THREE.Euler(0.35, -0.5, 0)));
    view.shift.set(0, 0);
    frameView();
  }

  // How turning is drawn: whole, or, where that is slow, as points for a share of the atoms and a coarse mesh, at one pixel
  // each; sticks and rings wait until it stops.
  let queued = false, moving = false, whole = true, share = 1, probes = [];
  const budget = () => (whole ? 80 : 45), leastShare = 0.2;  // ms a frame; the browser needs some more to show it
  const finePixels = Math.min(window.devicePixelRatio || 1, 2);
  function finished() {  // waits until the frame is there; finish() alone does not
    renderer.getContext().readPixels(0, 0, 1, 1, renderer.getContext().RGBA, renderer.getContext().UNSIGNED_BYTE, new Uint8Array(4));
  }
  function draw() {
    if (queued) return;
    queued = true;
    requestAnimationFrame(render);
  }
  function render() {
    queued = false;
    const begin = performance.now();
    const width = stage.clientWidth, height = stage.clientHeight, canvas = renderer.domElement;
    const pixels = moving && !whole ? Math.min(1, finePixels) : finePixels;
    if (renderer.getPixelRatio() !== pixels) renderer.setPixelRatio(pixels);
    if (canvas.clientWidth !== width || canvas.clientHeight !== height) renderer.setSize(width, height);
    uniforms.pixel.value = (2 * Math.tan((camera.fov * Math.PI) / 360)) / (height * pixels);
    uniforms.cut.value = halves() ? view.shift.x : -1e9;
    camera.aspect = width / height;
    camera.position.set(-view.shift.x, -view.shift.y, view.distance);
    camera.near = Math.max(0.2, view.distance - 2 * view.size);
    camera.far = view.distance + 3 * view.size;
    camera.updateProjectionMatrix();
    uniforms.fogNear.value = view.distance - 0.1 * view.size;
    uniforms.fogFar.value = view.distance + 0.75 * view.size;
    world.quaternion.copy(view.turn);
    const beside = surface && $('mesh').value === 'beside';
    world.children.forEach((child) => child.position.copy(view.middle).negate());
    if (beside) {
      const side = new THREE.Vector3(view.size * 0.5, 0, 0).applyQuaternion(view.turn.clone().conjugate());
      surface.position.sub(side);
      molecule.position.add(side);
    }
    const quickly = moving && !whole;
    points.visible = quickly;
    points.geometry.setDrawRange(0, Math.ceil(share * now.positions.length / 3));
    uniforms.grow.value = 1.4 / Math.sqrt(share);  // in the sticks' place, too
    sticks.visible = !quickly && $('style').value !== 'spheres';
    spheres.visible = !quickly && ($('style').value !== 'sticks' || !!now.picked);
    if (ringFaces) ringFaces.visible = !quickly;
    if (surface) {
      if (quickly && !coarseSurface) coarseSurface = fineSurface.getIndex().count < 30000 ? fineSurface : coarse.clustered(fineSurface, 60);
      surface.geometry = quickly ? coarseSurface : fineSurface;
    }
    renderer.render(scene, camera);
    if (moving && probes.length < 3) probe(begin);
  }
  // The first frames of each turn, and of each way of drawing, say whether it is quick enough, or too coarse.
  function probe(begin) {
    finished();
    probes.push(performance.now() - begin);
    if (probes.length < 3) return;
    const quickest = Math.min(...probes);
    if (quickest > budget() && (whole || share > leastShare)) {
      if (!whole) share = Math.max(leastShare, share * Math.min(0.8, 0.8 * budget() / quickest));
      whole = false;
      probes = [];
    } else if (quickest < 0.4 * budget() && share < 1) {
      share = Math.min(1, 2 * share);
    }
  }

  const canvas = renderer.domElement;
  const pointers = new Map();
  let travelled = 0, settle = 0;
  function startMoving() {
    moving = true;
    clearTimeout(settle);
    settle = setTimeout(() => { moving = false; draw(); }, 250);
  }
  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    travelled = 0;
    probes = [];
  });
  canvas.addEventListener('pointermove', (event) => {
    const last = pointers.get(event.pointerId);
    if (!last) return;
    const dx = event.clientX - last.x, dy = event.clientY - last.y;
    travelled += Math.abs(dx) + Math.abs(dy);
    const perPixel = (2 * view.distance * Math.tan((camera.fov * Math.PI) / 360)) / stage.clientHeight;
    if (pointers.size === 2) {
      const [a, b] = [...pointers.values()], before = Math.hypot(a.x - b.x, a.y - b.y);
      last.x = event.clientX;
      last.y = event.clientY;
      const [c, d] = [...pointers.values()], after = Math.hypot(c.x - d.x, c.y - d.y);
      if (before > 0 && after > 0) view.distance *= before / after;
    } else if (event.shiftKey || event.buttons === 2 || event.buttons === 4) {
      view.shift.x += dx * perPixel;
      view.shift.y -= dy * perPixel;
    } else {
      const axis = new THREE.Vector3(dy, dx, 0), angle = axis.length() * 0.008;
      if (angle > 0) view.turn.premultiply(new THREE.Quaternion().setFromAxisAngle(axis.normalize(), angle));
    }
    last.x = event.clientX;
    last.y = event.clientY;
    startMoving();
    draw();
  });
  for (const type of ['pointerup', 'pointercancel'])
    canvas.addEventListener(type, (event) => {
      const single = pointers.size === 1;
      pointers.delete(event.pointerId);
      if (type === 'pointerup' && single && travelled < 5) pick(event);
    });
  canvas.addEventListener('contextmenu', (event) => event.preventDefault());
  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    view.distance = Math.min(Math.max(view.distance * Math.exp(event.deltaY * 0.001), 2), 40 * view.size);
    startMoving();
    draw();
  }, { passive: false });
  window.addEventListener('resize', draw);

  // ---- picking --------------------------------------------------------------------------------------------------------
  function pick(event) {
    const box = canvas.getBoundingClientRect();
    const mouse = new THREE.Vector2(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2);
    world.updateMatrixWorld(true);
    camera.updateMatrixWorld(true);
    const caster = new THREE.Raycaster();
    caster.setFromCamera(mouse, camera);
    const back = new THREE.Matrix4().getInverse(molecule.matrixWorld), ray = caster.ray.clone().applyMatrix4(back);
    const radius = $('style').value === 'spheres' ? uniforms.radius.value : Math.max(uniforms.radius.value, 0.3), p = now.positions;
    const e = molecule.matrixWorld.elements, toRight = (a) => e[0] * p[3 * a] + e[4] * p[3 * a + 1] + e[8] * p[3 * a + 2] + e[12];
    let best = Infinity, atom = -1;
    for (let a = 0; a < p.length / 3; ++a) {
      const x = p[3 * a] - ray.origin.x, y = p[3 * a + 1] - ray.origin.y, z = p[3 * a + 2] - ray.origin.z;
      if (halves() && toRight(a) < 0) continue;
      const t = x * ray.direction.x + y * ray.direction.y + z * ray.direction.z;
      if (t > 0 && t - radius < best && x * x + y * y + z * z - t * t < radius * radius) {
        best = t - radius;
        atom = a;
      }
    }
    let ring = -1;
    if (now.rings) {
      const { triangles, of } = ringTriangles(), hit = new THREE.Vector3();
      for (let t = 0; t < of.length; ++t)
        if (ray.intersectTriangle(triangles[3 * t], triangles[3 * t + 1], triangles[3 * t + 2], false, hit)) {
          const far = hit.distanceTo(ray.origin), shown = !halves() || hit.clone().applyMatrix4(molecule.matrixWorld).x >= 0;
          if (far < best && shown) {
            best = far;
            ring = of[t];
          }
        }
    }
    select(ring >= 0 ? { ring } : atom >= 0 ? { atom } : null);
  }
  const id = (a) => (contents.ids ? as(Int32Array, contents.ids)[a] : a + 1);
  function select(choice) {
    const box = $('picked-text');
    box.textContent = '';
    now.picked = null;
    if (!choice) {
      box.textContent = 'Click an atom, or the inside of a ring.';
    } else {
      const table = box.appendChild(document.createElement('table'));
      if (choice.atom !== undefined) {
        const a = choice.atom;
        now.picked = { atoms: [a] };
        row(table, 'atom ID', id(a));
        row(table, 'position', [0, 1, 2].map((d) => now.positions[3 * a + d].toFixed(3)).join(', ') + ' Å');
        for (const c of now.frame.columns) {
          const value = column(c)[a], category = categories[c.category];
          row(table, c.name, category ? category.text(value) : Number.isFinite(value) ? `${short(value)} ${c.unit}` : 'not defined');
        }
        const bonded = [];
        for (let b = 0; b < now.bonds.length; b += 2) {
          if (now.bonds[b] === a) bonded.push(id(now.bonds[b + 1]));
          if (now.bonds[b + 1] === a) bonded.push(id(now.bonds[b]));
        }
        row(table, 'bonded to', bonded.join(', ') || 'nothing');
      } else {
        const atoms = choice.atoms || Array.from(now.rings.atoms.slice(now.rings.offsets[choice.ring], now.rings.offsets[choice.ring + 1]));
        now.picked = { atoms };
        row(table, choice.name ? 'defect' : 'ring', choice.name || `of ${atoms.length} atoms`);
        row(table, 'atom IDs', atoms.map(id).join(', '));
      }
    }
    upload();
  }

  // ---- controls -------------------------------------------------------------------------------------------------------
  function showFrame(index) {
    const first = now.index < 0;
    now.index = index;
    now.frame = frames[index];
    now.positions = positions(now.frame);
    now.bonds = as(Uint32Array, now.frame.bonds);
    now.images = now.frame.images ? as(Int8Array, now.frame.images) : null;
    now.rings = now.frame.rings ? ringRows(now.frame) : null;
    now.picked = null;
    $('frame-text').textContent = now.frame.label;
    layOutBonds();
    paint();
    showRings();
    showCell();
    if (first) resetView();
  }
  frames[0].columns.forEach((c, i) => $('colour').add(new Option(c.name, i)));
  $('colour').value = contents.colourColumn;
  $('colour').addEventListener('change', paint);
  function restyle() {
    const style = $('style').value;
    uniforms.radius.value = style === 'spheres' ? 0.85 : style === 'sticks' ? 0.2 : 0.35;
    draw();
  }
  $('style').addEventListener('change', restyle);
  $('show-rings').addEventListener('change', showRings);
  $('show-cell').addEventListener('change', showCell);
  $('mesh').addEventListener('change', placeMesh);
  $('reset').addEventListener('click', resetView);
  if (frames.length > 1) {
    $('frames').hidden = false;
    document.querySelectorAll('.of-last').forEach((span) => { span.hidden = false; });
    $('frame').max = frames.length - 1;
    $('frame').value = frames.length - 1;
    $('frame').addEventListener('input', () => showFrame(Number($('frame').value)));
  }
  $('show-cell').checked = true;
  showFrame(frames.length - 1);
  placeMesh();
  restyle();
  if (contents.defects && contents.defects.length > 0) {
    $('defect-section').hidden = false;
    for (const defect of contents.defects) {
      const button = $('defects').appendChild(document.createElement('button'));
      button.className = 'defect';
      button.textContent = `${defect.kind}: atom IDs ${defect.atoms.slice(0, 6).map(id).join(', ')}${defect.atoms.length > 6 ? ', …' : ''}`;
      button.addEventListener('click', () => {
        if (now.index !== frames.length - 1) showFrame(frames.length - 1);
        select({ atoms: defect.atoms, name: defect.kind });
      });
      $('defects').appendChild(document.createElement('br'));
    }
  }

  // For tests and for scripts that take pictures.
  window.nanocarbonPage = {
    atomOnScreen(a) {
      render();
      world.updateMatrixWorld(true);
      const p = new THREE.Vector3(now.positions[3 * a], now.positions[3 * a + 1], now.positions[3 * a + 2]);
      p.applyMatrix4(molecule.matrixWorld).project(camera);
      const box = canvas.getBoundingClientRect();
      return { x: box.left + ((p.x + 1) / 2) * box.width, y: box.top + ((1 - p.y) / 2) * box.height, depth: p.z };
    },
    nearestAtom() {  // the one nearest to the eye
      let best = 0, least = Infinity;
      world.updateMatrixWorld(true);
      for (let a = 0; a < now.positions.length / 3; ++a) {
        const p = new THREE.Vector3(now.positions[3 * a], now.positions[3 * a + 1], now.positions[3 * a + 2]).applyMatrix4(molecule.matrixWorld);
        if (-p.z < least) [best, least] = [a, -p.z];
      }
      return best;
    },
    atoms: () => now.positions.length / 3,
    value: (a, name) => column(now.frame.columns.find((c) => c.name === name))[a],
    drawn: () => renderer.info.render.frame,  // frames so far
    turnFor(count) {  // milliseconds of each of some frames while turning, and how they were drawn
      const times = [];
      moving = true;
      for (let k = 0; k < count; ++k) {
        const begin = performance.now();
        view.turn.premultiply(new THREE.Quaternion().setFromAxisAngle(new THREE.Vector3(0, 1, 0), 0.05));
        render();
        finished();
        times.push(performance.now() - begin);
      }
      moving = false;
      draw();
      return { times, whole, share };
    },
    turnAndStay() {  // as it is drawn while turning, until the next frame
      moving = true;
      render();
      moving = false;
    },
    turn(x, y) {
      view.turn.premultiply(new THREE.Quaternion().setFromEuler(new THREE.Euler(x, y, 0)));
      draw();
    },
    ready: true,
  };
})();
