// SPDX-License-Identifier: GPL-3.0-or-later
// Opening, pasting, saving and sharing, with threads and a view that note their calls.
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { FileActions } from '../../web/app/files/file-actions.ts'
import { PageActions } from '../../web/app/page-actions.ts'
import type { Circle } from '../../web/lib/index.ts'
import { CircleVoronoiError } from '../../web/lib/index.ts'
import { encodeLink } from '../../web/lib/link.ts'
import { NO_PADDING } from '../../web/view/camera.ts'
import { editingSession, sceneOf } from './editing-session.ts'

const { said, saved, columns, printed, packed, cards } = vi.hoisted(() => ({
  said: [] as [string, { label: string; act(): void }?][],
  saved: [] as [Blob, string][],
  columns: [] as unknown[],
  printed: [] as unknown[][],
  packed: [] as unknown[][],
  cards: [] as unknown[][],
}))
vi.mock('../../web/app/panels/toast.ts', () => ({ toast: (...what: (typeof said)[0]) => said.push(what) }))
vi.mock('../../web/app/files/saving.ts', async (load) => ({
  ...(await load<object>()),
  save: (...file: [Blob, string]) => saved.push(file),
}))
vi.mock('../../web/app/panels/choose-columns.ts', () => ({ chooseColumns: async () => columns.shift() }))
vi.mock('../../web/app/files/worksheet.ts', () => ({
  printWorksheet: async (...what: unknown[]) => printed.push(what),
}))
vi.mock('../../web/app/files/card.ts', async (load) => ({
  ...(await load<object>()),
  cardOf: async (...what: unknown[]) => {
    cards.push(what)
    return new Blob(['card'])
  },
}))
vi.mock('../../web/app/course/course-package.ts', () => ({
  coursePackage: async (...what: unknown[]) => {
    packed.push(what)
    return new Uint8Array([1])
  },
}))

beforeEach(() => {
  vi.stubGlobal('document', { title: 'circle-voronoi', getElementById: (id: string) => ({ id }) })
  vi.stubGlobal('HTMLElement', Object)
  vi.stubGlobal('requestAnimationFrame', (act: () => void) => queueMicrotask(act))
  vi.stubGlobal('location', { origin: 'https://a.example', pathname: '/page/', host: 'a.example' })
  for (const list of [said, saved, columns, printed, packed, cards]) list.length = 0
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] })
})
afterEach(() => {
  vi.unstubAllGlobals()
  vi.useRealTimers()
})

const TWO = Float64Array.of(0, 0, 1, 30, 10, 2)
const OPENED = { circles: Float64Array.of(1, 2, 3) }
const POLYGON = '{"type":"Polygon","coordinates":[[[0,0],[9,0],[0,9],[0,0]]]}'
const fileOf = (text: string | Uint8Array<ArrayBuffer>, name = 'a.csv', type = '') => new File([text], name, { type })

async function started({ dataSet = 'grid:5:2', circles = TWO } = {}) {
  const session = editingSession({ size: { width: 300, height: 200 } })
  const { store, editing, view, fake } = session
  const done: unknown[][] = []
  /** The answers of the threads, by the names of calls. */
  const answers: Record<string, (...args: unknown[]) => unknown> = {
    read: () => OPENED,
    write: (...args) => `written ${args[1]}`,
    stipple: () => OPENED,
  }
  const call = async (name: string, ...args: unknown[]) => {
    done.push([name, ...args])
    return answers[name]?.(...args)
  }
  Object.assign(fake, {
    toSVG: async (shot: unknown) => {
      done.push(['toSVG', shot])
      return '<svg>\n</svg>'
    },
    toPNG: async (scale: number, shot: unknown) => {
      done.push(['toPNG', scale, shot])
      return new Blob(['png'])
    },
    toPrint: async () => 'printed',
    cancel: () => false,
  })
  const actions = new PageActions(store, editing, view, () => NO_PADDING, { call, cancel() {} } as never)
  const links = { linkOf: encodeLink }
  const threads = { files: { call }, reader: { call }, links }
  const files = new FileActions(store, editing, actions, view, threads as never)
  await actions.open(async () => sceneOf(circles, dataSet))
  store.update((state) => ({ ...state, dataSet }))
  const toast = () => {
    const [text = '', offer] = said.at(-1) ?? []
    return `${text}${offer?.label ?? ''}`
  }
  const problem = () => store.get().problem
  const remedy = () => store.get().remedy
  const now = () => [...editing.circles.circles()]
  return { ...session, actions, files, done, answers, toast, problem, remedy, now, links }
}

