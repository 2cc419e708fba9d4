'use strict';
const $ = (id) => document.getElementById(id);
const client = Array.from(crypto.getRandomValues(new Uint8Array(12)), (b) => b.toString(16).padStart(2, '0')).join('');
// Distinct for the colour-blind too (Okabe and Ito), mid tones for light and dark ground.
const kColours = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#b58900', '#56b4e9'];
const state = { id: null, run: 0, snapshot: null, images: new Map(), pan: [0, 0], drag: null };

async function ask(path, options) {
  const response = await fetch(path, options);
  const body = await response.json();
  if (!response.ok) throw new Error(body.error || 'the server does not answer');
  return body;
}
const chosen = () => [...document.querySelectorAll('#samplers input:checked')].map((box) => box.value);

function settings() {
  const s = { client, scene: $('scene').value, integrator: $('integrator').value, device: $('device').value, samplers: chosen(),
    mode: $('mode').value, width: +$('width').value, frame_seconds: +$('frame').value };
  if (s.integrator === 'ao' && +$('radius').value > 0) s.radius = +$('radius').value;
  if (s.integrator === 'direct') s.split = +$('split').value;
  return s;
}

function say(headline, text, bad) { $('headline').textContent = headline; $('text').textContent = text; $('answer').classList.toggle('bad', !!bad); }

async function start(event) {
  if (event) event.preventDefault();
  const run = ++state.run;
  state.id = null; state.snapshot = null; state.images.clear();
  say('Starting …', '');
  try {
    const answer = await ask('api/start', { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify(settings()) });
    if (run !== state.run) return;
    state.id = answer.id;
    fillSides();
    poll(run);
  } catch (error) { if (run === state.run) say('Not started', error.message + '.', true); }
}
function leave() { return fetch('api/leave?client=' + client, { method: 'POST', keepalive: true }); }
async function stop() {
  ++state.run; state.id = null;
  await leave();
  $('status').textContent = 'Stopped.';
}

async function poll(run) {
  while (run === state.run) {
    try {
      state.snapshot = await ask(`api/comparison?id=${state.id}&client=${client}`);
      if (run !== state.run) return;
      show();
      await fetchImages();
      if (state.snapshot.state === 'failed') return;
    } catch (error) { if (run === state.run) $('status').textContent = error.message; return; }
    await new Promise((resolve) => setTimeout(resolve, state.snapshot.state === 'done' ? 5000 : 500));
  }
}

function fillSides() {
  const names = [...chosen(), 'reference'];
  for (const [id, index] of [['left', 0], ['right', names.length - 2]]) {
    const before = $(id).value;
    $(id).replaceChildren(...names.map((name) => new Option(name, name)));
    $(id).value = names.includes(before) ? before : names[index];
  }
  if ($('left').value === $('right').value) $('right').value = names[names.indexOf($('left').value) ? 0 : 1];
}

function show() {
  const s = state.snapshot;
  if (s.state === 'failed') return say('It cannot be done', s.message, true);
  const of = s.reference, first = of.groups < of.least, sets = $('integrator').value === 'igi' ? 'sets' : 'samples';
  const words = { waiting: 'Waiting for the device', opening: 'Reading the scene', done: 'All is measured', cancelled: 'Stopped' }[s.state] || 'Measuring';
  const facts = [words];
  if (s.width) facts.push(`${s.scene}, ${s.width} × ${s.height}` + ($('integrator').value === 'ao' ? `, radius ${+s.radius.toPrecision(4)}` : ''), s.device);
  if (of.groups > 1) facts.push(`reference of ${of.groups * of.count} ${sets}, its own MSE ${of.mse.toExponential(1)} is taken off`);
  $('status').textContent = facts.join(' · ');
  if (s.state === 'running' && first) {
    const part = of.count ? Math.min(.99, (of.groups + Math.min(1, s.part)) / of.least) : 0;
    say('Not known yet.', `First a reference is rendered, which errors are told from: ${Math.round(100 * part)} %.`);
  } else if (!s.width) say(words + ' …', '');
  else {
    const least = s.answer.seconds < s.frame_seconds ? `The most samples take no ${s.frame_seconds} s here, but ${s.answer.seconds.toPrecision(2)} s. ` : '';
    say(s.answer.headline, least + s.answer.text);
  }
  chart();
  table();
}

