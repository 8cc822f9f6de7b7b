// SPDX-License-Identifier: GPL-3.0-or-later
// Opening and saving files on the whole page.
// @vitest-environment happy-dom

import { beforeAll, beforeEach, describe, expect, it } from 'vitest'
import { FilesClient } from '../../web/app/files/files-client.ts'
import { valueIn } from '../../web/editing/attributes.ts'
import { nameIn } from '../../web/editing/identity.ts'
import { CircleVoronoiError } from '../../web/lib/index.ts'
import { encodeLink, type LinkInput } from '../../web/lib/link.ts'
import { DEFAULT_LAYERS } from '../../web/view/layers.ts'
import { all, choose, control, element, send, textOf } from './page-document.ts'
import { outputs } from './page-outputs.ts'
import { ThreadHere } from './page-threads.ts'
import { box } from './shapes.ts'
import { entered, FIVE, pressed, quiet, soon, wholePage } from './whole-page.ts'

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
    await page.actions.circles.setDomain({ region: [box(-9, -9, 30, 30)] })
    all.push(await saved())
    await page.actions.domain.repeat()
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
  const told = () =>
    soon(() => {
      const text = textOf(dialog().querySelector('.told') as Element)
      expect(text).not.toBe('')
      return text
    })
  const chosen = (name: string) => {
    const select = control(dialog(), name) as Element as HTMLSelectElement
    return [...select.options].find(({ selected }) => selected)?.textContent
  }

  it.each(['x,y,r,radius\n1,2,3,4\n', 'x,lon,y,r\n1,2,3,4\n', 'x,y,n\n1,2,3\n', 'Rechtswert;Hochwert;r\n1;2;3\n'])(
    'is there where the readers do not know the columns: %j',
    async (text) => {
      await open(text, 'a.csv')
      expect(dialog().open).toBe(true)
      await close('')
    },
  )

  it('rounds long numbers in its rows', async () => {
    await open('x,y,n\n37.142857142857146,2,12345678901234\n', 'a.csv')
    expect(all(dialog(), 'td').map(textOf)).toEqual(['37.1429', '2', '12345678901234'])
    await close('')
  })

  it('says how many circles are hidden before they are opened, for each way to get radii', async () => {
    await open(
      'Tree no;Species;X (m);Y (m);Dia (cm)\n1;oak;0;0;300\n2;;1;0;100\n3;fir;9;0;400\n4;fir;9;9;x\n',
      'trees.csv',
    )
    expect([chosen('x'), chosen('y'), chosen('radius'), chosen('read as')]).toEqual([
      'X (m)',
      'Y (m)',
      'Dia (cm)',
      'diameter: halved',
    ])
    expect(control(dialog(), 'factor').value).toBe('0.01')
    expect(await told()).toMatch(/^1 circle is hidden .* 1 row is not a circle/)
    expect(dialog().querySelector('.hidden')?.getAttribute('d')).not.toBe('')
    expect(dialog().querySelector('.edges')?.getAttribute('d')).toContain('M')
    await entered(dialog(), 'factor', '0.001')
    expect(await told()).toContain('No circle is hidden')
    await entered(dialog(), 'read as', 'radius')
    expect(control(dialog(), 'factor').value).toBe('0.01')
    expect(await told()).toContain('1 circle is hidden')
    await entered(dialog(), 'read as', 'root')
    expect(await told()).toContain('No circle is hidden')
    await entered(dialog(), 'read as', 'diameter')
    await close('open')
    await soon(() => expect(problem()).toContain('trees.csv:5'))
    page.store.get().remedy?.act()
    await soon(() => expect(circles()).toEqual([0, 0, 1.5, 1, 0, 0.5, 9, 0, 2]))
    const { columns } = page.editing.attributes
    expect(columns.map(({ name }) => name)).toEqual(['Dia (cm)', 'Tree no', 'Species'])
  })

  it('gives the radius another column than the center, and one size to all circles', async () => {
    await open('a,b,c\n0,0,1\n9,0,1\n', 'a.csv')
    expect(chosen('radius')).toBe('c')
    await entered(dialog(), 'y', '2')
    expect(chosen('radius')).toBe('the same for all')
    await entered(dialog(), 'r', '10')
    expect(await told()).toContain('No circle is hidden')
    await close('open')
    await soon(() => expect(circles()).toEqual([0, 1, 10, 9, 1, 10]))
  })
})

