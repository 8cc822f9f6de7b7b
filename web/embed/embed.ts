// SPDX-License-Identifier: GPL-3.0-or-later
import { loadDataSet } from '../app/data-sets.ts'
import { FilesClient } from '../app/files/files-client.ts'
import '../element/index.ts'
import { decodeLink } from '../lib/link.ts'

const figure = document.querySelector('circle-voronoi') as HTMLElementTagNameMap['circle-voronoi']
const link = document.querySelector('#open') as HTMLAnchorElement
/** It makes circles of families, if they are what is asked for. */
const files = new FilesClient()
const problem = document.querySelector('#problem') as HTMLElement

async function show(): Promise<void> {
  link.href = `./${location.hash}`
  try {
    const { circles, dataSet = '', ...rest } = await decodeLink(location.hash)
    figure.controls = rest.step === undefined ? '' : 'player'
    await figure.setState({ ...rest, circles: circles ?? (await loadDataSet(dataSet, (recipe) => files.make(recipe))) })
    problem.hidden = true
  } catch (error) {
    problem.textContent = (error as Error).message
    problem.hidden = false
  }
}

window.addEventListener('hashchange', show)
show()
