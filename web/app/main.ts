// SPDX-License-Identifier: GPL-3.0-or-later
import { Actions } from './actions.ts'
import type { Padding, Size } from './camera.ts'
import { Computer } from './computer.ts'
import { DATA_SETS } from './data-sets.ts'
import { listenToKeyboard } from './input/keyboard.ts'
import { listenToPointer } from './input/pointer.ts'
import { byId } from './panels/by-id.ts'
import { mountInspector } from './panels/inspector.ts'
import { mountStatus } from './panels/status.ts'
import { mountToolbar } from './panels/toolbar.ts'
import { mountViewControls } from './panels/view-controls.ts'
import { Scene } from './scene.ts'
import { INITIAL_STATE, refused, type State } from './state.ts'
import { createStore } from './store.ts'
import { onThemeChange, readTheme } from './theme.ts'

// input ──► actions ──► store ──► panels and scene
//                         │ ▲
//             circles     ▼ │     diagram
//                       computer

const canvas = byId('canvas', HTMLCanvasElement)
const context = canvas.getContext('2d') as CanvasRenderingContext2D
const store = createStore<State>(INITIAL_STATE)

const size = (): Size => ({ width: canvas.clientWidth, height: canvas.clientHeight })

/** What the panels at the top and at the bottom cover, and a margin. */
const padding = (): Padding => ({ top: 72, right: 32, bottom: 64, left: 32 })

const actions = new Actions(store, size, padding)

const computer = new Computer((reply) => {
  store.update((state) => ('diagram' in reply ? { ...state, diagram: reply.diagram } : refused(state, reply.problem)))
})

let computed = INITIAL_STATE.circles
store.subscribe(({ circles }) => {
  if (circles !== computed) computer.request(circles)
  computed = circles
})

let scene = new Scene(context, readTheme())
const draw = (state: State) => {
  const pixelRatio = devicePixelRatio
  const { width, height } = size()
  const deviceWidth = Math.round(width * pixelRatio)
  const deviceHeight = Math.round(height * pixelRatio)
  if (canvas.width !== deviceWidth) canvas.width = deviceWidth
  if (canvas.height !== deviceHeight) canvas.height = deviceHeight
  scene.draw(state, { width, height }, pixelRatio)
}
store.subscribe(draw)
new ResizeObserver(() => draw(store.get())).observe(canvas)
onThemeChange(() => {
  scene = new Scene(context, readTheme())
  draw(store.get())
})

mountToolbar(store, actions)
mountViewControls(actions)
mountStatus(store)
const editNumbers = mountInspector(store, actions)
listenToKeyboard(canvas, store, actions, editNumbers)
listenToPointer(canvas, store, actions, size)

await actions.load((DATA_SETS[0] as (typeof DATA_SETS)[number]).id)