function table() {
  const what = $('integrator').value === 'igi' ? 'set' : 'sample';
  const rows = state.snapshot.series.map((one) => {
    const row = document.createElement('tr');
    const command = one.shown ? one.shown.command : '';
    for (const text of [one.sampler, one.frames, one.device_seconds.toFixed(1) + ' s', (one.rays_per_second / 1e6).toFixed(2), one.shown ? `${one.shown.count} ${what}${one.shown.count > 1 ? 's' : ''}` : '…']) {
      const cell = document.createElement('td'); cell.textContent = text; row.append(cell);
    }
    const cell = document.createElement('td'), code = document.createElement('code'); for (const word of command.split(' ')) { const e = document.createElement('span'); e.textContent = word; code.append(code.firstChild ? ' ' : '', e); } cell.append(code); row.append(cell);
    const last = document.createElement('td'), copy = document.createElement('button');
    copy.textContent = 'Copy'; copy.title = 'Copy the command line';
    copy.onclick = async () => { try { await navigator.clipboard.writeText(command); copy.textContent = 'Copied'; } catch { getSelection().selectAllChildren(code); } };
    last.append(copy); row.append(last);
    return row;
  });
  const body = document.querySelector('#table tbody');
  // A button with the focus stays where nothing changed.
  const before = [...body.querySelectorAll('tr')].map((r) => [...r.cells].slice(0, 6).map((c) => c.textContent).join()).join('|');
  if (before !== rows.map((r) => [...r.cells].slice(0, 6).map((c) => c.textContent).join()).join('|')) body.replaceChildren(...rows);
}

function svg(name, attributes, text) {
  const e = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) e.setAttribute(key, value);
  if (text !== undefined) e.textContent = text;
  return e;
}
function chart() {
  const measure = $('measure').value, series = state.snapshot.series, box = { l: 62, r: 548, t: 12, b: 318 };
  const points = series.flatMap((s) => (s.cells || []).filter((c) => c[measure].value > 0));
  const frame = +state.snapshot.answer.seconds, parts = [];
  $('legend').replaceChildren(...series.map((s, i) => { const e = document.createElement('span'), dot = document.createElement('i'); dot.style.background = kColours[i]; e.append(dot, s.sampler); return e; }));
  if (points.length) {
    const range = (v) => [Math.floor(Math.log10(Math.min(...v)) * 2 - .1) / 2, Math.ceil(Math.log10(Math.max(...v)) * 2 + .1) / 2];
    const [x0, x1] = range([...points.map((c) => c.seconds), frame]), [y0, y1] = range(points.map((c) => c[measure].value));
    const x = (v) => box.l + (Math.log10(v) - x0) / (x1 - x0) * (box.r - box.l), y = (v) => box.b - (Math.log10(v) - y0) / (y1 - y0) * (box.b - box.t);
    for (let d = Math.ceil(x0); d <= x1; ++d) parts.push(svg('line', { class: 'grid', x1: x(10 ** d), x2: x(10 ** d), y1: box.t, y2: box.b }), svg('text', { x: x(10 ** d), y: box.b + 17, 'text-anchor': 'middle' }, d >= -3 ? String(+(10 ** d).toPrecision(1)) : '1e' + d));
    for (let d = Math.ceil(y0); d <= y1; ++d) parts.push(svg('line', { class: 'grid', y1: y(10 ** d), y2: y(10 ** d), x1: box.l, x2: box.r }), svg('text', { x: box.l - 6, y: y(10 ** d) + 4, 'text-anchor': 'end' }, '1e' + d));
    parts.push(svg('line', { class: 'frame', x1: x(frame), x2: x(frame), y1: box.t, y2: box.b }), svg('text', { x: x(frame) - 4, y: box.t + 11, 'text-anchor': 'end' }, +frame.toPrecision(2) + ' s a frame'));
    parts.push(svg('text', { x: (box.l + box.r) / 2, y: 350, 'text-anchor': 'middle' }, 'device seconds a frame'));
    series.forEach((s, i) => {
      const cells = (s.cells || []).filter((c) => c[measure].value > 0);
      parts.push(svg('polyline', { points: cells.map((c) => x(c.seconds) + ',' + y(c[measure].value)).join(' '), fill: 'none', stroke: kColours[i], 'stroke-width': 1.5 }));
      for (const c of cells) {
        const e = c[measure];
        if (e.low > 0 && e.high) parts.push(svg('line', { x1: x(c.seconds), x2: x(c.seconds), y1: Math.min(box.b, y(e.low)), y2: Math.max(box.t, y(e.high)), stroke: kColours[i], 'stroke-width': 2 }));
        if (c.time.low > 0) parts.push(svg('line', { x1: Math.max(box.l, x(c.time.low)), x2: Math.min(box.r, x(c.time.high)), y1: y(e.value), y2: y(e.value), stroke: kColours[i], 'stroke-width': 2 }));
        const dot = svg('circle', { cx: x(c.seconds), cy: y(e.value), r: 4, fill: kColours[i] });
        dot.append(svg('title', {}, s.sampler + ', ' + c.count));
        dot.onpointerenter = () => { $('hover').textContent = `${s.sampler}, ${c.count} a pixel: ${measure === 'mse' ? 'MSE' : 'relMSE'} ${e.value.toExponential(2)}` + (e.low !== null ? ` (95 %: ${e.low.toExponential(2)} to ${e.high.toExponential(2)})` : ' (no interval yet)') + `, ${c.seconds.toPrecision(3)} s a frame, ${(c.rays_per_second / 1e6).toFixed(2)} million rays/s, ${c.seeds} seeds`; };
        parts.push(dot);
      }
    });
  }
  $('chart').replaceChildren(...parts);
}