describe('points and polygons of one file', () => {
  const feature = (geometry: object, properties: object = {}) => ({ type: 'Feature', properties, geometry })
  const square = (x: number, size: number) =>
    feature({ type: 'Polygon', coordinates: [[...box(x, x, x + size, x + size), [x, x]]] })
  const point = (x: number) => feature({ type: 'Point', coordinates: [x, x] }, { r: 1, name: `P${x}` })
  const text = (...features: object[]) => JSON.stringify({ type: 'FeatureCollection', features })
  const corners = () => JSON.stringify(page.editing.domain.region).match(/\[-?\d/g)?.length

  it('are circles and their region, which is saved with them', async () => {
    await open(text(point(1), square(-5, 20), point(4)), 'both.geojson')
    await soon(() => expect(circles()).toEqual([1, 1, 1, 4, 4, 1]))
    expect(corners()).toBeGreaterThan(3)
    expect(nameIn(page.editing.attributes, 1)).toBe('P4')
    await pressed(panel, 'GeoJSON')
    const saved = await out.file()
    expect(saved.name).toBe('both.geojson')
    await open(saved.text, 'again.geojson')
    await soon(() => expect(page.editing.scene?.file).toBe('again.geojson'))
    expect([circles(), corners()]).toEqual([[1, 1, 1, 4, 4, 1], expect.any(Number)])
    await page.actions.circles.undo()
    await page.actions.circles.undo()
    expect([circles(), page.editing.domain.region]).toEqual([[...FIVE], undefined])
  })

  it('keep the region if an invalid point is skipped', async () => {
    const invalid = feature({ type: 'Point', coordinates: [2, 2] })
    await open(text(point(1), square(-5, 20), invalid), 'both.geojson')
    await soon(() => expect(problem()).toContain('feature'))
    await pressed(element('problem'), 'Skip 1 row')
    await soon(() => expect(circles()).toEqual([1, 1, 1]))
    expect(corners()).toBeGreaterThan(3)
  })

  it('are merged on request if they overlap, and pasted like a file', async () => {
    send(document, 'paste', {
      clipboardData: {
        files: [],
        getData: (type: string) => (type === 'text/plain' ? text(square(0, 9), square(4, 9), point(5)) : ''),
      },
    })
    await soon(() => expect(toast()).toContain('overlap'))
    expect(circles()).toEqual([...FIVE])
    await pressed(element('toast'), 'Merge polygons')
    await soon(() => expect(circles()).toEqual([5, 5, 1]))
  })
})

describe('a pasted table', () => {
  const paste = (text: string) =>
    send(document, 'paste', {
      clipboardData: { files: [], getData: (type: string) => (type === 'text/plain' ? text : '') },
    })

  it('keeps its names and columns, as one step of undo', async () => {
    paste('x,y,r,Ort,n\n50,50,1,Ulm,7\n60,60,1,Bonn,8\n')
    await soon(() => expect(page.editing.circles.count).toBe(7))
    await soon(() => expect([5, 6].map((id) => nameIn(page.editing.attributes, id))).toEqual(['Ulm', 'Bonn']))
    expect(nameIn(page.editing.attributes, 0)).toBe('Aa')
    expect(page.editing.attributes.columns.map(({ name }) => name)).toEqual(['name', 'n'])
    expect(valueIn(page.editing.attributes, 'n', 6)).toBe('8')
    await page.actions.circles.undo()
    expect([page.editing.circles.count, page.editing.attributes.columns.length]).toEqual([5, 1])
  })
})

describe('saved data', () => {
  const saved = async (button: string) => {
    await pressed(panel, button)
    return out.file()
  }

  it('has the name of the file and its headings, also after an edit and undo', async () => {
    await open('Longitude;Latitude;Radius;Ort\n1;2;3;Ulm\n9;2;1;Bonn\n', 'my places.v2.csv')
    await soon(() => expect(circles()).toEqual([1, 2, 3, 9, 2, 1]))
    await page.actions.circles.edit([{ kind: 'remove', id: 0 }])
    const { name, text } = await saved('CSV')
    expect([name, text]).toEqual(['my places.v2.csv', 'Longitude,Latitude,Radius,Ort\n9,2,1,Bonn\n'])
    expect((await saved('SVG')).name).toBe('my places.v2.svg')
    await page.actions.circles.undo()
    await page.actions.circles.undo()
    expect((await saved('CSV')).text).toMatch(/^x,y,r,name\n/)
  })

  it('has its headings after a reload, too', async () => {
    await open('Longitude;Latitude;Radius;Ort\n1;2;3;Ulm\n9;2;1;Bonn\n', 'places.csv')
    await soon(() => expect(circles()).toEqual([1, 2, 3, 9, 2, 1]))
    await page.actions.circles.edit([{ kind: 'remove', id: 0 }])
    const link = await encodeLink(page.actions.opening.linkState() as LinkInput)
    await page.open(FIVE)
    expect((await saved('CSV')).text).toMatch(/^x,y,r\n/)
    // The page opens the link of its address.
    await page.actions.data.openLink(link)
    expect((await saved('CSV')).text).toBe('Longitude,Latitude,Radius,Ort\n9,2,1,Bonn\n')
  })

  it('says that r has weights if areas were given', async () => {
    await saved('CSV')
    expect(toast()).toBe('')
    await page.actions.circles.setDomain({ region: [box(-9, -9, 30, 30)] })
    await page.actions.domain.setAreas('equal')
    await saved('CSV')
    await soon(() => expect(toast()).toContain('weights'))
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
