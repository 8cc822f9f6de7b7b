// SPDX-License-Identifier: GPL-3.0-or-later
// The table of numbers: keyboard, mouse and fingers, pasted rows, and the selection.

import { soon } from '../soon.ts'
import { violationsOf } from './accessibility.ts'
import { type App, dataSet, expect, test } from './page.ts'

const INTRODUCTION = dataSet('introduction')

class Table {
  readonly app: App
  constructor(app: App) {
    this.app = app
  }

  get grid() {
    return this.app.page.getByRole('grid', { name: 'Circles' })
  }

  async open(): Promise<void> {
    await this.app.openPanel('Table')
    await expect(this.grid.getByRole('row').nth(1)).toBeVisible()
  }

  /** The cell of a row and a column, counted from 1 without the heading. */
  cell(row: number, column: number) {
    return this.grid.locator(`[role=row][aria-rowindex="${row + 1}"] > [aria-colindex="${column}"]`)
  }

  /** Waits until the page has the given circles. */
  async has(circles: Float64Array): Promise<void> {
    await soon(() => this.app.circles()).toEqual(circles)
  }

  /** Pastes text in the format of spreadsheets. */
  async paste(text: string): Promise<void> {
    await this.grid.evaluate((element, text) => {
      const data = new DataTransfer()
      data.setData('text/plain', text)
      ;(document.activeElement ?? element).dispatchEvent(
        new ClipboardEvent('paste', { clipboardData: data, bubbles: true, cancelable: true }),
      )
    }, text)
  }
}

test('cells are edited by keys, what is wrong is said and changes nothing, and rows are pasted as one step', async ({
  introduction: app,
}) => {
  const { page } = app
  const table = new Table(app)
  await table.open()
  await expect(table.grid).toHaveAttribute('aria-rowcount', '15')
  await table.grid.focus()
  await page.keyboard.press('ArrowDown')
  await page.keyboard.press('Enter')
  await page.keyboard.type('-3.25')
  await page.keyboard.press('Tab')
  await expect(table.grid).toBeFocused()
  await expect(table.cell(2, 2)).toHaveText('-3.25')
  await expect(app.field('x')).toHaveValue('-3.25')
  // The current column is y, and a digit begins an edit.
  await page.keyboard.type('1.5')
  await page.keyboard.press('Escape')
  await expect(table.grid).toBeFocused()
  await page.keyboard.type('2,5')
  await page.keyboard.press('Tab')
  await expect(table.cell(2, 3)).toHaveText('2.5')
  const expected = INTRODUCTION.slice()
  expected.set([-3.25, 2.5], 3)
  await table.has(expected)

  // The table refuses one value, the diagram another.
  await table.grid.focus()
  await page.keyboard.press('Enter')
  const input = table.grid.getByRole('textbox', { name: 'r of row 2' })
  await input.fill('small')
  await input.press('Enter')
  await expect(page.getByRole('alert')).toHaveText('“small” is not a number. Nothing has changed.')
  await expect(input).toHaveAttribute('aria-invalid', 'true')
  await input.fill('-1')
  await input.press('Enter')
  await expect(page.getByRole('alert')).toContainText('radius')
  await expect(input).toBeFocused()
  await input.press('Escape')
  await table.has(expected)

  // Pastes three rows, of which the last ones are new.
  await table.grid.focus()
  await page.keyboard.press('Control+End')
  await page.keyboard.press('Home')
  await table.paste('x\ty\tr\n7\t7\t0,25\n8\t7\t0,5\n9\t7\t0,75\n')
  await expect(app.status).toContainText('16 circles')
  await expect(page.getByRole('region', { name: 'Selected circles' })).toContainText('3 circles')
  const pasted = new Float64Array(48)
  pasted.set(expected)
  pasted.set([7, 7, 0.25, 8, 7, 0.5, 9, 7, 0.75], 39)
  await table.has(pasted)
  await table.grid.focus()
  await table.paste('1\t2\tthree')
  await expect(page.getByRole('alert')).toHaveText('“three” is not a number. Nothing has changed.')
  await page.keyboard.press('Control+z')
  await expect(app.status).toContainText('14 circles')
  await table.has(expected)

  // Rows follow insertions and removals.
  await page.getByRole('button', { name: 'Add', exact: true }).click()
  await expect(app.status).toContainText('15 circles')
  await expect(table.grid.locator('[aria-selected=true] > [aria-colindex="1"]')).toHaveText(/^1[4-9]$/)
  await page.getByTitle('Delete the selected circles (Delete)').click()
  await expect(app.status).toContainText('14 circles')
  await expect(table.cell(15, 1).filter({ visible: true })).toHaveCount(0)
  await expect(table.grid).toHaveAttribute(
    'aria-activedescendant',
    (await table.cell(14, 1).getAttribute('id')) as string,
  )

  // The table is filled when it is opened again, and after a reload.
  await app.openPanel('Table')
  await expect(table.grid).toBeHidden()
  await table.open()
  await expect(table.cell(2, 2)).toHaveText('-3.25')
  await page.reload()
  await expect(table.cell(2, 2)).toHaveText('-3.25')
})

