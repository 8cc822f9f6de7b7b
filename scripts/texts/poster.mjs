// SPDX-License-Identifier: GPL-3.0-or-later
// The picture that stands for a figure until it lives, on paper and without scripts: what the library's writer draws, with the
// layers of the figure, in the colors of the page.

/** Groups of the writer's that figures show only if they are asked for. */
const ASKED_FOR = ['dual', 'hull']

const STYLE = `
.cells { fill: #fcfcfa; }
.edges { stroke: #27447c; }
.vertices { fill: #27447c; }
.circles { fill: #5b96cc; fill-opacity: 0.7; stroke: #27447c; }
.dual { stroke: #2f8f6f; }
.hull { stroke: #6a4fb3; stroke-dasharray: none; }
@media (prefers-color-scheme: dark) {
.cells { fill: #0f141b; }
.edges { stroke: #82a8e6; }
.vertices { fill: #82a8e6; }
.circles { fill: #3f74ad; stroke: #82a8e6; }
}
`

/** @param {Readonly<Record<string, unknown>>} [layers] of the figure */
export function posterOf(svg, layers = {}) {
  const left = ASKED_FOR.filter((name) => layers[name] !== true).reduce(
    (rest, name) => rest.replace(new RegExp(`<g id="${name}"[\\s\\S]*?</g>\n`), ''),
    svg,
  )
  return left.replace('</style>', `${STYLE.trimStart()}</style>`)
}
