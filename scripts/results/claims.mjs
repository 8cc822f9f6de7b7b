// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's claims, each with its measurement and whether it holds. `expected` is the known outcome; `npm run
// reproduce` reports any other.
import { fitPower, median } from './fit.mjs'
import { count, fixed, percent, power } from './text.mjs'

/** The paper's Table 1 (N_s = 3). */
export const TABLE_1 = [
  { figure: '7a', n: 49, onLargest: 192, onOthers: 9, average: '12.735' },
  { figure: '7b', n: 199, onLargest: 792, onOthers: 9, average: '12.935' },
]

/** The paper's own methods, without resampling. */
const SAMPLED_WAYS = ['N_s = 0', 'N_s = 1', 'N_s = 3']

/** Returns 'yes', 'partly' or 'no', by how many of several conditions hold. */
function outcomeOf(holding, all) {
  if (holding === all) return 'yes'
  return holding === 0 ? 'no' : 'partly'
}

/** The claims in the order of the page, each under the name by which the page refers to it. */
export function claimsOf(data) {
  return {
    table1: table1(data.table1),
    thirteen: thirteen(data.table1),
    threeSamples: threeSamples(data.figures['5d']),
    fewerSamples: fewerSamples(data.needed),
    samplesLinear: samplesLinear(data.counts),
    discsLinear: discsLinear(data.counts),
    exactness: exactness(data),
    printedRules: printedRules(data),
    check: check(data.correctness),
    severalEdges: severalEdges(data.figures['13b']),
    many: many(data.figures[14]),
    overlapping: overlapping(data),
    degenerate: degenerate(data),
    aroundOneDisc: aroundOneDisc(data.degenerate.aroundOneDisc),
    loglinear: loglinear(data.times),
    exactSlower: exactSlower(data.times),
    hierarchy: hierarchy(data.times),
    uniformSlower: uniformSlower(data.times),
    delaunayDecides: delaunayDecides(data.counts),
  }
}

function table1(rows) {
  const isSame = ({ n, onLargest, onOthers, average }) => {
    const row = rows.find((candidate) => candidate.n === n)
    return (
      row?.onLargest === onLargest &&
      row.fewestOnOthers === onOthers &&
      row.mostOnOthers === onOthers &&
      row.average.toFixed(3) === average
    )
  }
  return {
    claim: 'Table 1: how many samples the circles of figure 7 get at N_s = 3.',
    measured: 'the same numbers, all of them',
    outcome: outcomeOf(TABLE_1.filter(isSame).length, TABLE_1.length),
    expected: 'yes',
  }
}

function thirteen(rows) {
  const averages = rows.map(({ average }) => average)
  return {
    claim: 'In the configuration of figure 7 the average has an upper bound of 13 samples a circle, at N_s = 3.',
    measured: `${averages.map((average) => fixed(average, 3)).join(' and ')} samples a circle`,
    outcome: outcomeOf(averages.filter((average) => average < 13).length, averages.length),
    expected: 'yes',
  }
}

function threeSamples({ samplesOnLargest, areNeighbors, certified, stepsBetweenCenters }) {
  return {
    claim: 'In figure 5d (13a) three samples on the largest circle are enough, at N_s = 1.',
    measured: `${samplesOnLargest} samples on the largest circle; its neighbor is ${stepsBetweenCenters} steps away in the Delaunay graph of the centers; the diagram is ${certified ? '' : 'not '}certified`,
    outcome: outcomeOf(Number(samplesOnLargest === 3 && areNeighbors && certified), 1),
    expected: 'yes',
  }
}

function fewerSamples(needed) {
  const compared = needed.filter(({ uniform, dynamic }) => uniform.nothingMissed.most && dynamic.nothingMissed.most)
  const isFewer = ({ uniform, dynamic }) => dynamic.nothingMissed.most < uniform.nothingMissed.most
  const fewer = compared.filter(isFewer)
  const ratio = ({ uniform, dynamic }) => uniform.nothingMissed.most / dynamic.nothingMissed.most
  const best = [...compared].sort((a, b) => ratio(b) - ratio(a))[0]
  return {
    claim: 'Dynamic sampling needs fewer samples than uniform sampling.',
    measured: `in ${fewer.length} of ${compared.length} families (${fewer.map(({ family }) => family).join(', ')}); most clearly in ${best.family}, ${fixed(best.dynamic.nothingMissed.most, 1)} a circle against ${best.uniform.nothingMissed.most}`,
    outcome: outcomeOf(fewer.length, compared.length),
    expected: 'partly',
    why: 'Dynamic sampling takes about 6 (N_s + 1) samples a circle for all families. If the circles have similar sizes, a handful of equally spaced samples finds the same discs. If one circle has many neighbors, uniform sampling must give every circle as many samples as that circle needs. There dynamic sampling saves a factor of ten and more.',
  }
}