/** An answer of the reader that refuses invalid rows, and skips them if it is asked to. */
const invalid = (count: number) => (_: unknown, name: unknown, how: unknown) => {
  if ((how as { skipsInvalid: boolean }).skipsInvalid) return { ...OPENED, skipped: count }
  throw new Error(`${name}:2: no number.`)
}

describe('a file', () => {
  it('is read by its bytes and its name, as it is', async () => {
    const { files, done, now } = await started()
    expect(await files.openFile(fileOf('1,2,3'))).toBe('opened')
    expect(done).toEqual([
      ['read', new TextEncoder().encode('1,2,3'), 'a.csv', { skipsInvalid: false, columns: undefined }],
    ])
    expect(now()).toEqual([1, 2, 3])
  })

  it('of a picture becomes circles, and of an SVG is read', async () => {
    const { files, done, answers, problem } = await started()
    await files.openFile(fileOf('', 'a.png', 'image/png'))
    await files.openFile(fileOf('<svg>', 'a.svg', 'image/svg+xml'))
    expect(done.map(([name]) => name)).toEqual(['stipple', 'read'])
    answers.stipple = () => {
      throw new Error('internal')
    }
    expect(await files.openFile(fileOf('', 'a.png', 'image/png'))).toBe('refused')
    expect(problem()).toBe('a.png cannot be read as a picture.')
  })

  it('that is too large is not read', async () => {
    const { files, done, problem, now } = await started()
    const large = fileOf(POLYGON, 'a.json')
    let size = 2 ** 28 + 1
    Object.defineProperty(large, 'size', { get: () => size })
    expect(await files.openFile(large)).toBe('refused')
    expect(problem()).toBe('a.json: the file is too large.')
    expect(await files.openRegion(large)).toBe('refused')
    expect([done, problem(), now()]).toEqual([[], 'a.json: the file is too large.', [...TWO]])
    size = 2 ** 28
    expect(await files.openFile(large)).toBe('opened')
    const rows = fileOf('1,2,3')
    Object.defineProperty(rows, 'size', { get: () => size })
    expect([await files.openFile(rows), files.mergesPolygons]).toEqual(['opened', false])
  })

  it('of polygons is the region, which can be undone', async () => {
    for (const open of ['openFile', 'openRegion'] as const) {
      const { files, editing, toast, actions, camera } = { ...(await started()), camera: vi.fn() }
      const look = vi.spyOn(actions, 'look').mockImplementation(camera)
      expect(await files[open](fileOf(POLYGON, 'a.json'))).toBe('opened')
      expect(editing.domain.region).toBeDefined()
      expect([toast(), look.mock.calls]).toEqual(['Cells are clipped to a.json.Undo', [[undefined]]])
      said.at(-1)?.[1]?.act()
      await vi.waitFor(() => expect(editing.domain.region).toBeUndefined())
    }
  })

  it('of other circles opened meanwhile changes no region', async () => {
    const { files, actions, editing } = await started()
    const file = fileOf(POLYGON, 'a.json')
    const opening = files.openFile(file)
    await actions.open(async () => sceneOf(Float64Array.of(7, 7, 7)))
    expect(await opening).toBe('refused')
    expect(editing.domain.region).toBeUndefined()
  })

  it('of polygons that are wrong says why, with its name', async () => {
    const { files, editing, problem } = await started()
    const wrong = fileOf('{"type":"Polygon","coordinates":[[["x",0],[9,0],[0,9]]]}', 'b.json')
    for (const open of ['openFile', 'openRegion'] as const) {
      expect(await files[open](wrong)).toBe('refused')
      expect(problem()).toMatch(/^b\.json: ./)
    }
    expect(editing.domain.region).toBeUndefined()
  })

  it('of polygons that overlap offers to merge them', async () => {
    const { files, editing, computer, toast, problem } = await started()
    vi.spyOn(computer, 'apply').mockRejectedValueOnce(new Error('They overlap: pass `dissolve`.'))
    expect(await files.openFile(fileOf(POLYGON, 'a.json'))).toBe('refused')
    expect([problem(), toast()]).toEqual(['', 'Polygons of a.json share borders or overlap.Merge polygons'])
    said.at(-1)?.[1]?.act()
    await vi.waitFor(() => expect(editing.domain.region).toMatchObject({ dissolve: true }))
    vi.spyOn(computer, 'apply').mockRejectedValueOnce(new Error('They cross.'))
    expect(await files.openFile(fileOf(POLYGON, 'a.json'))).toBe('refused')
    expect(problem()).toBe('They cross.')
    files.mergesPolygons = true
    await files.openFile(fileOf('{"type":"Polygon","coordinates":[[[0,0],[8,0],[0,8],[0,0]]]}', 'a.json'))
    expect(editing.domain.region).toMatchObject({ dissolve: true })
  })

  it.each([
    [1, '1 row'],
    [2000, '2,000 rows'],
  ])('with %d invalid rows offers to skip them', async (count, rows) => {
    const { files, answers, done, problem, remedy, toast, now } = await started()
    answers.read = invalid(count)
    expect(await files.openFile(fileOf('1,2,3'))).toBe('refused')
    // The thread takes over the bytes of each call.
    expect(done.map(([, bytes]) => bytes)[1]).not.toBe(done[0]?.[1])
    expect([problem(), remedy()?.problem, remedy()?.label, now()]).toEqual([
      'a.csv:2: no number.',
      'a.csv:2: no number.',
      `Skip ${rows}`,
      [...TWO],
    ])
    remedy()?.act()
    await vi.waitFor(() => expect(toast()).toBe(`${rows} skipped.`))
    expect(now()).toEqual([1, 2, 3])
  })

  it('without valid rows says what is wrong with the first', async () => {
    const { files, answers, problem, remedy } = await started()
    answers.read = invalid(0)
    expect(await files.openFile(fileOf('1,2,3'))).toBe('refused')
    expect([problem(), remedy()]).toEqual(['a.csv:2: no number.', undefined])
  })

  it('that is no text says what can be opened', async () => {
    const { files, answers, problem } = await started()
    answers.read = () => {
      throw new Error('a.csv:1: no number.')
    }
    const READABLE = 'Open CSV, JSON, GeoJSON, well-known text, an SVG that was saved here, or a picture.'
    const bytes = (...values: number[]) => fileOf(Uint8Array.from(values))
    const opened = async (file: File) => {
      await files.openFile(file)
      return problem()
    }
    expect(await opened(bytes(65, 0, 66))).toBe(`a.csv is not a table of circles. ${READABLE}`)
    expect(await opened(bytes(65, 66))).toBe('a.csv:1: no number.')
    // UTF-16 has zeros, too.
    expect(await opened(bytes(0xff, 0xfe, 65, 0))).toBe('a.csv:1: no number.')
    expect(await opened(bytes(0xfe, 0xff, 0, 65))).toBe('a.csv:1: no number.')
    const late = new Uint8Array(5000).fill(65)
    late[4096] = 0
    expect(await opened(fileOf(late))).toBe('a.csv:1: no number.')
    late[4095] = 0
    expect(await opened(fileOf(late))).toMatch(/is not a table/)
  })

  it('with unknown columns asks for them, once', async () => {
    const { files, answers, done, problem } = await started()
    const chosen = { x: 'a', y: 'b', radius: 'c', isDiameter: false }
    answers.read = (_, __, how) => {
      if ((how as { columns?: unknown }).columns !== undefined) return OPENED
      throw new Error('a.csv:1: no columns.')
    }
    columns.push(chosen)
    expect(await files.openFile(fileOf('n,a,b,c\nu,1,2,3'))).toBe('opened')
    expect(done.at(-1)?.[3]).toEqual({ skipsInvalid: false, columns: chosen })
    expect(await files.openFile(fileOf('n,a,b,c\nu,1,2,3'))).toBe('refused')
    expect(problem(), 'canceled').toBe('')
    answers.read = () => {
      throw new Error('a.csv:1: no columns.')
    }
    columns.push(chosen, chosen)
    expect(await files.openFile(fileOf('n,a,b,c\nu,1,2,3'))).toBe('refused')
    expect([problem(), columns]).toEqual(['a.csv:1: no columns.', [chosen]])
    // Three unnamed columns are circles.
    expect(await files.openFile(fileOf('1;2;3\n4;x;6'))).toBe('refused')
    expect(columns).toHaveLength(1)
  })
})

