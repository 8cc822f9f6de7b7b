// SPDX-License-Identifier: GPL-3.0-or-later

/** Has the browser save a file. */
export function save(content: Blob, name: string): void {
  const link = document.createElement('a')
  link.href = URL.createObjectURL(content)
  link.download = name
  link.click()
  // Once the browser has begun to read it.
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000)
}

/** HTML that shows the circles of a link in another page: two lines, with the module that is beside this page. */
export function elementCode(module: string, link: string, controls: string): string {
  return `<script type="module" src="${module}"></script>\n<circle-voronoi src="#${link}" ${controls}></circle-voronoi>`
}

/** HTML that shows a page in another one. */
export function embedCode(address: string): string {
  return `<iframe src="${address}" title="Voronoi diagram of circles" width="800" height="500" style="border: 0"></iframe>`
}
