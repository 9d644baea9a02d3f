'use strict';
// Shows the closures of one sample: the nearest to where one points, or the one that the sliders choose. Data: see sweep_html.cpp.
(() => {
  const byId = (id) => document.getElementById(id);
  const data = JSON.parse(byId('data').textContent);
  const svg = document.querySelector('#picture svg');
  const svgNamespace = 'http://www.w3.org/2000/svg';
  const [left, top, right, bottom] = data.plot;
  const panelSize = 220;
  const sliders = data.axes.map((axis, k) => byId('axis-' + k));
  const readouts = data.axes.map((axis, k) => byId('value-' + k));

  const text = (x) => String(Number(x.toPrecision(6)));
  const clamp = (x, low, high) => Math.min(Math.max(x, low), high);
  const nearest = (values, x) => values.reduce(
    (best, value, k) => (Math.abs(value - x) < Math.abs(values[best] - x) ? k : best), 0);

  // The counter-clockwise convex hull of points [x, y], by Andrew's chains.
  const hull = (points) => {
    const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
    const turns = (o, a, b) => (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
    const chain = (along) => {
      const kept = [];
      for (const p of along) {
        while (kept.length > 1 && turns(kept[kept.length - 2], kept[kept.length - 1], p) <= 0) kept.pop();
        kept.push(p);
      }
      return kept.slice(0, -1);
    };
    return sorted.length < 3 ? sorted : [...chain(sorted), ...chain(sorted.reverse())];
  };

  const [lowX, lowY, highX, highY] = data.box;
  const margin = 16;
  const scale = (panelSize - 2 * margin) / Math.max(highX - lowX, highY - lowY, 1e-300);
  const width = (highX - lowX) * scale + 2 * margin;
  const height = (highY - lowY) * scale + 2 * margin;
  const pixel = ([x, y]) => [margin + (x - lowX) * scale, height - margin - (y - lowY) * scale];
  const path = (points, closes) => 'M' + points.map((p) => p.map((v) => v.toFixed(1)).join(' ')).join('L') + (closes ? 'Z' : '');

  const markup = (name, attributes, content = '') =>
    `<${name} ${Object.entries(attributes).map(([key, value]) => `${key}="${value}"`).join(' ')}>${content}</${name}>`;
  const escaped = (plain) => {
    const holder = document.createElement('span');
    holder.textContent = plain;
    return holder.innerHTML;
  };

  const drawing = (flat) => {
    const at = (k) => pixel([flat[2 * k], flat[2 * k + 1]]);
    let shapes = '';
    for (const body of data.bodies) {
      const outline = hull(body.points.map(at));
      if (outline.length > 1) {
        shapes += markup('g', {class: body.colour}, markup('path', {class: 'link', d: path(outline, true)}));
      }
    }
    for (const [kind, a, b] of data.lines) shapes += markup('path', {class: kind, d: path([at(a), at(b)], false)});
    for (const [kind, k] of data.spots) {
      const [x, y] = at(k);
      if (kind === 'ground') {
        shapes += markup('path', {class: 'ground', d: path([[x, y], [x - 7, y + 12], [x + 7, y + 12]], true)});
      }
      shapes += markup('circle', {class: kind === 'mark' ? 'mark' : 'pin', cx: x.toFixed(1), cy: y.toFixed(1), r: kind === 'mark' ? 2 : 3.5});
    }
    return markup('svg', {viewBox: `0 0 ${width.toFixed(1)} ${height.toFixed(1)}`, role: 'img'}, shapes);
  };
  const table = (values) => markup('table', {}, data.unknowns.map(
    (name, k) => markup('tr', {}, markup('td', {}, escaped(name)) + markup('td', {}, text(values[k])))).join(''));

  const horizontal = document.createElementNS(svgNamespace, 'path');
  const spot = document.createElementNS(svgNamespace, 'circle');
  horizontal.setAttribute('class', 'here');
  spot.setAttribute('class', 'spot');
  spot.setAttribute('r', 5);
  svg.append(horizontal, spot);

  // Where a value of an axis is in the picture; the first axis goes right, the second up.
  const shareOf = (axis, value) => {
    const first = axis.values[0];
    return (value - first) / (axis.values[axis.values.length - 1] - first);
  };
  const columns = data.axes.length > 1 ? data.axes[1].values.length : 1;

  const show = (chosen) => {
    const k = chosen[0] * columns + (chosen[1] || 0);
    chosen.forEach((place, j) => {
      sliders[j].value = place;
      readouts[j].textContent = `${text(data.axes[j].values[place])} ${data.axes[j].unit}`;
    });
    const x = left + (right - left) * shareOf(data.axes[0], data.axes[0].values[chosen[0]]);
    const isMap = data.axes.length > 1;
    const y = isMap ? bottom - (bottom - top) * shareOf(data.axes[1], data.axes[1].values[chosen[1]]) : top;
    horizontal.setAttribute('d', `M${x} ${top}V${bottom}` + (isMap ? `M${left} ${y}H${right}` : ''));
    spot.setAttribute('cx', x);
    spot.setAttribute('cy', y);
    spot.setAttribute('visibility', isMap ? 'visible' : 'hidden');
    const closures = data.closures[k];
    byId('told').textContent = data.told[k];
    byId('closures').innerHTML = closures.map((flat, c) => markup('figure', {}, markup(
      'figcaption', {}, markup('b', {}, data.ids[c])) + (data.unknowns.length > 0 ? table(flat) : drawing(flat)))).join('');
  };

  const pointed = (event) => {
    const box = svg.getBoundingClientRect();
    const view = svg.viewBox.baseVal;
    const px = (event.clientX - box.left) / box.width * view.width;
    const py = (event.clientY - box.top) / box.height * view.height;
    const shares = [clamp((px - left) / (right - left), 0, 1), clamp((bottom - py) / (bottom - top), 0, 1)];
    show(data.axes.map((axis, j) => {
      const last = axis.values[axis.values.length - 1];
      return nearest(axis.values, axis.values[0] + shares[j] * (last - axis.values[0]));
    }));
  };
  svg.addEventListener('pointermove', pointed);
  svg.addEventListener('pointerdown', pointed);
  for (const slider of sliders) slider.addEventListener('input', () => show(sliders.map((s) => Number(s.value))));

  const asked = /at=([^&]*)/.exec(location.hash);
  const wanted = asked ? decodeURIComponent(asked[1]).split(',').map(Number) : [];
  show(data.axes.map((axis, j) => (Number.isFinite(wanted[j]) ? nearest(axis.values, wanted[j]) : (axis.values.length - 1) >> 1)));
  document.documentElement.dataset.state = 'ready';
})();