describe('pasted text', () => {
  it('is a link, polygons, or circles that are added', async () => {
    const { files, editing, toast, now, actions } = await started()
    const reveal = vi.spyOn(actions, 'reveal')
    expect(await files.openText('1,2,3')).toBe('opened')
    expect([toast(), now()]).toEqual(['One circle was added.Replace all circles instead', [...TWO, 1, 2, 3]])
    expect(reveal.mock.calls).toEqual([[[{ x: 1, y: 2, r: 3 } satisfies Circle]]])
    expect(await files.openText(POLYGON)).toBe('opened')
    expect([toast(), editing.domain.region !== undefined]).toEqual([
      'Cells are clipped to the pasted polygons.Undo',
      true,
    ])
    const link = await encodeLink({ circles: Float64Array.of(7, 8, 9) })
    expect(await files.openText(` https://a.example/#${link}\n`)).toBe('opened')
    expect(now()).toEqual([7, 8, 9])
  })

  it('can replace all circles, and says which columns are left out', async () => {
    const { files, answers, toast, now } = await started()
    const column = (name: string) => ({ name, values: ['1', '2'] })
    const circles = Float64Array.of(1, 2, 3, 40, 50, 6)
    answers.read = () => ({
      circles,
      attributes: { columns: [column('a'), column('b')], ids: [], heights: [], collection: '' },
    })
    await files.openText('1,2,3')
    expect(toast()).toBe('2 circles were added, without the columns a, b.Replace all circles instead')
    said.at(-1)?.[1]?.act()
    await vi.waitFor(() => expect(now()).toEqual([...circles]))
  })

  it('is opened if it is no table, or if there are no circles', async () => {
    const { files, now } = await started()
    await files.openText(' {"circles":[]}')
    expect(now()).toEqual([1, 2, 3])
    const empty = await started({ circles: new Float64Array() })
    await empty.files.openText('1,2,3')
    expect([empty.now(), empty.toast()]).toEqual([[1, 2, 3], ''])
  })

  it('that is wrong changes nothing, and offers to skip rows', async () => {
    const { files, answers, problem, remedy, now, toast } = await started()
    answers.read = invalid(3)
    expect(await files.openText('1,2,x')).toBe('refused')
    expect([problem(), remedy()?.label, now()]).toEqual(['The pasted text:2: no number.', 'Skip 3 rows', [...TWO]])
    remedy()?.act()
    await vi.waitFor(() => expect(now()).toHaveLength(9))
    await vi.waitFor(() => expect(toast()).toBe('3 rows skipped.'))
    answers.read = () => ({ circles: Float64Array.of(0, 0, -1) })
    expect(await files.openText('0,0,-1')).toBe('refused')
    expect(now()).toHaveLength(9)
  })

  it('of a saved drawing opens its link', async () => {
    const { files, answers, now } = await started()
    const link = await encodeLink({ circles: Float64Array.of(7, 8, 9) })
    answers.read = () => ({ link })
    await files.openText('a table')
    expect(now()).toEqual([7, 8, 9])
  })
})

