// SPDX-License-Identifier: GPL-3.0-or-later
/** The kinds of steps that a reader can search for. */
export type StepKind = 'stage' | 'disc' | 'edge' | 'vertex' | 'rejected' | 'circle'

/** The targets of "go to next": a kind of step, the selected circle, or a breakpoint. */
export type Goal = StepKind | 'selected' | 'breakpoint'

/** The player's texts. */
export interface PlayerWords {
  /** The language of the texts, as a value of the attribute `lang`. */
  readonly lang: string
  readonly goals: Readonly<Record<Goal, string>>
  readonly running: string
  readonly notRun: string
  /** Localizes the reason why nothing can be played. The messages of errors are English. */
  told?(error: Error): string
  readonly stepLabel: string
  stepOf(step: number, last: number): string
  readonly back: string
  readonly play: string
  readonly pause: string
  readonly forth: string
  readonly speed: string
  readonly ask: string
  readonly breakHere: string
  readonly previous: string
  readonly goal: string
  readonly next: string
  readonly howItWorks: string
  readonly whatNext: string
  readonly right: string
  wrong(answer: string): string
  score(right: number, asked: number): string
  queue(count: number): string
  more(count: number): string
  readonly around: string
  readonly selectOne: string
  aroundCircle(id: number, isSelected: boolean): string
  ring(id: number, marks: readonly { readonly isOut: boolean; readonly other: number }[]): string
  readonly ringNote: string

  /** The titles and lines of the algorithms. */
  readonly titles: Readonly<Record<'prepare' | 'loop' | 'antipodal' | 'threeTouch' | 'end' | 'flips' | 'edit', string>>
  readonly lines: Readonly<Record<PseudocodeLine, string>>

  given(circles: number, hidden: number): string
  centers(edges: number): string
  readonly angles: string
  samples(count: number): string
  sampleGraph(edges: number): string
  pairs(count: number): string
  used(circles: readonly number[]): string
  notEmpty(a: number, b: number, c: number): string
  place(a: number, b: number, tested: readonly number[]): string
  form(discs: readonly string[]): string
  disc(name: string, radius: string): string
  stale(name: string): string
  branch(circles: readonly number[], place: string, radius: string): string
  finish(edges: readonly string[]): string
  placeThird(edge: string): string
  again(round: number): string
  readonly ties: string
  flipDiscs(count: number): string
  editBegin(vertices: number): string
  hull(left: number): string
  readonly flipDone: string
  readonly editDone: string
  readonly proven: string
  refused(message: string): string
  takenTriple(circles: readonly number[], radius: string): string
  takenPair(circles: readonly number[], radius: string, tested: readonly number[]): string
  come(id: number, place: string, radius: string): string
  gone(id: number): string
  moved(id: number, place: string, radius: string): string
  discMissing(a: number, b: number, c: number): string
  tangentNotClear(a: number, b: number, c: number): string
  hullNotConvex(a: number, b: number, c: number): string
  shrunk(a: number, radius: string): string
  discNotEmpty(a: number, b: number, c: number, radius: string): string
  flip(from: string, to: string): string
  allNew(names: readonly string[]): string
  allGone(names: readonly string[]): string
  discMoves(circles: readonly number[]): string
  triangles(removed: number, made: number): string

  askAntipodal(a: number, b: number): string
  readonly antipodalAnswers: readonly [empty: string, meets: string, used: string]
  askThreeTouch(circles: readonly number[]): string
  readonly threeTouchAnswers: readonly [one: string, three: string, nothing: string]
  askFlip(edge: string): string
}

const plural = (count: number, one: string, many = `${one}s`) => `${count} ${count === 1 ? one : many}`

function list(items: readonly (number | string)[]): string {
  return items.length < 2 ? items.join('') : `${items.slice(0, -1).join(', ')} and ${items.at(-1)}`
}

const circles = (ids: readonly number[]) => (ids.length === 1 ? `circle ${ids[0]}` : `circles ${list(ids)}`)

const becauseOutside = (ids: readonly number[]) =>
  ids.length === 0 ? '' : `, because ${circles(ids)} ${ids.length === 1 ? 'does' : 'do'} not reach into it`

