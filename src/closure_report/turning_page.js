'use strict';
// Every panel shows its closure from one eye, which the mouse (or a finger, or the arrow keys) turns.
const data = JSON.parse(document.getElementById('data').textContent);
const canvases = [...document.querySelectorAll('canvas')];
const home = {
  azimuth: data.eye[0],
  elevation: data.eye[1],
  zoom: 1
};
const eye = {...home};
// What is shown is near the middle of the ball about it: seen from home it may be larger than the ball would be.
const closest = 1.7;
const margin = 26;  // pixels, for names

function seen(p) {
  const [x, y, z] = p.map((v, k) => v - data.centre[k]);
  const sa = Math.sin(eye.azimuth), ca = Math.cos(eye.azimuth);
  const se = Math.sin(eye.elevation), ce = Math.cos(eye.elevation);
  return {
    right: -sa * x + ca * y,
    up: -(ca * x + sa * y) * se + z * ce,
    near: (ca * x + sa * y) * ce + z * se
  };
}

function ballScale(canvas) {
  return 0.46 * Math.min(canvas.clientWidth, canvas.clientHeight) / data.radius;
}

// So near that every closure fits into its panel.
function homeZoom(canvas) {
  const reach = {right: 0, up: 0};
  for (const closure of data.closures) {
    for (const p of closure.strokes.flatMap(s => [s[0], s[1]])) {
      const s = seen(p);
      reach.right = Math.max(reach.right, Math.abs(s.right));
      reach.up = Math.max(reach.up, Math.abs(s.up));
    }
  }
  const room = (pixels, half) => (pixels / 2 - margin) / Math.max(half, 1e-12 * data.radius);
  const fits = Math.min(room(canvas.clientWidth, reach.right), room(canvas.clientHeight, reach.up));
  return Math.max(1, Math.min(closest, fits / ballScale(canvas)));
}

// Names stand beside their places, where they cover no spot and no other name.
function writeNames(pen, names, spots, place) {
  const taken = spots.map(p => {
    const [x, y] = place(p);
    return [x - 4, y - 4, x + 4, y + 4];
  });
  const isFree = box => taken.every(
    t => box[2] < t[0] || t[2] < box[0] || box[3] < t[1] || t[3] < box[1]);
  for (const [p, name] of names) {
    const [x, y] = place(p);
    const wide = pen.measureText(name).width;
    const boxes = [[5, -5], [-5 - wide, -5], [5, 14], [-5 - wide, 14], [-wide / 2, -9], [
                    -wide / 2, 19
                  ]].map(([right, down]) => [x + right, y + down - 10, x + right + wide, y + down]);
    const box = boxes.find(isFree) || boxes[0];
    taken.push(box);
    pen.strokeStyle = '#fff';
    pen.lineWidth = 3;
    pen.strokeText(name, box[0], box[3]);
    pen.fillText(name, box[0], box[3]);
  }
}

function draw(canvas, closure) {
  const ratio = devicePixelRatio || 1;
  const width = canvas.clientWidth, height = canvas.clientHeight;
  canvas.width = width * ratio;
  canvas.height = height * ratio;
  const pen = canvas.getContext('2d');
  const scale = ballScale(canvas) * eye.zoom;
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
  pen.lineCap = 'round';
  const place = p => {
    const s = seen(p);
    return [width / 2 + scale * s.right, height / 2 - scale * s.up, s.near];
  };
  const strokes = closure.strokes.map(([from, to, colour, thick]) => {
    const a = place(from), b = place(to);
    return {a, b, colour, thick, near: (a[2] + b[2]) / 2};
  });
  strokes.sort((s, t) => s.near - t.near);
  for (const s of strokes) {
    for (const [colour, thick] of s.thick > 2 ? [['#fff', s.thick + 3], [s.colour, s.thick]] :
                                                [[s.colour, s.thick]]) {
      pen.strokeStyle = colour;
      pen.lineWidth = thick;
      pen.beginPath();
      pen.moveTo(s.a[0], s.a[1]);
      pen.lineTo(s.b[0], s.b[1]);
      pen.stroke();
    }
  }
  pen.fillStyle = '#1c2733';
  for (const p of closure.spots) {
    const [x, y] = place(p);
    pen.beginPath();
    pen.arc(x, y, 3, 0, 2 * Math.PI);
    pen.fill();
  }
  pen.font = '12px sans-serif';
  writeNames(pen, closure.names, closure.spots, place);
}

function drawAll() {
  canvases.forEach((canvas, k) => draw(canvas, data.closures[k]));
}

function turn(right, down) {
  eye.azimuth -= 0.01 * right;
  eye.elevation = Math.max(-1.57, Math.min(1.57, eye.elevation + 0.01 * down));
  drawAll();
}

for (const canvas of canvases) {
  canvas.addEventListener('pointerdown', e => canvas.setPointerCapture(e.pointerId));
  canvas.addEventListener('pointermove', e => {
    if (e.buttons) turn(e.movementX, e.movementY);
  });
  canvas.addEventListener('wheel', e => {
    e.preventDefault();
    eye.zoom *= Math.exp(-0.001 * e.deltaY);
    drawAll();
  }, {passive: false});
  canvas.addEventListener('dblclick', () => {
    Object.assign(eye, home);
    drawAll();
  });
}
addEventListener('keydown', e => {
  const step = {ArrowLeft: [-10, 0], ArrowRight: [10, 0], ArrowUp: [0, -10], ArrowDown: [
                  0, 10
                ]}[e.key];
  if (step) turn(...step);
});
if (canvases.length > 0) home.zoom = eye.zoom = homeZoom(canvases[0]);
const wanted = /eye=(-?[\d.]+),(-?[\d.]+)/.exec(location.hash);
if (wanted) Object.assign(eye, {azimuth: +wanted[1], elevation: +wanted[2]});
addEventListener('resize', drawAll);
drawAll();
document.documentElement.dataset.state = 'ready';
