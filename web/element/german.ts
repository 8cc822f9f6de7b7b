// SPDX-License-Identifier: GPL-3.0-or-later

import type { KeyHelp } from '../editing/key-help.ts'
import type { ProblemWords } from '../editing/problem.ts'
import { problemOf } from '../editing/problem.ts'
import type { EditingWords } from '../editing/words.ts'
import type { ErrorCode } from '../lib/base/errors.ts'
import type { PlayerWords } from '../player/words.ts'
import { listed } from '../view/refusal.ts'
import type { GoalWords } from './goals.ts'
import type { ElementRefusals } from './refusals.ts'
import { numbersOf, type Words } from './words.ts'

/** The element's texts in German. */
export function germanWords(lang: string): Words {
  const number = numbersOf(lang)
  const count = (value: number, one: string, many: string) => `${number(value)} ${value === 1 ? one : many}`
  return {
    lang,
    label: 'Kreise und ihr Voronoi-Diagramm',
    keys: KEYS,
    wheelHint: 'Strg und das Mausrad zoomen; nach einem Klick auch das Mausrad allein',
    met: 'Gelöst.',
    unmet: 'Noch nicht gelöst.',
    goals: GOALS,
    buttons: {
      add: 'Kreis hinzufügen',
      remove: 'Auswahl löschen',
      undo: 'Rückgängig',
      redo: 'Wiederholen',
      zoomOut: 'Verkleinern',
      zoomIn: 'Vergrößern',
      fit: 'Alles zeigen',
    },
    player: 'Die Methode Schritt für Schritt',
    editing: EDITING,
    others: { refusals: REFUSALS, player: PLAYER },
    describe({ circles, hidden, vertices, edges }) {
      const inside = hidden === 0 ? '' : `, ${number(hidden)} davon in anderen verborgen`
      return `${count(circles, 'Kreis', 'Kreise')}${inside}; das Diagramm hat ${count(vertices, 'Ecke', 'Ecken')} und ${count(edges, 'Kante', 'Kanten')}.`
    },
  }
}

const GOALS = {
  names: {
    area: 'Fläche',
    neighbors: 'Nachbarn',
    edges: 'Kanten',
    bounded: 'Zelle ist begrenzt',
    hidden: 'verborgen',
    neighbor: 'Zellen haben eine gemeinsame Kante',
    r: 'Radius',
    x: 'x',
    y: 'y',
    circles: 'Kreise',
    vertices: 'Ecken',
  },
  hiddenCircles: 'verborgene Kreise',
  counted: (name, value): string => {
    if (name === 'edges') return plural(value, 'Kante', 'Kanten')
    if (name === 'neighbors') return plural(value, 'Nachbar', 'Nachbarn')
    return `${GOALS.names[name]} ${value}`
  },
  yes: 'ja',
  no: 'nein',
  is: (name, now, goal) => `${name}: jetzt ${now}, Ziel ${goal}`,
  atLeast: (least) => `mindestens ${least}`,
  atMost: (most) => `höchstens ${most}`,
  between: (least, most) => `${least} bis ${most}`,
} satisfies GoalWords

const KEYS = {
  select: {
    one: ['Enter', 'wählt einen Kreis aus'],
    next: ['Tab, Umschalt + Tab', 'der nächste, der vorige'],
    neighbor: ['Strg + Pfeile', 'der Nachbar auf dieser Seite'],
    all: ['Strg + A, Escape', 'alle, keiner'],
    zoom: ['F', 'vergrößert die Auswahl'],
  },
  edit: {
    add: ['N', 'fügt einen Kreis hinzu, nahe der Mitte, wo Platz ist'],
    move: ['Pfeile', 'bewegen die Auswahl: mit Umschalt in größeren Schritten, mit Alt in kleineren'],
    resize: ['+ −', 'ändern die Größe der Auswahl, in denselben Schritten'],
    remove: ['Entf', 'löscht die Auswahl'],
    duplicate: ['Strg + D', 'verdoppelt die Auswahl'],
    undo: ['Strg + Z, Strg + Umschalt + Z', 'rückgängig, wiederholen'],
    snap: ['S', 'Einrasten an oder aus'],
  },
  look: {
    pan: ['Pfeile', 'bewegen das Bild'],
    zoom: ['+ −', 'zoomen'],
    fit: ['0', 'zeigt alles; noch einmal: ohne das, was weit außerhalb liegt'],
  },
  withoutSelection: 'Ohne Auswahl:',
} satisfies KeyHelp