const LINES = {
  begin: 'Given: circles; those inside others are left out',
  centers: 'T ← Delaunay graph of the centers',
  angles: 'divide the angle of each triangle at each center',
  samples: 'put a sample where each edge and each dividing ray leaves its circle',
  sampleGraph: 'D ← Delaunay graph of the samples',
  pairs: 'L ← an antipodal disc for every two circles with an edge in D, by radius',
  take: 'while L is not empty: take its smallest disc',
  used: 'if a foot lies where another border has already passed: throw the disc away',
  notEmpty: 'if another circle reaches into it: throw it away',
  place: 'else it is empty: place directed edges a→b and b→a',
  form: 'put the three-touch discs with the next directed edges into L',
  stale: 'if a→b or b→c has ended, or they are no longer next to each other: throw the disc away',
  branch: 'else it is empty: its center is a vertex',
  finish: 'a→b and b→c end there, and so does c→a if it leads there',
  placeThird: 'if c→a does not lead there: a→c begins there',
  formThird: 'put its three-touch discs into L',
  again: 'the judge found an edge wrong: begin again with more samples',
  ties: 'settle ties where more than three circles touch one disc',
  hull: 'the directed edges that are left over lead around the hull',
  flipCenters: 'T ← Delaunay triangulation of the centers',
  flipDiscs: 'for each triangle of T: the disc that touches its circles',
  flipTest: 'while the disc beside an edge a–b meets the circle opposite, or no such disc exists:',
  flip: 'replace a–b by the edge of the two circles opposite',
  flipDone: 'no edge is wrong: T is the dual of the Voronoi diagram',
  editBegin: 'the diagram as it is: its triangles and their discs',
  edit: 'insert, remove or change a circle',
  editTest: 'while the disc beside an edge meets the circle (or it shrinks until it touches one):',
  editFlip: 'replace that edge',
  editDone: 'the judge checks what changed: it is the diagram again',
} as const

/** The name of a line of pseudocode. */
export type PseudocodeLine = keyof typeof LINES