test('what is written goes into the circle it was begun for, and rows are sorted anew once nothing is edited', async ({
  introduction: app,
}) => {
  const { page } = app
  const table = new Table(app)
  await table.open()
  const x = table.grid.getByRole('columnheader', { name: 'x', exact: true })
  await x.click()
  await expect(x).toHaveAttribute('aria-sort', 'ascending')
  // The circles with the smallest x are 13, 10, 4 and 3.
  await expect(table.cell(2, 1)).toHaveText('10')
  // With a controlled clock, pauses end only when the test says so.
  await page.clock.install()
  await page.clock.pauseAt(Date.now() + 60_000)
  const frame = () => page.clock.runFor(20)
  await table.cell(1, 2).click()
  await frame()
  await page.keyboard.type('7')
  await page.keyboard.press('Enter')
  await expect(table.grid).toBeFocused()
  await frame()
  await page.keyboard.type('6')
  const input = table.grid.getByRole('textbox')
  await expect(input).toHaveValue('6')
  // Ends the pause before sorting.
  await page.clock.fastForward(5000)
  await expect(table.cell(1, 1)).toHaveText('13')
  await page.clock.resume()
  await input.press('Enter')
  await expect(input).toHaveCount(0)
  await expect(table.cell(1, 1)).toHaveText('4')
  const expected = INTRODUCTION.slice()
  expected[39] = 7
  expected[30] = 6
  await table.has(expected)

  // A heading is not editable, and a word of an edited text can be selected.
  await table.cell(1, 3).click()
  await x.dblclick()
  await expect(input).toHaveCount(0)
  await table.cell(1, 3).dblclick()
  await input.fill('12')
  await input.dblclick()
  await expect(input).toHaveValue('12')
})

test('rows are sorted by any column, and what is selected here is selected there', async ({ app }) => {
  const { page } = app
  const table = new Table(app)
  await table.open()
  await expect(table.grid).toHaveAttribute('aria-rowcount', '679')
  const columnOf = async (column: number, rows: number) => {
    const texts = await Promise.all(Array.from({ length: rows }, (_, k) => table.cell(k + 1, column).textContent()))
    // Cells without a measure are empty.
    if (texts.includes('')) return undefined
    return texts.map((text) => (text === '∞' ? Number.POSITIVE_INFINITY : text === '–' ? Number.NaN : Number(text)))
  }
  const heading = (name: string) => table.grid.getByRole('columnheader', { name, exact: true })
  const isSorted = (values: number[], sign: number) =>
    values.length > 0 && values.every((value, k) => k === 0 || sign * (values[k - 1] as number) <= sign * value)
  for (const [column, name] of Object.entries({ 4: 'r', 5: 'area', 6: 'nbrs', 7: 'nearest' })) {
    for (const [sort, sign] of [
      ['ascending', 1],
      ['descending', -1],
    ] as const) {
      await heading(name).click()
      await expect(heading(name)).toHaveAttribute('aria-sort', sort)
      await soon(async () =>
        isSorted((await columnOf(Number(column), 8))?.filter((value) => !Number.isNaN(value)) ?? [], sign),
      ).toBe(true)
    }
  }
  // The arrow key leads from the first row to the heading.
  await table.cell(1, 1).click()
  await page.keyboard.press('ArrowUp')
  await page.keyboard.press('Enter')
  await expect(heading('#')).toHaveAttribute('aria-sort', 'ascending')

  await table.cell(3, 1).click()
  await expect(page.getByRole('region', { name: 'Selected circle', exact: true })).toContainText('Circle 2')
  await page.keyboard.press('Shift+ArrowDown')
  await page.keyboard.press('Shift+ArrowDown')
  await expect(page.getByRole('region', { name: 'Selected circles' })).toContainText('3 circles')
  await table.cell(4, 1).click({ modifiers: ['ControlOrMeta'] })
  await expect(page.getByRole('region', { name: 'Selected circles' })).toContainText('2 circles')

  // Selecting in the picture scrolls to the row and makes it current.
  await page.locator('#figure').focus()
  await page.keyboard.press('Escape')
  await page.keyboard.press('Enter')
  await expect(app.inspector.locator('h2')).toHaveText(/^Circle \d+$/)
  const id = Number((await app.inspector.locator('h2').textContent())?.replace('Circle ', ''))
  await expect(table.cell(id + 1, 1)).toBeInViewport()
  await expect(table.grid).toHaveAttribute(
    'aria-activedescendant',
    (await table.cell(id + 1, 1).getAttribute('id')) as string,
  )
  expect(await violationsOf(page, '#table')).toEqual([])
})

