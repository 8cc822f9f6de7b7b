// SPDX-License-Identifier: GPL-3.0-or-later
// Tables that people bring: opened, dropped, pasted, or handed over by the playground, which opens this page.

/** Larger files are refused, in bytes. */
const LARGEST = 2 ** 26
/** The messages between this page and the page that opened it. */
const ASK = 'circle-voronoi-globe'

/**
 * Calls `open` with each table, and `complain` with a sentence if a file cannot be one.
 * @param {(table: { name: string, text: string, unit?: 'km' | 'm' }) => void} open
 * @param {(problem: string) => void} complain
 */
export function listenToTables(input, open, complain) {
  const openFile = async (file) => {
    if (file === undefined) return
    if (file.size > LARGEST) complain(`${file.name}: the file is larger than 64 MB.`)
    else open({ name: file.name, text: await file.text() })
  }
  input.addEventListener('change', () => {
    openFile(input.files[0])
    // The same file may be chosen again.
    input.value = ''
  })
  addEventListener('dragover', (event) => {
    event.preventDefault()
    document.body.classList.add('dropping')
  })
  addEventListener('dragleave', (event) => {
    if (event.relatedTarget === null) document.body.classList.remove('dropping')
  })
  addEventListener('drop', (event) => {
    event.preventDefault()
    document.body.classList.remove('dropping')
    const [file] = event.dataTransfer.files
    const text = event.dataTransfer.getData('text/plain')
    if (file !== undefined) openFile(file)
    else if (text !== '') open({ name: 'The dropped text', text })
  })
  addEventListener('paste', (event) => {
    const [file] = event.clipboardData.files
    const text = event.clipboardData.getData('text/plain')
    if (file !== undefined) openFile(file)
    else if (text.trim() !== '') open({ name: 'The pasted text', text })
  })
}

/** Asks the page that opened this one for a table. Only a page of the same site is asked. */
export function askOpener(open) {
  addEventListener('message', ({ source, origin, data }) => {
    if (origin !== location.origin || source !== window.opener || source === null) return
    if (data?.kind === ASK && typeof data.text === 'string') open(data)
  })
  window.opener?.postMessage({ kind: ASK }, location.origin)
}

const KEPT = 'circle-voronoi-globe'

/** Keeps a table for a reload of this tab. Browsers refuse large ones. */
export function keep(table) {
  try {
    sessionStorage.setItem(KEPT, JSON.stringify(table))
  } catch {
    sessionStorage.removeItem(KEPT)
  }
}

/** Returns the table that was kept; `undefined` if there is none. */
export function kept() {
  return JSON.parse(sessionStorage.getItem(KEPT) ?? 'null') ?? undefined
}
