// SPDX-License-Identifier: GPL-3.0-or-later
// Writes docs/results.md from the data of scripts/reproduce.mjs.
import { exponentOf, ratioOf, TABLE_1 } from './claims.mjs'
import { fitPower, median } from './fit.mjs'
import { METHODS } from './methods.mjs'
import { count, fixed, percent, power, seconds, table } from './text.mjs'

const OUTCOMES = { yes: 'holds', partly: 'holds in part', no: 'does not hold' }

/** Formats a claim. */
function block({ claim, measured, outcome, why }) {
  const reason = outcome === 'yes' ? '' : ` ${why}`
  return `> **The paper:** ${claim}\n>\n> **Measured:** ${measured}.\n>\n> **${capital(OUTCOMES[outcome])}.**${reason}`
}

function capital(text) {
  return text[0].toUpperCase() + text.slice(1)
}

function picture(name, alt, width) {
  return `<img src="results/${name}.svg" alt="${alt}"${width === undefined ? '' : ` width="${width}"`}>`
}

/** Pictures beside each other, each with a caption. */
function gallery(pictures, width) {
  const cells = pictures.map(([name, caption]) => `<td>${picture(name, '', width)}<br>${caption}</td>`)
  return `<table><tr>${cells.join('')}</tr></table>`
}

export function pageOf(data, claims) {
  return `${[
    head(data),
    method(),
    summary(claims),
    samples(data, claims),
    correctnessSection(data, claims),
    overlappingSection(claims),
    degenerateSection(data, claims),
    timeSection(data, claims),
    beyond(data),
    again(data),
  ].join('\n\n')}\n`
}

function head({ machine }) {
  return `<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Written by \`npm run reproduce\`: change scripts/results, not this page. -->
# The paper's results, run again

This library started from the method of "A dynamic sampling approach towards computing Voronoi diagram of a set of circles"; the copy that we have names no authors.
\`npm run reproduce\` runs the experiments of that paper again and writes this page. Beside each claim it gives the measurement, and
if the claim does not hold, the reason.

| processor | cores | load before | memory | system | compiler | CGAL | Node | commit | run |
|---|---|---|---|---|---|---|---|---|---|
| ${machine.processor} | ${machine.cores} | ${machine.load} | ${machine.memory} GB | ${machine.system} | ${machine.compiler} | ${machine.cgal} | ${machine.node} | ${machine.commit} | ${machine.date}, ${machine.mode} |

Random inputs have the seeds 1, 2 and so on, so counts and pictures are the same on every machine. Times are not. A load above 0
means that other programs used the processor too: then trust the ratios of times, not the times.`
}

function method() {
  return `## The method in a few words

The **Voronoi diagram of circles** gives each circle the region of the plane that is nearer to it than to any other circle. The
paper finds it with discs that touch circles from outside and meet no other circle. The center of a disc that touches two circles
is on an edge of the diagram. The center of a disc that touches three circles is a vertex.

- The **antipodal disc** of two circles is the smallest disc that touches both. If it is *empty*, an edge passes through its center.
  The method starts there with two **directed edges**, one for each way along that edge.
- Discs are taken in the order of their radii. Two directed edges that meet at a circle may form a **three-touch disc**. If
  both are still there when its turn comes, its center is a vertex: the edges end there, and a new edge may begin.
- Trying all pairs of circles takes too long. So sample points are put on the circles, and a pair gets an antipodal disc
  only if samples of the two are neighbors in the Delaunay graph of all samples. **Uniform sampling** puts m points on each
  circle. **Dynamic sampling**, the paper's idea, puts one towards each neighbor in the Delaunay graph of the *centers*, and N_s
  into each angle between two of these.

${gallery(
  [
    ['figure-6-uniform-20', 'uniform, m = 20'],
    ['figure-6-dynamic-0', 'dynamic, N_s = 0'],
    ['figure-6-dynamic-1', 'dynamic, N_s = 1'],
    ['figure-6-dynamic-3', 'dynamic, N_s = 3'],
  ],
  200,
)}

Samples (red) and their Delaunay graph, as in figure 6. A certificate, which the paper does not have, tells afterwards in
linear time whether a diagram is right ([ARCHITECTURE.md](../ARCHITECTURE.md)); \`auto\` is this library's own way to one.`
}

function summary(claims) {
  const rows = Object.values(claims).map(({ claim, outcome }) => [claim, OUTCOMES[outcome].replaceAll(' ', '\u00a0')])
  return `## The claims\n\n${table(['the paper', 'here'], rows)}`
}