async function fetchImages() {
  for (const name of new Set([$('left').value, $('right').value, 'reference'])) {
    const one = state.snapshot.series.find((s) => s.sampler === name);
    const version = name === 'reference' ? state.snapshot.reference.groups : one && one.shown ? one.shown.count : 0;
    const known = state.images.get(name);
    if (!version || (known && known.version === version)) continue;
    const response = await fetch(`api/image?id=${state.id}&client=${client}&sampler=${encodeURIComponent(name)}&count=${version}`);
    if (!response.ok) continue;
    const bytes = await response.arrayBuffer(), [width, height, channels] = new Uint32Array(bytes, 0, 3);
    state.images.set(name, { version, width, height, channels, data: new Float32Array(bytes, 12) });
  }
  draw();
}

const srgb = (v) => 255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * Math.min(1, v) ** (1 / 2.4) - 0.055);
const kHeat = [[0, 0, 4], [87, 16, 110], [188, 55, 84], [249, 142, 9], [252, 255, 164]];  // black to yellow, lightness rises evenly
function heat(t) {
  const at = Math.min(.9999, Math.max(0, t)) * 4, i = Math.floor(at), f = at - i;
  return kHeat[i].map((v, c) => v + f * (kHeat[i + 1][c] - v));
}
function bitmap(image) {
  const out = new ImageData(image.width, image.height), gain = 2 ** +$('exposure').value, reference = state.images.get('reference');
  const error = $('error').checked && reference, n = image.channels;
  for (let p = 0; p < image.width * image.height; ++p) {
    let colour;
    if (error) {
      let sum = 0;
      for (let c = 0; c < n; ++c) sum += Math.abs(image.data[p * n + c] - reference.data[p * n + c]) / n;
      colour = heat(4 * gain * sum);
    } else colour = [0, 1, 2].map((c) => srgb(gain * image.data[p * n + (n === 1 ? 0 : c)]));
    out.data.set([...colour, 255], p * 4);
  }
  const canvas = new OffscreenCanvas(image.width, image.height);
  canvas.getContext('2d').putImageData(out, 0, 0);
  return canvas;
}
function draw() {
  const left = state.images.get($('left').value), right = state.images.get($('right').value), view = $('view'), any = left || right;
  if (!any) return;
  const scale = Math.max(1, Math.round(960 / any.width)), zoom = +$('zoom').value;
  view.width = any.width * scale; view.height = any.height * scale;
  state.pan = state.pan.map((v, i) => Math.min(1 - 1 / zoom, Math.max(0, v)));
  const g = view.getContext('2d'), split = view.width * $('wipe').value / 100;
  g.imageSmoothingEnabled = false;
  const paint = (image, x0, x1) => {
    if (!image || x1 <= x0) return;
    g.save(); g.beginPath(); g.rect(x0, 0, x1 - x0, view.height); g.clip();
    g.drawImage(bitmap(image), state.pan[0] * image.width, state.pan[1] * image.height, image.width / zoom, image.height / zoom, 0, 0, view.width, view.height);
    g.restore();
  };
  paint(left, 0, split); paint(right, split, view.width);
  g.fillStyle = '#fff'; g.fillRect(split - 1, 0, 3, view.height);
  g.font = `${Math.round(view.width / 40)}px sans-serif`;
  for (const [id, right] of [['left', false], ['right', true]]) {  // on a ground of their own: images are white in places
    const text = $(id).value, wide = g.measureText(text).width + 16, high = view.width / 26, x = right ? view.width - wide - 6 : 6, y = view.height - high - 6;
    g.fillStyle = '#000a'; g.fillRect(x, y, wide, high);
    g.fillStyle = '#fff'; g.textBaseline = 'middle'; g.fillText(text, x + 8, y + high / 2);
  }
  view.dataset.drawn = [$('left').value, $('right').value, $('wipe').value].join();
}
function place(event) {
  const r = $('view').getBoundingClientRect(), zoom = +$('zoom').value;
  return [state.pan[0] + (event.clientX - r.left) / r.width / zoom, state.pan[1] + (event.clientY - r.top) / r.height / zoom];
}
function under(event) {
  const [u, v] = place(event), any = state.images.get('reference');
  if (!any) return;
  const x = Math.floor(u * any.width), y = Math.floor(v * any.height), line = (name) => {
    const i = state.images.get(name);
    return i && x >= 0 && y >= 0 && x < i.width && y < i.height ? `${name} ` + Array.from(i.data.slice((y * i.width + x) * i.channels, (y * i.width + x + 1) * i.channels), (f) => f.toPrecision(4)).join(' ') : '';
  };
  $('value').textContent = `(${x}, ${y}): ` + [...new Set([$('left').value, $('right').value, 'reference'])].map(line).filter(Boolean).join(' · ');
}

