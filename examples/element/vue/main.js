// SPDX-License-Identifier: GPL-3.0-or-later
// In templates, tell the compiler: isCustomElement: (tag) => tag === 'circle-voronoi'.
import 'circle-voronoi/element'
import { createApp, h, shallowRef } from 'vue'

const START = [
  { x: 0, y: 0, r: 2 },
  { x: 10, y: 0, r: 1 },
  { x: 5, y: 8, r: 1.5 },
]

createApp({
  setup() {
    const circles = shallowRef(START)
    const counts = shallowRef()
    return () => [
      h('h1', 'With Vue'),
      h('circle-voronoi', {
        circles: circles.value,
        controls: '',
        onCircleschange: ({ detail }) => {
          circles.value = detail.circles
        },
        onDiagramchange: ({ detail }) => {
          counts.value = detail
        },
      }),
      h('p', [
        h('output', counts.value && `${counts.value.circles} circles, ${counts.value.edges} edges`),
        h('button', { type: 'button', onClick: () => (circles.value = START) }, 'Reset'),
      ]),
    ]
  },
}).mount('#app')
