// Charts with hover and zoom in place of the drawings that are there without scripts. Each figure.plot holds its data as JSON:
// lines of [x, low, high, y, low, high, sure, note]; ends are null where there is none.
(() => {
  'use strict';
  if (typeof Dygraph === 'undefined') return;
  const superscripts = '⁰¹²³⁴⁵⁶⁷⁸⁹';
  const power = (k) => '10' + (k < 0 ? '⁻' : '') + [...String(Math.abs(k))].map((d) => superscripts[d]).join('');
  const short = (v) => String(Number(v.toPrecision(3)));
  const seconds = (v) => (v >= 1 ? short(v) + ' s' : v >= 1e-3 ? short(v * 1e3) + ' ms' : short(v * 1e6) + ' µs');

  function label(v, style) {
    if (style === 'seconds') return seconds(v);
    if (style !== 'decades') return short(v);
    const k = Math.floor(Math.log10(v) + 1e-9), m = v / 10 ** k;
    return Math.abs(m - 1) < 1e-6 ? power(k) : short(m) + '·' + power(k);
  }

  // Ticks of a logarithmic axis: the densest of some scales that has room; a few decades' worth of zoom ends in even steps.
  function ticks(low, high, most, style) {
    const within = (v) => v >= low * (1 - 1e-9) && v <= high * (1 + 1e-9);
    let best = [];
    if (style === 'counts') {
      for (let v = 2 ** Math.ceil(Math.log2(low) - 1e-9); within(v); v *= 2) best.push(v);
      while (best.length > most) best = best.filter((_, i) => i % 2 === 0);
      if (best.length > 1) return best;
    }
    const first = Math.floor(Math.log10(low)), last = Math.ceil(Math.log10(high));
    for (const scale of [[1], [1, 3], [1, 2, 5], [1, 1.5, 2, 3, 5, 7]]) {
      const all = [];
      for (let k = first; k <= last; ++k) for (const m of scale) if (within(m * 10 ** k)) all.push(m * 10 ** k);
      if (all.length <= most && all.length > best.length) best = all;
      if (scale.length === 1 && all.length > most) return all.filter((_, i) => i % Math.ceil(all.length / most) === 0);
    }
    if (best.length > 2) return best;
    const rough = (high - low) / Math.max(2, most), unit = 10 ** Math.floor(Math.log10(rough));
    const step = unit * [1, 2, 5, 10].find((m) => m * unit >= rough);
    best = [];
    for (let i = Math.ceil(low / step); i * step <= high; ++i) best.push(i * step);
    return style === 'counts' ? best.filter((v) => v === Math.round(v)) : best;
  }
  const ticker = (style, room) => (low, high, pixels) =>
    ticks(low, high, Math.max(2, Math.floor(pixels / room)), style).map((v) => ({v, label: label(v, style)}));

  const shapes = [
    null,
    [[-0.9, -0.9], [0.9, -0.9], [0.9, 0.9], [-0.9, 0.9]],
    [[0, -1.2], [1.15, 0.9], [-1.15, 0.9]],
    [[0, -1.35], [1.15, 0], [0, 1.35], [-1.15, 0]],
    [[0, 1.2], [1.15, -0.9], [-1.15, -0.9]],
    [[-0.4, -1.2], [0.4, -1.2], [0.4, -0.4], [1.2, -0.4], [1.2, 0.4], [0.4, 0.4], [0.4, 1.2], [-0.4, 1.2], [-0.4, 0.4],
     [-1.2, 0.4], [-1.2, -0.4], [-0.4, -0.4]]];
  function marker(c, style, x, y, r) {
    const shape = shapes[style % shapes.length];
    c.beginPath();
    if (shape) for (const [u, v] of shape) c.lineTo(x + r * u, y + r * v);
    else c.arc(x, y, r, 0, 2 * Math.PI);
    c.closePath();
  }

  const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const lineColour = (line) => colour('--c' + line.style);
  const dashes = [[], [7, 4], [2, 3], [9, 3, 2, 3], [4, 2]];

  function element(parent, tag, attributes, text) {
    const e = document.createElement(tag);
    for (const [k, v] of Object.entries(attributes || {})) e.setAttribute(k, v);
    if (text) e.textContent = text;
    parent.append(e);
    return e;
  }

  function live(figure) {
    const data = JSON.parse(figure.querySelector('script').textContent);
    const lines = data.lines.filter((l) => l.points.length);
    if (!lines.length) return;
    const still = figure.querySelector('.still');
    const box = document.createElement('div');
    box.className = 'live';
    still.after(box);
    figure.classList.add('is-live');
    const plot = element(box, 'div', {
      class: 'canvas', tabindex: 0, role: 'application',
      'aria-label': data.title + '. ' + data.description + ' Left and right: from point to point; up and down: from line to ' +
        'line; plus and minus: zoom; shift and arrows: move; 0: all of it.'});
    const tip = element(box, 'output', {class: 'tip', 'aria-live': 'polite'});
    tip.hidden = true;
    const bar = element(box, 'div', {class: 'legend', role: 'group', 'aria-label': 'Lines of ' + data.title});
    const whole = element(bar, 'button', {type: 'button', class: 'whole'}, 'All of it');
    whole.hidden = true;

    // All x in one column, as the library wants it; lines have gaps where others have a point.
    const xs = [...new Set(lines.flatMap((l) => l.points.map((p) => p[0])))].sort((a, b) => a - b);
    const rows = xs.map((x) => [x, ...lines.map((l) => (l.points.find((p) => p[0] === x) || [])[3] ?? null)]);
    // The ends of intervals widen it by a factor of four at most, as in the drawing.
    const extent = (column, more) => {
      const points = lines.flatMap((l) => l.points);
      const values = [...points.map((p) => p[column]), ...lines.flatMap((l) => (l.companion || []).map((p) => p[column ? 1 : 0])),
                      ...more].filter((v) => v > 0);
      const ends = points.flatMap((p) => [p[column + 1], p[column + 2]]).filter((v) => v > 0);
      const least = Math.min(...values), most = Math.max(...values);
      const low = Math.min(least, ends.length ? Math.max(least / 4, Math.min(...ends)) : least);
      const high = Math.max(most, ends.length ? Math.min(most * 4, Math.max(...ends)) : most);
      const margin = Math.max(1.04, (high / low) ** 0.04);
      return [low / margin, high * margin];
    };
    const home = {dateWindow: extent(0, []), valueRange: extent(3, data.one ? [1] : [])};
    const byName = new Map(lines.map((l) => [l.name, l]));
    // The library's own toDomXCoord() is of even axes.
    const X = (chart, v) => chart.getArea().x + chart.toPercentXCoord(v) * chart.getArea().w;
    const Y = (chart, v) => chart.toDomYCoord(v);

    function draw(e) {
      const line = byName.get(e.setName), c = e.drawingContext, g = e.dygraph;
      const at = (x, y) => [X(g, x), Y(g, y)];
      c.save();
      c.strokeStyle = c.fillStyle = lineColour(line);
      c.lineJoin = 'round';
      const path = (points, x, y) => {
        c.beginPath();
        for (const p of points) c.lineTo(...at(p[x], p[y]));
        c.stroke();
      };
      if (line.companion) {
        c.lineWidth = 1.3;
        c.setLineDash([4, 3]);
        path(line.companion, 0, 1);
      }
      c.lineWidth = line.strong ? 2.8 : 1.6;
      c.setLineDash(dashes[line.dash % dashes.length]);
      path(line.points, 0, 3);
      c.setLineDash([]);
      for (const [x, xl, xh, y, yl, yh, sure] of line.points) {
        c.lineWidth = 1.5;
        c.beginPath();
        if (yl > 0) c.moveTo(...at(x, yl)), c.lineTo(...at(x, yh));
        if (xl > 0) c.moveTo(...at(xl, y)), c.lineTo(...at(xh, y));
        c.stroke();
        marker(c, line.style, ...at(x, y), 3.6);
        if (!sure) c.fillStyle = colour('--ground');
        c.fill();
        if (!sure) c.stroke();
        c.fillStyle = c.strokeStyle;
      }
      c.restore();
    }

    function tell(row, name) {
      const line = byName.get(name);
      const p = line && line.points.find((q) => q[0] === xs[row]);
      if (!p) return hush();
      const text = p[7] || `${name}: ${label(p[0], data.x.style)}, ${label(p[3], data.y.style)}`;
      tip.textContent = p[4] > 0 ? `${text}; 95 %: ${p[4].toPrecision(3)} to ${p[5].toPrecision(3)}` : text;
      tip.hidden = false;
      const x = plot.offsetLeft + X(g, p[0]), y = plot.offsetTop + Y(g, p[3]);
      const left = Math.min(Math.max(0, x - tip.offsetWidth / 2), box.offsetWidth - tip.offsetWidth);
      tip.style.left = left + 'px';
      tip.style.top = (y - tip.offsetHeight - 14 < 0 ? y + 16 : y - tip.offsetHeight - 14) + 'px';
    }
    function hush() {
      tip.hidden = true;
    }

    const g = new Dygraph(plot, rows, {
      labels: ['x', ...lines.map((l) => l.name)],
      ...home,
      logscale: true,
      colors: lines.map(lineColour),
      plotter: draw,
      connectSeparatedPoints: true,
      axes: {
        x: {logscale: true, ticker: ticker(data.x.style, 58), drawGrid: true, axisLabelWidth: 60},
        y: {ticker: ticker(data.y.style, 34), axisLabelWidth: 52}
      },
      xlabel: data.x.label, ylabel: data.y.label, xLabelHeight: 22, yLabelWidth: 20,
      rightGap: 26, legend: 'never', labelsDiv: document.createElement('div'),
      gridLineColor: colour('--rule'), gridLineWidth: 1, axisLineColor: colour('--soft'),
      highlightSeriesOpts: {strokeWidth: 3}, highlightSeriesBackgroundColor: colour('--ground'),
      highlightSeriesBackgroundAlpha: 0.75,
      drawHighlightPointCallback: (_, name, c, x, y) => {
        c.strokeStyle = colour('--ink');
        c.lineWidth = 1.5;
        c.beginPath();
        c.arc(x, y, 8, 0, 2 * Math.PI);
        c.stroke();
      },
      highlightCallback: (_, x, points, row, name) => tell(row, name),
      unhighlightCallback: hush,
      zoomCallback: () => (whole.hidden = false),
      underlayCallback: (c, area, chart) => {
        const [low, high] = chart.yAxisRange();
        if (!data.one || low > 1 || high < 1) return;
        c.save();
        c.strokeStyle = colour('--soft');
        c.lineWidth = 1.8;
        c.beginPath();
        c.moveTo(area.x, chart.toDomYCoord(1));
        c.lineTo(area.x + area.w, chart.toDomYCoord(1));
        c.stroke();
        c.restore();
      }
    });
    box.chart = g;  // for the curious, and the tests
    function show(window) {
      g.updateOptions(window);
      whole.hidden = Math.abs(Math.log(window.dateWindow[0] / home.dateWindow[0])) < 1e-9 &&
        Math.abs(Math.log(window.dateWindow[1] / home.dateWindow[1])) < 1e-9 &&
        Math.abs(Math.log(window.valueRange[0] / home.valueRange[0])) < 1e-9;
      hush();
    }
    const reset = () => show(home);
    g.resetZoom = reset;  // a double click too ends here, not at the data's bare ends
    whole.addEventListener('click', () => (reset(), plot.focus()));

    for (const [i, line] of lines.entries()) {
      const button = element(bar, 'button', {type: 'button', 'aria-pressed': 'true', class: 's' + line.style});
      button.innerHTML = line.key;
      button.append(line.name);
      button.addEventListener('click', () => {
        const on = !g.visibility()[i];
        button.setAttribute('aria-pressed', on);
        g.setVisibility(i, on);
        hush();
      });
    }

    // Keys: a place is a line and one of its points.
    let line = Math.max(0, lines.findIndex((l) => l.strong)), point = -1;
    plot.addEventListener('keydown', (e) => {
      if (e.ctrlKey || e.metaKey || e.altKey) return;
      const move = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}[e.key];
      const x = g.xAxisRange(), y = g.yAxisRange();
      const shifted = ([a, b], by) => [a * (b / a) ** by, b * (b / a) ** by];
      const scaled = ([a, b], by) => [a * (b / a) ** by, b / (b / a) ** by];
      if (move && e.shiftKey) {
        show({dateWindow: shifted(x, 0.1 * move[0]), valueRange: shifted(y, -0.1 * move[1])});
      } else if (move) {
        const n = lines.length;
        if (move[1]) {
          for (let k = 0; k < n; ++k) {
            line = (line + move[1] + n) % n;
            if (g.visibility()[line]) break;
          }
        }
        const points = lines[line].points;
        point = point < 0 ? points.length - 1 : Math.min(Math.max(0, point + move[0]), points.length - 1);
        const row = xs.indexOf(points[point][0]);
        g.setSelection(row, lines[line].name);
        tell(row, lines[line].name);
      } else if (e.key === '+' || e.key === '=') {
        show({dateWindow: scaled(x, 0.1), valueRange: scaled(y, 0.1)});
      } else if (e.key === '-') {
        show({dateWindow: scaled(x, -0.125), valueRange: scaled(y, -0.125)});
      } else if (e.key === '0' || e.key === 'Escape') {
        reset();
        g.clearSelection();
      } else {
        return;
      }
      e.preventDefault();
    });
    plot.addEventListener('blur', () => (g.clearSelection(), hush()));
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => g.updateOptions({
      colors: lines.map(lineColour), gridLineColor: colour('--rule'), axisLineColor: colour('--soft'),
      highlightSeriesBackgroundColor: colour('--ground')}));
  }

  for (const figure of document.querySelectorAll('figure.plot')) {
    try {
      live(figure);
    } catch (error) {  // the drawing stays
      figure.classList.remove('is-live');
      figure.querySelector('.live')?.remove();
      console.error(error);
    }
  }
})();
