// SPDX-License-Identifier: GPL-2.0-or-later
// Coarser stand-ins for what is too large to be drawn whole while it turns.
function nanocarbonCoarse(THREE) {
  'use strict';
  // 0 to count - 1 in an order whose every beginning is spread over all of them: steps by the golden section.
  function spread(count) {
    const divisor = (a, b) => (b === 0 ? a : divisor(b, a % b));
    let step = Math.max(1, Math.round(0.618034 * count));
    while (divisor(step, count) > 1) ++step;
    const order = new Uint32Array(count);
    for (let k = 0, at = 0; k < count; ++k, at = (at + step) % count) order[k] = at;
    return order;
  }

  // A mesh whose vertices within each cell of a grid have become one, their mean; cells: along its longest side.
  function clustered(geometry, cells) {
    const points = geometry.getAttribute('position').array, index = geometry.getIndex().array;
    geometry.computeBoundingBox();
    const box = geometry.boundingBox, size = box.getSize(new THREE.Vector3());
    const edge = Math.max(size.x, size.y, size.z) / cells || 1, of = new Map(), sums = [];
    const cluster = new Uint32Array(points.length / 3);
    for (let v = 0; v < cluster.length; ++v) {
      const at = [0, 1, 2].map((d) => Math.floor((points[3 * v + d] - box.min.getComponent(d)) / edge));
      const key = at[0] + 4096 * (at[1] + 4096 * at[2]);
      if (!of.has(key)) {
        of.set(key, sums.length);
        sums.push([0, 0, 0, 0]);
      }
      cluster[v] = of.get(key);
      const sum = sums[cluster[v]];
      for (let d = 0; d < 3; ++d) sum[d] += points[3 * v + d];
      ++sum[3];
    }
    const places = new Float32Array(3 * sums.length), corners = [];
    sums.forEach((sum, i) => places.set([sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3]], 3 * i));
    for (let t = 0; t < index.length; t += 3) {
      const [a, b, c] = [cluster[index[t]], cluster[index[t + 1]], cluster[index[t + 2]]];
      if (a !== b && b !== c && c !== a) corners.push(a, b, c);
    }
    const result = new THREE.BufferGeometry();
    result.setAttribute('position', new THREE.BufferAttribute(places, 3));
    result.setIndex(new THREE.BufferAttribute(new Uint32Array(corners), 1));
    result.computeVertexNormals();
    return result;
  }
  return { spread, clustered };
}
