// SPDX-License-Identifier: GPL-3.0-or-later
// Only type-checked, with the types of the DOM.
import 'circle-voronoi/element'
import type { CircleVoronoiElement, FigureState } from 'circle-voronoi/element'
import { defineCircleVoronoi } from 'circle-voronoi/element/define'

defineCircleVoronoi({ wasm: new Uint8Array(8), name: 'my-circles' })

// The tag name has a type without a cast.
const figure: CircleVoronoiElement = document.createElement('circle-voronoi')
export const found: CircleVoronoiElement | null = document.querySelector('circle-voronoi')
figure.circles = [[0, 0, 1]]
figure.layers = { hull: true, cells: 'degree' }
figure.check = { cell: 0, edges: { min: 3 } }
figure.controls = 'player'
figure.step = 3
figure.step = undefined
export const played: Promise<void>[] = [figure.ready, figure.play(), figure.stepTo(5)]
figure.pause()
export const state: FigureState = figure.getState()
figure.setState({ ...state, step: 2 })
figure.addEventListener('stepchange', ({ detail: { step, steps } }) => step < steps)
figure.addEventListener('circleschange', ({ detail }) => detail.circles.length)
figure.addEventListener('click', ({ clientX }) => clientX)
// @ts-expect-error: a step is a number
figure.step = 'last'
// @ts-expect-error: there is no such method
figure.method = 'magic'
// @ts-expect-error: its detail has no such part
figure.addEventListener('stepchange', ({ detail }) => detail.circles)
