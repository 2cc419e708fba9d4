// Compares images: two side by side under a wipe, zoomed, exposed, as errors in false colour, with linear values under the
// cursor. Data: half floats of all images, high bytes before low bytes, deflated; see image/half_planes.h.
(() => {
  'use strict';
  const place = document.querySelector('.viewer');
  if (!place || typeof DecompressionStream === 'undefined') return;
  const facts = JSON.parse(document.getElementById('view-facts').textContent);
  const {width, height, channels, images} = facts;
  const size = width * height * channels;

  function half(bits) {
    const sign = bits & 0x8000 ? -1 : 1, exponent = bits >> 10 & 31, fraction = bits & 1023;
    if (exponent === 31) return fraction ? NaN : sign * Infinity;
    return sign * (exponent ? 2 ** (exponent - 15) * (1 + fraction / 1024) : 2 ** -14 * (fraction / 1024));
  }

  async function load() {
    const text = atob(document.getElementById('view-pixels').textContent.trim());
    const packed = Uint8Array.from(text, (c) => c.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
    const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
    const count = bytes.length / 2;
    if (count !== size * images.length) throw new Error('the images of this page are not whole');
    return images.map((_, i) => Float32Array.from({length: size}, (_, k) => half(bytes[i * size + k] << 8 | bytes[count + i * size + k])));
  }

  const toSrgb = (v) => 255 * (v <= 0.0031308 ? 12.92 * Math.max(0, v) : 1.055 * Math.min(1, v) ** (1 / 2.4) - 0.055);
  // Dark to bright, and even in lightness, so that it reads without colour too.
  const ramp = [[0, 0, 4], [66, 10, 104], [147, 38, 103], [221, 81, 58], [252, 165, 10], [252, 255, 164]];
  function falseColour(t) {
    const at = Math.min(1, Math.max(0, t)) * (ramp.length - 1), i = Math.min(ramp.length - 2, Math.floor(at));
    return [0, 1, 2].map((c) => ramp[i][c] + (at - i) * (ramp[i + 1][c] - ramp[i][c]));
  }
  const number = (v) => (v === 0 ? '0' : Math.abs(v) < 1e-3 || Math.abs(v) >= 1e4 ? v.toExponential(2) : v.toPrecision(3));

  function element(parent, tag, attributes, text) {
    const e = document.createElement(tag);
    for (const [k, v] of Object.entries(attributes || {})) e.setAttribute(k, v);
    if (text) e.textContent = text;
    parent.append(e);
    return e;
  }

  function start(pixels) {
    const state = {left: facts.left, right: facts.right, wipe: 0.5, stops: 0, error: false, zoom: 1, x: width / 2, y: height / 2,
                   probe: null};
    const bar = element(place, 'div', {class: 'controls'});
    const field = (label, control) => {
      const e = element(bar, 'label', {}, label);
      e.append(control);
      return control;
    };
    const choice = (label, side) => {
      const select = document.createElement('select');
      images.forEach((image, i) => element(select, 'option', {value: i}, image.name));
      select.value = state[side];
      select.addEventListener('change', () => (state[side] = Number(select.value), draw()));
      return field(label, select);
    };
    choice('left ', 'left');
    choice('right ', 'right');
    const range = (label, low, high, step, value, tell, change) => {
      const input = document.createElement('input');
      Object.assign(input, {type: 'range', min: low, max: high, step, value});
      const text = () => input.setAttribute('aria-valuetext', tell(Number(input.value)));
      text();
      input.addEventListener('input', () => (change(Number(input.value)), text(), draw()));
      return field(label, input);
    };
    const wipe = range('wipe ', 0, 1, 0.01, 0.5, (v) => Math.round(100 * v) + ' % left', (v) => (state.wipe = v));
    const exposure = range('exposure ', -6, 10, 0.25, 0, (v) => v + ' stops', (v) => (state.stops = v));
    const stops = element(exposure.parentNode, 'span', {class: 'stops'});
    const mode = element(bar, 'button', {type: 'button', 'aria-pressed': 'false', title: 'Absolute error against the reference'},
                         'error');
    mode.addEventListener('click', () => {
      state.error = !state.error;
      mode.setAttribute('aria-pressed', state.error);
      draw();
    });
    const zooms = element(bar, 'span', {role: 'group', 'aria-label': 'zoom', class: 'zooms'});
    for (const [text, label, factor] of [['−', 'Zoom out', 1 / 1.5], ['+', 'Zoom in', 1.5], ['fit', 'All of the picture', 0]]) {
      element(zooms, 'button', {type: 'button', 'aria-label': label}, text).addEventListener('click', () => zoom(factor));
    }

    const stage = element(place, 'div', {class: 'stage'});
    const canvas = element(stage, 'canvas', {
      tabindex: 0, role: 'application',
      'aria-label': 'Comparison of two images. Arrows: move over the pixels and hear their values; w and e: move the wipe; plus, ' +
        'minus and 0: zoom; drag the line to wipe, elsewhere to move.'});
    const names = ['left', 'right'].map((side) => element(stage, 'span', {class: 'name ' + side}));
    const scale = element(place, 'div', {class: 'scale'});
    const readout = element(place, 'output', {class: 'readout', 'aria-live': 'polite'});
    const context = canvas.getContext('2d');
    const scratch = document.createElement('canvas');
    Object.assign(scratch, {width, height});

    function paint(index) {
      const image = new ImageData(width, height), data = pixels[index], reference = pixels[0];
      const gain = 2 ** state.stops;
      for (let i = 0; i < width * height; ++i) {
        let rgb;
        if (state.error) {
          let sum = 0;
          for (let c = 0; c < channels; ++c) sum += Math.abs(data[i * channels + c] - reference[i * channels + c]) / channels;
          rgb = falseColour(sum * gain / facts.white);
        } else {
          rgb = [0, 1, 2].map((c) => toSrgb(gain * data[i * channels + Math.min(c, channels - 1)]));
        }
        image.data.set([rgb[0] + 0.5, rgb[1] + 0.5, rgb[2] + 0.5, 255], 4 * i);
      }
      scratch.getContext('2d').putImageData(image, 0, 0);
    }
    const pixel = () => state.zoom * canvas.width / width;  // its side on the canvas

    function draw() {
      const ratio = window.devicePixelRatio || 1;
      canvas.width = Math.round(stage.clientWidth * ratio);
      canvas.height = Math.round(canvas.width * height / width);
      const s = pixel(), room = (all) => all / 2 / state.zoom;
      state.x = Math.min(Math.max(state.x, room(width)), width - room(width));
      state.y = Math.min(Math.max(state.y, room(height)), height - room(height));
      const x0 = canvas.width / 2 - s * state.x, y0 = canvas.height / 2 - s * state.y, at = state.wipe * canvas.width;
      context.imageSmoothingEnabled = false;
      for (const [side, from, to] of [[state.left, 0, at], [state.right, at, canvas.width]]) {
        paint(side);
        context.save();
        context.beginPath();
        context.rect(from, 0, to - from, canvas.height);
        context.clip();
        context.drawImage(scratch, x0, y0, s * width, s * height);
        context.restore();
      }
      context.fillStyle = '#000';
      context.fillRect(at - 2 * ratio, 0, 4 * ratio, canvas.height);
      context.fillStyle = '#fff';
      context.fillRect(at - ratio, 0, 2 * ratio, canvas.height);
      context.beginPath();
      context.arc(at, canvas.height / 2, 9 * ratio, 0, 7);
      context.fill();
      context.strokeStyle = '#000';
      context.lineWidth = ratio;
      context.stroke();
      if (state.probe) {
        const [px, py] = state.probe;
        context.lineWidth = 3 * ratio;
        context.strokeRect(x0 + s * px, y0 + s * py, s, s);
        context.lineWidth = 1.2 * ratio;
        context.strokeStyle = '#ffd24a';
        context.strokeRect(x0 + s * px, y0 + s * py, s, s);
      }
      names.forEach((e, i) => (e.textContent = images[i ? state.right : state.left].name));
      stops.textContent = (state.stops > 0 ? '+' : '') + state.stops;
      wipe.value = state.wipe;
      scale.textContent = '';
      if (state.error) {
        scale.append('|image − reference|: 0 ');
        element(scale, 'span', {class: 'ramp', style: `background:linear-gradient(90deg,${ramp.map((c) => `rgb(${c})`)})`});
        scale.append(' ' + number(facts.white / 2 ** state.stops) + ' and above');
      }
      tell();
    }

    function tell() {
      if (!state.probe) {
        readout.textContent = 'Linear values under the cursor.';
        return;
      }
      const [x, y] = state.probe, at = (y * width + x) * channels;
      const values = (index) => [...pixels[index].slice(at, at + channels)].map(number).join(' ');
      const off = (index) => {
        let sum = 0;
        for (let c = 0; c < channels; ++c) sum += Math.abs(pixels[index][at + c] - pixels[0][at + c]) / channels;
        return index ? ` (off by ${number(sum)})` : '';
      };
      readout.textContent = `pixel ${x + facts.x}, ${y + facts.y}: ` +
        [...new Set([state.left, state.right, 0])].map((i) => `${images[i].name} ${values(i)}${off(i)}`).join(' · ');
    }

    function zoom(factor) {
      state.zoom = factor ? Math.min(Math.max(state.zoom * factor, 1), 24) : 1;
      draw();
    }
    function under(e) {
      const box = canvas.getBoundingClientRect(), ratio = canvas.width / box.width, s = pixel();
      const x = Math.floor(state.x + ((e.clientX - box.left) * ratio - canvas.width / 2) / s);
      const y = Math.floor(state.y + ((e.clientY - box.top) * ratio - canvas.height / 2) / s);
      return [Math.min(Math.max(x, 0), width - 1), Math.min(Math.max(y, 0), height - 1)];
    }
    let drag = null;
    canvas.addEventListener('pointerdown', (e) => {
      const box = canvas.getBoundingClientRect();
      drag = Math.abs(e.clientX - box.left - state.wipe * box.width) < 16 || state.zoom === 1 ? 'wipe' : 'pan';
      canvas.setPointerCapture(e.pointerId);
      if (drag === 'wipe') state.wipe = Math.min(Math.max((e.clientX - box.left) / box.width, 0), 1);
      draw();
    });
    canvas.addEventListener('pointermove', (e) => {
      const box = canvas.getBoundingClientRect();
      if (drag === 'wipe') state.wipe = Math.min(Math.max((e.clientX - box.left) / box.width, 0), 1);
      if (drag === 'pan') {
        const ratio = canvas.width / box.width;
        state.x -= e.movementX * ratio / pixel();
        state.y -= e.movementY * ratio / pixel();
      }
      state.probe = under(e);
      draw();
    });
    canvas.addEventListener('pointerup', () => (drag = null));
    canvas.addEventListener('pointerleave', () => {
      if (!drag && document.activeElement !== canvas) state.probe = null, draw();
    });
    canvas.addEventListener('wheel', (e) => {  // a page that scrolls is not caught by it
      if (!e.ctrlKey && document.activeElement !== canvas) return;
      e.preventDefault();
      zoom(e.deltaY < 0 ? 1.25 : 0.8);
    }, {passive: false});
    canvas.addEventListener('keydown', (e) => {
      if (e.ctrlKey || e.metaKey || e.altKey) return;
      const move = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}[e.key];
      if (move) {
        const [x, y] = state.probe || [Math.floor(width / 2), Math.floor(height / 2)];
        state.probe = [Math.min(Math.max(x + move[0], 0), width - 1), Math.min(Math.max(y + move[1], 0), height - 1)];
        const far = (p, centre, all) => Math.abs(p - centre) > all / 2 / state.zoom - 1;
        if (far(state.probe[0], state.x, width)) state.x = state.probe[0];
        if (far(state.probe[1], state.y, height)) state.y = state.probe[1];
        draw();
      } else if (e.key === 'w' || e.key === 'e') {
        state.wipe = Math.min(Math.max(state.wipe + (e.key === 'w' ? -0.05 : 0.05), 0), 1);
        draw();
      } else if (e.key === '+' || e.key === '=') {
        zoom(1.5);
      } else if (e.key === '-') {
        zoom(1 / 1.5);
      } else if (e.key === '0' || e.key === 'Escape') {
        zoom(0);
      } else {
        return;
      }
      e.preventDefault();
    });
    let drawn = 0;  // the width that was drawn for: drawing itself changes the height
    new ResizeObserver(() => {
      if (stage.clientWidth !== drawn) drawn = stage.clientWidth, requestAnimationFrame(draw);
    }).observe(stage);
    place.hidden = false;
    draw();
  }

  load().then(start).catch((error) => console.error(error));  // the pictures below stay
})();
