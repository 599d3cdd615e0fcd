// Plots as SVG: sharp at any size, on paper as well, and readable by programs. Each bears a legend whose buttons hide
// and show curves, a note of the point under the pointer, and its numbers as a table.

const chartWidth = 640, chartHeight = 400, chartMargin = {
  left: 78,
  right: 14,
  top: 12,
  bottom: 48
};
const curveColours = 12;
const markerShapes = ['circle', 'square', 'diamond', 'triangle', 'cross'];

/** One axis: where values lie between two ends in pixels. Logarithmic axes take positive numbers alone. */
class Axis {
  constructor(values, logarithmic, begin, end) {
    const usable = values.filter((v) => Number.isFinite(v) && (!logarithmic || v > 0));
    let low = Math.min(...usable), high = Math.max(...usable);
    if (!usable.length) [low, high] = logarithmic ? [0.1, 1] : [0, 1];
    if (logarithmic) {
      const pad = Math.max(0.05 * Math.log10(high / low), 0.06);
      [low, high] = [low * 10 ** -pad, high * 10 ** pad];
    } else {
      const pad = 0.05 * (high - low) || 0.5 * Math.abs(high) || 0.5;
      [low, high] = [low - pad, high + pad];
    }
    Object.assign(this, {logarithmic, low, high, begin, end});
  }
  place(value) {
    const share = this.logarithmic ? Math.log(value / this.low) / Math.log(this.high / this.low) :
                                     (value - this.low) / (this.high - this.low);
    return this.begin + share * (this.end - this.begin);
  }
  holds(value) { return Number.isFinite(value) && (!this.logarithmic || value > 0); }
  /** {value, label}: label is empty for a line of the grid alone. */
  ticks() { return this.logarithmic ? this.decades() : this.steps(); }
  steps() {
    const rough = (this.high - this.low) / 6, power = 10 ** Math.floor(Math.log10(rough));
    const step = [1, 2, 5, 10].map((f) => f * power).find((s) => s >= rough);
    const ticks = [];
    for (let k = Math.ceil(this.low / step); k * step <= this.high; ++k)
      ticks.push(
          {value: k * step, label: digits(Math.abs(k * step) < 1e-12 * step ? 0 : Number((k * step).toPrecision(12)))});
    return ticks;
  }
  decades() {
    const spanned = Math.log10(this.high / this.low), ticks = [];
    const stride = Math.ceil(spanned / 8);
    for (let p = Math.floor(Math.log10(this.low)); p <= Math.log10(this.high); ++p)
      for (let m = 1; m < 10; ++m) {
        const value = m * 10 ** p;
        if (value < this.low || value > this.high || (m > 1 && spanned > 5)) continue;
        const named = spanned > 2.2 ? m === 1 && p % stride === 0 : spanned > 0.9 ? [1, 2, 5].includes(m) : true;
        ticks.push({value, label: named ? tickText(value) : '', minor: m > 1});
      }
    return ticks;
  }
}

/** 1e-4 and 2e-4 as powers of ten, other numbers as they are. */
function tickText(value) {
  const power = Math.floor(Math.log10(value) + 1e-9);
  if (power >= -2 && power <= 3) return digits(value, 2);
  const raised = String(power).replace(/[-\d]/g, (c) => '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'['-0123456789'.indexOf(c)]);
  const factor = Math.round(value / 10 ** power);
  return (factor === 1 ? '' : factor + '·') + '10' + raised;
}

function markerPath(shape, x, y, r) {
  const at = (dx, dy) => `${(x + dx * r).toFixed(2)} ${(y + dy * r).toFixed(2)}`;
  switch (shape) {
    case 'square':
      return `M${at(-0.9, -0.9)}L${at(0.9, -0.9)}L${at(0.9, 0.9)}L${at(-0.9, 0.9)}Z`;
    case 'diamond':
      return `M${at(0, -1.25)}L${at(1.25, 0)}L${at(0, 1.25)}L${at(-1.25, 0)}Z`;
    case 'triangle':
      return `M${at(0, -1.2)}L${at(1.1, 0.9)}L${at(-1.1, 0.9)}Z`;
    case 'cross':
      return `M${at(-1, -1)}L${at(1, 1)}M${at(-1, 1)}L${at(1, -1)}`;
    default:
      return `M${at(-1, 0)}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${- 2 * r} 0Z`;
  }
}

/** The lines of the grid, the ticks and the labels. */
function drawAxes(chart, x, y) {
  const {left, top, bottom} = chartMargin, right = chartWidth - chartMargin.right, low = chartHeight - bottom;
  const group = element('g', {class: 'axes'});
  for (const {value, label, minor} of x.ticks()) {
    const at = x.place(value);
    group.append(element('line', {x1: at, x2: at, y1: top, y2: low, class: minor ? 'minor' : 'major'}));
    if (label) group.append(element('text', {x: at, y: low + 17, 'text-anchor': 'middle'}, label));
  }
  for (const {value, label, minor} of y.ticks()) {
    const at = y.place(value);
    group.append(element('line', {x1: left, x2: right, y1: at, y2: at, class: minor ? 'minor' : 'major'}));
    if (label) group.append(element('text', {x: left - 7, y: at + 4, 'text-anchor': 'end'}, label));
  }
  group.append(element('path', {class: 'frame', d: `M${left} ${top}V${low}H${right}`}));
  const middle = (top + low) / 2;
  group.append(element(
      'text', {class: 'label', x: (left + right) / 2, y: chartHeight - 8, 'text-anchor': 'middle'}, chart.x_label));
  group.append(element(
      'text', {class: 'label', x: 16, y: middle, 'text-anchor': 'middle', transform: `rotate(-90 16 ${middle})`},
      chart.y_label));
  return group;
}