const EDITING = {
  called: (id, name) => name || `Kreis ${id}`,
  added: (circle) => `${circle} hinzugefügt`,
  addedMany: (count) => `${count} Kreise hinzugefügt`,
  duplicated: (count) => (count === 1 ? 'Kreis verdoppelt' : `${count} Kreise verdoppelt`),
  deleted: (circle) => `${circle} gelöscht`,
  deletedMany: (count) => `${count} Kreise gelöscht`,
  moved: (count) => `${count} Kreise verschoben`,
  selected: (count) => `${count} Kreise ausgewählt`,
  circle: (circle, description) => `${circle}. ${description}`,
  numbers: (circle, x, y, r) => `${circle}: x ${x}, y ${y}, r ${r}`,
  hidden: (hider) => `In ${hider} verborgen: Er hat keine Zelle.`,
  cell: (isBounded, neighbors) =>
    `${isBounded ? 'Begrenzte' : 'Unbegrenzte'} Zelle, ${neighbors} ${neighbors === 1 ? 'Nachbar' : 'Nachbarn'}`,
  snaps: 'Einrasten ist an',
  snapsNot: 'Einrasten ist aus',
} satisfies EditingWords

/** The errors of the library. */
const CODES = {
  nonFinite: 'Eine Zahl ist nicht endlich.',
  negativeRadius: 'Der Radius darf nicht negativ sein.',
  coordinateTooLarge: 'Eine Zahl ist zu groß: höchstens 7,9e28.',
  coordinateTooSmall: 'Alle Zahlen sind zu klein: Die größte muss mindestens 1,4e-17 sein.',
  linkTooLong: 'Der Link ist zu lang.',
  tooManyCircles: 'Es sind zu viele Kreise.',
  badOption: 'Eine Option hat einen falschen Wert.',
  notCertified: 'Das Diagramm konnte nicht bewiesen werden.',
  notConverged: 'Die Flächen wurden nicht erreicht.',
  unknownCircle: 'Diesen Kreis gibt es nicht.',
  badInput: 'Eine Angabe ist falsch.',
  badArithmetic: 'Hier wird falsch gerundet.',
  notWritten: 'Die Datei kann nicht geschrieben werden.',
  notLoaded: 'Das WebAssembly kann nicht geladen werden.',
  internal: 'Das Programm selbst hat versagt.',
} satisfies Record<ErrorCode, string>

