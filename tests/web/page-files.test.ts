// SPDX-License-Identifier: GPL-3.0-or-later
// Opening and saving files on the whole page.
// @vitest-environment happy-dom
import { beforeAll, beforeEach, describe, expect, it } from 'vitest'
import { encodeLink } from '../../web/lib/link.ts'
import { DEFAULT_LAYERS } from '../../web/view/layers.ts'
import { all, choose, chosenOf, control, element, optionsOf, press, send, textOf } from './page-document.ts'
import { outputs } from './page-outputs.ts'
import { box } from './shapes.ts'
import { entered, FIVE, pressed, quiet, soon, wholePage } from './whole-page.ts'

let page: Awaited<ReturnType<typeof wholePage>>
let out: ReturnType<typeof outputs>
let panel: HTMLElement
const toast = () => (element('toast').hidden ? '' : textOf(element('toast')))
const problem = () => page.store.get().problem
const circles = () => [...page.editing.circles.circles()]
const SQUARE = '{"type":"Polygon","coordinates":[[[-9,-9],[30,-9],[30,30],[-9,30],[-9,-9]]]}'

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
  const before = [
    page.store.get().edited,
    problem(),
    element('toast').innerHTML,
    element<HTMLDialogElement>('columns').open,
  ]
  const input = control(panel, 'Open …')
  choose(input, new File([text], name, { type }))
  await soon(() => {
    const now = [
      page.store.get().edited,
      problem(),
      element('toast').innerHTML,
      element<HTMLDialogElement>('columns').open,
    ]
    expect(now).not.toEqual(before)
  })
  await quiet()
  return input
}

