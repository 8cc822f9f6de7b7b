// SPDX-License-Identifier: GPL-3.0-or-later
// Tables that are dropped while the start picture moves: rows keep their values in each engine.
import { expect, test } from '@playwright/test'
import { decodeLink } from '../../web/lib/link.ts'
import { type Engine, until } from './engine.ts'
import { ENGINES } from './engines.ts'

/** The number of dropped tables, each on a page of its own. The drops are spread evenly over the first seconds. */
const DROPS = Number(process.env.DROPS ?? 2)
const SECONDS = DROPS > 2 ? 10 : 1

type Evaluate = Pick<Engine, 'open' | 'evaluate'>

/**
 * Rows that depend on the drop's number, so that no two tables are the same: eight close together, or a survey with
 * large numbers.
 */
function rowsOf(drop: number): number[][] {
  const isSurvey = drop % 2 === 1
  return Array.from({ length: isSurvey ? 400 : 8 }, (_, k) =>
    isSurvey
      ? [470_000 + ((37 * k) % 400) + drop / 64, 5_118_800 + ((91 * k) % 400), 0.02 + (k % 30) / 128]
      : [100 + 10 * k, 100 + k * k + drop / 64, 1],
  )
}

/** Drops tables on new pages, and compares the saved circles with the rows. */
async function dropTables(baseURL: string, { open, evaluate }: Evaluate): Promise<void> {
  for (let drop = 0; drop < DROPS; drop++) {
    // Clears the storage, so that the page begins with the start picture. This address shows text without running
    // scripts.
    await open(`${baseURL}/service-worker.js`)
    await evaluate(() => {
      localStorage.clear()
      sessionStorage.clear()
    })
    await open(baseURL)
    const status = () => evaluate(() => document.querySelector('#status')?.textContent ?? '')
    await until('begun', status, (text) => text.includes('8 circles'))
    const rows = rowsOf(drop)
    const wait = (1000 * SECONDS * drop) / DROPS
    await evaluate(
      async (text, wait) => {
        await new Promise((resolve) => setTimeout(resolve, wait))
        const data = new DataTransfer()
        data.items.add(new File([text], 'table.csv', { type: 'text/csv' }))
        for (const name of ['dragenter', 'dragover', 'drop']) {
          document.body.dispatchEvent(new DragEvent(name, { dataTransfer: data, bubbles: true, cancelable: true }))
        }
      },
      `x,y,r\n${rows.map((row) => row.join()).join('\n')}`,
      wait,
    )
    // The start picture may be saved first, by its name.
    const keptCircles = async () => {
      const hash = await evaluate(() => location.hash)
      return hash === '' ? undefined : (await decodeLink(hash)).circles
    }
    const circles = await until(`kept after drop ${drop}`, keptCircles, (kept) => kept !== undefined)
    expect([...(circles as Float64Array)], `drop ${drop}`).toEqual(rows.flat())
    expect(await evaluate(() => document.querySelector('#problem')?.textContent)).toBe('')
  }
}

test('Chromium keeps the rows of tables that are dropped while circles move', async ({ browser, baseURL }) => {
  test.setTimeout(120_000 + 60_000 * DROPS)
  const context = await browser.newContext({ reducedMotion: 'no-preference', serviceWorkers: 'block' })
  const page = await context.newPage()
  await dropTables(
    baseURL as string,
    {
      open: async (url) => void (await page.goto(url)),
      evaluate: (call, ...args) =>
        page.evaluate(`(${call})(...${JSON.stringify(args)})`) as ReturnType<typeof page.evaluate>,
    } as Evaluate,
  )
  await context.close()
})

for (const [name, openEngine] of ENGINES) {
  test(`${name} keeps the rows of tables that are dropped while circles move`, async ({ baseURL }) => {
    test.setTimeout(120_000 + 60_000 * DROPS)
    const engine = await openEngine()
    try {
      await dropTables(baseURL as string, engine)
    } finally {
      await engine.close()
    }
  })
}