const REFUSALS = {
  coded: ({ code, circle }) => (circle === undefined ? CODES[code] : `Kreis ${circle}: ${CODES[code]}`),
  must: (what, allowed, got) => `${what} muss ${allowed} sein (angegeben: ${got}).`,
  layers: 'Der Wert der Ebenen',
  object: 'ein Objekt',
  layer: (name) => `Die Ebene ${name}`,
  oneOf: (values) => listed(values, 'oder'),
  wholeNumber: (least, most) => `eine ganze Zahl ab ${least}${most === undefined ? '' : ` bis ${most}`}`,
  trueOrFalse: 'true oder false',
  number: 'eine Zahl',
  numberFromZero: 'eine Zahl ab 0',
  path: 'ein Paar von Punkten { from: { x, y }, to: { x, y } }',
  data: 'eine Liste von Objekten mit points, segments oder discs als Listen von Zahlen',
  cellValues: 'ein Objekt mit einem Namen und Werten als Float64Array',
  noLayer: (word, names) => `Es gibt keine Ebene ${word}. Ebenen sind ${listed(names, 'und')}.`,
  notComputed: (reason) => `Das Diagramm konnte nicht berechnet werden: ${reason}.`,
  notDrawn: 'Das Bild konnte nicht gezeichnet werden.',
  drawingFailed: (reason) => `Das Zeichnen ist gescheitert und wurde neu begonnen: ${reason}.`,
  drawingEnded: (reason) => `Das Bild kann nicht mehr gezeichnet werden: ${reason}. Laden Sie die Seite neu.`,
  nothingChanged: 'Nichts hat sich geändert. Versuchen Sie es noch einmal.',
  latticeWithRegion: 'Zu einem Gitter gehört kein Gebiet: seine Zellen sind ganz.',
  areasWithoutRegion: 'Flächen brauchen ein Gebiet, das die Zellen teilen.',
  areasForCircles: (areas, circles) => `Es gibt ${areas} Flächen für ${circles} Kreise.`,
  tooManyForAreas: (most) => `Flächen können hier höchstens ${most} Zellen bekommen.`,
  notRegion: (reason) => `Das ist weder GeoJSON noch Well-known Text von Polygonen: ${reason}`,
  lattice: 'Der Wert von lattice',
  twoPeriods: 'zwei Perioden, vier Zahlen ax ay bx by',
  areas: 'Der Wert von areas',
  sharesOrEqual: 'equal oder eine Liste von Zahlen über 0',
  disposed: 'es wird nicht mehr gebraucht',
  noThread: 'seine Datei kann nicht geladen werden',
  circles: 'Der Wert der Kreise',
  method: 'Die Methode',
  controls: 'Der Wert von controls',
  samples: 'Die Zahl der Proben',
  selection: 'Die Auswahl',
  listOfIds: 'eine Liste von Nummern von Kreisen',
  someOf: (words) => `${listed(words, 'oder')} oder beides`,
  notJson: (what, reason) => `${what} ist kein gültiges JSON: ${reason}.`,
  view: 'Ein Ausschnitt besteht aus drei Zahlen: x, y und einer Weite über 0.',
  step: (got) => `Ein Schritt ist eine ganze Zahl ab 0, nicht ${got}.`,
  check: (reason) => `Die Prüfung ist nicht lesbar: ${reason}.`,
  checkParts: 'Sie hat zu viele Teile',
  checkObject: 'Jeder Teil ist ein Objekt',
  checkNothing: 'Ein Teil sagt nichts',
  checkNotJson: 'Sie ist kein gültiges JSON',
  checkNoCell: 'Sie sagt nichts über die Zelle',
  checkAlone: (name) => `${name} steht allein`,
  checkList: (name) => `${name} hat eine Liste`,
  checkCircle: (name) => `${name} ist die Nummer eines Kreises`,
  checkFlag: (name) => `${name} ist true oder false`,
  checkCondition: (name) => `${name} ist eine Zahl oder ein Objekt mit min und max`,
  checkName: (isOfCell, name, known) =>
    `${isOfCell ? 'Eine Zelle' : 'Ein Diagramm'} hat kein ${name}, nur ${listed(known, 'und')}`,
  checkMissing: (circle, count) =>
    `Es gibt keinen Kreis ${circle}. ${count === 0 ? 'Es gibt keine Kreise' : `Die Kreise haben die Nummern 0 bis ${count - 1}`}`,
  line: (k) => `Zeile ${k}`,
  row: (k) => `Zeile ${k} der Tabelle`,
  notThree: (place, fields) => `${place} hat nicht drei Zahlen x, y und r: ${fields}`,
  notCircle: (index) => `Kreis ${index} hat nicht drei Zahlen x, y und r.`,
  noCircles: 'Darin sind keine Kreise.',
  notLoaded: (src, status) => `${src} kann nicht geladen werden: Die Antwort ist ${status}.`,
  within: (src, sentence) => `${src}: ${sentence}`,
  dataSet: (name) => `Der Link nennt den Datensatz ${name} der Seite, von der er ist, und hat keine eigenen Kreise.`,
  notInPage: 'Die Figur ist in keiner Seite, oder nicht mehr.',
  notComputedAgain: 'Das Diagramm konnte nicht berechnet werden. Versuchen Sie es noch einmal.',
} satisfies ElementRefusals & ProblemWords