describe('saving', () => {
  it.each([
    ['csv', '.csv', 'text/csv'],
    ['json', '.json', 'application/json'],
    ['geojson', '.geojson', 'application/geo+json'],
    ['cells', '-cells.geojson', 'application/geo+json'],
  ] as const)('data as %s has the name of the data set and its type', async (format, ending, type) => {
    const { files, done, editing, answers } = await started()
    await files.saveAs(format)
    const [[blob, name] = []] = saved
    expect([name, blob?.type, await blob?.text()]).toEqual([`grid-5-2${ending}`, type, `written ${format}`])
    expect(done).toEqual([['write', TWO, format, editing.domain, undefined]])
    answers.write = () => {
      throw new Error('It failed.')
    }
    const other = await started({ dataSet: '' })
    await other.files.saveAs(format)
    expect(saved[1]?.[1]).toBe(`circles${ending}`)
  })

  it('cells says where they end', async () => {
    const { files, answers, editing, toast, actions, problem } = await started()
    answers.write = () => '{"type":"FeatureCollection","bbox":[-1.23456,0,3,4],"features":[]}'
    await files.saveAs('csv')
    expect(toast()).toBe('')
    await files.saveAs('cells')
    expect(toast()).toBe('The cells are cut to the box from -1.235, 0 to 3, 4.')
    answers.write = () => '{"type":"FeatureCollection","features":[\n{"properties":{"shifts":[]}}\n]}'
    await files.saveAs('cells')
    expect(toast()).toBe('The cells are whole, also where they cross the box.')
    await actions.setDomain({
      region: [
        [
          [0, 0],
          [9, 0],
          [0, 9],
        ],
      ],
    })
    expect(editing.domain.region).toBeDefined()
    await files.saveAs('cells')
    expect(toast()).toBe('The cells are those inside the region.')
    answers.write = () => {
      throw new Error('It failed.')
    }
    await files.saveAs('cells')
    expect(problem()).toBe('It failed.')
  })

  const SEEN = { camera: { x: 15, y: 5, scale: 4 }, size: { width: 300, height: 200 } }

  it('a drawing has its link, or a table of circles that are too many for a link', async () => {
    const { files, done, fake, toast, links } = await started()
    fake.camera = SEEN.camera
    await files.saveDrawing('seen')
    const [[blob, name] = []] = saved
    expect([name, blob?.type]).toEqual(['grid-5-2.svg', 'image/svg+xml'])
    expect(await blob?.text()).toMatch(/<metadata id="circle-voronoi">v\d+\.[\w-]+<\/metadata>/)
    expect([done, toast()]).toEqual([[['toSVG', SEEN]], 'The picture shows the box from -22.5, -20 to 52.5, 30.'])
    links.linkOf = () => Promise.reject(new CircleVoronoiError('linkTooLong', 'too long'))
    await files.saveDrawing('all')
    expect(await saved[1]?.[0].text()).toMatch(/<metadata id="circle-voronoi-circles">\nwritten csv<\/metadata>/)
    expect(done.at(-1)).toEqual(['write', TWO, 'csv', undefined, undefined])
  })

  it('a drawing whose link cannot be made says why', async () => {
    const { files, links, problem } = await started()
    links.linkOf = () => Promise.reject(new CircleVoronoiError('badInput', 'It failed.'))
    await files.saveDrawing('seen')
    expect([problem(), saved]).toEqual(['It failed.', []])
  })

  it('a picture shows what is seen or all circles, enlarged', async () => {
    const { files, done, fake, toast } = await started()
    fake.camera = SEEN.camera
    await files.savePicture('seen', 3)
    expect([saved[0]?.[1], done.pop()]).toEqual(['grid-5-2.png', ['toPNG', 3, SEEN]])
    await files.savePicture('all', 2)
    // The circles have the box from -1, -1 to 32, 12, with a margin of 24 pixels.
    const [[, , shot] = []] = done
    const { scale } = (shot as typeof SEEN).camera
    expect(scale).toBeCloseTo((300 - 48) / 33, 6)
    expect(done).toEqual([['toPNG', 2, { camera: { x: 15.5, y: 5.5, scale }, size: SEEN.size }]])
    expect(toast()).toMatch(/^The picture shows the box from -4\.1/)
  })

  it.each([
    [300, 200, 4961, 3508],
    [200, 300, 3508, 4961],
    [300, 50, 4961, 3508],
    [200, 200, 4961, 3508],
  ])(
    'a poster of %d x %d has the aspect ratio of paper and contains what is seen',
    async (width, height, across, down) => {
      const { files, done, fake } = await started()
      Object.assign(fake, { size: { width, height }, camera: SEEN.camera })
      await files.savePoster('seen')
      const [, scale, sheet] = done[0] as [string, number, typeof SEEN]
      expect([sheet.size.width * scale, sheet.size.height * scale]).toEqual([
        expect.closeTo(across),
        expect.closeTo(down),
      ])
      expect(Math.min(sheet.size.width / width, sheet.size.height / height)).toBeCloseTo(1, 12)
      expect([sheet.camera, saved[0]?.[1]]).toEqual([SEEN.camera, 'grid-5-2-poster.png'])
    },
  )

  it('a card has all circles, and the label of the data set', async () => {
    const { files, done } = await started()
    await files.saveCard()
    const [[, enlarged, shot] = []] = done
    const { camera, size } = shot as typeof SEEN
    expect([enlarged, size, camera.x, camera.y]).toEqual([1, { width: 1200, height: 546 }, 15.5, 5.5])
    expect(camera.scale).toBeCloseTo((1200 - 48) / 33, 6)
    expect([cards[0]?.slice(1), saved[0]?.[1]]).toEqual([['grid, 2', 'a.example'], 'grid-5-2-card.png'])
    const other = await started({ dataSet: '' })
    await other.files.saveCard()
    expect(cards[1]?.[1]).toBe('Voronoi diagram of circles')
  })
})