function samplesLinear(counts) {
  const fit = fitPower(counts.map(({ n, samples }) => ({ x: n, y: samples })))
  const perCircle = atLargest(counts, 'samples')
  return {
    claim: 'The number of samples is linear in the number of circles, about 12 a circle at N_s = 1 (figure 16a).',
    measured: `${fixed(perCircle, 2)} a circle; ${power(fit)}`,
    outcome: outcomeOf(Number(fit.slope < 1.05 && perCircle > 11 && perCircle < 12.5), 1),
    expected: 'yes',
  }
}

function discsLinear(counts) {
  const fitOf = (key) => fitPower(counts.map((row) => ({ x: row.n, y: row[key] })))
  const fits = [fitOf('antipodalDiscs'), fitOf('threeTouchDiscs')]
  return {
    claim: 'The numbers of antipodal and of three-touch discs are linear too.',
    measured: `${fixed(atLargest(counts, 'antipodalDiscs'), 2)} antipodal discs a circle, ${power(fits[0])}; ${fixed(atLargest(counts, 'threeTouchDiscs'), 2)} three-touch discs, ${power(fits[1])}`,
    outcome: outcomeOf(fits.filter(({ slope }) => slope < 1.05).length, fits.length),
    expected: 'yes',
  }
}

/** The count per circle for the largest input. */
function atLargest(counts, key) {
  const largest = Math.max(...counts.map(({ n }) => n))
  return median(counts.filter(({ n }) => n === largest).map((row) => row[key] / row.n))
}

function exactness({ correctness, trials }) {
  const rows = correctness.filter(({ wrong }) => 'N_s = 1' in wrong)
  const right = rows.filter(({ wrong }) => wrong['N_s = 1'] === 0)
  const worst = [...rows].sort((a, b) => b.wrong['N_s = 1'] - a.wrong['N_s = 1'])[0]
  return {
    claim: 'Dynamic sampling with N_s = 1 leads to the right diagram.',
    measured: `right in all ${trials.correctness} inputs of each of ${right.length} families out of ${rows.length}; worst in ${worst.family}, where ${percent(worst.wrong['N_s = 1'] / trials.correctness)} are wrong`,
    outcome: outcomeOf(right.length, rows.length),
    expected: 'partly',
    why: 'Samples cover a circle at a few points only, so the method may miss an empty antipodal disc between two samples. Three-touch discs do not make up for every missed disc, so no fixed N_s is safe. This library therefore proves each result. With the option `resample` it takes more samples where the proof fails.',
  }
}

function printedRules({ printed, correctness, trials }) {
  const disjoint = printed.families.filter(({ isDisjoint }) => isDisjoint)
  const right = disjoint.filter(({ wrongOfAllPairs }) => wrongOfAllPairs === 0)
  const worst = disjoint.filter(({ wrongOfAllPairs }) => wrongOfAllPairs === trials.printed)
  const corrected = correctness.reduce((sum, { wrong }) => sum + (wrong['all pairs'] ?? 0), 0)
  return {
    claim: 'Algorithms 1 to 4 compute the Voronoi diagram of circles that do not intersect (lemma 3).',
    measured: `as printed, and with every pair as a candidate, in ${right.length} of ${disjoint.length} families; in ${worst.length} (${worst.map(({ family }) => family).join(', ')}) no result is right. With the corrected rules ${corrected === 0 ? 'none is wrong' : `${corrected} are wrong`} in any family`,
    outcome: right.length === disjoint.length ? 'yes' : 'no',
    expected: 'no',
    why: 'Algorithm 3 accepts any directed edge between the third pair of circles as the third edge of a three-touch disc. Two circles with a smaller circle between them have two Voronoi edges, and the directed edge may belong to the other edge. The picture shows the result.',
  }
}

