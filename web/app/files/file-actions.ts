// SPDX-License-Identifier: GPL-3.0-or-later

import { type Attributes, fileAttributes } from '../../editing/attributes.ts'
import type { Editing } from '../../editing/editing.ts'
import { colorColumn, nameColumn } from '../../editing/identity.ts'
import type { HowOpened } from '../../editing/opening-actions.ts'
import { dataSetName, type State } from '../../editing/state.ts'
import { idsOf, withIds } from '../../element/check.ts'
import { goalRings, goalsOf } from '../../element/goals.ts'
import { loadWords, wordsOf } from '../../element/language.ts'
import { type Circle, CircleVoronoiError, circleAt } from '../../lib/index.ts'
import type { LinkFrame, LinkInput } from '../../lib/link.ts'
import { plainRegion } from '../../lib/regions/region-shape.ts'
import { fitted, toPlane } from '../../view/camera.ts'
import { boxOf } from '../../view/domain.ts'
import { type ExportView, toPNG, toPrint, toSVG } from '../../view/export.ts'
import { readRegion } from '../../view/region-text.ts'
import { short } from '../../view/short.ts'
import type { Store } from '../../view/store.ts'
import type { View } from '../../view/view.ts'
import { wholeNumber } from '../../view/whole-number.ts'
import { labelOf, sourceOf } from '../data-sets.ts'
import type { LinkWriter } from '../link-writer.ts'
import type { PageActions } from '../page-actions.ts'
import { byId } from '../panels/by-id.ts'
import { chooseColumns } from '../panels/choose-columns.ts'
import { toast } from '../panels/toast.ts'
import { unknownTable } from './columns.ts'
import type { FilesClient } from './files-client.ts'
import type { HowRead, Photo, Read, SavedFormat } from './files-protocol.ts'
import { type FoundRegion, type ReadsRegion, regionOfFile, regionOfText } from './region-file.ts'
import { elementCode, embedCode, save } from './saving.ts'
import { USUAL_CIRCLES } from './stipple.ts'
import { withLink, withTable } from './svg-scene.ts'

/** Limit for files, in bytes. Browsers could not show larger ones. */
const LARGEST_FILE = 2 ** 28
const READABLE = 'Open CSV, JSON, GeoJSON, well-known text, an SVG that was saved here, or a picture.'
/** Limit for addresses, in characters. Browsers do not open longer ones. */
const LONGEST_LINK = 2_000_000
/** Size of the picture on a sheet of paper: A3 at 300 dots per inch. */
const POSTER = { long: 4961, short: 3508 }
/** Size of the picture on a worksheet, in pixels. */
const SHEET = { width: 960, height: 640 }
/** The longest side of a saved photo, in pixels. */
const LONGEST_SIDE = 2400
/** Margin around all circles in a picture, in pixels. */
const MARGIN = 24
const TYPES: Readonly<Record<SavedFormat, readonly [ending: string, type: string]>> = {
  csv: ['.csv', 'text/csv'],
  json: ['.json', 'application/json'],
  geojson: ['.geojson', 'application/geo+json'],
  cells: ['-cells.geojson', 'application/geo+json'],
}

const WEIGHTS = 'The file has weights, not the original radii. The weights give the cells their areas.'

/** The part that a picture shows: the window's contents, or all circles. */
export type Part = 'seen' | 'all'

/**
 * The files threads: the first for saving and linking, another for opening, and the writer of links that uses the
 * first.
 */
export interface FileThreads {
  readonly files: Pick<FilesClient, 'call'>
  readonly reader: Pick<FilesClient, 'call'>
  readonly links: LinkWriter
}

/** Everything that a user can do with files and links. */
export class FileActions {
  /** Whether polygons of a file that share borders or overlap are merged into one region. */
  mergesPolygons = false
  readonly #store: Store<State>
  readonly #editing: Editing
  readonly #actions: PageActions
  readonly #view: View
  readonly #threads: FileThreads

  constructor(store: Store<State>, editing: Editing, actions: PageActions, view: View, threads: FileThreads) {
    this.#store = store
    this.#editing = editing
    this.#actions = actions
    this.#view = view
    this.#threads = threads
  }