function samples({ table1, counts, needed, trials }, claims) {
  const rows = TABLE_1.map((paper) => {
    const row = table1.find(({ n }) => n === paper.n)
    return [
      paper.figure,
      row.n,
      `${paper.onLargest} / ${row.onLargest}`,
      `${paper.onOthers} / ${row.fewestOnOthers}`,
      `${paper.average} / ${fixed(row.average, 3)}`,
    ]
  })
  const neededRows = needed.map(({ family, uniform, dynamic }) => [
    family,
    uniform.nothingMissed.settingForAll ?? 'over 1000',
    dynamic.nothingMissed.settingForAll ?? 'over 1000',
    dynamic.nothingMissed.most === undefined ? '' : fixed(dynamic.nothingMissed.most, 1),
    uniform.right.settingForAll ?? 'over 1000',
    dynamic.right.settingForAll ?? 'over 1000',
    dynamic.right.most === undefined ? '' : fixed(dynamic.right.most, 1),
  ])
  const seeds = new Set(counts.map(({ seed }) => seed)).size
  return `## Samples

### Table 1

${table(['figure', 'circles', 'samples on the largest: paper / here', 'on each other circle', 'on average'], rows)}

${gallery(
  [
    ['figure-7a', 'figure 7a: 49 circles'],
    ['figure-7b', 'figure 7b: 199 circles'],
  ],
  360,
)}

Samples at N_s = 3 and the Delaunay graph of the centers: all circles are neighbors of the one in the middle.

${block(claims.table1)}

${block(claims.thirteen)}

### Figures 5d and 13a

${gallery(
  [
    ['figure-5d', 'the Delaunay graph of the centers'],
    ['figure-13a', 'the diagram, with the samples of N_s = 1'],
  ],
  380,
)}

The circle on the right has radius 600, so you see only its rim. It is a neighbor of the circle on the left, but many steps away
from it in the graph. The paper gives no coordinates; these circles are like those of its figure.

${block(claims.threeSamples)}

### How many samples are needed

${picture('needed-samples', 'Samples a circle that uniform and dynamic sampling need, by family')}

${count(trials.needed)} inputs a family, of 10 to 100 circles. On the left the samples are enough if every pair of circles with
an empty antipodal disc is a candidate, as the paper requires. On the right they are enough if the diagram is right. That takes far
fewer samples, because three-touch discs make up for most missed antipodal discs. Dots are medians, and ticks mark the input that needs
the most. (The samples lie on circles shrunk by the smallest radius, which have the same diagram.)

<details><summary>What all inputs of a family need</summary>

${table(['family', 'm: nothing missed', 'N_s: nothing missed', 'samples a circle at most', 'm: right', 'N_s: right', 'samples a circle at most'], neededRows)}

</details>

${block(claims.fewerSamples)}

### Figure 16a: counts

${picture('counts', 'Samples, antipodal discs and three-touch discs against the number of circles')}

Random circles, N_s = 1, ${seeds} inputs of each size. Exponents are those of the power law that fits best, with 95 % confidence.

${block(claims.samplesLinear)}

${block(claims.discsLinear)}`
}

function correctnessSection({ printed, correctness, trials }, claims) {
  const { family, circles } = printed.counterexample
  const ways = Object.keys(correctness[0].wrong)
  const percentOf = (value) => (value === undefined ? '' : value === 0 ? '0' : percent(value / trials.correctness))
  const printedOf = new Map(printed.families.map((row) => [row.family, row]))
  const rows = correctness.map((row) => {
    const its = printedOf.get(row.family)
    const printedPart = (key) => (its === undefined ? '' : its[key] === 0 ? '0' : percent(its[key] / trials.printed))
    return [row.family, printedPart('wrongOfAllPairs'), ...ways.map((way) => percentOf(row.wrong[way]))]
  })
  return `## Correctness

Every diagram is compared with CGAL's Apollonius graph in exact arithmetic: the circles of all vertices, with their
orientation, and the unbounded edges; for circles in special position after merging vertices that coincide.

${picture('failures', 'Percent of wrong diagrams by family, as printed and corrected')}

${block(claims.printedRules)}

${gallery(
  [
    ['counterexample-right', 'the Voronoi diagram'],
    ['counterexample-printed', 'what the printed rules find'],
  ],
  340,
)}

The smallest counterexample of this run, of the family ${family}: ${circles.length} circles, ${circles.map(([x, y, r]) => `(${[x, y, r].map((value) => fixed(value, 3)).join(', ')})`).join(', ')}. The small
circle has a cell of its own between the two others, whose edge therefore has two parts that go to infinity. The printed rules
mistake the directed edge of one part for that of the other, and join the two vertices by a segment that is no edge.

Where the text of the algorithms leaves a choice, we chose in their favor: \`cpp/printed/printed_algorithm.h\` says how.

${block(claims.exactness)}

<details><summary>Percent of wrong diagrams, all families and ways</summary>

${count(trials.correctness)} inputs a family of 10 to 100 circles (extreme: 5 to 14), ${count(trials.printed)} for the printed rules. "Resampled" takes more samples where the
certificate fails. A field is empty if rounding alone decides the order of discs in that family, or, for the printed rules, if
circles in special position overlap.

${table(['family', 'as printed, all pairs', ...ways], rows)}

</details>

${block(claims.check)}

### Figures 13b and 14

${gallery(
  [
    ['figure-13b', 'figure 13b'],
    ['figure-14-whole', 'figure 14: 100,000 circles, each a dot'],
    ['figure-14-part', 'the small square, enlarged'],
  ],
  280,
)}

${block(claims.severalEdges)}

${block(claims.many)}`
}