function check(correctness) {
  const sum = (key) =>
    correctness.reduce((total, row) => total + SAMPLED_WAYS.reduce((some, way) => some + (row[key][way] ?? 0), 0), 0)
  const wrong = sum('wrong')
  const passed = sum('passed')
  const misjudged = correctness.filter((row) => row.misjudged !== '').length
  return {
    claim: 'That the leftover directed edges form one cycle shows that the diagram is right (section 7).',
    measured: `of ${count(wrong)} wrong diagrams ${count(passed)} pass that check; the certificate of this library accepts ${misjudged === 0 ? 'none' : 'some'} of them, and refuses no right one in general position`,
    outcome: passed === 0 ? 'yes' : 'no',
    expected: 'no',
    why: 'The check is necessary but not sufficient: if a neighbor inside the hull is missed, the cycle does not change.',
  }
}

function severalEdges({ certified, pairsOfSeveralEdges, cellsOfTwoEdges, convexCells }) {
  return {
    claim: 'Convex cells, several edges between two circles, and cells with two edges come out right (figure 13b).',
    measured: `${count(convexCells)} convex cells, ${count(pairsOfSeveralEdges)} pair with several edges, ${count(cellsOfTwoEdges)} cells with two edges; ${certified ? '' : 'not '}certified`,
    outcome: outcomeOf(Number(certified && pairsOfSeveralEdges > 0 && cellsOfTwoEdges > 0 && convexCells > 0), 1),
    expected: 'yes',
  }
}

function many({ n, certified }) {
  return {
    claim: 'The method copes with 100,000 random circles (figure 14).',
    measured: `${count(n)} circles, ${certified ? '' : 'not '}certified`,
    outcome: outcomeOf(Number(certified), 1),
    expected: 'yes',
  }
}

function overlapping({ printed, correctness, trials }) {
  const rows = printed.families.filter(({ isDisjoint }) => !isDisjoint)
  const right = rows.filter(({ wrongOfAllPairs }) => wrongOfAllPairs === 0)
  const wrong = rows.reduce((sum, { wrongOfAllPairs }) => sum + wrongOfAllPairs, 0)
  const corrected = correctness
    .filter(({ isDisjoint }) => !isDisjoint)
    .reduce((sum, row) => sum + (row.wrong['all pairs'] ?? 0), 0)
  return {
    claim: 'Intersecting circles, and circles that another one hides, are handled outside all circles (section 9).',
    measured: `as printed, and with every pair as a candidate, ${percent(wrong / rows.length / trials.printed)} of such inputs come out wrong there, in ${rows.length - right.length} of ${rows.length} families; with the corrected rules ${corrected === 0 ? 'none does' : `${corrected} do`}, and inside the circles neither`,
    outcome: wrong === 0 ? 'yes' : 'no',
    expected: 'no',
    why: 'The antipodal disc of two intersecting circles may meet a third circle like any other disc, so the method must check whether it is empty. Hidden circles that are not removed displace the neighbors of the circle that contains them. With signed radii, and with hidden circles removed first, neither case needs special rules.',
  }
}

function degenerate({ degenerate: { cases }, correctness }) {
  const only = (degrees, degree) => Object.keys(degrees).every((key) => key === degree)
  const isRight = {
    '15a': ({ degrees }) => degrees[24] === 1,
    '15b': ({ degrees }) => degrees[100] === 1 && only(degrees, '100'),
    '15d': ({ degrees }) => degrees[4] === 81 && only(degrees, '4'),
    '15e': ({ degrees }) => degrees[4] === 81 && only(degrees, '4'),
    '15f': ({ degrees, quasiTriangulation: its }) =>
      only(degrees, '4') && its.squaresOfTwoTriangles === its.squares && its.trianglesElsewhere === 0,
  }
  const right = cases.filter((its) => its.certifiedByAuto && isRight[its.figure](its))
  const wrong = correctness
    .filter(({ isDegenerate }) => isDegenerate)
    .reduce((sum, row) => sum + (row.wrong['N_s = 1'] ?? 0), 0)
  return {
    claim: 'Circles in non-general position need no perturbation (figure 15).',
    measured: `${right.length} of ${cases.length} cases have exactly the vertices of higher degree that they should; of random inputs of the degenerate families ${wrong === 0 ? 'none is' : `${wrong} are`} wrong after merging, at N_s = 1`,
    outcome: outcomeOf(Number(right.length === cases.length && wrong === 0), 1),
    expected: 'yes',
  }
}

