// Work-precision: what a given error costs, by kernel, transfer and particles.

const soughtErrors = [0.1, 0.03, 0.01, 0.003, 0.001];

/** Points by problem and error. */
function workProblems(results) {
  const problems = new Map();
  for (const one of results.cases)
    for (const point of one.work) {
      const error = numberOf(point, 'error'), seconds = numberOf(point.cost, 'seconds');
      if (!(error > 0) || !(seconds > 0) || !Number.isFinite(error)) continue;
      const name = `${point.problem}: error of ${point.error_name}`;
      if (!problems.has(name)) problems.set(name, []);
      problems.get(name).push({...point, error, seconds, cells: numberOf(point, 'cells')});
    }
  return problems;
}

/** Those that no other beats in both error and time, from fast to slow. */
function paretoFront(points) {
  const front = [];
  let least = Infinity;
  for (const point of [...points].sort((a, b) => a.seconds - b.seconds || a.error - b.error))
    if (point.error < least) front.push(point), least = point.error;
  return front;
}

const schemeOf = (point) => `${point.kernel}, ${point.transfer}`;
const pointText = (point) => `${schemeOf(point)}, ${point.per_direction} per direction, ${digits(point.cells)} cells`;

/** A curve a scheme and number of particles, from coarse to fine; then the front. */
function workCurves(points, front) {
  const schemes = [...new Set(points.map(schemeOf))],
        counts = [...new Set(points.map((p) => p.per_direction))].sort((a, b) => a - b);
  const curves = [];
  for (const scheme of schemes)
    for (const many of counts) {
      const own =
          points.filter((p) => schemeOf(p) === scheme && p.per_direction === many).sort((a, b) => a.cells - b.cells);
      if (own.length)
        curves.push({
          name: `${scheme}, ${many}`,
          x: own.map((p) => p.seconds),
          y: own.map((p) => p.error),
          kind: 'thin',
          colour: schemes.indexOf(scheme),
          marker: markerShapes[counts.indexOf(many) % 5],
          notes: own.map((p) => `${digits(p.cells)} cells`)
        });
    }
  if (front.length > 1)
    curves.push({
      name: 'Pareto front',
      x: front.map((p) => p.seconds),
      y: front.map((p) => p.error),
      kind: 'front',
      colour: 0,
      marker: 'circle'
    });
  return curves;
}

/** The cheapest point whose error is below each of the sought ones. */
function cheapestTable(front) {
  const columns = [
    {title: 'error', number: true}, {title: 'scheme'}, {title: 'time', number: true},
    {title: 'its error', number: true}, {title: 'particle-steps', number: true}
  ];
  const rows = soughtErrors.map((error) => {
    const sought = `${digits(100 * error)} %`, point = front.find((p) => p.error <= error);
    if (!point) return [sought, element('span', {class: 'dim'}, 'none of these reaches it'), '', '', ''];
    const steps = largeText(point.cost.particle_steps);
    return [sought, pointText(point), durationText(point.seconds), `${digits(100 * point.error, 2)} %`, steps];
  });
  return tableOf(columns, rows, {class: 'cheapest', caption: 'The cheapest way to an error below'});
}

function workSection(results) {
  const problems = workProblems(results);
  if (!problems.size) return null;
  const diagrams = [...problems].map(([name, points]) => {
    const front = paretoFront(points);
    return element(
        'div', {class: 'work'}, chartFigure({
          title: name,
          x_label: 'time of the run [s]',
          y_label: 'relative error [1]',
          log_x: true,
          log_y: true,
          curves: workCurves(points, front)
        }),
        cheapestTable(front));
  });
  return element(
      'section', {id: 'work'}, element('h2', {}, 'Error against time'),
      element(
          'p', {class: 'dim'},
          'Each line is one scheme from coarse to fine; colours are kernel and transfer, markers the particles per ' +
              'direction in a cell. What lies on the Pareto front is beaten by none in both error and time.'),
      diagrams);
}
