// SPDX-License-Identifier: GPL-3.0-or-later
// `value` of <circle-voronoi>, bound as docs/element.md says: by v-model of Vue, and by a property and a listener in Svelte.
import { join } from 'node:path'
import { expect, type Page, test } from '@playwright/test'
import { build } from 'esbuild'
import { compile as compileSvelte } from 'svelte/compiler'
import { compileTemplate } from 'vue/compiler-sfc'
import { soon } from '../soon.ts'
import { ownPages } from './own-pages.ts'
import { ROOT } from './project.mjs'

type Element = HTMLElementTagNameMap['circle-voronoi']

const pages = ownPages('bindings')
const START = '[[0, 0, 2], [10, 0, 1], [5, 8, 1.5]]'

/** An application of Vue, with a template that is compiled as its build tools do. */
function vue(): string {
  const source = `<circle-voronoi v-model="circles" view="5 4 20"></circle-voronoi>
    <output>{{ circles?.length }}: {{ circles?.[0] }}</output>
    <button @click="circles = [[1, 1, 1]]">One</button>
    <button @click="circles = undefined">None</button>`
  const compilerOptions = { isCustomElement: (name: string) => name === 'circle-voronoi' }
  const { code } = compileTemplate({ source, filename: 'App.vue', id: 'app', compilerOptions })
  return `${code}
import { createApp, ref } from 'vue'
createApp({ setup: () => ({ circles: ref(${START}) }), render }).mount('#app')`
}

function svelte(): string {
  const source = `<script>let circles = $state.raw(${START})</script>
<circle-voronoi value={circles} oninput={(event) => (circles = event.currentTarget.value)} view="5 4 20"></circle-voronoi>
<output>{circles?.length}: {circles?.[0]}</output>
<button onclick={() => (circles = [[1, 1, 1]])}>One</button>
<button onclick={() => (circles = undefined)}>None</button>`
  const { code } = compileSvelte(source, { generate: 'client', name: 'App' }).js
  return `import { mount } from 'svelte'\n${code}\nmount(App, { target: document.querySelector('#app') })`
}

async function open(page: Page, source: string): Promise<void> {
  await build({
    stdin: { contents: source, resolveDir: ROOT },
    outfile: join(ROOT, pages.folder, 'app.js'),
    bundle: true,
    format: 'esm',
    conditions: ['browser', 'production'],
    define: {
      __VUE_OPTIONS_API__: 'true',
      __VUE_PROD_DEVTOOLS__: 'false',
      __VUE_PROD_HYDRATION_MISMATCH_DETAILS__: 'false',
    },
    logLevel: 'error',
  })
  await pages.open(page, '<script type="module" src="app.js"></script><div id="app"></div>')
}

const circles = (page: Page) => page.locator('circle-voronoi').evaluate((element: Element) => [...element.circles])

for (const [name, source] of [
  ['v-model in Vue', vue],
  ['value and oninput in Svelte', svelte],
] as const) {
  test(`${name}: the state follows a drag, and the figure follows the state`, async ({ page }) => {
    const problems: string[] = []
    page.on('pageerror', ({ message }) => problems.push(message))
    await open(page, source())
    await expect(page.locator('output')).toHaveText(/^3: /)
    expect(await circles(page)).toEqual(JSON.parse(START).flat())
    const [x, y, scale] = await page.locator('circle-voronoi').evaluate((element: Element) => {
      const box = ((element.shadowRoot as ShadowRoot).querySelector('.figure') as HTMLElement).getBoundingClientRect()
      const scale = Math.min(box.width, box.height) / 20
      return [box.left + box.width / 2 - 5 * scale, box.top + box.height / 2 + 4 * scale, scale] as const
    })
    await page.mouse.move(x, y)
    await page.mouse.down()
    await page.mouse.move(x + 2 * scale, y, { steps: 5 })
    await page.mouse.up()
    // Each `input` sets the state, and the state sets nothing back: the drag reaches its end.
    await expect(page.locator('output')).toHaveText(/^9: (1\.9|2)/)
    const [now = 0] = await circles(page)
    await expect(page.locator('output')).toHaveText(`9: ${now}`)
    await page.keyboard.press('Control+z')
    await expect(page.locator('output')).toHaveText('9: 0')
    await page.getByRole('button', { name: 'One', exact: true }).click()
    await soon(() => circles(page)).toEqual([1, 1, 1])
    await page.getByRole('button', { name: 'None' }).click()
    await soon(() => circles(page)).toEqual([])
    expect(problems).toEqual([])
  })
}
