// SPDX-License-Identifier: GPL-3.0-or-later
/** The kinds of steps that a reader can search for. */
export type StepKind = 'stage' | 'disc' | 'edge' | 'vertex' | 'rejected' | 'circle'

/** The targets of "go to next": a kind of step, the selected circle, or a breakpoint. */
export type Goal = StepKind | 'selected' | 'breakpoint'

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
}

/** The name of a line of pseudocode. */
export type PseudocodeLine = keyof typeof LINES

/** The player's texts. */
export const ENGLISH_PLAYER = {
  /** The language of the texts, as a value of the attribute `lang`. */
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
  } satisfies Record<Goal, string>,
  running: 'Running the method…',
  notRun: 'The method could not be run. Try again.',
  stepLabel: 'Step',
  stepOf: (step: number, last: number) => `Step ${step} of ${last}`,
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
  wrong: (answer: string) => `No: ${answer}.`,
  score: (right: number, asked: number) => `${right} of ${asked} right so far.`,
  queue: (count: number) => `The list L, by radius (${count})`,
  more: (count: number) => `and ${count} more`,
  around: 'Around a circle',
  selectOne: 'Select a circle to see its directed edges in order.',
  aroundCircle: (id: number, isSelected: boolean) => `Around circle ${id}${isSelected ? ', selected' : ''}`,
  ring: (id: number, marks: readonly { readonly isOut: boolean; readonly other: number }[]) =>
    `Around circle ${id}: ${marks.length === 0 ? 'no directed edge yet' : marks.map(({ isOut, other }) => (isOut ? `to ${other}` : `from ${other}`)).join(', ')}.`,
  ringNote: 'From the right, counter-clockwise. Green: no border has passed yet.',
  /** The titles and lines of the algorithms. */
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
  given: (count: number, hidden: number) =>
    hidden === 0
      ? `There are ${plural(count, 'circle')}.`
      : `There are ${plural(count, 'circle')}, ${hidden} of them inside others and left out.`,
  centers: (edges: number) => `The Delaunay graph of the centers has ${plural(edges, 'edge')}.`,
  angles: 'At each center, the angles between these edges are divided by rays.',
  samples: (count: number) =>
    `All circles become smaller by the radius of the smallest one. ${plural(count, 'sample')} lie where edges and rays leave them.`,
  sampleGraph: (edges: number) => `The Delaunay graph of the samples has ${plural(edges, 'edge')}.`,
  pairs: (count: number) =>
    `Its edges join ${plural(count, 'pair')} of circles: each gets an antipodal disc, and all go into the list by radius.`,
  used: (ids: readonly number[]) =>
    `A foot of the disc of ${circles(ids)} lies where another border has already passed. The disc is thrown away.`,
  notEmpty: (a: number, b: number, c: number) =>
    `Circle ${c} reaches into the disc of circles ${a} and ${b}. The disc is thrown away.`,
  place: (a: number, b: number, tested: readonly number[]) =>
    `The disc of circles ${a} and ${b} is empty${becauseOutside(tested)}: directed edges ${a}→${b} and ${b}→${a} are placed.`,
  form: (discs: readonly string[]) =>
    `${plural(discs.length, 'three-touch disc')} ${discs.length === 1 ? 'goes' : 'go'} into the list: ${discs.join(', ')}.`,
  disc: (name: string, radius: string) => `${name} (radius ${radius})`,
  stale: (name: string) =>
    `A directed edge of disc ${name} has ended, or the two are no longer next to each other. The disc is thrown away.`,
  branch: (ids: readonly number[], place: string, radius: string) =>
    `The disc of ${circles(ids)} is empty: its center ${place} is a vertex, at distance ${radius} from all three.`,
  finish: (edges: readonly string[]) =>
    edges.length === 1 ? `Directed edge ${edges[0]} ends there.` : `Directed edges ${list(edges)} end there.`,
  placeThird: (edge: string) => `Directed edge ${edge} begins there: the border continues from the vertex.`,
  again: (round: number) => `The judge found the diagram wrong: round ${round} begins with more samples.`,
  ties: 'Four or more circles touch one disc: its triangles are settled by the places of the centers.',
  flipDiscs: (count: number) => `${plural(count, 'triangle')}, each with the disc that touches its three circles.`,
  editBegin: (vertices: number) => `The diagram has ${plural(vertices, 'vertex', 'vertices')}.`,
  hull: (left: number) =>
    `The list is empty. The ${plural(left, 'directed edge')} left over lead once around the hull.`,
  flipDone: 'No edge is left to flip.',
  editDone: 'The diagram is whole again.',
  proven: 'The judge proves the diagram.',
  refused: (message: string) => `The judge refuses the diagram: ${message}`,
  takenTriple: (ids: readonly number[], radius: string) =>
    `The smallest disc in the list touches ${circles(ids)}, with radius ${radius}. Are its directed edges still there?`,
  takenPair: (ids: readonly number[], radius: string, tested: readonly number[]) =>
    `The smallest disc in the list lies between circles ${list(ids)}, with radius ${radius}.${tested.length > 0 ? ` It is tested against ${circles(tested)}.` : ''}`,
  come: (id: number, place: string, radius: string) => `Circle ${id} is inserted at ${place} with radius ${radius}.`,
  gone: (id: number) => `Circle ${id} is removed.`,
  moved: (id: number, place: string, radius: string) => `Circle ${id} is now at ${place} with radius ${radius}.`,
  discMissing: (a: number, b: number, c: number) =>
    `No disc touches circles ${a}, ${b} and ${c}: the edge ${a}–${b} must go.`,
  tangentNotClear: (a: number, b: number, c: number) =>
    `The tangent line of circles ${a} and ${b} meets circle ${c}: the edge ${a}–${b} is no longer on the hull.`,
  hullNotConvex: (a: number, b: number, c: number) =>
    `Circle ${a} lies within the tangent line of circles ${b} and ${c}: it leaves the hull.`,
  shrunk: (a: number, radius: string) =>
    `Circle ${a} has shrunk to radius ${radius}: there it touches a disc of its neighbors.`,
  discNotEmpty: (a: number, b: number, c: number, radius: string) =>
    `The disc beside the edge ${a}–${b}, with radius ${radius}, meets circle ${c}: the edge is wrong.`,
  flip: (from: string, to: string) => `The edge ${from} becomes ${to}.`,
  allNew: (names: readonly string[]) => `Added: ${names.join(', ')}.`,
  allGone: (names: readonly string[]) => `Removed: ${names.join(', ')}.`,
  discMoves: (ids: readonly number[]) => `The disc of ${list(ids)} moves.`,
  triangles: (removed: number, made: number) =>
    `${plural(removed, 'triangle')} ${removed === 1 ? 'is' : 'are'} removed, ${made} added.`,
  askAntipodal: (a: number, b: number) => `What is the disc between circles ${a} and ${b}?`,
  antipodalAnswers: [
    'It is empty',
    'Another circle reaches into it',
    'A foot lies where another border has already passed',
  ] satisfies [empty: string, meets: string, used: string],
  askThreeTouch: (ids: readonly number[]) => `Which directed edges end at the disc of circles ${ids.join(', ')}?`,
  threeTouchAnswers: ['Two edges end, one begins', 'Three edges end', 'Nothing: one of its edges has ended'] satisfies [
    one: string,
    three: string,
    nothing: string,
  ],
  askFlip: (edge: string) => `The edge ${edge} is flipped. Which edge takes its place?`,
}

export type PlayerWords = typeof ENGLISH_PLAYER & {
  /** Localizes the reason why nothing can be played. The messages of errors are English. */
  localized?(error: Error): string
}
