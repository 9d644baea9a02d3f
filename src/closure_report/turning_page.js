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

function draw(canvas, closure) {
  const ratio = devicePixelRatio || 1;
  const width = canvas.clientWidth, height = canvas.clientHeight;
  canvas.width = width * ratio;
  canvas.height = height * ratio;
  const pen = canvas.getContext('2d');
  const scale = 0.46 * Math.min(width, height) / data.radius * eye.zoom;
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
  for (const [p, name] of closure.names) {
    const [x, y] = place(p);
    pen.strokeStyle = '#fff';
    pen.lineWidth = 3;
    pen.strokeText(name, x + 5, y - 5);
    pen.fillText(name, x + 5, y - 5);
  }
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
const wanted = /eye=(-?[\d.]+),(-?[\d.]+)/.exec(location.hash);
if (wanted) Object.assign(eye, {azimuth: +wanted[1], elevation: +wanted[2]});
addEventListener('resize', drawAll);
drawAll();
document.documentElement.dataset.state = 'ready';