function aroundOneDisc(rows) {
  const most = Math.max(...rows.map(({ n, threeTouchDiscs }) => threeTouchDiscs / n))
  return {
    claim: 'At most 3 n three-touch discs are formed where all n circles touch one disc (section 8.1).',
    measured: `${fixed(most, 2)} n at most, for n = ${rows[0].n} to ${count(rows.at(-1).n)}`,
    outcome: outcomeOf(Number(most <= 3), 1),
    expected: 'yes',
  }
}

/** The exponent of a method's time for at least `from` circles. */
export function exponentOf(times, method, from) {
  const points = times
    .filter((row) => row.method === method && row.n >= from)
    .flatMap(({ n, repetitions }) => repetitions.map((seconds) => ({ x: n, y: seconds })))
  return fitPower(points)
}

/** The ratio of two methods' times for the largest input that both have. */
export function ratioOf(times, slow, fast) {
  const rowOf = (method, n) => times.find((row) => row.method === method && row.n === n)
  const n = Math.max(...times.map((row) => row.n).filter((size) => rowOf(slow, size) && rowOf(fast, size)))
  const [numerator, denominator] = [rowOf(slow, n).repetitions, rowOf(fast, n).repetitions]
  return { n, ratio: median(numerator.map((seconds, k) => seconds / denominator[k])) }
}

function loglinear(times) {
  const dynamic = exponentOf(times, 'touching-disc-1', 1000)
  const allPairs = exponentOf(times, 'touching-disc-all-pairs', 100)
  return {
    claim: 'The time of dynamic sampling is O(n log n), where all pairs take O(n²).',
    measured: `dynamic sampling ${power(dynamic)} from 1,000 circles on (n log n itself has 1.1 there); all pairs ${power(allPairs)}`,
    // Only a clearly different exponent refutes the claim.
    outcome: outcomeOf(
      Number(dynamic.slope - dynamic.halfWidth < 1.25 && allPairs.slope + allPairs.halfWidth > 1.75),
      1,
    ),
    expected: 'yes',
  }
}

function exactSlower(times) {
  const { n, ratio } = ratioOf(times, 'cgal-exact', 'touching-disc-1')
  return {
    claim: 'Dynamic sampling is faster than CGAL with an exact number type.',
    measured: `${fixed(ratio, 1)} times faster at ${count(n)} circles`,
    outcome: outcomeOf(Number(ratio > 1), 1),
    expected: 'yes',
  }
}

function hierarchy(times) {
  const { n, ratio } = ratioOf(times, 'touching-disc-1', 'cgal-hierarchy')
  return {
    claim: "Its time is comparable to that of CGAL's filtered hierarchy (within a factor of 3).",
    measured: `${fixed(ratio, 2)} times CGAL's at ${count(n)} circles`,
    outcome: outcomeOf(Number(ratio < 3 && ratio > 1 / 3), 1),
    expected: 'yes',
  }
}

function uniformSlower(times) {
  const { n, ratio } = ratioOf(times, 'touching-disc-uniform-50', 'touching-disc-1')
  return {
    claim: 'Uniform sampling with 50 samples a circle takes longer.',
    measured: `${fixed(ratio, 1)} times as long at ${count(n)} circles`,
    outcome: outcomeOf(Number(ratio > 1), 1),
    expected: 'yes',
  }
}

function delaunayDecides(counts) {
  const largest = Math.max(...counts.map(({ n }) => n))
  const rows = counts.filter(({ n }) => n === largest)
  const part = (key) => median(rows.map(({ seconds }) => seconds[key] / seconds.total))
  return {
    claim: 'The Delaunay graph of the samples decides the time; computing touching discs does not take much.',
    measured: `at ${count(largest)} circles the graph of the samples takes ${percent(part('pair'))} of the time, the discs and directed edges ${percent(part('touch'))}`,
    outcome: part('touch') < 0.1 ? 'yes' : part('pair') > 0.25 ? 'partly' : 'no',
    expected: 'partly',
    why: 'Discs in the order of their radii lie all over the plane, so each step waits for memory. The triangulation of this library works on neighbors.',
  }
}
