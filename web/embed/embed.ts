// SPDX-License-Identifier: GPL-3.0-or-later
import { loadLinked } from '../app/data-sets.ts'
import { FilesClient } from '../app/files/files-client.ts'
import '../element/index.ts'
import { decodeLink } from '../lib/link.ts'

const figure = document.querySelector('circle-voronoi') as HTMLElementTagNameMap['circle-voronoi']
const link = document.querySelector('#open') as HTMLAnchorElement
/** It makes circles of families, if they are what is asked for. */
const files = new FilesClient()
const problem = document.querySelector('#problem') as HTMLElement

/** Which address is shown: what comes of another one is late. */
let lastTurn = 0

async function show(): Promise<void> {
  lastTurn += 1
  const turn = lastTurn
  link.href = `./${location.hash}`
  try {
    const { circles: own, dataSet = '', ...rest } = await decodeLink(location.hash)
    const named =
      own === undefined ? await loadLinked(dataSet, (recipe) => files.call('make', recipe)) : { circles: own }
    const { circles, domain } = { domain: undefined, ...named }
    if (turn !== lastTurn) return
    figure.controls = rest.step === undefined ? '' : 'player'
    await figure.setState({ region: domain?.region, ...rest, circles })
    if (turn === lastTurn) problem.hidden = true
  } catch (error) {
    if (turn !== lastTurn) return
    problem.textContent = (error as Error).message
    problem.hidden = false
  }
}

window.addEventListener('hashchange', show)
show()