function overlappingSection(claims) {
  return `## Circles that intersect or hide one another

${gallery(
  [
    ['figure-12-printed', 'as printed: finished segments (red), leftover directed edges (pink)'],
    ['figure-12', 'corrected: antipodal discs (blue), leftover directed edges (pink)'],
  ],
  380,
)}

These circles are like those of figure 12: three of them intersect mutually, and one (gray) is inside another. With the printed rules,
directed edges are left over inside the three. Signed radii, negative inside an overlap, need no exception: the three circles have a
vertex there, and only the edges of the hull are left over.

${block(claims.overlapping)}`
}

function degenerateSection({ degenerate }, claims) {
  const rows = degenerate.cases.map((its) => [
    its.figure,
    its.family,
    its.n,
    Object.entries(its.degrees)
      .map(([degree, vertices]) => `${vertices} of degree ${degree}`)
      .join(', '),
    its.certifiedByMethod ? 'yes' : 'after merging',
  ])
  const { spread } = degenerate.cases.find(({ figure }) => figure === '15b')
  const { quasiTriangulation: its } = degenerate.cases.find(({ figure }) => figure === '15f')
  return `## Circles in special position

${gallery(
  [
    ['figure-15a', '15a'],
    ['figure-15b', '15b'],
    ['figure-15c', '15c: the middle of 15b'],
  ],
  270,
)}

${gallery(
  [
    ['figure-15d', '15d'],
    ['figure-15e', '15e'],
    ['figure-15f', '15f: quasi-triangulation'],
  ],
  270,
)}

${table(['figure', 'family', 'circles', 'vertices after merging', 'right by dynamic sampling, N_s = 1'], rows)}

In 15b all circles touch one disc, but for the rounding of their coordinates: the vertices lie within ${spread.toPrecision(2)} of each other (the
disc has the radius 50), and 15c shows where. In 15f radii grow from column to column; ${its.squaresOfTwoTriangles} of ${its.squares} squares of the grid have two triangles,
and ${its.trianglesElsewhere === 0 ? 'no triangle lies elsewhere' : `${its.trianglesElsewhere} triangles lie elsewhere`}. "After merging": rounding has chosen edges of length zero that do not fit together exactly.

${block(claims.degenerate)}

${block(claims.aroundOneDisc)}`
}

function timeSection({ times }, claims) {
  const sizes = [...new Set(times.map(({ n }) => n))]
  const rowOf = (name, n) => times.find((row) => row.method === name && row.n === n)
  const rows = Object.entries(METHODS).map(([name, text]) => {
    const own = sizes.filter((n) => rowOf(name, n))
    const from = own.length > 4 && own.at(-1) > 2000 ? 1000 : own[0]
    return [
      text,
      ...sizes.map((n) => (rowOf(name, n) ? seconds(median(rowOf(name, n).repetitions)) : '')),
      power(exponentOf(times, name, from)),
    ]
  })
  const { n, ratio } = ratioOf(times, 'cgal-hierarchy', 'auto')
  return `## Time

### Figures 16b and c

${picture('times', 'Seconds of each method against the number of circles')}

Random circles, all methods in one run on the same circles, in turns; medians of ${times[0].repetitions.length} repetitions. Ratios are computed
within each repetition; the table has their medians. The exponents are fitted from 1,000 circles on, or for slow methods from the first size.

${table(['', ...sizes.map(count), 'exponent'], rows)}

\`auto\` takes ${fixed(ratio, 1)} times less than CGAL's filtered hierarchy at ${count(n)} circles, its proof included.

${block(claims.loglinear)}

${block(claims.exactSlower)}

${block(claims.hierarchy)}

${block(claims.uniformSlower)}

${block(claims.delaunayDecides)}`
}

function beyond({ large, wasm }) {
  const fit = fitPower(large.map((row) => ({ x: row.n, y: row.seconds })))
  const largeRows = large.map((row) => [
    count(row.n),
    seconds(row.seconds),
    `${fixed((1e6 * row.seconds) / row.n, 2)} µs`,
    `${count(Math.round(row.peakMegabytes))} MB`,
    count(Math.round((1e6 * row.peakMegabytes) / row.n)),
  ])
  const wasmRows = wasm.map((row) => [
    row.family,
    count(row.n),
    seconds(row.native),
    seconds(row.wasm),
    fixed(row.ratio, 2),
  ])
  return `## Beyond the paper

Two parts have no counterpart in the paper: \`auto\`, certified, with up to ten million circles, and the browser.

${picture('large', 'Time and memory a circle of auto against the number of circles')}

${table(['circles', 'time', 'a circle', 'memory at the peak', 'bytes a circle'], largeRows)}

The time is ${power(fit)}. The memory includes the circles and the program.

WebAssembly in Node against the native program, on the same circles, in turns:

${table(['family', 'circles', 'native', 'WebAssembly', 'times'], wasmRows)}`
}

function again({ trials }) {
  return `## Run it again

    npm run reproduce              writes this page and its pictures
    npm run reproduce -- --quick   a smaller run in build/results; \`npm run test:long\` runs it and asserts Table 1 and each outcome

${count(trials.correctness)} inputs of each family are compared with CGAL; \`build/results/data.json\` has all numbers of the last run.`
}
