// SPDX-License-Identifier: GPL-3.0-or-later
// Opening and saving files on the whole page.
// @vitest-environment happy-dom
import { beforeAll, beforeEach, describe, expect, it } from 'vitest'
import { FilesClient } from '../../web/app/files/files-client.ts'
import { CircleVoronoiError } from '../../web/lib/index.ts'
import { DEFAULT_LAYERS } from '../../web/view/layers.ts'
import { choose, control, element, send, textOf } from './page-document.ts'
import { outputs } from './page-outputs.ts'
import { ThreadHere } from './page-threads.ts'
import { box } from './shapes.ts'
import { FIVE, pressed, quiet, soon, wholePage } from './whole-page.ts'

let page: Awaited<ReturnType<typeof wholePage>>
let out: ReturnType<typeof outputs>
let panel: HTMLElement
const toast = () => (element('toast').hidden ? '' : textOf(element('toast')))
const problem = () => page.store.get().problem
const circles = () => [...page.editing.circles.circles()]

beforeAll(async () => {
  out = outputs()
  page = await wholePage()
  panel = await page.panel('files')
})
beforeEach(async () => {
  page.view.setLayers(DEFAULT_LAYERS)
  await page.open(FIVE, [{ name: 'name', values: ['"Aa"', '', '', '', ''] }])
  element('toast').hidden = true
})

/** Chooses a file in the panel, and waits until it has been opened or refused. */
async function open(text: BlobPart, name: string, type = '') {
  const now = () => [
    page.store.get().edited,
    problem(),
    element('toast').innerHTML,
    element<HTMLDialogElement>('columns').open,
  ]
  const before = now()
  choose(control(panel, 'Open …'), new File([text], name, { type }))
  await soon(() => expect(now()).not.toEqual(before))
  await quiet()
}

describe('saving', () => {
  it('cells says where they end: at a box, at the region, or nowhere', async () => {
    const saved = async () => {
      await pressed(panel, 'Cells')
      const { name, text } = await out.file()
      await soon(() => expect(toast()).not.toBe(''))
      return [name, JSON.parse(text).features.length, toast()]
    }
    const all = [await saved()]
    await page.actions.setDomain({ region: [box(-9, -9, 30, 30)] })
    all.push(await saved())
    await page.actions.repeat()
    all.push(await saved())
    expect(all.map(([name, count]) => [name, count])).toEqual(Array(3).fill(['circles-cells.geojson', 5]))
    expect(new Set(all.map(([, , said]) => said)).size).toBe(3)
  })
})

describe('a file', () => {
  it('that is no table, no picture or too large is named in the problem, and changes nothing', async () => {
    await open(Uint8Array.of(1, 0, 2, 255, 0, 9), 'a.bin')
    expect(problem()).toContain('a.bin')
    await open('', 'a.png', 'image/png')
    expect(problem()).toContain('a.png')
    const large = Object.defineProperty(new File(['1,2,3'], 'l.csv'), 'size', { value: 2 ** 28 + 1 })
    choose(control(panel, 'Open …'), large)
    await soon(() => expect(problem()).toContain('l.csv'))
    expect(circles()).toEqual([...FIVE])
  })
})

it('a folder is named in the problem, and the second of two files that are dropped is not forgotten', async () => {
  const drop = async (...files: File[]) => {
    send(document, 'drop', { dataTransfer: { files, getData: () => '' } })
    await quiet()
  }
  const refuse = () => Promise.reject(new DOMException('A folder', 'NotFoundError'))
  const folder = Object.assign(new File([], 'folder'), { text: refuse, arrayBuffer: refuse })
  await drop(Object.assign(folder, { slice: () => folder }))
  await soon(() => expect(problem()).toContain('folder'))
  expect(circles()).toEqual([...FIVE])
  await drop(new File(['1,2,3\n'], 'a.csv'), new File(['4,5,6\n'], 'b.csv'))
  await soon(() => expect(circles()).toEqual([1, 2, 3]))
  await soon(() => expect(toast()).toContain('a.csv'))
})

describe('the dialog for columns', () => {
  const dialog = () => element<HTMLDialogElement>('columns')
  const close = async (value: string) => {
    dialog().close(value)
    await quiet()
  }

  it.each(['x,y,r,radius\n1,2,3,4\n', 'x,lon,y,r\n1,2,3,4\n', 'x,y,n\n1,2,3\n'])(
    'is there where the names do not say everything: %j',
    async (text) => {
      await open(text, 'a.csv')
      expect(dialog().open).toBe(true)
      await close('')
    },
  )

  it('is not there where a diameter is named', async () => {
    await open('n,y,x,diameter\n9,2,1,6\n', 'a.csv')
    expect([dialog().open, circles()]).toEqual([false, [1, 2, 3]])
  })
})

it('a call of files ends where its thread breaks down or is canceled, and the next one has another thread', async () => {
  const client = new FilesClient()
  const make = () => client.call('make', { kind: 'family', family: 'grid', seed: 1, count: 9 })
  for (const end of [
    () => client.cancel(),
    () => {
      for (const thread of ThreadHere.running) if (thread.name.startsWith('files')) thread.onerror?.({ message: '' })
    },
  ]) {
    const call = make()
    end()
    await expect(call).rejects.toBeInstanceOf(CircleVoronoiError)
  }
  expect(await make()).toHaveLength(27)
})
