// SPDX-License-Identifier: GPL-3.0-or-later

import { checkNumber, refuseInput } from '../base/check.ts'
import type { CircleLike } from '../base/coordinates.ts'
import { NONE } from '../base/diagram-data.ts'
import { callListener } from '../base/errors.ts'
import type { Certificate, Circle, Int32s } from '../base/types.ts'
import { type Change, changeOf } from '../diagram/change.ts'
import { DiagramSnapshot } from '../diagram/diagram-snapshot.ts'
import {
  type CheckedEdit,
  checkedCircle,
  checkedEdits,
  checkId,
  type Edit,
  type EditorMethods,
  type EditorStart,
  refuse,
} from './editor.ts'
import type { TraceArrays } from './trace.ts'
import { unwrap, type WasmError } from './wasm.ts'

/** The functions of the module that an editor needs. */
type EditorModule = Pick<
  WasmModule,
  | 'createEditor'
  | 'deleteEditor'
  | 'editCircle'
  | 'applyEdits'
  | 'traceEdits'
  | 'nearestCircle'
  | 'editorSize'
  | 'circleOfEditor'
  | 'idsOfEditor'
  | 'snapshotOfEditor'
  | 'certificateOfEditor'
>

/** A function that makes editors in a module. */
export function editorsOf(module: EditorModule): (start: EditorStart) => Editor {
  // Frees editors that were not disposed of.
  const registry = new FinalizationRegistry((address: number) => module.deleteEditor(address))
  return ({ circles, weights, ids = new Int32Array(), nextId = NONE }) =>
    new Editor(module, registry, weights, unwrap(module.createEditor(circles, weights, ids, nextId)).editor)
}

/** The values of `Edit.kind`, by their numbers in the core. */
const KINDS = ['insert', 'remove', 'replace']
const INSERT = 0
const REMOVE = 1
const REPLACE = 2

/** A `DiagramEditor`, which can also be traced. */
export class Editor implements EditorMethods {
  onchange: ((change: Change) => void) | undefined
  readonly #module: EditorModule
  readonly #registry: FinalizationRegistry<number>
  readonly #weights: boolean
  /** The address in the module; 0 after `dispose`. */
  #address: number
  #revision = 0

  constructor(module: EditorModule, registry: FinalizationRegistry<number>, weights: boolean, address: number) {
    this.#module = module
    this.#registry = registry
    this.#weights = weights
    this.#address = address
    registry.register(this, address, this)
  }

  insert(circle: CircleLike, hint: number = NONE): Change {
    const { x, y, r } = checkedCircle(circle, this.#weights)
    checkNumber(hint, 'insert', 'hint')
    return this.#changed(this.#module.editCircle(this.#live(), INSERT, NONE, x, y, r, hint))
  }

  remove(id: number): Change {
    checkId(id, 'remove')
    return this.#changed(this.#module.editCircle(this.#live(), REMOVE, id, 0, 0, 0, NONE))
  }

  replace(id: number, circle: CircleLike): Change {
    checkId(id, 'replace')
    const { x, y, r } = checkedCircle(circle, this.#weights, id)
    return this.#changed(this.#module.editCircle(this.#live(), REPLACE, id, x, y, r, NONE))
  }

  apply(edits: Iterable<Edit>): Change {
    const checked = checkedEdits(edits, this.#weights)
    return this.#changed(this.#module.applyEdits(this.#live(), numbersOf(checked)))
  }

  /** Applies the edits and returns their events. */
  trace(edits: Iterable<Edit>): TraceArrays {
    const checked = checkedEdits(edits, this.#weights)
    return unwrap(this.#module.traceEdits(this.#live(), numbersOf(checked)))
  }

  nearest(x: number, y: number, hint: number = NONE): number {
    checkNumber(x, 'nearest', 'x')
    checkNumber(y, 'nearest', 'y')
    checkNumber(hint, 'nearest', 'hint')
    return this.#module.nearestCircle(this.#live(), x, y, hint)
  }

  size(): number {
    return this.#module.editorSize(this.#live())
  }

  circle(id: number): Circle | undefined {
    checkId(id, 'circle')
    const numbers = this.#module.circleOfEditor(this.#live(), id)
    if (numbers === undefined) return undefined
    const [x = 0, y = 0, r = 0] = numbers
    return { x, y, r }
  }

  isHidden(id: number): boolean {
    checkId(id, 'isHidden')
    const numbers = this.#module.circleOfEditor(this.#live(), id)
    if (numbers === undefined) refuse('unknownCircle', `There is no circle with id ${id}.`, id)
    return numbers[3] === 1
  }

  ids(): Int32s {
    return unwrap(this.#module.idsOfEditor(this.#live()))
  }

  snapshot(): DiagramSnapshot {
    const { numbers, ...data } = unwrap(this.#module.snapshotOfEditor(this.#live()))
    return new DiagramSnapshot({ metric: 'circles', ...data, numbers: { revision: this.#revision, ...numbers } })
  }

  certificate(): Certificate {
    return unwrap(this.#module.certificateOfEditor(this.#live()))
  }

  dispose(): void {
    if (this.#address === 0) return
    this.#registry.unregister(this)
    this.#module.deleteEditor(this.#address)
    this.#address = 0
  }

  [Symbol.dispose](): void {
    this.dispose()
  }

  #live(): number {
    if (this.#address === 0) refuseInput('The editor has been disposed of.')
    return this.#address
  }

  #changed(result: Uint8Array | WasmError): Change {
    const bytes = unwrap(result)
    this.#revision += 1
    const change = changeOf(bytes, this.#revision)
    callListener(this.onchange, change)
    return change
  }
}

/** For each edit its kind, id, x, y and r. `NONE` stands for a new id. */
function numbersOf(edits: readonly CheckedEdit[]): Float64Array {
  const numbers = new Float64Array(5 * edits.length)
  let place = 0
  for (const { kind, id = NONE, circle: { x, y, r } = NOTHING } of edits) {
    numbers[place++] = KINDS.indexOf(kind)
    numbers[place++] = id
    numbers[place++] = x
    numbers[place++] = y
    numbers[place++] = r
  }
  return numbers
}

const NOTHING: Circle = { x: 0, y: 0, r: 0 }