  /** Opens a file with circles, or with polygons as the region. An unreadable file changes nothing. */
  async openFile(file: File): Promise<HowOpened> {
    const gesture = this.#actions.circles.beginGesture()
    // Avoids reading a file that is too large.
    const region = file.size > LARGEST_FILE ? undefined : await regionOfFile(file).catch(() => undefined)
    if (region === undefined) {
      return isPicture(file) ? this.openPhoto(file) : this.#openRead(() => this.#readFile(file), file.name)
    }
    if (region.polygons === undefined) return this.#clipTo(region.read, file.name, gesture)
    return this.#openWithRegion(() => file.arrayBuffer(), file.name, region, file.name)
  }

  /** Opens a photo as circles. Undo restores another number of circles, too. */
  openPhoto(file: File, count = USUAL_CIRCLES): Promise<HowOpened> {
    return this.#actions.data.openPhoto(file, count, () => {
      if (file.size > LARGEST_FILE) throw new Error(`${file.name}: the file is too large.`)
      return this.#threads.reader.call('stipple', file, count).catch(() => {
        throw new Error(`${file.name} cannot be read as a picture.`)
      })
    })
  }

  /** Saves the mosaic of a photo, as large as the photo's frame. */
  async savePhoto({ size: { width, height } }: Photo): Promise<void> {
    const scale = LONGEST_SIDE / Math.max(width, height)
    const size = { width: Math.round(width * scale), height: Math.round(height * scale) }
    const camera = { x: width / 2, y: height / 2, scale }
    await this.#try(async () => save(await toPNG(this.#view, 1, { camera, size }), 'photo-circles.png'))
  }

  /** Opens circles, and polygons of the same file as their region. */
  async #openWithRegion(
    load: () => Promise<ArrayBuffer>,
    name: string,
    { read, polygons }: FoundRegion,
    file?: string,
    merges = this.mergesPolygons,
  ): Promise<HowOpened> {
    const how = await this.#openRead(
      async () => this.#read(new Uint8Array(await load()), name, { polygons }),
      file,
      (circles) => ({ ...circles, region: plainRegion(read(), merges) }),
    )
    if (how === 'refused' && this.#store.get().problem.includes('`dissolve`')) {
      this.#offerToMerge(name, () => this.#openWithRegion(load, name, { read, polygons }, file, true))
    }
    return how
  }

  /** Opens the first of several files, and says so. */
  async openFiles([first, ...others]: readonly File[]): Promise<void> {
    if (first === undefined) return
    const how = await this.openFile(first)
    if (how === 'opened' && others.length > 0)
      toast(`${first.name} was opened alone. Open the other files one at a time.`)
  }

  /**
   * Reads circles, completes them with `finish`, and opens them. If some rows are invalid, the error offers to skip them.
   */
  async #openRead(
    read: () => Promise<Read>,
    file?: string,
    finish = (circles: Read): Read => circles,
  ): Promise<HowOpened> {
    let invalid: InvalidRows | undefined
    const how = await this.#actions.data.openRead(
      () =>
        read().then(finish, (error) => {
          if (error instanceof InvalidRows) invalid = error
          throw error
        }),
      file,
    )
    if (how === 'refused' && invalid !== undefined) {
      const { skipping } = invalid
      this.#offerToSkip(invalid, () => this.#actions.data.openRead(() => skipping().then(finish), file))
    }
    return how
  }

  #offerToSkip({ message, count }: InvalidRows, skip: () => Promise<HowOpened>): void {
    const rows = count === 1 ? '1 row' : `${wholeNumber(count)} rows`
    const act = async () => {
      if ((await skip()) === 'opened') toast(`${rows} skipped.`)
    }
    this.#actions.messages.offer({ problem: message, label: `Skip ${rows}`, act })
  }

  /** Clips the cells to the polygons of a file. An invalid region changes nothing. */
  async openRegion(file: File): Promise<HowOpened> {
    const gesture = this.#actions.circles.beginGesture()
    if (file.size > LARGEST_FILE) {
      this.#actions.messages.complain(`${file.name}: the file is too large.`)
      return 'refused'
    }
    const text = await file.text().catch(() => undefined)
    if (text === undefined) {
      this.#actions.messages.complain(unreadable(file))
      return 'refused'
    }
    return this.#clipTo(() => readRegion(text), file.name, gesture)
  }

  async #clipTo(read: ReadsRegion, name: string, gesture?: number, merges = this.mergesPolygons): Promise<HowOpened> {
    try {
      const edited = await this.#actions.domain.setDomain({ region: plainRegion(read(), merges) }, gesture)
      if (edited === undefined) {
        if (this.#store.get().problem.includes('`dissolve`')) {
          this.#offerToMerge(name, () => this.#clipTo(read, name, undefined, true))
        }
        return 'refused'
      }
    } catch (error) {
      this.#actions.messages.complain(`${name}: ${(error as Error).message}`)
      return 'refused'
    }
    this.#actions.camera.showView(undefined)
    toast(`Cells are clipped to ${name}.`, { label: 'Undo', act: () => this.#actions.circles.undo() })
    return 'opened'
  }

  #offerToMerge(name: string, merge: () => Promise<HowOpened>): void {
    this.#actions.messages.complain('')
    const act = () => void merge()
    toast(`Polygons of ${name} share borders or overlap.`, { label: 'Merge polygons', act })
  }

  /** Opens text like a file, or as a link. Circles of a table are added to the existing ones. */
  async openText(text: string): Promise<HowOpened> {
    const link = /^\S*#(v\d+\.[\w-]+)$/.exec(text.trim())?.[1]
    if (link !== undefined) return this.#actions.data.openLink(link)
    const name = 'The pasted text'
    const region = regionOfText(text)
    const bytes = new TextEncoder().encode(text)
    if (region?.polygons !== undefined) return this.#openWithRegion(async () => bytes.slice().buffer, name, region)
    if (region !== undefined) return this.#clipTo(region.read, 'the pasted polygons')
    const read = () => this.#read(bytes, name)
    const isTable = !/^\s*[[{<]/.test(text)
    if (!isTable || this.#editing.circles.count === 0) return this.#openRead(read)
    return this.#add(read)
  }

  async #add(read: () => Promise<Read>): Promise<HowOpened> {
    const gesture = this.#actions.circles.beginGesture()
    try {
      const result = await read()
      if ('link' in result) return this.#actions.data.openLink(result.link)
      const { circles, degrees } = result
      // Degrees and other units are no circles of one plane.
      if (degrees !== undefined && this.#editing.scene?.degrees === undefined) return this.#openRead(async () => result)
      const added = Array.from({ length: circles.length / 3 }, (_, i) => circleAt(circles, i))
      const ids = await this.#actions.circles.add(added, gesture)
      if (ids.length === 0) return 'refused'
      this.#actions.camera.reveal(added)
      const count = ids.length === 1 ? 'One circle was' : `${wholeNumber(ids.length)} circles were`
      const replace = async () => {
        await this.#actions.circles.undo()
        await this.#actions.data.openRead(async () => result)
      }
      await this.#editing.setColumns(columnsFor(ids, result.attributes, this.#editing.attributes), gesture)
      toast(`${count} added.`, { label: 'Replace all circles instead', act: replace })
      return 'opened'
    } catch (error) {
      this.#actions.messages.complain((error as Error).message)
      if (error instanceof InvalidRows) this.#offerToSkip(error, () => this.#add(error.skipping))
      return 'refused'
    }
  }

  async #readFile(file: File): Promise<Read> {
    if (file.size > LARGEST_FILE) throw new Error(`${file.name}: the file is too large.`)
    const bytes = await file.arrayBuffer().catch(() => {
      throw new Error(unreadable(file))
    })
    return this.#read(new Uint8Array(bytes), file.name)
  }

  /** Reads a file. `columns` is the user's choice, for a table whose columns the reader does not know. */
  async #read(bytes: Uint8Array<ArrayBuffer>, name: string, how: HowRead = {}): Promise<Read> {
    const { columns } = how
    // Copies the bytes, because the thread takes them over.
    const read = (skipsInvalid: boolean) =>
      this.#threads.reader.call('read', bytes.slice(), name, { ...how, skipsInvalid })
    try {
      return await read(false)
    } catch (error) {
      const { message } = error as Error
      const skipping = await read(true).catch(() => undefined)
      if (skipping !== undefined && 'skipped' in skipping && (skipping.skipped ?? 0) > 0) {
        throw new InvalidRows(message, skipping.skipped as number, async () => skipping)
      }
      if (isBinary(bytes)) throw new Error(`${name} is not a table of circles. ${READABLE}`)
      const table = columns === undefined ? unknownTable(new TextDecoder().decode(bytes)) : undefined
      // With three unnamed columns, the error is about a row and not about the columns.
      if (table === undefined || (table.heading.length === 3 && !table.hasHeading)) throw error
      const chosen = await chooseColumns(table, name, (circles) => this.#threads.reader.call('preview', circles))
      // The user has canceled the dialog and needs no message.
      if (chosen === undefined) throw new Error('')
      return this.#read(bytes, name, { columns: chosen })
    }
  }

  async saveAs(format: SavedFormat): Promise<void> {
    await this.#try(async () => {
      const circles = this.#editing.circles.circles()
      const { domain, scene } = this.#editing
      const attributes = fileAttributes(this.#editing)
      const text = await this.#threads.files.call('write', circles, format, domain, attributes, scene?.headings)
      const [ending, type] = TYPES[format]
      save(new Blob([text], { type }), `${this.#name}${ending}`)
      if (format === 'cells')
        toast(domain.region === undefined ? cutTo(text) : 'The cells are those inside the region.')
      else if (domain.areas !== undefined) toast(WEIGHTS)
    })
  }

  /**
   * Saves the drawing with a link that opens it again, or with a table of the circles if they are too many for a
   * link.
   */
  async saveDrawing(part: Part): Promise<void> {
    await this.#try(async () => {
      const shot = this.#shotOf(part)
      const [drawing, link] = [await toSVG(this.#view, shot), await this.#link()]
      const svg = link !== '' ? withLink(drawing, link) : withTable(drawing, await this.#csv())
      save(new Blob([svg], { type: 'image/svg+xml' }), `${this.#name}.svg`)
      toast(extentOf(shot))
    })
  }

  /** Saves the picture, enlarged by a factor. */
  async savePicture(part: Part, scale: number): Promise<void> {
    const shot = this.#shotOf(part)
    await this.#try(async () => {
      save(await toPNG(this.#view, scale, shot), `${this.#name}.png`)
      toast(extentOf(shot))
    })
  }

  /** Saves the picture in the aspect ratio of a sheet of paper, which extends it on two sides. */
  async savePoster(part: Part): Promise<void> {
    const { camera, size } = this.#shotOf(part)
    const isWide = size.width >= size.height
    const [across, down] = isWide ? [POSTER.long, POSTER.short] : [POSTER.short, POSTER.long]
    const scale = Math.min(across / size.width, down / size.height)
    const sheet = { camera, size: { width: across / scale, height: down / scale } }
    await this.#try(async () => {
      save(await toPNG(this.#view, scale, sheet), `${this.#name}-poster.png`)
      toast(extentOf(sheet))
    })
  }

  /** Saves a picture of all circles with a caption, in the size that other sites show beside a link. */
  async saveCard(): Promise<void> {
    await this.#try(async () => {
      const { cardOf, CARD } = await import('./card.ts')
      const shot = this.#shotOf('all', { width: CARD.width, height: CARD.height - CARD.caption })
      const title = labelOf(dataSetName(this.#store.get())) || 'Voronoi diagram of circles'
      save(await cardOf(await toPNG(this.#view, 1, shot), title, location.host), `${this.#name}-card.png`)
    })
  }

  #shotOf(part: Part, size = this.#view.size): ExportView {
    if (part === 'seen') return { camera: this.#view.camera, size }
    const room = { top: MARGIN, right: MARGIN, bottom: MARGIN, left: MARGIN }
    return { camera: fitted(boxOf(this.#editing.circles.box(), this.#editing.domain), size, room), size }
  }

  /** Opens the system's dialog for sharing the link. */
  async shareLink(): Promise<void> {
    await this.#try(async () => {
      const url = addressOf(`#${await this.#shortLink(this.#actions.opening.linkState())}`)
      await navigator.share({ title: document.title, url }).catch((error: Error) => {
        // The user has closed the dialog.
        if (error.name !== 'AbortError') throw error
      })
    })
  }

  /** Copies the link to the clipboard. Resolves to its length, or to `undefined` if that failed. */
  copyLink(): Promise<number | undefined> {
    return this.#copy((link) => addressOf(`#${link}`), this.#actions.opening.linkState())
  }

  copyEmbedCode(): Promise<number | undefined> {
    const state = this.#actions.opening.linkState()
    const shape = state?.step === undefined ? 'figure' : 'player'
    return this.#copy((link) => embedCode(addressOf(`embed.html#${link}`), this.#about, shape), state)
  }

  copyElementCode(): Promise<number | undefined> {
    const state = this.#wholeState()
    const controls = state.step === undefined ? 'controls' : 'controls="player"'
    return this.#copy((link) => elementCode(addressOf('element.js'), link, controls, this.#about), state)
  }

  /** Describes the figure for screen readers, until its author does. */
  get #about(): string {
    const { count } = this.#editing.circles
    return `Voronoi diagram of ${count} ${count === 1 ? 'circle' : 'circles'}`
  }

  /** Copies the code of a frame with a question about the current state, or the address of the frame. */
  copyQuestion(what: 'code' | 'link', frame: LinkFrame): Promise<number | undefined> {
    const state = this.#questionState(frame)
    const shape = state.step === undefined ? 'question' : 'player'
    const name = frame.alt ?? frame.title ?? this.#about
    const codeOf = (address: string) => (what === 'code' ? embedCode(address, name, shape) : address)
    return this.#copy((link) => codeOf(addressOf(`embed.html#${link}`)), state)
  }

  /**
   * Prints the circles without their cells, to draw on, with a task and a code of the frame's address; and a key with the
   * diagram.
   */
  async printWorksheet(frame: LinkFrame, task: string): Promise<void> {
    await this.#try(async () => {
      const state = this.#questionState(frame)
      const shot = state.view === undefined ? this.#shotOf('all', SHEET) : this.#shotOf('seen')
      const { check, lang = 'en' } = frame
      const [link, key, facts] = await Promise.all([
        this.#shortLink(state),
        toPrint(this.#view, shot),
        this.#view.scene.ask('tell', [check === undefined ? [] : idsOf(check)]),
        loadWords(lang),
      ])
      const { printWorksheet } = await import('./worksheet.ts')
      const { circles } = this.#editing
      const rings =
        check === undefined || facts === undefined
          ? []
          : goalRings(check, goalsOf(check, facts), false, wordsOf(lang).goals)
      await printWorksheet(byId('worksheet', HTMLElement), {
        frame,
        task,
        key,
        shot,
        discs: Array.from(circles.ids(), (id) => this.#view.discOf(id) as Circle),
        // Circles are numbered as in the frame.
        marks: rings.map(({ id, text }) => ({ index: circles.countBelow(id), text })),
        address: addressOf(`embed.html#${link}`),
      })
    })
  }

  /** Opens the frame in a new tab. */
  async openQuestion(frame: LinkFrame): Promise<void> {
    // Browsers open a tab only during the click, not a moment later.
    const tab = window.open('', '_blank')
    const isOpened = await this.#try(async () => {
      const link = await this.#shortLink(this.#questionState(frame))
      if (tab !== null) tab.location.href = addressOf(`embed.html#${link}`)
    })
    if (!isOpened) tab?.close()
  }

  /** Saves a SCORM 1.2 file with the question for a learning management system. */
  async saveCourse(frame: LinkFrame): Promise<void> {
    await this.#try(async () => {
      const link = await this.#shortLink(this.#questionState(frame))
      const { coursePackage } = await import('../course/course-package.ts')
      const { title = 'Voronoi diagram of circles', lang = 'en' } = frame
      const bytes = await coursePackage({ link, title, lang }, addressOf('element.js'))
      save(new Blob([bytes], { type: 'application/zip' }), 'question-scorm.zip')
    })
  }

  /** A check names circles by their indices in the link. */
  #questionState(frame: LinkFrame): LinkInput {
    const { circles } = this.#editing
    const check = frame.check && withIds(frame.check, (id) => circles.countBelow(id))
    return { ...this.#wholeState(), ...frame, ...(check && { check }) }
  }

  /** The current state with the circles themselves, because data sets exist only on this site. */
  #wholeState(): LinkInput {
    const { view, layers, step, method, areas } = this.#actions.opening.linkState() ?? {}
    const { circles, domain, colors } = this.#editing
    const { region, lattice } = domain
    const attributes = fileAttributes(this.#editing)
    return { circles: circles.circles(), attributes, colors, view, layers, step, method, region, lattice, areas }
  }

  async #copy(textOf: (link: string) => string, state: LinkInput | undefined): Promise<number | undefined> {
    let length: number | undefined
    await this.#try(async () => {
      const text = this.#shortLink(state).then(textOf)
      // Safari copies only items created during the click, so the text is passed as a promise.
      const item = new ClipboardItem({ 'text/plain': text.then((text) => new Blob([text], { type: 'text/plain' })) })
      await Promise.all([text, navigator.clipboard.write([item])])
      length = (await text).length
    })
    return length
  }

  async #shortLink(state: LinkInput | undefined): Promise<string> {
    const link = await this.#link(state)
    if (link === '' || link.length > LONGEST_LINK) {
      throw new Error('These are too many circles for a link: save them as a file.')
    }
    return link
  }

  /** Resolves to an empty text if the state is too large for a link. */
  async #link(state = this.#actions.opening.linkState()): Promise<string> {
    try {
      return await this.#threads.links.linkOf(state ?? {})
    } catch (error) {
      if (error instanceof CircleVoronoiError && error.code === 'linkTooLong') return ''
      throw error
    }
  }

  #csv(): Promise<string> {
    const { circles } = this.#editing
    return this.#threads.files.call('write', circles.circles(), 'csv', undefined, fileAttributes(this.#editing))
  }

  /** The name of saved files: that of the file that was opened, or of the family of random circles. */
  get #name(): string {
    const dataSet = dataSetName(this.#store.get())
    const file = this.#editing.scene?.file?.replace(/(-cells)?\.[^.]*$/, '') ?? ''
    if (file !== '') return file
    return sourceOf(dataSet) === undefined ? 'circles' : dataSet.replaceAll(':', '-')
  }

  /** Runs an action and reports its error. Resolves to whether it succeeded. */
  async #try(act: () => Promise<void>): Promise<boolean> {
    try {
      await act()
      return true
    } catch (error) {
      this.#actions.messages.complain((error as Error).message)
      return false
    }
  }
}

