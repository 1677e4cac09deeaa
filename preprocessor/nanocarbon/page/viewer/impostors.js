// SPDX-License-Identifier: GPL-2.0-or-later
// Spheres as one triangle each and cylinders as one rectangle each, shaded as if they were round. Every corner is a vertex of
// its own: software renderers draw instances one by one, which is a hundred times slower.
function nanocarbonImpostors(THREE) {
  'use strict';
  const uniforms = {
    radius: { value: 0.35 }, stick: { value: 0.14 }, fogNear: { value: 1 }, fogFar: { value: 1e6 },
    pixel: { value: 0 },  // how wide a pixel is at unit distance: nothing is drawn narrower
    grow: { value: 1 },  // how much larger points are, where they stand for more atoms than one
    cut: { value: -1e9 },  // what lies to the left of this is not drawn
  };
  const common = 'uniform float fogNear; uniform float fogFar;' +
    'vec3 shade(vec3 colour, vec3 n, float depth) {' +
    '  float light = 0.42 + 0.58 * max(dot(n, normalize(vec3(0.35, 0.5, 0.8))), 0.0);' +
    '  vec3 h = normalize(vec3(0.35, 0.5, 1.8));' +
    '  vec3 c = colour * light + 0.18 * pow(max(dot(n, h), 0.0), 30.0);' +
    '  return mix(c, vec3(1.0), 0.62 * smoothstep(fogNear, fogFar, depth)); }';
  // The fourth component of a tint says which corner this is (0 to 2, or 3), and 4 times its kind: 1 small, 2 picked.
  const sphereMaterial = new THREE.ShaderMaterial({
    uniforms,
    vertexShader: 'attribute vec4 tint; uniform float radius; uniform float pixel; uniform float cut; varying vec2 at;' +
      'varying vec3 colour; varying float depth; varying float picked; void main() {' +
      'float code = floor(tint.w * 255.0 + 0.5); float corner = mod(code, 4.0); float kind = floor(code / 4.0);' +
      'at = corner < 0.5 ? vec2(0.0, 2.0) : vec2(corner < 1.5 ? -1.7320508 : 1.7320508, -1.0);' +
      'colour = tint.rgb; picked = step(1.5, kind); vec4 p = modelViewMatrix * vec4(position, 1.0); depth = -p.z;' +
      'float r = max(radius * (mod(kind, 2.0) > 0.5 ? 0.62 : 1.0), 0.7 * pixel * depth);' +
      'if (p.x < cut) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); return; }' +
      'p.xy += r * at; p.z += r; gl_Position = projectionMatrix * p; }',
    fragmentShader: common + 'varying vec2 at; varying vec3 colour; varying float depth; varying float picked; void main() {' +
      'float q = dot(at, at); if (q > 1.0) discard; vec3 n = vec3(at, sqrt(1.0 - q));' +
      'vec3 c = shade(colour, n, depth); if (picked > 0.5 && q > 0.55) c = vec3(1.0, 0.75, 0.0); gl_FragColor = vec4(c, 1.0); }',
  });
  const stickMaterial = new THREE.ShaderMaterial({
    uniforms, side: THREE.DoubleSide,
    vertexShader: 'attribute vec3 end; attribute vec4 tint; attribute vec4 tintEnd; uniform float stick; uniform float pixel;' +
      'uniform float cut; varying vec2 at; varying vec3 colour; varying vec3 colourEnd; varying vec3 side; varying vec3 facing;' +
      'varying float depth; void main() { float corner = floor(tint.w * 255.0 + 0.5);' +
      'at = vec2(mod(corner, 2.0) < 0.5 ? -1.0 : 1.0, corner < 1.5 ? -1.0 : 1.0); colour = tint.rgb; colourEnd = tintEnd.rgb;' +
      'vec4 a = modelViewMatrix * vec4(position, 1.0), b = modelViewMatrix * vec4(end, 1.0);' +
      'if (min(a.x, b.x) < cut) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); return; }' +
      'vec4 p = at.y < 0.0 ? a : b; vec3 axis = normalize(b.xyz - a.xyz + vec3(1e-6)); vec3 eye = normalize(-p.xyz);' +
      'side = normalize(cross(axis, eye)); facing = cross(side, axis); p.xyz += max(stick, 0.5 * pixel * -p.z) * at.x * side;' +
      'depth = -p.z; gl_Position = projectionMatrix * p; }',
    fragmentShader: common + 'varying vec2 at; varying vec3 colour; varying vec3 colourEnd; varying vec3 side; varying vec3 facing;' +
      'varying float depth; void main() { vec3 n = normalize(side * at.x + facing * sqrt(max(0.0, 1.0 - at.x * at.x)));' +
      'gl_FragColor = vec4(shade(at.y < 0.0 ? colour : colourEnd, n, depth), 1.0); }',
  });
  // The same spheres as points, for fast turning: at most as large as points may be, and gone where their middle is. Where not
  // all of them are drawn, the others grow.
  const pointMaterial = new THREE.ShaderMaterial({
    uniforms,
    vertexShader: 'attribute vec4 tint; uniform float radius; uniform float grow; uniform float pixel; uniform float cut; varying vec3 colour;' +
      'varying float depth; void main() { float kind = floor(tint.w * 255.0 + 0.5); colour = tint.rgb;' +
      'vec4 p = modelViewMatrix * vec4(position, 1.0); depth = -p.z; float r = grow * radius * (mod(kind, 2.0) > 0.5 ? 0.62 : 1.0);' +
      'if (p.x < cut) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); return; }' +
      'p.z += r; gl_Position = projectionMatrix * p; gl_PointSize = clamp(2.0 * r / (pixel * depth), 1.4, 60.0); }',
    fragmentShader: common + 'varying vec3 colour; varying float depth; void main() {' +
      'vec2 at = 2.0 * gl_PointCoord - 1.0; at.y = -at.y; float q = dot(at, at); if (q > 1.0) discard;' +
      'gl_FragColor = vec4(shade(colour, vec3(at, sqrt(1.0 - q)), depth), 1.0); }',
  });
  const byte = (v) => Math.min(255, Math.max(0, Math.round(255 * v)));

  // positions: three numbers a sphere; colours: the same, 0 to 1; kind(a): as above.
  function sphereGeometry(positions, colours, kind) {
    const count = positions.length / 3, centre = new Float32Array(9 * count), tint = new Uint8Array(12 * count);
    for (let a = 0, i = 0; a < count; ++a) {
      const code = 4 * kind(a), r = byte(colours[3 * a]), g = byte(colours[3 * a + 1]), b = byte(colours[3 * a + 2]);
      for (let k = 0; k < 3; ++k, ++i) {
        for (let d = 0; d < 3; ++d) centre[3 * i + d] = positions[3 * a + d];
        tint[4 * i] = r;
        tint[4 * i + 1] = g;
        tint[4 * i + 2] = b;
        tint[4 * i + 3] = code + k;
      }
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(centre, 3));
    geometry.setAttribute('tint', new THREE.BufferAttribute(tint, 4, true));
    return geometry;
  }

  // order: of the atoms, so that the first of them stand for all.
  function pointGeometry(positions, colours, kind, order) {
    const count = positions.length / 3, tint = new Uint8Array(4 * count), centre = new Float32Array(3 * count);
    order.forEach((a, k) => {
      for (let d = 0; d < 3; ++d) {
        centre[3 * k + d] = positions[3 * a + d];
        tint[4 * k + d] = byte(colours[3 * a + d]);
      }
      tint[4 * k + 3] = kind(a);
    });
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(centre, 3));
    geometry.setAttribute('tint', new THREE.BufferAttribute(tint, 4, true));
    return geometry;
  }

  // ends: six numbers a stick; atoms: the two whose colours it has.
  function stickGeometry(ends, atoms, colours) {
    const count = ends.length / 6, start = new Float32Array(12 * count), end = new Float32Array(12 * count);
    const tint = new Uint8Array(16 * count), tintEnd = new Uint8Array(16 * count), index = new Uint32Array(6 * count);
    for (let n = 0, i = 0; n < count; ++n) {
      index.set([i, i + 1, i + 2, i + 1, i + 3, i + 2], 6 * n);
      for (let k = 0; k < 4; ++k, ++i) {
        for (let d = 0; d < 3; ++d) {
          start[3 * i + d] = ends[6 * n + d];
          end[3 * i + d] = ends[6 * n + 3 + d];
          tint[4 * i + d] = byte(colours[3 * atoms[2 * n] + d]);
          tintEnd[4 * i + d] = byte(colours[3 * atoms[2 * n + 1] + d]);
        }
        tint[4 * i + 3] = k;
      }
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setIndex(new THREE.BufferAttribute(index, 1));
    geometry.setAttribute('position', new THREE.BufferAttribute(start, 3));
    geometry.setAttribute('end', new THREE.BufferAttribute(end, 3));
    geometry.setAttribute('tint', new THREE.BufferAttribute(tint, 4, true));
    geometry.setAttribute('tintEnd', new THREE.BufferAttribute(tintEnd, 4, true));
    return geometry;
  }
  return { uniforms, sphereMaterial, stickMaterial, pointMaterial, sphereGeometry, stickGeometry, pointGeometry };
}
