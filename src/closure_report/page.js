'use strict';
// Drives the page: one time for all panels and plots. Data: see page.cpp. Nothing is loaded from elsewhere.
(() => {
  const byId = (id) => document.getElementById(id);
  const data = JSON.parse(byId('data').textContent);
  const svgNamespace = 'http://www.w3.org/2000/svg';
  const svgElement = (name, attributes, parent) => {
    const made = document.createElementNS(svgNamespace, name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    parent.appendChild(made);
    return made;
  };
  const text = (x) => String(Number(x.toPrecision(5)));

  // The place k + s, 0 <= s <= 1, of a time among increasing times; clamped to them.
  const placeAmong = (times, t) => {
    if (times.length < 2 || t <= times[0]) return [0, 0];
    let low = 0;
    let high = times.length - 1;
    if (t >= times[high]) return [high - 1, 1];
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (times[middle] <= t) low = middle; else high = middle;
    }
    return [low, (t - times[low]) / (times[high] - times[low])];
  };
  const mix = (a, b, s) => (a === null || b === null ? null : a + (b - a) * s);
  const valueAt = (values, [k, s]) => (s === 0 || values.length === 1 ? values[k] : mix(values[k], values[k + 1], s));

  // Names: each keeps its side of its anchor, and changes it only where it would cover a name before it.
  const largeNames = 0.5;  // of an enlarged panel, as in the style sheet
  const covered = (p, q) => Math.max(0, Math.min(p.x + p.w, q.x + q.w) - Math.max(p.x, q.x)) *
    Math.max(0, Math.min(p.y + p.h, q.y + q.h) - Math.max(p.y, q.y));
  const sides = [1, 7, 3, 5, 0, 4, 2, 6].map((k) => [Math.cos(k * Math.PI / 4), Math.sin(k * Math.PI / 4)]);
  // A name's room reaches as far from its middle as its ink: slanted letters, of a font that has none of its own above all,
  // stand out beyond where the next letter would begin.
  const sizeOf = (label) => {
    const box = label.getBBox();
    const middle = Number(label.getAttribute('x'));
    return [2 * Math.max(middle - box.x, box.x + box.width - middle), parseFloat(getComputedStyle(label).fontSize)];
  };
  // The middle of a name of this width and height beside the anchor (x, y), own = the side that it was drawn on.
  const placeName = (taken, [x, y], own, [w, h]) => {
    const room = 0.6 * h;
    const offsets = [own, ...sides.map(([c, s]) => [c * (w / 2 + room), s * (h / 2 + room)])];
    const boxes = offsets.map(([dx, dy]) => ({x: x + dx - w / 2, y: y + dy - h / 2, w, h}));
    const costs = boxes.map((box) => taken.reduce((sum, other) => sum + covered(box, other), 0));
    const best = costs.indexOf(Math.min(...costs));
    taken.push(boxes[best]);
    return [x + offsets[best][0], y + offsets[best][1]];
  };

  // A panel: groups [data-frame] get their frame's similarity, labels follow their anchors.
  const panels = data.branches.map((branch, index) => {
    const figure = byId('panel-' + index);
    const groups = [...figure.querySelectorAll('[data-frame]')].map((g) => [g, Number(g.dataset.frame)]);
    const labels = [...figure.querySelectorAll('text[data-label]')].map((t) => [t, JSON.parse(t.dataset.label), sizeOf(t)]);
    const note = figure.querySelector('figcaption span');
    return (t) => {
      const place = placeAmong(branch.t, t);
      const [k, s] = place;
      const from = branch.frames[k];
      const to = branch.frames[Math.min(k + 1, branch.frames.length - 1)];
      const at = (j) => from[j] + (to[j] - from[j]) * s;
      for (const [g, frame] of groups) {
        const [a, b, e, f] = [0, 1, 2, 3].map((j) => at(4 * frame + j));
        g.setAttribute('transform', `matrix(${a} ${b} ${-b} ${a} ${e} ${f})`);
      }
      const scale = figure.classList.contains('large') ? largeNames : 1;
      const taken = [];
      for (const [label, {frame, x, y, dx, dy, base, turns, series}, size] of labels) {
        const [a, b, e, f] = [0, 1, 2, 3].map((j) => at(4 * frame + j));
        const [u, v] = turns ? [a / Math.hypot(a, b), b / Math.hypot(a, b)] : [1, 0];
        const anchor = [a * x - b * y + e, b * x + a * y + f];
        const own = [scale * (u * dx - v * dy), scale * (v * dx + u * dy)];
        const middle = placeName(taken, anchor, own, size.map((length) => scale * length));
        label.setAttribute('x', middle[0]);
        label.setAttribute('y', middle[1] + scale * base);
        if (series === undefined) continue;
        const value = valueAt(branch.series[series][0], place);
        const {name, units} = data.quantities[series];
        label.textContent = `${name} = ${value === null ? '?' : text(value)} ${units[0]}`;
      }
      const slack = 1e-9 * Math.max(1, Math.abs(data.to - data.from));
      const early = t < branch.t[0] - slack;
      const late = t > branch.t[branch.t.length - 1] + slack;
      figure.classList.toggle('gone', early || late);
      note.textContent = early ? branch.begins : late ? branch.ends : '';
    };
  });

  // Round steps: 1, 2 or 5 times a power of ten, about `wanted` of them; three at least.
  const ticksOf = (low, high, wanted) => {
    const rough = (high - low) / wanted;
    const power = 10 ** Math.floor(Math.log10(rough));
    const steps = [0.5, 1, 2, 5, 10].map((m) => m * power);
    const multiples = (step) => {
      const ticks = [];
      for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) ticks.push(k * step);
      return ticks;
    };
    const first = steps.findIndex((step) => step >= rough);
    const ticks = multiples(steps[first]);
    return ticks.length >= 3 ? ticks : multiples(steps[first - 1]);
  };
  // What does not vary by more than `noise` is drawn as constant. Where a value runs away (velocities do near a dead point),
  // the scale is that of the bulk.
  const largest = (values) => values.reduce((most, v) => (v === null ? most : Math.max(most, Math.abs(v))), 0);
  const rangeOf = (values, noise) => {
    const sorted = values.filter((v) => v !== null).sort((a, b) => a - b);
    if (sorted.length === 0) return [-1, 1];
    const at = (share) => sorted[Math.round(share * (sorted.length - 1))];
    let [low, high] = [sorted[0], sorted[sorted.length - 1]];
    if (high - low <= noise) {
      const room = Math.max(0.1 * largest(sorted), 1e3 * noise) || 1;
      return [(low + high) / 2 - room, (low + high) / 2 + room];
    }
    const bulk = at(0.95) - at(0.05);
    if (bulk > 0 && high - low > 6 * bulk) [low, high] = [Math.max(low, at(0.05) - bulk), Math.min(high, at(0.95) + bulk)];
    const room = 0.06 * (high - low);
    return [low - room, high + room];
  };

  const kinds = ['position', 'velocity', 'acceleration'];
  const hidden = new Set();
  const cursors = [];
  const drawPlot = (parent, quantity, kind, setTime) => {
    const [width, height, left, right, top, bottom] = [420, 240, 64, 10, 24, 36];
    const unit = data.quantities[quantity].units[kind];
    const svg = svgElement('svg', {viewBox: `0 0 ${width} ${height}`, role: 'img'}, parent);
    const shown = data.branches.filter((b) => !hidden.has(b));
    const lines = shown.map((b) => ({t: b.t, values: b.series[quantity][kind]}));
    const valuesOf = (k) => shown.flatMap((b) => b.series[quantity][k]);
    const before = kind === 0 ? 0 : largest(valuesOf(kind - 1)) / (data.to - data.from);
    const [low, high] = rangeOf(valuesOf(kind), 1e-7 * Math.max(largest(valuesOf(kind)), before));
    const x = (t) => left + (t - data.from) / (data.to - data.from) * (width - left - right);
    const y = (v) => height - bottom - (v - low) / (high - low) * (height - top - bottom);
    const label = (attributes, content) => {
      svgElement('text', {class: 'tick', ...attributes}, svg).textContent = content;
    };
    for (const v of ticksOf(low, high, 4)) {
      svgElement('path', {class: 'grid', d: `M${left} ${y(v)}H${width - right}`}, svg);
      label({x: left - 6, y: y(v) + 4, 'text-anchor': 'end'}, text(v));
    }
    for (const t of ticksOf(data.from, data.to, 5)) {
      svgElement('path', {class: 'grid', d: `M${x(t)} ${top}V${height - bottom}`}, svg);
      label({x: x(t), y: height - bottom + 15, 'text-anchor': 'middle'}, text(t));
    }
    const what = data.quantities[quantity].units.length > 1 ? `${kinds[kind]} of ` : '';
    label({x: left, y: 14}, `${what}${data.quantities[quantity].name}${unit ? ` [${unit}]` : ''}`);
    label({x: width - right, y: height - 4, 'text-anchor': 'end'}, 'time t [s]');
    const clip = svgElement('clipPath', {id: `clip-${kind}`}, svg);
    svgElement('rect', {x: left, y: top, width: width - left - right, height: height - top - bottom}, clip);
    const curves = svgElement('g', {'clip-path': `url(#clip-${kind})`}, svg);
    lines.forEach((line, k) => {
      let path = '';
      let isDown = false;
      line.t.forEach((t, j) => {
        const v = line.values[j];
        if (v !== null) path += `${isDown ? 'L' : 'M'}${x(t).toFixed(2)} ${y(v).toFixed(2)}`;
        isDown = v !== null;
      });
      const {colour, dashes} = shown[k];
      svgElement('path', {class: `curve ${colour}`, d: path, 'stroke-dasharray': dashes || 'none'}, curves);
    });
    const cursor = svgElement('path', {class: 'cursor'}, svg);
    cursors.push((t) => cursor.setAttribute('d', `M${x(t)} ${top}V${height - bottom}`));
    const follow = (event) => {
      if (event.buttons === 0) return;
      const box = svg.getBoundingClientRect();
      const px = (event.clientX - box.left) / box.width * width;
      setTime(data.from + (px - left) / (width - left - right) * (data.to - data.from));
    };
    svg.addEventListener('pointerdown', follow);
    svg.addEventListener('pointermove', follow);
  };

  const slider = byId('time');
  const readout = byId('readout');
  const setTime = (wanted) => {
    const t = Math.min(Math.max(wanted, data.from), data.to);
    for (const show of panels) show(t);
    if (!slider) return;
    slider.value = String((t - data.from) / (data.to - data.from));
    const place = placeAmong(data.times, t);
    const drivers = data.drivers.map((d) => `${d.name} = ${text(valueAt(d.values, place))} ${d.unit}`);
    readout.textContent = [`t = ${text(t)} s`, ...drivers].join(', ');
    for (const show of cursors) show(t);
    now = t;
  };
  let now = data.from;

  const chooser = byId('quantity');
  const showPlots = () => {
    cursors.length = 0;
    kinds.forEach((kind, k) => {
      const parent = byId('plot-' + kind);
      parent.replaceChildren();
      const quantity = Number(chooser.value);
      parent.hidden = k >= data.quantities[quantity].units.length;
      if (!parent.hidden) drawPlot(parent, quantity, k, setTime);
    });
    setTime(now);
  };

  const toggleBranch = (button) => {
    const index = Number(button.dataset.branch);
    const branch = data.branches[index];
    if (!hidden.delete(branch)) hidden.add(branch);
    button.classList.toggle('off', hidden.has(branch));
    button.setAttribute('aria-pressed', String(!hidden.has(branch)));
    byId('panel-' + index).hidden = hidden.has(branch);
    showPlots();
  };
  for (const figure of document.querySelectorAll('#panels figure')) {
    const name = figure.querySelector('figcaption');
    name.title = 'enlarge';
    name.addEventListener('click', () => {
      figure.classList.toggle('large');
      setTime(now);
    });
  }

  // Every quantity that can be plotted, a sample a line, as many digits as the plots have.
  const csvOf = () => {
    const suffixes = ['', '.velocity', '.acceleration'];
    const cell = (x) => (x === null ? '' : String(x));
    const quoted = (name) => (/[",\n]/.test(name) ? `"${name.replaceAll('"', '""')}"` : name);
    const unitOf = (unit) => (unit ? ` [${unit}]` : '');
    const names = ['branch', 't', ...data.drivers.map((d) => `driver ${d.name}${unitOf(d.unit)}`)];
    for (const {name, units} of data.quantities) {
      units.forEach((unit, k) => names.push(`${name}${suffixes[k]}${unitOf(unit)}`));
    }
    const rows = data.branches.filter((b) => !hidden.has(b)).flatMap((b) => b.t.map((t, j) => {
      const place = placeAmong(data.times, t);
      const drivers = data.drivers.map((d) => cell(valueAt(d.values, place)));
      return [b.id, cell(t), ...drivers, ...b.series.flatMap((kindsOf) => kindsOf.map((values) => cell(values[j])))];
    }));
    return [names.map(quoted), ...rows].map((row) => row.join(',')).join('\n') + '\n';
  };
  const save = (ending, type, content) => {
    const link = document.createElement('a');
    link.download = `${document.title}.${ending}`;
    link.href = URL.createObjectURL(new Blob([content], {type}));
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  };

  // Once through all the motion in so many seconds.
  const seconds = 8;

  // The panels that are shown as one animated SVG, without a script: each frame's similarity as a shift, a turn and a stretch
  // at a hundred samples or so (SMIL). Before a branch begins and behind its end it stands still, pale.
  const mostSamples = 120;
  const svgOf = () => {
    const shown = data.branches.map((_, k) => k).filter((k) => !hidden.has(data.branches[k]));
    const columns = Math.ceil(Math.sqrt(shown.length));
    const [, , width, height] = byId('panel-0').querySelector('svg').getAttribute('viewBox').split(' ').map(Number);
    const [top, caption] = [34, 24];
    const size = [columns * width, top + Math.ceil(shown.length / columns) * (height + caption)];
    const root = document.createElementNS(svgNamespace, 'svg');
    root.setAttribute('viewBox', `0 0 ${size[0]} ${size[1]}`);
    svgElement('title', {}, root).textContent = document.title;
    const style = document.querySelector('style').textContent;
    svgElement('style', {}, root).textContent = `${style}path,circle{vector-effect:non-scaling-stroke}`;
    svgElement('rect', {width: size[0], height: size[1], fill: '#fff'}, root);
    svgElement('text', {class: 'title', x: 12, y: 24}, root).textContent = document.title;
    shown.forEach((index, place) => {
      const branch = data.branches[index];
      const figure = byId('panel-' + index);
      const at = [place % columns * width, top + Math.floor(place / columns) * (height + caption)];
      const name = svgElement('text', {class: 'caption', x: at[0] + 12, y: at[1] + 16}, root);
      name.style.fill = figure.querySelector('b').style.color;
      name.textContent = [...figure.querySelectorAll('b, small')].map((part) => part.textContent).join(', ');
      const panel = svgElement('svg', {x: at[0], y: at[1] + caption, width, height}, root);
      panel.append(...figure.querySelector('svg').cloneNode(true).childNodes);
      const share = (t) => (t - data.from) / (data.to - data.from);
      const late = share(branch.t[0]) > 1e-9;
      const early = share(branch.t[branch.t.length - 1]) < 1 - 1e-9;
      const stride = Math.ceil(branch.t.length / mostSamples);
      const taken = branch.t.map((_, k) => k).filter((k) => k % stride === 0 || k === branch.t.length - 1);
      const frames = taken.map((k) => branch.frames[k]);
      const rows = [...(late ? frames.slice(0, 1) : []), ...frames, ...(early ? frames.slice(-1) : [])];
      const inner = taken.map((k) => Math.min(Math.max(share(branch.t[k]), 0), 1).toFixed(5));
      const keyTimes = [...(late ? ['0'] : []), ...inner, ...(early ? ['1'] : [])];
      keyTimes[0] = '0';
      keyTimes[keyTimes.length - 1] = '1';
      const timing = {dur: `${seconds}s`, repeatCount: 'indefinite'};
      const animate = (parent, type, values, additive) => svgElement('animateTransform', {
        attributeName: 'transform', type, additive, values: values.join(';'), keyTimes: keyTimes.join(';'), ...timing}, parent);
      const round = (x, digits) => Number(x.toFixed(digits));
      const similarity = (frame) => rows.map((row) => row.slice(4 * frame, 4 * frame + 4));
      // An angle goes on beyond half a turn.
      const turnsOf = (matrices) => matrices.reduce((turns, [a, b]) => {
        const turn = Math.atan2(b, a) * 180 / Math.PI;
        const last = turns.length ? turns[turns.length - 1] : turn;
        return [...turns, turn + 360 * Math.round((last - turn) / 360)];
      }, []);
      for (const group of panel.querySelectorAll('g[data-frame]')) {
        const matrices = similarity(Number(group.dataset.frame));
        group.removeAttribute('transform');
        group.removeAttribute('data-frame');
        animate(group, 'translate', matrices.map(([, , e, f]) => `${round(e, 2)} ${round(f, 2)}`), 'replace');
        animate(group, 'rotate', turnsOf(matrices).map((turn) => round(turn, 2)), 'sum');
        const stretches = matrices.map(([a, b]) => round(Math.hypot(a, b), 4));
        if (stretches.some((stretch) => stretch !== 1)) animate(group, 'scale', stretches, 'sum');
      }
      for (const label of panel.querySelectorAll('text[data-label]')) {
        const {frame, x, y, dx, dy, base, turns, series} = JSON.parse(label.dataset.label);
        label.removeAttribute('data-label');
        label.setAttribute('x', 0);
        label.setAttribute('y', 0);
        if (series !== undefined) label.textContent = data.quantities[series].name;
        animate(label, 'translate', similarity(frame).map(([a, b, e, f]) => {
          const [u, v] = turns ? [a / Math.hypot(a, b), b / Math.hypot(a, b)] : [1, 0];
          return `${round(a * x - b * y + e + u * dx - v * dy, 2)} ${round(b * x + a * y + f + v * dx + u * dy + base, 2)}`;
        }), 'replace');
      }
      if (!late && !early) return;
      const steps = [...(late ? [['0', 0.3]] : []), [late ? inner[0] : '0', 1], ...(early ? [[inner[inner.length - 1], 0.3]] : [])];
      svgElement('animate', {attributeName: 'opacity', calcMode: 'discrete', values: steps.map(([, v]) => v).join(';'),
        keyTimes: steps.map(([k]) => k).join(';'), ...timing}, panel);
    });
    return new XMLSerializer().serializeToString(root);
  };

  let playing = null;
  const play = byId('play');
  const step = (stamp) => {
    if (playing === null) return;
    const span = data.to - data.from;
    const t = now + span * Math.min(stamp - playing, 100) / (1000 * seconds);
    playing = stamp;
    setTime(t > data.to ? data.from : t);
    requestAnimationFrame(step);
  };
  const togglePlay = () => {
    playing = playing === null ? performance.now() : null;
    play.textContent = playing === null ? 'Play' : 'Stop';
    if (playing !== null) requestAnimationFrame(step);
  };

  const readAddress = () => {
    const wanted = new URLSearchParams(location.hash.slice(1));
    const quantity = Number(wanted.get('plot'));
    if (chooser && wanted.has('plot') && data.quantities[quantity]) {
      chooser.value = String(quantity);
      showPlots();
    }
    const t = Number(wanted.get('t'));
    if (wanted.has('t') && Number.isFinite(t)) setTime(t);
  };

  if (slider) {
    slider.addEventListener('input', () => setTime(data.from + Number(slider.value) * (data.to - data.from)));
    play.addEventListener('click', togglePlay);
    chooser.addEventListener('change', showPlots);
    byId('save').addEventListener('click', () => save('csv', 'text/csv', csvOf()));
    byId('animate').addEventListener('click', () => save('svg', 'image/svg+xml', svgOf()));
    for (const button of document.querySelectorAll('#legend button')) {
      button.addEventListener('click', () => toggleBranch(button));
    }
    showPlots();
  }
  setTime(data.from);
  readAddress();
  window.addEventListener('hashchange', readAddress);
  document.documentElement.dataset.state = 'ready';
})();