function isPicture({ type }: File): boolean {
  return type.startsWith('image/') && type !== 'image/svg+xml'
}

/**
 * The columns of circles that were added, by the ids of the circles. The columns of names and colors go into those of the
 * circles that are there.
 */
function columnsFor(
  ids: readonly number[],
  added: Attributes | undefined,
  { columns }: Attributes,
): Map<string, Map<number, string>> {
  const own = added?.columns ?? []
  return new Map(
    own.map((column) => {
      const { name, values } = column
      const same = [nameColumn, colorColumn].find((find) => find(own) === column)?.(columns)
      const known = same ?? columns.find((other) => other.name.toLowerCase() === name.toLowerCase())
      return [known?.name ?? name, new Map(ids.map((id, k) => [id, values[k] ?? '']))] as const
    }),
  )
}

function unreadable({ name }: File): string {
  return `${name} cannot be read. Open a file, not a folder; if it is a file, it may have been moved or changed.`
}

/** Some rows of a file are invalid. The others can be opened without them. */
class InvalidRows extends Error {
  readonly count: number
  readonly skipping: () => Promise<Read>

  constructor(message: string, count: number, skipping: () => Promise<Read>) {
    super(message)
    this.count = count
    this.skipping = skipping
  }
}

/** Describes the clipping region of a file in a sentence. */
function cutTo(text: string): string {
  if (/^.*\n.*"shifts":/.test(text)) return 'The cells are whole, also where they cross the box.'
  const box = /^\{"type":"FeatureCollection","bbox":(\[[^\]]*\])/.exec(text)?.[1] ?? '[]'
  return `The cells are cut to ${boxInWords(JSON.parse(box))}.`
}

/** Returns a sentence about the visible part of the plane. */
function extentOf({ camera, size }: ExportView): string {
  const [low, high] = [
    { x: 0, y: size.height },
    { x: size.width, y: 0 },
  ].map((corner) => toPlane(camera, size, corner))
  return `The picture shows ${boxInWords([low, high].flatMap((corner) => [corner?.x ?? 0, corner?.y ?? 0]))}.`
}

function boxInWords(box: readonly number[]): string {
  const [minX, minY, maxX, maxY] = box.map((value) => short(value, 4))
  return `the box from ${minX}, ${minY} to ${maxX}, ${maxY}`
}

/** Whether the bytes contain one that does not occur in text. */
function isBinary(bytes: Uint8Array): boolean {
  const isUtf16 = (bytes[0] === 0xff && bytes[1] === 0xfe) || (bytes[0] === 0xfe && bytes[1] === 0xff)
  return !isUtf16 && bytes.subarray(0, 4096).includes(0)
}

/** The address of a file next to this page. */
function addressOf(name: string): string {
  return new URL(name, `${location.origin}${location.pathname}`).href
}
