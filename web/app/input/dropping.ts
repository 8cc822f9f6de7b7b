// SPDX-License-Identifier: GPL-3.0-or-later
import type { FileActions } from '../files/file-actions.ts'
import { NOT_LOADED } from '../not-loaded.ts'

/** Opens files dropped on the page, and content pasted outside of text fields. */
export function listenToFiles(actions: () => Promise<FileActions>, complain: (problem: string) => void): void {
  const open = async (files: readonly File[], text: string) => {
    const opening = await actions().catch(() => undefined)
    if (opening === undefined) return complain(NOT_LOADED)
    if (files.length > 0) opening.openFiles(files)
    else opening.openText(text)
  }
  const openFrom = (data: DataTransfer): boolean => {
    const files = [...data.files]
    const text = data.getData('text/plain')
    const isAny = files.length > 0 || text.trim() !== ''
    if (isAny) open(files, text)
    return isAny
  }

  // The browser would otherwise navigate to the file.
  document.addEventListener('dragover', (event) => {
    event.preventDefault()
    document.body.classList.add('dropping')
  })
  document.addEventListener('dragleave', (event) => {
    if (event.relatedTarget === null) document.body.classList.remove('dropping')
  })
  document.addEventListener('drop', (event) => {
    event.preventDefault()
    document.body.classList.remove('dropping')
    if (event.dataTransfer !== null) openFrom(event.dataTransfer)
  })
  document.addEventListener('paste', (event) => {
    const isWritten = event.target instanceof Element && event.target.closest('input, textarea') !== null
    if (!isWritten && event.clipboardData !== null && openFrom(event.clipboardData)) event.preventDefault()
  })
}
