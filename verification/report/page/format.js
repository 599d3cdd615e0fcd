// Numbers, durations and elements: what all other scripts write with.

/** Four digits, as short as they can be written: 0.01234, 1.234e-5. */
function digits(value, count = 4) {
  if (value === null || value === undefined || Number.isNaN(value)) return '–';
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-3) return value.toExponential(count - 1).replace(/\.?0+e/, 'e').replace('e+', 'e');
  const text = value.toPrecision(count);
  const plain = text.includes('e') ? String(Number(text)) : text;
  return plain.includes('.') ? plain.replace(/\.?0+$/, '') : plain;
}

/** A number of an object of results.json, where null has its reason beside it. */
function numberOf(object, name) {
  if (object[name] !== null && object[name] !== undefined) return object[name];
  const status = object[name + '_status'];
  return status === 'inf' ? Infinity : status === '-inf' ? -Infinity : NaN;
}

function valueText(value, unit) {
  if (value === Infinity || value === -Infinity) return value > 0 ? '∞' : '−∞';
  return unit && unit !== '1' && !Number.isNaN(value) ? `${digits(value)} ${unit}` : digits(value);
}

function allowedText({low, high}) {
  if (low !== undefined && high !== undefined) return `${digits(low)} … ${digits(high)}`;
  if (low !== undefined) return `≥ ${digits(low)}`;
  return high !== undefined ? `≤ ${digits(high)}` : '';
}

function intervalText({low, high}) {
  return low === undefined || high === undefined ? '' : `[${digits(low, 3)}, ${digits(high, 3)}]`;
}

function durationText(seconds) {
  if (!(seconds > 0)) return '';
  if (seconds < 0.0995) return `${digits(1000 * seconds, 2)} ms`;
  if (seconds < 59.5) return `${seconds < 9.95 ? seconds.toFixed(1) : seconds.toFixed(0)} s`;
  const whole = Math.round(seconds), two = (n) => String(n).padStart(2, '0');
  const minutes = Math.floor(whole / 60);
  return minutes < 60 ? `${minutes}:${two(whole % 60)}` :
                        `${Math.floor(minutes / 60)}:${two(minutes % 60)}:${two(whole % 60)}`;
}

/** 8 100 000 as "8.1 M". */
function largeText(value) {
  if (!(value > 0)) return '';
  const prefixes = ['', ' k', ' M', ' G', ' T'];
  let step = 0;
  while (value >= 999.5 && step + 1 < prefixes.length) value /= 1000, ++step;
  return digits(value, 3) + prefixes[step];
}

function memoryText(bytes) { return bytes > 0 ? `${digits(bytes / 1048576, 3)} MiB` : ''; }

/** An element with attributes and children; text becomes text, never markup. */
function element(name, attributes = {}, ...children) {
  const svg = ['svg', 'g', 'path', 'line', 'text', 'circle', 'rect', 'title'].includes(name);
  const made = svg ? document.createElementNS('http://www.w3.org/2000/svg', name) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith('on'))
      made.addEventListener(key.slice(2), value);
    else if (value !== undefined && value !== false)
      made.setAttribute(key, value === true ? '' : value);
  }
  made.append(...children.flat().filter((child) => child !== undefined && child !== null));
  return made;
}

/** Text in which every DOI is a link. */
function withLinks(text) {
  const parts = [];
  let end = 0;
  for (const found of text.matchAll(/(?:doi:\s*)?(10\.\d{4,9}\/[^\s,;()\]]*[^\s,;.()\]])/gi)) {
    parts.push(text.slice(end, found.index));
    parts.push(element('a', {href: 'https://doi.org/' + encodeURI(found[1]), rel: 'noreferrer'}, 'doi:' + found[1]));
    end = found.index + found[0].length;
  }
  return [...parts, text.slice(end)];
}

/** A name as it may stand in an address within the page. */
function anchorOf(id) { return 'case-' + id.replace(/[^\w-]+/g, '-'); }

function verdictBadge(verdict) { return element('span', {class: `badge ${verdict}`}, verdict.toUpperCase()); }

const isGreen = (verdict) => ['pass', 'noted', 'omitted'].includes(verdict);

/** A table in a frame that scrolls. Columns: {title, number: put to the right}; rows: lists of cells, or elements. */
function tableOf(columns, rows, {caption, ...attributes} = {}) {
  const side = (column) => column.number ? 'n' : column.wide;
  const heads = columns.map((column) => element('th', {scope: 'col', class: side(column)}, column.title));
  const line = (cells) => element('tr', {}, cells.map((cell, k) => element('td', {class: side(columns[k])}, cell)));
  const body = element('tbody', {}, rows.map((row) => row instanceof Element ? row : line(row)));
  const parts =
      [caption ? element('caption', {}, caption) : null, element('thead', {}, element('tr', {}, heads)), body];
  return element('div', {class: 'scroll'}, element('table', attributes, parts));
}