describe('saving', () => {
  it.each([
    ['CSV', 'circles.csv', 'text/csv', /^x,y,r,name\n0,0,2,Aa\n/],
    ['JSON', 'circles.json', 'application/json', /^\{/],
    ['GeoJSON', 'circles.geojson', 'application/geo+json', /"FeatureCollection"/],
  ])('%s gives the same circles back', async (label, name, type, start) => {
    await pressed(panel, label)
    const file = await out.file()
    expect([file.name, file.type, file.text]).toEqual([name, type, expect.stringMatching(start)])
    await page.open(Float64Array.of(1, 1, 1))
    await open(file.text, name)
    expect([circles(), page.editing.nameOf(0), problem()]).toEqual([[...FIVE], 'Aa', ''])
  })

  it('cells says where they end: at a box, at the region, or nowhere', async () => {
    const saved = async () => {
      await pressed(panel, 'Cells')
      const { name, text } = await out.file()
      await soon(() => expect(toast()).not.toBe(''))
      return [name, JSON.parse(text).features.length, toast()]
    }
    expect(await saved()).toEqual([
      'circles-cells.geojson',
      5,
      expect.stringMatching(/cut to the box from -[\d.]+, -[\d.]+ to/),
    ])
    await page.actions.setDomain({
      region: [box(-9, -9, 30, 30)],
    })
    expect(await saved()).toEqual(['circles-cells.geojson', 5, 'The cells are those inside the region.'])
    await page.actions.repeat()
    expect((await saved())[2]).toMatch(/^The cells are whole/)
  })

  it('the picture has a link that opens it again, and a name of its data set', async () => {
    page.view.setLayers({ hull: true })
    await pressed(panel, 'SVG')
    const { name, text } = await out.file()
    expect([name, toast()]).toEqual(['circles.svg', expect.stringMatching(/^The picture shows the box from/)])
    await page.open(Float64Array.of(1, 1, 1))
    page.view.setLayers({ hull: false })
    await open(text, name)
    expect([circles(), page.view.layers.hull]).toEqual([[...FIVE], true])
    await page.actions.load('start')
    await pressed(panel, 'SVG')
    expect((await out.file()).name).toBe('start.svg')
  })

  it('the picture shows what is seen or all circles, in the size that is chosen', async () => {
    page.view.setCamera({ x: 500, y: 500, scale: 800 })
    const sizes: string[] = []
    const boxes: string[] = []
    const save = async (label: string) => {
      await pressed(panel, label)
      const { name, text } = await out.file()
      sizes.push(`${name} ${text}`)
      boxes.push(toast() ?? '')
    }
    await save('PNG')
    await entered(panel, 'What the picture shows', 'all')
    await entered(panel, '× its size', '1.5')
    await entered(panel, '× its size', '0')
    expect([control(panel, '× its size').value, chosenOf(control(panel, 'What the picture shows'))]).toEqual([
      '1.5',
      'all circles',
    ])
    await save('PNG')
    await save('Poster, A3')
    expect(sizes).toEqual(['circles.png 1600 x 1200', 'circles.png 1200 x 900', 'circles-poster.png 4961 x 3508'])
    expect([boxes[0], boxes[1]]).toEqual([expect.stringContaining('from 499.'), expect.stringMatching(/from -\d/)])
    await entered(panel, '× its size', '1000')
    await pressed(panel, 'PNG')
    await soon(() => expect(problem()).toMatch(/too large/))
    expect(out.files).toEqual([])
  })
})

describe('a file', () => {
  it('can be opened twice, and has columns', async () => {
    for (let k = 0; k < 2; k++) {
      const input = await open('x,y,r,n\n1,2,3,a\n4,5,6,b\n', 'a.csv')
      expect([circles(), page.editing.valueOf(1, 'n'), input.value]).toEqual([[1, 2, 3, 4, 5, 6], '"b"', ''])
      await page.actions.undo()
      expect(circles()).toEqual([...FIVE])
    }
  })

  it('with polygons is the region, which can be undone', async () => {
    await open(SQUARE, 'a.geojson')
    await soon(() => expect(toast()).toBe('Cells are clipped to a.geojson.Undo'))
    expect([page.store.get().domain.region, circles()]).toEqual([expect.anything(), [...FIVE]])
    await pressed(element('toast'), 'Undo')
    expect(page.store.get().domain.region).toBeUndefined()
    await open('{"type":"Polygon","coordinates":[[[0,0]]]}', 'b.geojson')
    expect([problem() === '', page.store.get().domain.region]).toEqual([false, undefined])
    const overlapping =
      '{"type":"MultiPolygon","coordinates":[[[[0,0],[9,0],[9,9],[0,0]]],[[[1,0],[10,0],[10,9],[1,0]]]]}'
    await open(overlapping, 'c.geojson')
    await soon(() => expect(toast()).toMatch(/^Polygons of c\.geojson share borders or overlap\./))
    await pressed(element('toast'), 'Merge polygons')
    await soon(() => expect(page.store.get().domain.region).toMatchObject({ dissolve: true }))
  })

  it.each([
    ['1,2,3\nx,y,z\n4,5,6\n', 'Skip 1 row', '1 row skipped.'],
    ['1,2,3\nx,y,z\n4,5,-6\n7,8,9\n', 'Skip 2 rows', '2 rows skipped.'],
  ])('with invalid rows offers to skip them', async (text, label, said) => {
    await open(`x,y,r\n${text}`, 'a.csv')
    expect([circles(), element('problem').hidden]).toEqual([[...FIVE], false])
    await pressed(element('problem'), label)
    await soon(() => expect(toast()).toBe(said))
    expect([circles().length, circles().slice(0, 3), problem()]).toEqual([6, [1, 2, 3], ''])
  })

  it('that is no table says what can be opened', async () => {
    await open(Uint8Array.of(1, 0, 2, 255, 0, 9), 'a.bin')
    expect(problem()).toMatch(/^a\.bin is not a table of circles\. Open CSV/)
    await open('', 'a.png', 'image/png')
    expect(problem()).toBe('a.png cannot be read as a picture.')
    const large = Object.defineProperty(new File(['1,2,3'], 'l.csv'), 'size', { value: 2 ** 28 + 1 })
    choose(control(panel, 'Open …'), large)
    await soon(() => expect(problem()).toBe('l.csv: the file is too large.'))
    expect(circles()).toEqual([...FIVE])
  })
})

describe('the dialog for columns', () => {
  const dialog = () => element<HTMLDialogElement>('columns')
  const chosen = () => ['x', 'y', 'radius'].map((label) => chosenOf(control(dialog(), label)))
  const close = async (value: string) => {
    dialog().close(value)
    await quiet()
  }

  it('has the guesses, a preview, and gives what is chosen', async () => {
    await open('n,a,lon,lat\n1,2,3,4\n5,6,7,8\n', 'a.csv')
    expect([chosen(), textOf(dialog())]).toEqual([['lon', 'lat', 'lon'], expect.stringContaining('a.csv has 2 rows.')])
    await entered(dialog(), 'x', '3')
    await entered(dialog(), 'y', '2')
    await entered(dialog(), 'radius', '1')
    expect([chosen(), all(dialog(), 'th').map(({ classList }) => classList.contains('used'))]).toEqual([
      ['lat', 'lon', 'a'],
      [false, true, true, true],
    ])
    expect(all(dialog(), 'td').map(textOf)).toEqual(['1', '2', '3', '4', '5', '6', '7', '8'])
    await pressed(dialog(), 'diameters')
    await close('open')
    await soon(() => expect(circles()).toEqual([4, 3, 1, 8, 7, 3]))
  })

  it('gives one radius to all circles', async () => {
    await open('a,b\n1,2\n3,4\n', 'a.csv')
    expect(chosen()[2]).toBe('the same for all')
    await entered(dialog(), 'r', '2.5')
    control(dialog(), 'r').value = '-1'
    send(control(dialog(), 'r'), 'focusout')
    expect(control(dialog(), 'r').value).toBe('2.5')
    await close('open')
    await soon(() => expect(circles()).toEqual([1, 2, 2.5, 3, 4, 2.5]))
  })

  it('says what is wrong with the choice, and opens nothing then or when it is canceled', async () => {
    await open('a,b,c\n1,2,u\n3,4,v\n', 'a.csv')
    const wrong = () => [textOf(dialog().querySelector('.wrong')), control(dialog(), 'Open').disabled]
    expect(wrong()).toEqual(['There are no numbers in column c.', true])
    await entered(dialog(), 'radius', '1')
    expect(wrong()).toEqual(['', false])
    await entered(dialog(), 'y', '0')
    expect(wrong()).toEqual(['x and y are the same column.', true])
    await close('')
    expect([circles(), problem()]).toEqual([[...FIVE], ''])
  })

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

describe('what is dropped or pasted', () => {
  const data = (files: readonly File[], text = '') => ({
    files,
    getData: (type: string) => (type === 'text/plain' ? text : ''),
  })
  const marked = () => document.body.classList.contains('dropping')

  it('is announced until it leaves the page or is dropped, and opened', async () => {
    expect(send(document, 'dragover').defaultPrevented).toBe(true)
    expect(marked()).toBe(true)
    send(document, 'dragleave', { relatedTarget: document.body })
    expect(marked()).toBe(true)
    send(document, 'dragleave', { relatedTarget: null })
    expect(marked()).toBe(false)
    send(document, 'dragover')
    send(document, 'drop', { dataTransfer: data([new File(['1,2,3\n'], 'a.csv')]) })
    expect(marked()).toBe(false)
    await soon(() => expect(circles()).toEqual([1, 2, 3]))
  })

  it('may be a link, or polygons', async () => {
    const paste = (text: string) => send(document, 'paste', { clipboardData: data([], text) }).defaultPrevented
    expect(paste(`https://a.example/#${await encodeLink({ circles: [[7, 8, 9]] })}`)).toBe(true)
    await soon(() => expect(circles()).toEqual([7, 8, 9]))
    expect(paste(SQUARE)).toBe(true)
    await soon(() => expect(toast()).toMatch(/^Cells are clipped to the pasted polygons\./))
    expect(paste(' \n')).toBe(false)
    expect(paste('1 2 -3')).toBe(true)
    await soon(() => expect(problem()).not.toBe(''))
  })
})

describe('the panel of circles', () => {
  const generate = () => element('generate')
  const button = (name: string) => all(generate(), 'button').find(({ dataset }) => dataset.name === name) as HTMLElement
  const shown = () => all(generate(), '[aria-current="true"]').map(({ dataset }) => dataset.name)
  const dataSet = () => page.store.get().dataSet

  it('opens prepared circles, families and figures, and marks what is shown', async () => {
    await page.panel('generate')
    await soon(() => expect(button('uniform')).toBeDefined())
    const lists = all(generate(), 'ul').map((list) => list.getAttribute('aria-label'))
    expect(lists).toEqual(['Prepared circles', 'Apart', 'Overlapping', 'In special position', 'Figures of the paper'])
    expect(['n', 'seed'].map((name) => control(generate(), name).value)).toEqual(['300', '1'])
    await entered(generate(), 'n', '20')
    await entered(generate(), 'seed', '7')
    const figure = all(generate(), 'ul').at(-1)?.querySelector('button')?.dataset.name as string
    for (const [name, opened] of [
      ['spruces', 'spruces'],
      ['uniform', 'uniform:7:20'],
      [figure, `figure-${figure}`],
    ] as const) {
      button(name).click()
      await soon(() => expect([dataSet(), shown()]).toEqual([opened, [name]]))
    }
  })

  it('generates the family again where its number or its seed is changed, and no invalid one', async () => {
    button('uniform').click()
    await soon(() => expect(dataSet()).toBe('uniform:7:20'))
    await quiet()
    await entered(generate(), 'n', '30')
    await soon(() => expect([dataSet(), problem()]).toEqual(['uniform:7:30', '']))
    await quiet()
    await entered(generate(), 'seed', '8')
    await soon(() => expect(dataSet()).toBe('uniform:8:30'))
    await quiet()
    press(generate(), 'Another seed')
    await soon(() => expect(dataSet()).toMatch(/^uniform:(?!8:)\d+:30$/))
    await entered(generate(), 'n', '-1')
    expect(dataSet()).toMatch(/:30$/)
  })
})

describe('the menu of circles', () => {
  const menu = () => element<HTMLSelectElement>('data-set')
  const own = () => textOf(all(menu(), 'option')[0])

  it('opens data sets, and says which one is open and whether it is edited', async () => {
    expect([menu().value, own()]).toEqual(['', 'Your circles'])
    for (const [value, label] of [
      ['spruces', 'Spruces'],
      ['start', optionsOf(menu())[1]],
    ] as const) {
      menu().value = value
      send(menu(), 'change')
      await soon(() => expect([page.store.get().dataSet, menu().value]).toEqual([value, value]))
      await page.editing.edit([{ kind: 'remove', id: 0 }])
      await quiet()
      expect([menu().value, own()]).toEqual(['', `${label}, edited`])
    }
    await page.open(new Float64Array())
    expect(own()).toBe('No circles')
    menu().value = 'more'
    send(menu(), 'change')
    await soon(() => expect([element('generate').hidden, menu().value]).toEqual([false, '']))
  })

  it('offers another random sample of a family alone', async () => {
    const again = element('again')
    await page.actions.generate({ kind: 'family', family: 'uniform', seed: 7, count: 20 })
    await soon(() => expect([page.store.get().dataSet, again.hidden]).toEqual(['uniform:7:20', false]))
    again.click()
    await soon(() => expect(page.store.get().dataSet).toMatch(/^uniform:(?!7:)\d+:20$/))
    await page.actions.load('spruces')
    await soon(() => expect(again.hidden).toBe(true))
  })
})