describe('links', () => {
  it('are sent by the system, and closing its dialog is no problem', async () => {
    const { files, problem } = await started()
    const shared: unknown[] = []
    let error: Error | undefined
    vi.stubGlobal('navigator', {
      share: async (what: unknown) => {
        shared.push(what)
        if (error !== undefined) throw error
      },
    })
    await files.shareLink()
    expect(shared).toEqual([
      { title: 'circle-voronoi', url: expect.stringMatching(/^https:\/\/a\.example\/page\/#v\d/) },
    ])
    error = Object.assign(new Error('closed'), { name: 'AbortError' })
    await files.shareLink()
    expect(problem()).toBe('')
    error = new Error('forbidden')
    await files.shareLink()
    expect(problem()).toBe('forbidden')
  })

  it.each([() => Promise.reject(new CircleVoronoiError('linkTooLong', 'too long')), async () => 'v'.repeat(2_000_001)])(
    'that are too long are none',
    async (linkOf) => {
      const { files, links, problem } = await started()
      links.linkOf = linkOf
      vi.stubGlobal('navigator', { share: expect.unreachable })
      await files.shareLink()
      expect(problem()).toBe('These are too many circles for a link: save them as a file.')
    },
  )

  const FRAME = { title: 'T', question: 'Q?', lang: 'de', check: { cell: 3, edges: 4 } } as const

  it('of questions name circles by their places', async () => {
    const { files, editing } = await started({ circles: Float64Array.of(0, 0, 1, 9, 0, 1, 0, 9, 1, 9, 9, 1) })
    await editing.edit([{ kind: 'remove', id: 1 }])
    await files.saveCourse(FRAME)
    const [[course, element] = []] = packed
    expect(course).toEqual({ link: expect.stringMatching(/^v\d/), title: 'T', lang: 'de' })
    expect(element).toBe('https://a.example/page/element.js')
    const { decodeLink } = await import('../../web/lib/link.ts')
    const state = await decodeLink((course as { link: string }).link)
    expect(state).toMatchObject({ title: 'T', question: 'Q?', lang: 'de', check: { cell: 2, edges: 4 } })
    expect([saved[0]?.[1], saved[0]?.[0].type]).toEqual(['question-scorm.zip', 'application/zip'])
    await files.saveCourse({})
    expect(packed[1]?.[0]).toMatchObject({ title: 'Voronoi diagram of circles', lang: 'en' })
  })

  it('of questions are printed on a worksheet', async () => {
    const { files } = await started()
    await files.printWorksheet(FRAME)
    expect(printed).toEqual([
      [{ id: 'worksheet' }, FRAME, 'printed', expect.stringMatching(/^https:\/\/a\.example\/page\/embed\.html#v\d/)],
    ])
  })

  it('of questions are opened in a new tab, which is closed again if there is no link', async () => {
    const { files, links, problem } = await started()
    const tab = { location: { href: '' }, closed: 0, close: () => tab.closed++ }
    const opened: unknown[] = []
    vi.stubGlobal('window', {
      open: (...what: unknown[]) => {
        opened.push(what)
        return tab
      },
    })
    await files.openQuestion(FRAME)
    expect([opened, tab.closed]).toEqual([[['', '_blank']], 0])
    expect(tab.location.href).toMatch(/^https:\/\/a\.example\/page\/embed\.html#v\d/)
    links.linkOf = () => Promise.reject(new Error('It failed.'))
    await files.openQuestion(FRAME)
    expect([tab.closed, problem()]).toEqual([1, 'It failed.'])
    vi.stubGlobal('window', { open: () => null })
    await files.openQuestion(FRAME)
    links.linkOf = encodeLink
    await files.openQuestion(FRAME)
    expect(tab.closed, 'the browser has opened no tab').toBe(1)
  })
})
