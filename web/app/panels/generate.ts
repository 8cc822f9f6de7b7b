// SPDX-License-Identifier: GPL-3.0-or-later
import { html, nothing, type TemplateResult } from 'lit/html.js'
import type { Float64s } from '../../lib/index.ts'
import { icon } from '../../player/icon.ts'
import { DICE } from '../../view/icons.ts'
import { DATA_SETS, type DataSet, MOST_CIRCLES, randomSeed, sourceOf } from '../data-sets.ts'
import type { FilesClient } from '../files/files-client.ts'
import type { Catalogue, Family, Figure, Pictured } from '../generators/generators.ts'
import type { PageActions } from '../page-actions.ts'
import { byId } from './by-id.ts'
import { panelOf } from './panel.ts'

/** The initial values of the fields. */
const FIRST = { seed: 1, count: 300 }

const GROUPS: readonly (readonly [title: string, holds: (family: Family) => boolean])[] = [
  ['Apart', ({ isDisjoint, isDegenerate }) => isDisjoint && !isDegenerate],
  ['Overlapping', ({ isDisjoint, isDegenerate }) => !isDisjoint && !isDegenerate],
  ['In special position', ({ isDegenerate }) => isDegenerate],
]

/**
 * Families of random circles with number and seed, and the figures of the paper. Returns a function that opens the
 * panel.
 */
export function mountGenerate(actions: PageActions, files: FilesClient): { show(dataSet: string): void; open(): void } {
  const panel = byId('generate', HTMLElement)
  let fields = FIRST
  let shown = ''
  let catalogue: Catalogue | undefined
  let picture: ((sample: Float64s) => TemplateResult) | undefined
  let problem = ''

  const load = async () => {
    try {
      const [loaded, { pictureOf }] = await Promise.all([
        files.call('catalogue'),
        import('../generators/sample-picture.ts'),
      ])
      catalogue = loaded
      picture = pictureOf
    } catch (error) {
      problem = (error as Error).message
    }
    draw()
  }
  const draw = () => folded.render(body)
  const folded = panelOf(panel, 'Circles', draw, { onopen: load })

  const generate = (family: string) => actions.generate({ kind: 'family', family, ...fields })
  const change = (event: Event) => {
    const input = event.target as HTMLInputElement
    // The browser reports the invalid field.
    if (!input.reportValidity()) return
    fields = { ...fields, [input.name]: input.valueAsNumber }
    const source = sourceOf(shown)
    if (source?.kind === 'family') generate(source.family)
  }
  const again = () => {
    fields = { ...fields, seed: randomSeed() }
    const source = sourceOf(shown)
    if (source?.kind === 'family') generate(source.family)
    else draw()
  }

  const row = (
    { name, description, sample }: Pictured<Figure>,
    label: string,
    isShown: boolean,
    act: () => void,
  ) => html`
    <li>
      <button type="button" data-name=${name} aria-current=${isShown} @click=${act}>
        ${picture?.(sample)}<span>${label}<small>${description}</small></span>
      </button>
    </li>
  `
  const list = ({ families, figures }: Catalogue) => {
    const source = sourceOf(shown)
    return html`
      ${GROUPS.map(
        ([title, holds]) => html`
          <h3>${title}</h3>
          <ul aria-label=${title}>
            ${families
              .filter(holds)
              .map((family) =>
                row(family, family.name, source?.kind === 'family' && source.family === family.name, () =>
                  generate(family.name),
                ),
              )}
          </ul>
        `,
      )}
      <h3>Figures of the paper</h3>
      <ul aria-label="Figures of the paper">
        ${figures.map((figure) =>
          row(figure, `Figure ${figure.name}`, source?.kind === 'figure' && source.figure === figure.name, () =>
            actions.generate({ kind: 'figure', figure: figure.name }),
          ),
        )}
      </ul>
    `
  }

  const setRow = ({ id, label, about, credit }: DataSet) => html`
    <li>
      <button type="button" data-name=${id} aria-current=${id === shown} @click=${() => actions.load(id)}>
        <span>${label}<small>${about}${credit === undefined ? nothing : html`<br />${credit}`}</small></span>
      </button>
    </li>
  `

  const body = () => html`
    <ul aria-label="Prepared circles">
      ${DATA_SETS.filter(({ random }) => random === undefined).map(setRow)}
    </ul>
    <h3>Random circles</h3>
    <div class="fields">
      <label title="How many circles a family makes">
        n
        <input name="count" type="number" min="1" max=${MOST_CIRCLES} step="1" required .value=${String(fields.count)} @change=${change} autocomplete="off" />
      </label>
      <label title="The same seed makes the same circles">
        seed
        <input name="seed" type="number" min="0" max=${Number.MAX_SAFE_INTEGER} step="1" required .value=${String(fields.seed)} @change=${change} autocomplete="off" />
      </label>
      <button type="button" class="icon" aria-label="Another seed" title="Another seed" @click=${again}>
        ${icon(DICE)}
      </button>
    </div>
    ${catalogue === undefined ? html`<p class="quiet">${problem === '' ? 'Loading …' : problem}</p>` : list(catalogue)}
  `

  draw()
  return {
    show(dataSet) {
      if (dataSet === shown) return
      shown = dataSet
      const source = sourceOf(dataSet)
      if (source?.kind === 'family') fields = { seed: source.seed, count: source.count }
      draw()
    },
    open() {
      folded.open()
      panel.querySelector<HTMLElement>('.body button, .body input')?.focus()
    },
  }
}
