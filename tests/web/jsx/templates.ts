// SPDX-License-Identifier: GPL-3.0-or-later
// Types of the element in the templates of Vue and Svelte: `npm run check` compiles this.
import '../../../web/element/index.ts'
import type { SvelteHTMLElements } from 'svelte/elements'
import type { GlobalComponents } from 'vue'

type VueProps = InstanceType<GlobalComponents['circle-voronoi']>['$props']
type SvelteProps = SvelteHTMLElements['circle-voronoi']

const circles = [[0, 0, 1]]
export const vue: VueProps = { circles, class: 'figure', onCircleschange: ({ detail }) => detail.ids }
export const svelte: SvelteProps = { circles, class: 'figure', oncircleschange: ({ detail }) => detail.ids }
// @ts-expect-error There is no such method.
export const wrongVue: VueProps = { method: 'magic' }
// @ts-expect-error There is no such method.
export const wrongSvelte: SvelteProps = { method: 'magic' }
