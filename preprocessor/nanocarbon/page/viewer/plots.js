// SPDX-License-Identifier: GPL-2.0-or-later
// A plot of a page as SVG: bars or a line. short(v): a number as text; ringColour(size): as CSS.
function nanocarbonPlot(p, parent, short, ringColour) {
  'use strict';
  const SVG = 'http://www.w3.org/2000/svg';
  function svg(tag, attributes, parent, text) {
    const element = document.createElementNS(SVG, tag);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    if (text !== undefined) element.textContent = text;
    if (parent) parent.appendChild(element);
    return element;
  }
  const W = 300, H = 150, left = 46, right = 8, top = 8, bottom = 34;
  const figure = document.createElement('figure');
  figure.appendChild(document.createElement('figcaption')).textContent = p.title;
  const picture = svg('svg', { viewBox: `0 0 ${W} ${H}`, width: '100%', role: 'img' }, figure);
  svg('title', {}, picture, p.title);
  const bars = p.kind === 'bars', xs = p.x, ys = p.y.filter(Number.isFinite);
  if (ys.length === 0) return;
  const x0 = xs[0], x1 = bars ? xs[xs.length - 1] + p.width : xs[xs.length - 1];
  let y0 = bars ? 0 : Math.min(...ys), y1 = Math.max(...ys);
  if (y0 === y1) [y0, y1] = bars ? [0, y1 || 1] : [y0 - 0.5, y1 + 0.5];
  const X = (x) => left + ((x - x0) / (x1 - x0 || 1)) * (W - left - right);
  const Y = (y) => H - bottom - ((y - y0) / (y1 - y0)) * (H - top - bottom);
  if (bars) {
    xs.forEach((x, i) => {
      const colour = p.colours ? ringColour(x) : '#5c8fd6';
      const bar = svg('rect', { x: X(x) + 0.5, y: Y(p.y[i]), width: Math.max(0.8, X(x + p.width) - X(x) - 1),
        height: Math.max(0, Y(0) - Y(p.y[i])), fill: colour }, picture);
      svg('title', {}, bar, `${short(x)}: ${p.y[i]}`);
    });
  } else {
    const points = xs.map((x, i) => [x, p.y[i]]).filter((q) => Number.isFinite(q[1]));
    svg('polyline', { points: points.map(([x, y]) => `${X(x)},${Y(y)}`).join(' '), fill: 'none', stroke: '#1f6feb',
      'stroke-width': 1.5 }, picture);
  }
  svg('line', { x1: left, y1: H - bottom, x2: W - right, y2: H - bottom, stroke: '#9aa5b1' }, picture);
  const halfway = Math.abs(x0 + x1) < 1e-9 * (x1 - x0) ? 0 : (x0 + x1) / 2;
  const middle = bars && p.colours ? xs.map((x) => [x + p.width / 2, x]) : [[x0, x0], [halfway, halfway], [x1, x1]];
  middle.forEach(([x, name], i) => svg('text', { x: X(x), y: H - bottom + 13,
    'text-anchor': bars && p.colours ? 'middle' : ['start', 'middle', 'end'][i] }, picture, short(name)));
  svg('text', { x: (left + W) / 2, y: H - 5, 'text-anchor': 'middle' }, picture, p.label);
  for (const y of [y0, y1]) svg('text', { x: left - 4, y: Y(y) + 4, 'text-anchor': 'end' }, picture, short(y));
  parent.appendChild(figure);
}