export const ENGLISH_PLAYER: PlayerWords = {
  lang: 'en',
  goals: {
    stage: 'stage',
    vertex: 'vertex',
    edge: 'edges placed',
    disc: 'three-touch disc',
    rejected: 'disc thrown away',
    circle: 'edit',
    selected: 'step of the selected circle',
    breakpoint: 'breakpoint',
  },
  running: 'Running the method…',
  notRun: 'The method could not be run. Try again.',
  stepLabel: 'Step',
  stepOf: (step, last) => `Step ${step} of ${last}`,
  back: 'Previous step',
  play: 'Play',
  pause: 'Pause',
  forth: 'Next step',
  speed: 'Speed',
  ask: 'Quiz: ask me before each step what happens next',
  breakHere: 'Breakpoint: stop here when playing',
  previous: 'Previous match',
  goal: 'Jump to',
  next: 'Next match',
  howItWorks: 'How it works',
  whatNext: 'What happens next?',
  right: 'Right.',
  wrong: (answer) => `No: ${answer}.`,
  score: (right, asked) => `${right} of ${asked} right so far.`,
  queue: (count) => `The list L, by radius (${count})`,
  more: (count) => `and ${count} more`,
  around: 'Around a circle',
  selectOne: 'Select a circle to see its directed edges in order.',
  aroundCircle: (id, isSelected) => `Around circle ${id}${isSelected ? ', selected' : ''}`,
  ring: (id, marks) =>
    `Around circle ${id}: ${marks.length === 0 ? 'no directed edge yet' : marks.map(({ isOut, other }) => (isOut ? `to ${other}` : `from ${other}`)).join(', ')}.`,
  ringNote: 'From the right, counter-clockwise. Green: no border has passed yet.',
  titles: {
    prepare: '1 Prepare',
    loop: '2 Loop',
    antipodal: '3 Antipodal disc of a and b',
    threeTouch: '4 Three-touch disc of a→b→c',
    end: 'End',
    flips: 'Flips',
    edit: 'An edit',
  },
  lines: LINES,
  given: (count, hidden) =>
    hidden === 0
      ? `There are ${plural(count, 'circle')}.`
      : `There are ${plural(count, 'circle')}, ${hidden} of them inside others and left out.`,
  centers: (edges) => `The Delaunay graph of the centers has ${plural(edges, 'edge')}.`,
  angles: 'At each center, the angles between these edges are divided by rays.',
  samples: (count) =>
    `All circles become smaller by the radius of the smallest one. ${plural(count, 'sample')} lie where edges and rays leave them.`,
  sampleGraph: (edges) => `The Delaunay graph of the samples has ${plural(edges, 'edge')}.`,
  pairs: (count) =>
    `Its edges join ${plural(count, 'pair')} of circles: each gets an antipodal disc, and all go into the list by radius.`,
  used: (ids) =>
    `A foot of the disc of ${circles(ids)} lies where another border has already passed. The disc is thrown away.`,
  notEmpty: (a, b, c) => `Circle ${c} reaches into the disc of circles ${a} and ${b}. The disc is thrown away.`,
  place: (a, b, tested) =>
    `The disc of circles ${a} and ${b} is empty${becauseOutside(tested)}: directed edges ${a}→${b} and ${b}→${a} are placed.`,
  form: (discs) =>
    `${plural(discs.length, 'three-touch disc')} ${discs.length === 1 ? 'goes' : 'go'} into the list: ${discs.join(', ')}.`,
  disc: (name, radius) => `${name} (radius ${radius})`,
  stale: (name) =>
    `A directed edge of disc ${name} has ended, or the two are no longer next to each other. The disc is thrown away.`,
  branch: (ids, place, radius) =>
    `The disc of ${circles(ids)} is empty: its center ${place} is a vertex, at distance ${radius} from all three.`,
  finish: (edges) =>
    edges.length === 1 ? `Directed edge ${edges[0]} ends there.` : `Directed edges ${list(edges)} end there.`,
  placeThird: (edge) => `Directed edge ${edge} begins there: the border continues from the vertex.`,
  again: (round) => `The judge found the diagram wrong: round ${round} begins with more samples.`,
  ties: 'Four or more circles touch one disc: its triangles are settled by the places of the centers.',
  flipDiscs: (count) => `${plural(count, 'triangle')}, each with the disc that touches its three circles.`,
  editBegin: (vertices) => `The diagram has ${plural(vertices, 'vertex', 'vertices')}.`,
  hull: (left) => `The list is empty. The ${plural(left, 'directed edge')} left over lead once around the hull.`,
  flipDone: 'No edge is left to flip.',
  editDone: 'The diagram is whole again.',
  proven: 'The judge proves the diagram.',
  refused: (message) => `The judge refuses the diagram: ${message}`,
  takenTriple: (ids, radius) =>
    `The smallest disc in the list touches ${circles(ids)}, with radius ${radius}. Are its directed edges still there?`,
  takenPair: (ids, radius, tested) =>
    `The smallest disc in the list lies between circles ${list(ids)}, with radius ${radius}.${tested.length > 0 ? ` It is tested against ${circles(tested)}.` : ''}`,
  come: (id, place, radius) => `Circle ${id} is inserted at ${place} with radius ${radius}.`,
  gone: (id) => `Circle ${id} is removed.`,
  moved: (id, place, radius) => `Circle ${id} is now at ${place} with radius ${radius}.`,
  discMissing: (a, b, c) => `No disc touches circles ${a}, ${b} and ${c}: the edge ${a}–${b} must go.`,
  tangentNotClear: (a, b, c) =>
    `The tangent line of circles ${a} and ${b} meets circle ${c}: the edge ${a}–${b} is no longer on the hull.`,
  hullNotConvex: (a, b, c) => `Circle ${a} lies within the tangent line of circles ${b} and ${c}: it leaves the hull.`,
  shrunk: (a, radius) => `Circle ${a} has shrunk to radius ${radius}: there it touches a disc of its neighbors.`,
  discNotEmpty: (a, b, c, radius) =>
    `The disc beside the edge ${a}–${b}, with radius ${radius}, meets circle ${c}: the edge is wrong.`,
  flip: (from, to) => `The edge ${from} becomes ${to}.`,
  allNew: (names) => `Added: ${names.join(', ')}.`,
  allGone: (names) => `Removed: ${names.join(', ')}.`,
  discMoves: (ids) => `The disc of ${list(ids)} moves.`,
  triangles: (removed, made) =>
    `${plural(removed, 'triangle')} ${removed === 1 ? 'is' : 'are'} removed, ${made} added.`,
  askAntipodal: (a, b) => `What is the disc between circles ${a} and ${b}?`,
  antipodalAnswers: [
    'It is empty',
    'Another circle reaches into it',
    'A foot lies where another border has already passed',
  ],
  askThreeTouch: (ids) => `Which directed edges end at the disc of circles ${ids.join(', ')}?`,
  threeTouchAnswers: ['Two edges end, one begins', 'Three edges end', 'Nothing: one of its edges has ended'],
  askFlip: (edge) => `The edge ${edge} is flipped. Which edge takes its place?`,
}