function drawCurve(curve, x, y, points) {
  const group = element('g', {class: `curve ${curve.guide ? 'guide' : ''} ${curve.kind || ''}`});
  group.style.setProperty(
      '--colour',
      curve.guide                ? 'var(--dim)' :
          curve.kind === 'front' ? 'var(--ink)' :
                                   `var(--curve-${curve.colour % curveColours})`);
  const all = curve.x.map((value, k) => ({x: value, y: curve.y[k], note: curve.notes?.[k], curve}));
  const seen = [];
  let path = '', pen = 'M';  // lifted where a point is missing
  for (const point of all) {
    if (!x.holds(point.x) || !y.holds(point.y)) {
      pen = 'M';
      continue;
    }
    point.at = [x.place(point.x), y.place(point.y)];
    path += pen + point.at.map((c) => c.toFixed(2)).join(' ');
    pen = 'L';
    seen.push(point);
  }
  if (seen.length > 1) group.append(element('path', {class: 'line', d: path}));
  // points that would run into one another are left to the line
  if (!curve.guide && curve.kind !== 'front' && seen.length <= 60)
    for (const p of seen)
      group.append(element('path', {class: `point ${curve.marker}`, d: markerPath(curve.marker, ...p.at, 4)}));
  if (!curve.guide) points.push(...seen);
  return group;
}

/** The nearest point within 40 units of the pointer is told. */
function followPointer(svg, points, note, ring) {
  svg.addEventListener('pointermove', (event) => {
    const box = svg.getBoundingClientRect(), scale = chartWidth / box.width;
    const px = (event.clientX - box.left) * scale, py = (event.clientY - box.top) * scale;
    let best, least = 40;
    for (const point of points) {
      const distance = point.curve.hidden ? Infinity : Math.hypot(point.at[0] - px, point.at[1] - py);
      if (distance < least) [best, least] = [point, distance];
    }
    ring.setAttribute('visibility', best ? 'visible' : 'hidden');
    note.hidden = !best;
    if (!best) return;
    ring.setAttribute('cx', best.at[0]);
    ring.setAttribute('cy', best.at[1]);
    note.replaceChildren(
        element('b', {}, best.curve.name), ` ${digits(best.x)}, ${digits(best.y)}`, best.note ? ` (${best.note})` : '');
  });
  svg.addEventListener('pointerleave', () => {
    note.hidden = true;
    ring.setAttribute('visibility', 'hidden');
  });
}

/** A button that hides and shows a curve, with the curve's line and marker. */
function legendButton(curve, group) {
  const swatch = element(
      'svg', {viewBox: '0 0 26 12', width: 26, height: 12, 'aria-hidden': 'true'},
      element('path', {class: 'line', d: 'M0 6H26'}),
      curve.guide || curve.kind === 'front' ?
          null :
          element('path', {class: `point ${curve.marker}`, d: markerPath(curve.marker, 13, 6, 4)}));
  const button = element(
      'button', {
        type: 'button',
        'aria-pressed': 'true',
        class: group.getAttribute('class'),
        onclick: () => {
          curve.hidden = !curve.hidden;
          group.toggleAttribute('hidden', curve.hidden);
          group.style.display = curve.hidden ? 'none' : '';
          button.setAttribute('aria-pressed', String(!curve.hidden));
        }
      },
      swatch, curve.name);
  // whoever points at a name sees its curve before the others
  const focus = (on) => {
    group.classList.toggle('focus', on);
    group.ownerSVGElement.classList.toggle('focused', on);
  };
  for (const [event, on] of [['pointerenter', true], ['focus', true], ['pointerleave', false], ['blur', false]])
    button.addEventListener(event, () => focus(on && !curve.hidden));
  button.style.setProperty('--colour', group.style.getPropertyValue('--colour'));
  return button;
}

function numbersOf(chart) {
  const columns = [{title: 'curve'}, {title: chart.x_label, number: true}, {title: chart.y_label, number: true}];
  const rows = [];
  for (const curve of chart.curves)
    if (!curve.guide) curve.x.forEach((x, k) => rows.push([curve.name, digits(x), digits(curve.y[k])]));
  return element('details', {class: 'numbers'}, element('summary', {}, 'numbers'), tableOf(columns, rows));
}

/** A figure of {title, x_label, y_label, log_x, log_y, curves: [{name, x, y, guide}]}, as in results.json. */
function chartFigure(chart) {
  let count = 0;
  const curves = chart.curves.map(
      (curve) =>
          ({marker: markerShapes[Math.floor(count / curveColours) % 5], colour: curve.guide ? 0 : count++, ...curve}));
  const judged = curves.some((c) => !c.guide) ? curves : [];
  const x = new Axis(judged.flatMap((c) => c.x), chart.log_x, chartMargin.left, chartWidth - chartMargin.right);
  const y = new Axis(judged.flatMap((c) => c.y), chart.log_y, chartHeight - chartMargin.bottom, chartMargin.top);
  const svg = element(
      'svg', {
        viewBox: `0 0 ${chartWidth} ${chartHeight}`,
        role: 'img',
        'aria-label': `${chart.title}: ${chart.y_label} against ${chart.x_label}`
      },
      drawAxes(chart, x, y));
  const points = [], groups = curves.map((curve) => drawCurve(curve, x, y, points));
  const ring = element('circle', {class: 'ring', r: 7, visibility: 'hidden'}),
        note = element('p', {class: 'note', hidden: true});
  svg.append(...groups, ring);
  followPointer(svg, points, note, ring);
  return element(
      'figure', {class: 'chart'}, element('figcaption', {}, chart.title), element('div', {class: 'drawing'}, svg, note),
      element('div', {class: 'legend'}, curves.map((curve, k) => legendButton(curve, groups[k]))),
      numbersOf({...chart, curves}));
}