$('view').onpointerdown = (e) => { state.drag = { from: place(e), zoomed: +$('zoom').value > 1 && !e.shiftKey }; $('view').setPointerCapture(e.pointerId); if (!state.drag.zoomed) move(e); };
function move(e) {
  under(e);
  if (!state.drag) return;
  if (state.drag.zoomed) { const [u, v] = place(e); state.pan[0] += state.drag.from[0] - u; state.pan[1] += state.drag.from[1] - v; }
  else { const r = $('view').getBoundingClientRect(); $('wipe').value = 100 * (e.clientX - r.left) / r.width; }
  draw();
}
$('view').onpointermove = move;
$('view').onpointerup = $('view').onpointercancel = () => { state.drag = null; };
$('view').addEventListener('wheel', (e) => {
  e.preventDefault();
  const before = place(e), index = $('zoom').selectedIndex + (e.deltaY < 0 ? 1 : -1);
  $('zoom').selectedIndex = Math.max(0, Math.min(3, index));
  const after = place(e);
  state.pan[0] += before[0] - after[0]; state.pan[1] += before[1] - after[1];
  draw();
}, { passive: false });
$('view').onkeydown = (e) => {
  const step = { ArrowLeft: -2, ArrowRight: 2 }[e.key];
  if (!step) return;
  e.preventDefault(); $('wipe').value = +$('wipe').value + step; draw();
};
for (const id of ['wipe', 'exposure', 'error', 'zoom']) $(id).oninput = draw;
for (const id of ['left', 'right']) $(id).onchange = fetchImages;
$('measure').onchange = () => state.snapshot && chart();
$('settings').onsubmit = start;
$('cancel').onclick = stop;
$('integrator').onchange = () => { $('radius-label').hidden = $('integrator').value !== 'ao'; $('split-label').hidden = $('integrator').value !== 'direct'; };
addEventListener('pagehide', leave);

(async () => {
  const setup = await ask('api/setup');
  for (const name of ['scenes', 'devices']) $(name.slice(0, -1)).replaceChildren(...setup[name].map((v) => new Option(v, v)));
  $('samplers').replaceChildren(...setup.samplers.map((name) => {
    const label = document.createElement('label'), box = document.createElement('input');
    box.type = 'checkbox'; box.value = name; box.checked = ['sobol-owen', 'capcon-domain', 'random'].includes(name);
    label.append(box, ' ' + name);
    return label;
  }));
  $('status').textContent = 'Ready.';
  start();
})().catch((error) => say('Not started', error.message, true));
