// The table of all rows: filtered by text, verdict, tier and case, sorted by any column.

/** The rows of all cases, flat; each with its case, and with what it was in the earlier run. */
function flatRows(results) {
  const changes = new Map();
  for (const change of results.against?.changes || []) {
    if (!change.verdict) continue;
    const list = changes.get(change.case) || [];
    list.push(change);
    changes.set(change.case, list);
  }
  return results.cases.flatMap(
      (one) => one.rows.map(
          (row, k) =>
              ({...row, id: one.id, tier: one.tier, value: numberOf(row, 'found'), change: changes.get(one.id)?.[k]})));
}

const verdictOrder = ['error', 'fail', 'floored', 'omitted', 'noted', 'pass'];

/** {title, text(row), key(row) to sort by, number: put to the right, cell(row) where it is more than text}. */
function rowColumns(compared) {
  const low = (interval) => interval.low ?? interval.high ?? -Infinity;
  const measured = (row) => !['omitted', 'error'].includes(row.verdict);
  const columns = [
    {title: 'case', text: (r) => r.id, cell: (r) => element('a', {href: '#' + anchorOf(r.id)}, r.id)},
    {title: 'subject', text: (r) => r.subject, wide: 'wrap'},
    {title: 'measure', text: (r) => r.measure, wide: 'wrap'},
    {title: 'found', number: true, text: (r) => measured(r) ? valueText(r.value, r.unit) : '', key: (r) => r.value},
    {title: '95 % interval', number: true, text: (r) => intervalText(r.uncertainty), key: (r) => low(r.uncertainty)},
    {title: 'allowed', number: true, text: (r) => allowedText(r.allowed), key: (r) => low(r.allowed)},
    {
      title: 'verdict',
      text: (r) => r.verdict,
      key: (r) => verdictOrder.indexOf(r.verdict),
      cell: (r) => verdictBadge(r.verdict)
    },
    {title: 'time', number: true, text: (r) => durationText(r.cost.seconds), key: (r) => r.cost.seconds},
    {
      title: 'particle-steps',
      number: true,
      text: (r) => largeText(r.cost.particle_steps),
      key: (r) => r.cost.particle_steps
    },
    {title: 'why', text: (r) => r.because, wide: 'wide why'},
  ];
  if (compared)
    columns.splice(
        7, 0, {
          title: 'earlier',
          number: true,
          text: (r) => r.change?.earlier_verdict && measured(r) ? valueText(numberOf(r.change, 'earlier'), r.unit) : '',
          key: (r) => r.change ? numberOf(r.change, 'earlier') : NaN
        },
        {
          title: 'change',
          number: true,
          text: (r) => (r.change?.text || '') + (verdictMoved(r.change) ? `, was ${r.change.earlier_verdict}` : ''),
          key: (r) => r.change ? Math.abs(numberOf(r.change, 'found') / numberOf(r.change, 'earlier') - 1) : NaN
        });
  return columns;
}

function verdictMoved(change) {
  return Boolean(change && change.earlier_verdict && change.verdict && change.verdict !== change.earlier_verdict);
}

function inOrder(a, b) {
  if (typeof a === 'string' && typeof b === 'string') return a.localeCompare(b, 'en', {numeric: true});
  if (Number.isNaN(a) || Number.isNaN(b)) return Number(Number.isNaN(a)) - Number(Number.isNaN(b));
  return a < b ? -1 : a > b ? 1 : 0;
}

function rowElement(row, columns) {
  return element(
      'tr', {class: isGreen(row.verdict) ? undefined : 'red'},
      columns.map(
          (column) => element(
              'td', {class: column.number ? 'n' : column.wide}, column.cell ? column.cell(row) : column.text(row))));
}

function chooser(label, all, options, changed) {
  return element(
      'label', {}, label + ' ',
      element(
          'select', {onchange: (event) => changed(event.target.value)}, element('option', {value: ''}, all),
          options.map((option) => element('option', {value: option}, String(option)))));
}

/** The rows that are shown, in their order. */
class RowTable {
  constructor(results) {
    this.rows = flatRows(results);
    this.columns = rowColumns(Boolean(results.against));
    this.wanted = {text: '', verdict: '', tier: '', id: ''};
    this.sorting = {column: -1, falling: false};
    this.heads = this.columns.map((column, k) => this.head(column, k));
    this.body = element('tbody');
    this.shown = element('span', {class: 'shown', 'aria-live': 'polite'});
    this.fill();
  }
  head(column, k) {
    const sort = () => {
      this.sorting = {column: k, falling: this.sorting.column === k && !this.sorting.falling};
      this.fill();
    };
    const button = element('button', {type: 'button', onclick: sort}, column.title);
    return element('th', {scope: 'col', class: column.number ? 'n' : undefined}, button);
  }
  want(name, value) {
    this.wanted[name] = value;
    this.fill();
  }
  fits(row) {
    const {text, verdict, tier, id} = this.wanted;
    const words = text.toLowerCase().split(/\s+/).filter(Boolean);
    const all = `${row.id} ${row.subject} ${row.measure} ${row.because} ${row.verdict}`.toLowerCase();
    const judged = verdict === 'not green' ? !isGreen(row.verdict) : !verdict || row.verdict === verdict;
    return judged && (!tier || String(row.tier) === tier) && (!id || row.id === id) &&
        words.every((word) => all.includes(word));
  }
  fill() {
    const {rows, columns, sorting} = this, kept = rows.filter((row) => this.fits(row));
    if (sorting.column >= 0) {
      const key = columns[sorting.column].key || columns[sorting.column].text;
      kept.sort((a, b) => (sorting.falling ? -1 : 1) * inOrder(key(a), key(b)));
    }
    const direction = sorting.falling ? 'descending' : 'ascending';
    this.heads.forEach((head, k) => head.setAttribute('aria-sort', k === sorting.column ? direction : 'none'));
    this.body.replaceChildren(...kept.map((row) => rowElement(row, columns)));
    this.shown.textContent =
        kept.length === rows.length ? `${rows.length} rows` : `${kept.length} of ${rows.length} rows`;
  }
}

/** A section with the table; show(verdict) filters it from elsewhere. */
function rowsSection(results) {
  const table = new RowTable(results);
  const present = (verdict) => table.rows.some((row) => row.verdict === verdict);
  const choose = (label, name, options) => chooser(label, 'all', options, (value) => table.want(name, value));
  const byVerdict = choose('verdict', 'verdict', ['not green', ...verdictOrder.filter(present)]);
  const search = element('input', {type: 'search', id: 'filter', placeholder: 'words, e.g. cubic apic'});
  search.addEventListener('input', () => table.want('text', search.value));
  const filters = element(
      'div', {class: 'filters'}, element('label', {}, 'filter ', search), byVerdict,
      choose('tier', 'tier', [...new Set(table.rows.map((row) => row.tier))].sort()),
      choose('case', 'id', results.cases.map((one) => one.id)), table.shown);
  const lines = element('table', {id: 'all-rows'}, element('thead', {}, element('tr', {}, table.heads)), table.body);
  const section = element(
      'section', {id: 'rows'}, element('h2', {}, 'All rows'), filters, element('div', {class: 'scroll'}, lines));
  const show = (verdict) => {
    byVerdict.querySelector('select').value = verdict;
    table.want('verdict', verdict);
    section.scrollIntoView();
  };
  return {section, show};
}
