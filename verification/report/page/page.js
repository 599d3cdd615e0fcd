// The page, from top to bottom.

function tile(number, label, verdict, show) {
  return element(
      'button', {type: 'button', class: `tile ${verdict}`, disabled: number === 0, onclick: () => show(verdict)},
      element('b', {}, String(number)), label);
}

function headline(results, show) {
  const {totals, provenance} = results;
  const red = totals.fail + totals.floored + totals.error;
  const tiers = [...new Set(results.cases.map((one) => one.tier))].sort();
  const git = provenance.build?.git || {};
  const facts = [
    `version ${provenance.version}`,
    git.commit ? `commit ${git.commit.slice(0, 10)}${git.dirty ? ' with changes' : ''}` : null, provenance.start,
    `tier ${tiers.join(', ')}`, `${results.cases.length} cases in ${durationText(results.seconds) || '0 s'}`,
    `${results.jobs} at a time`
  ];
  const labels =
      {pass: 'passed', fail: 'failed', floored: 'floored', error: 'errors', omitted: 'omitted', noted: 'noted'};
  return element(
      'header', {}, element('div', {class: 'top'}, element('h1', {}, 'Talus: verification'), themeButton()),
      element(
          'p', {class: `outcome ${results.green ? 'pass' : 'fail'}`},
          results.green ? 'Everything that was asked for holds.' :
                          `${red} row${red === 1 ? ' is' : 's are'} not as asked.`),
      element(
          'div', {class: 'tiles'},
          Object.entries(labels).map(([verdict, label]) => tile(totals[verdict], label, verdict, show))),
      element('p', {class: 'dim'}, facts.filter(Boolean).join(' · ')));
}

function themeButton() {
  const root = document.documentElement;
  const dark = () =>
      root.dataset.theme ? root.dataset.theme === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
  return element(
      'button', {
        type: 'button',
        class: 'theme',
        title: 'light or dark',
        'aria-label': 'Change between light and dark',
        onclick: () => {
          root.dataset.theme = dark() ? 'light' : 'dark';
        }
      },
      '◐');
}

function worstOf(rows) {
  return ['error', 'fail', 'floored'].find((verdict) => rows.some((row) => row.verdict === verdict)) || 'pass';
}

function casesSection(results) {
  const columns = [
    {title: 'case'}, {title: 'what', wide: 'wide'}, {title: 'tier', number: true}, {title: 'verdict'},
    {title: 'passed', number: true}, {title: 'time', number: true}, {title: 'memory', number: true}
  ];
  const rows = results.cases.map((one) => {
    const asked = one.rows.filter((row) => !['noted', 'omitted'].includes(row.verdict));
    const passed = asked.filter((row) => row.verdict === 'pass').length;
    return [
      element('a', {href: '#' + anchorOf(one.id)}, one.id), one.title, String(one.tier),
      verdictBadge(worstOf(one.rows)), `${passed} / ${asked.length}`, durationText(one.seconds),
      memoryText(one.peak_memory)
    ];
  });
  return element('section', {id: 'cases'}, element('h2', {}, 'Cases'), tableOf(columns, rows));
}

function againstSection(results) {
  const {against} = results;
  if (!against) return null;
  const told = against.changes.filter((change) => !change.verdict || !change.earlier_verdict || verdictMoved(change));
  const moved =
      against.changes.filter((change) => change.verdict && change.earlier_verdict && change.text !== 'same').length;
  const items = told.map(
      (change) => element(
          'li', {}, `${change.case}, ${change.subject}: ${change.measure} `,
          verdictMoved(change) ?
              [
                verdictBadge(change.earlier_verdict), ' → ', verdictBadge(change.verdict),
                ` (${valueText(numberOf(change, 'earlier'), change.unit)} → ${
                    valueText(numberOf(change, 'found'), change.unit)})`
              ] :
              element('b', {}, change.text)));
  items.push(...against.not_run.map((id) => element('li', {}, `${id} was not run now`)));
  return element(
      'section', {id: 'against'}, element('h2', {}, 'Against an earlier run'),
      element(
          'p', {},
          `${against.folder}, version ${against.version}, ${against.start}: ${moved} value${
              moved === 1 ? ' has' : 's have'} changed; the table of all rows shows each.`),
      items.length ? element('ul', {}, items) :
                     element('p', {class: 'dim'}, 'No verdict has changed, no row is new or gone.'));
}

function caseSection(one) {
  const fact = (name, ...what) => [element('dt', {}, name), element('dd', {}, ...what)];
  const columns = rowColumns(false).slice(1);
  const rows = one.rows.map((row) => ({...row, id: one.id, value: numberOf(row, 'found')}));
  const lines = rows.map((row) => rowElement(row, columns));
  const took = [durationText(one.seconds), durationText(one.processor_seconds), memoryText(one.peak_memory)];
  return element(
      'section', {class: 'case', id: anchorOf(one.id)}, element('h3', {}, one.id, ' ', verdictBadge(worstOf(one.rows))),
      element('p', {class: 'title'}, one.title),
      element(
          'dl', {}, fact('compared with', one.truth), fact('source', ...withLinks(one.source)),
          fact('file', element('code', {}, `verification/cases/${one.id}.cpp`)),
          fact('took', `${took[0] || '0 s'}; of processors ${took[1] || '0 s'}; ${took[2]}`)),
      element('div', {class: 'charts'}, one.plots.map(chartFigure)),
      element(
          'details', {open: rows.length <= 12},
          element('summary', {}, `${rows.length} row${rows.length === 1 ? '' : 's'}`), tableOf(columns, lines)));
}

function provenanceSection(results) {
  return element(
      'section', {id: 'provenance'}, element('h2', {}, 'Where this comes from'),
      element(
          'details', {}, element('summary', {}, 'program, build, machine and command'),
          element('pre', {}, JSON.stringify(results.provenance, null, 2))));
}

function contents(sections) {
  return element(
      'nav', {'aria-label': 'Contents'},
      sections.filter(Boolean).map(
          (section) => element('a', {href: '#' + section.id}, section.querySelector('h2').textContent)));
}

const results = JSON.parse(document.getElementById('results').textContent);
const table = rowsSection(results);
const each = element('section', {id: 'each'}, element('h2', {}, 'Case by case'), results.cases.map(caseSection));
const sections = [
  casesSection(results), againstSection(results), table.section, workSection(results), each, provenanceSection(results)
];
document.getElementById('page').append(headline(results, table.show), contents(sections), ...sections.filter(Boolean));
