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
    {title: 'subject', text: (r) => r.subject},
    {title: 'measure', text: (r) => r.measure},
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

/** A section with the table; show(verdict) filters it from elsewhere. */
function rowsSection(results) {
  const rows = flatRows(results), columns = rowColumns(Boolean(results.against));
  const wanted = {text: '', verdict: '', tier: '', id: ''}, sorting = {column: -1, falling: false};
  const body = element('tbody'), shown = element('span', {class: 'shown', 'aria-live': 'polite'});
  const heads = columns.map(
      (column, k) => element(
          'th', {scope: 'col', class: column.number ? 'n' : undefined},
          element(
              'button', {
                type: 'button',
                onclick: () => {
                  sorting.falling = sorting.column === k && !sorting.falling;
                  sorting.column = k;
                  fill();
                }
              },
              column.title)));
  const fits = (row) => {
    const words = wanted.text.toLowerCase().split(/\s+/).filter(Boolean);
    const text = `${row.id} ${row.subject} ${row.measure} ${row.because} ${row.verdict}`.toLowerCase();
    const judged =
        wanted.verdict === 'not green' ? !isGreen(row.verdict) : !wanted.verdict || row.verdict === wanted.verdict;
    return judged && (!wanted.tier || String(row.tier) === wanted.tier) && (!wanted.id || row.id === wanted.id) &&
        words.every((w) => text.includes(w));
  };
  const fill = () => {
    const kept = rows.filter(fits);
    if (sorting.column >= 0) {
      const key = columns[sorting.column].key || columns[sorting.column].text;
      kept.sort((a, b) => (sorting.falling ? -1 : 1) * inOrder(key(a), key(b)));
    }
    heads.forEach(
        (head, k) => head.setAttribute(
            'aria-sort',
            k !== sorting.column ? 'none' :
                sorting.falling  ? 'descending' :
                                   'ascending'));
    body.replaceChildren(...kept.map((row) => rowElement(row, columns)));
    shown.textContent = kept.length === rows.length ? `${rows.length} rows` : `${kept.length} of ${rows.length} rows`;
  };
  const set = (name) => (value) => {
    wanted[name] = value;
    fill();
  };
  const verdicts = ['not green', ...verdictOrder.filter((v) => rows.some((row) => row.verdict === v))];
  const verdictChooser = chooser('verdict', 'all', verdicts, set('verdict'));
  const filters = element(
      'div', {class: 'filters'}, element('label', {}, 'filter ', element('input', {
                                           type: 'search',
                                           id: 'filter',
                                           placeholder: 'words, e.g. cubic apic',
                                           oninput: (event) => set('text')(event.target.value)
                                         })),
      verdictChooser, chooser('tier', 'all', [...new Set(rows.map((r) => r.tier))].sort(), set('tier')),
      chooser('case', 'all', results.cases.map((one) => one.id), set('id')), shown);
  fill();
  const section = element(
      'section', {id: 'rows'}, element('h2', {}, 'All rows'), filters,
      element(
          'div', {class: 'scroll'},
          element('table', {id: 'all-rows'}, element('thead', {}, element('tr', {}, heads)), body)));
  return {
    section,
    show: (verdict) => {
      verdictChooser.querySelector('select').value = verdict;
      set('verdict')(verdict);
      section.scrollIntoView();
    }
  };
}