const plural = (count: number | string, one: string, many: string) => `${count} ${Number(count) === 1 ? one : many}`
const list = (items: readonly (number | string)[]) => listed(items.map(String), 'und')
const circles = (ids: readonly number[]) => (ids.length === 1 ? `Kreis ${ids[0]}` : `die Kreise ${list(ids)}`)
const ofCircles = (ids: readonly number[]) => (ids.length === 1 ? `von Kreis ${ids[0]}` : `der Kreise ${list(ids)}`)
const becauseOutside = (ids: readonly number[]) =>
  ids.length === 0 ? '' : `, denn ${circles(ids)} ${ids.length === 1 ? 'ragt' : 'ragen'} nicht hinein`

const PLAYER = {
  lang: 'de',
  localized: (error) => problemOf(error, false, REFUSALS),
  goals: {
    stage: 'Abschnitt',
    vertex: 'Ecke',
    edge: 'gesetzte Kanten',
    disc: 'Dreiberührscheibe',
    rejected: 'verworfene Scheibe',
    circle: 'Änderung',
    selected: 'des ausgewählten Kreises',
    breakpoint: 'Haltepunkt',
  },
  running: 'Die Methode läuft…',
  notRun: 'Die Methode konnte nicht ausgeführt werden. Versuchen Sie es noch einmal.',
  stepLabel: 'Schritt',
  stepOf: (step, last) => `Schritt ${step} von ${last}`,
  back: 'Ein Schritt zurück',
  play: 'Abspielen',
  pause: 'Pause',
  forth: 'Ein Schritt',
  speed: 'Tempo',
  ask: 'Fragen, was als Nächstes geschieht',
  breakHere: 'Beim Abspielen hier anhalten',
  previous: 'Zurück zum letzten Ziel',
  goal: 'Ziel',
  next: 'Weiter zum nächsten Ziel',
  howItWorks: 'So funktioniert es',
  whatNext: 'Was geschieht als Nächstes?',
  right: 'Richtig.',
  wrong: (answer) => `Nein: ${answer}.`,
  score: (right, asked) => `Bisher ${right} von ${asked} richtig.`,
  queue: (count) => `Die Liste L nach Radius (${count})`,
  more: (count) => `und ${count} weitere`,
  around: 'Um einen Kreis',
  selectOne: 'Wählen Sie einen Kreis, um seine gerichteten Kanten der Reihe nach zu sehen.',
  aroundCircle: (id, isSelected) => `Um Kreis ${id}${isSelected ? ', ausgewählt' : ''}`,
  ring: (id, marks) =>
    `Um Kreis ${id}: ${marks.length === 0 ? 'noch keine gerichtete Kante' : marks.map(({ isOut, other }) => `${isOut ? 'zu' : 'von'} ${other}`).join(', ')}.`,
  ringNote: 'Von rechts gegen den Uhrzeigersinn. Grün: Hier lief noch keine Grenze entlang.',
  titles: {
    prepare: '1 Vorbereiten',
    loop: '2 Schleife',
    antipodal: '3 Antipodale Scheibe von a und b',
    threeTouch: '4 Dreiberührscheibe von a→b→c',
    end: 'Ende',
    flips: 'Flips',
    edit: 'Eine Änderung',
  },
  lines: {
    begin: 'Gegeben: Kreise; die in anderen liegen, bleiben weg',
    centers: 'T ← Delaunay-Graph der Mittelpunkte',
    angles: 'teile an jedem Mittelpunkt den Winkel jedes Dreiecks',
    samples: 'setze eine Probe, wo Kanten und teilende Strahlen ihren Kreis verlassen',
    sampleGraph: 'D ← Delaunay-Graph der Proben',
    pairs: 'L ← eine antipodale Scheibe für je zwei Kreise mit einer Kante in D, nach Radius',
    take: 'solange L nicht leer ist: nimm die kleinste Scheibe',
    used: 'liegt ein Fußpunkt, wo schon eine andere Grenze entlanglief: verwirf die Scheibe',
    notEmpty: 'ragt ein anderer Kreis hinein: verwirf die Scheibe',
    place: 'sonst ist sie leer: setze die gerichteten Kanten a→b und b→a',
    form: 'lege die Dreiberührscheiben mit den nächsten gerichteten Kanten in L',
    stale: 'fehlt a→b oder b→c, oder sind sie nicht mehr benachbart: verwirf die Scheibe',
    branch: 'sonst ist sie leer: ihr Mittelpunkt ist eine Ecke',
    finish: 'a→b und b→c enden dort, und c→a, wenn sie dorthin führt',
    placeThird: 'führt c→a nicht dorthin: a→c beginnt dort',
    formThird: 'lege deren Dreiberührscheiben in L',
    again: 'die Prüfung fand eine falsche Kante: beginne noch einmal mit mehr Proben',
    ties: 'entscheide Gleichstände: wo mehr als drei Kreise eine Scheibe berühren',
    hull: 'die übrigen gerichteten Kanten führen um die Hülle',
    flipCenters: 'T ← Delaunay-Triangulierung der Mittelpunkte',
    flipDiscs: 'für jedes Dreieck von T: die Scheibe, die seine Kreise berührt',
    flipTest: 'solange die Scheibe neben einer Kante a–b den Kreis gegenüber trifft oder es keine gibt:',
    flip: 'ersetze a–b durch die Kante der beiden Kreise gegenüber',
    flipDone: 'keine Kante ist falsch: T ist der duale Graph des Voronoi-Diagramms',
    editBegin: 'das Diagramm, wie es ist: seine Dreiecke und ihre Scheiben',
    edit: 'ein Kreis kommt, geht oder ändert sich',
    editTest: 'solange die Scheibe neben einer Kante den Kreis trifft (oder er schrumpft, bis er eine berührt):',
    editFlip: 'ersetze diese Kante',
    editDone: 'alles Geänderte ist geprüft: Es ist wieder das Diagramm',
  },
  given: (count, hidden) =>
    hidden === 0
      ? `Es gibt ${plural(count, 'Kreis', 'Kreise')}.`
      : `Es gibt ${plural(count, 'Kreis', 'Kreise')}; ${hidden} davon liegen in anderen und bleiben weg.`,
  centers: (edges) => `Der Delaunay-Graph der Mittelpunkte hat ${plural(edges, 'Kante', 'Kanten')}.`,
  angles: 'An jedem Mittelpunkt teilen Strahlen die Winkel zwischen diesen Kanten.',
  samples: (count) =>
    `Alle Kreise werden um den kleinsten Radius kleiner. ${plural(count, 'Probe', 'Proben')}: wo Kanten und Strahlen sie verlassen.`,
  sampleGraph: (edges) => `Der Delaunay-Graph der Proben hat ${plural(edges, 'Kante', 'Kanten')}.`,
  pairs: (count) =>
    `Seine Kanten verbinden ${plural(count, 'Paar', 'Paare')} von Kreisen: Jedes bekommt eine antipodale Scheibe, und alle kommen nach Radius in die Liste.`,
  used: (ids) =>
    `Ein Fußpunkt der Scheibe ${ofCircles(ids)} liegt, wo schon eine andere Grenze entlanglief: Sie wird verworfen.`,
  notEmpty: (a, b, c) => `Kreis ${c} ragt in die Scheibe der Kreise ${a} und ${b}: Sie wird verworfen.`,
  place: (a, b, tested) =>
    `Die Scheibe der Kreise ${a} und ${b} ist leer${becauseOutside(tested)}: Die gerichteten Kanten ${a}→${b} und ${b}→${a} werden gesetzt.`,
  form: (discs) =>
    `${plural(discs.length, 'Dreiberührscheibe kommt', 'Dreiberührscheiben kommen')} in die Liste: ${discs.join(', ')}.`,
  disc: (name, radius) => `${name} (Radius ${radius})`,
  stale: (name) =>
    `Eine gerichtete Kante der Scheibe ${name} ist zu Ende, oder die beiden sind nicht mehr benachbart: Sie wird verworfen.`,
  branch: (ids, place, radius) =>
    `Die Scheibe ${ofCircles(ids)} ist leer: Ihr Mittelpunkt ${place} ist eine Ecke, ${radius} von allen dreien entfernt.`,
  finish: (edges) =>
    edges.length === 1
      ? `Die gerichtete Kante ${edges[0]} endet dort.`
      : `Die gerichteten Kanten ${list(edges)} enden dort.`,
  placeThird: (edge) => `Die gerichtete Kante ${edge} beginnt dort: Die Grenze geht von der Ecke aus weiter.`,
  again: (round) => `Die Prüfung fand das Diagramm falsch: Runde ${round} beginnt mit mehr Proben.`,
  ties: 'Vier oder mehr Kreise berühren eine Scheibe: Die Lage der Mittelpunkte entscheidet über die Dreiecke.',
  flipDiscs: (count) =>
    `${plural(count, 'Dreieck', 'Dreiecke')}, jedes mit der Scheibe, die seine drei Kreise berührt.`,
  editBegin: (vertices) => `Das Diagramm hat ${plural(vertices, 'Ecke', 'Ecken')}.`,
  hull: (left) =>
    `Die Liste ist leer. ${left === 1 ? 'Die übrige gerichtete Kante führt' : `Die ${left} übrigen gerichteten Kanten führen`} einmal um die Hülle.`,
  flipDone: 'Keine Kante ist mehr zu ersetzen.',
  editDone: 'Das Diagramm ist wieder ganz.',
  proven: 'Die Prüfung beweist das Diagramm.',
  refused: (message) => `Die Prüfung lehnt das Diagramm ab: ${message}`,
  takenTriple: (ids, radius) =>
    `Die kleinste Scheibe der Liste berührt ${circles(ids)} und hat den Radius ${radius}. Gibt es ihre gerichteten Kanten noch?`,
  takenPair: (ids, radius, tested) =>
    `Die kleinste Scheibe der Liste liegt zwischen den Kreisen ${list(ids)} und hat den Radius ${radius}.${tested.length > 0 ? ` Geprüft wird, ob sie ${circles(tested)} trifft.` : ''}`,
  come: (id, place, radius) => `Kreis ${id} kommt bei ${place} mit Radius ${radius}.`,
  gone: (id) => `Kreis ${id} ist weg.`,
  moved: (id, place, radius) => `Kreis ${id} liegt jetzt bei ${place} mit Radius ${radius}.`,
  discMissing: (a, b, c) => `Keine Scheibe berührt die Kreise ${a}, ${b} und ${c}: Die Kante ${a}–${b} muss weg.`,
  tangentNotClear: (a, b, c) =>
    `Die Tangente der Kreise ${a} und ${b} trifft Kreis ${c}: Die Kante ${a}–${b} gehört nicht mehr zur Hülle.`,
  hullNotConvex: (a, b, c) =>
    `Kreis ${a} liegt innerhalb der Tangente der Kreise ${b} und ${c}: Er verlässt die Hülle.`,
  shrunk: (a, radius) =>
    `Kreis ${a} ist auf den Radius ${radius} geschrumpft: Dort berührt er eine Scheibe seiner Nachbarn.`,
  discNotEmpty: (a, b, c, radius) =>
    `Die Scheibe neben der Kante ${a}–${b} mit Radius ${radius} trifft Kreis ${c}: Die Kante ist falsch.`,
  flip: (from, to) => `Aus der Kante ${from} wird ${to}.`,
  allNew: (names) => `Neu: ${names.join(', ')}.`,
  allGone: (names) => `Weg: ${names.join(', ')}.`,
  discMoves: (ids) => `Die Scheibe von ${list(ids)} bewegt sich.`,
  triangles: (removed, made) => `${plural(removed, 'Dreieck geht', 'Dreiecke gehen')}, ${made} kommen.`,
  askAntipodal: (a, b) => `Was ist mit der Scheibe zwischen den Kreisen ${a} und ${b}?`,
  antipodalAnswers: [
    'Sie ist leer',
    'Ein anderer Kreis ragt hinein',
    'Ein Fußpunkt liegt, wo schon eine andere Grenze entlanglief',
  ],
  askThreeTouch: (ids) => `Welche gerichteten Kanten nimmt die Scheibe der Kreise ${ids.join(', ')} weg?`,
  threeTouchAnswers: ['Ihre beiden Kanten gehen, eine kommt', 'Drei Kanten gehen', 'Keine: Eine davon fehlt schon'],
  askFlip: (edge) => `Die Kante ${edge} geht. Welche kommt?`,
} satisfies PlayerWords