test('keys bring the current row into sight, and up from the heading there is nothing', async ({ app }) => {
  const { page } = app
  const table = new Table(app)
  await table.open()
  await expect(table.grid).toHaveAttribute('aria-rowcount', '679')
  const isCurrent = async (row: number) =>
    expect(table.grid).toHaveAttribute('aria-activedescendant', (await table.cell(row, 1).getAttribute('id')) as string)
  await table.cell(1, 1).click()
  await page.keyboard.press('Control+End')
  await expect(table.cell(678, 1)).toBeInViewport()
  await isCurrent(678)
  await expect(table.grid.locator('[aria-selected=true] > [aria-colindex="1"]')).toHaveText('677')
  await page.keyboard.press('PageUp')
  await expect(table.grid.locator('[aria-selected=true] > [aria-colindex="1"]')).not.toHaveText('677')
  await page.keyboard.press('Control+Home')
  await expect(table.cell(1, 1)).toBeInViewport()
  await isCurrent(1)
  const heading = table.grid.getByRole('columnheader', { name: '#', exact: true })
  for (let k = 0; k < 3; k++) await page.keyboard.press('ArrowUp')
  await expect(table.grid).toHaveAttribute('aria-activedescendant', (await heading.getAttribute('id')) as string)
  // Keys typed there have no effect elsewhere.
  await page.keyboard.press('ArrowRight')
  await page.keyboard.type('5')
  await expect(table.grid.getByRole('textbox')).toHaveCount(0)
  await page.keyboard.press('ArrowLeft')
  await page.keyboard.press('ArrowDown')
  await isCurrent(1)
  // A circle that is added has the last row.
  await page.getByRole('button', { name: 'Add', exact: true }).click()
  await expect(table.cell(679, 1)).toBeInViewport()
  await isCurrent(679)
})

test('of a hundred thousand rows only those that are seen are elements', async ({ app }) => {
  const { page } = app
  await app.openPanel('Gallery')
  await page.getByText('Hard inputs', { exact: true }).click()
  await page.getByRole('button', { name: /^Figure 14/ }).click()
  await expect(app.status).toContainText('100,000 circles', { timeout: 60_000 })
  const table = new Table(app)
  await table.open()
  await expect(table.grid).toHaveAttribute('aria-rowcount', '100001')
  const elements = await table.grid.evaluate(async (grid) => {
    let most = 0
    for (let k = 0; k < 12; k++) {
      grid.scrollTop += grid.scrollHeight / 12
      await new Promise(requestAnimationFrame)
      most = Math.max(most, grid.querySelectorAll('[role=row]').length)
    }
    return most
  })
  // Only visible rows have elements.
  expect(elements).toBeLessThan(80)
  await expect(table.cell(100_000, 1)).toHaveText('99999')
  await expect(table.cell(100_000, 5)).not.toHaveText('')
})

test.describe('with fingers', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true })

  test('the table is a sheet', async ({ app }) => {
    const { page } = app
    const table = new Table(app)
    await app.openPanel('Table')
    await table.cell(2, 4).tap()
    await expect(table.grid.locator('[aria-selected=true]')).toHaveCount(1)
    const cut = await table.grid
      .getByRole('gridcell')
      .evaluateAll((cells) =>
        cells.filter(({ scrollWidth, clientWidth }) => scrollWidth > clientWidth).map(({ textContent }) => textContent),
      )
    expect(cut).toEqual([])
    const box = await page.locator('#table').boundingBox()
    expect(box?.width).toBeGreaterThan(360)
    expect((await table.cell(2, 4).boundingBox())?.height).toBeGreaterThanOrEqual(44)
    expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0)
  })
})
