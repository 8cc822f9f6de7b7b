// SPDX-License-Identifier: GPL-3.0-or-later
import { html, nothing, type TemplateResult } from 'lit/html.js'
import { dataSetName, type State } from '../../editing/state.ts'
import type { Float64s } from '../../lib/index.ts'
import { icon } from '../../player/icon.ts'
import { ringsOf } from '../../view/domain.ts'
import { DICE, PICTURE } from '../../view/icons.ts'
import { parsedSvg } from '../../view/parsed-svg.ts'
import type { Store } from '../../view/store.ts'
import { DATA_SETS, type DataSet, dataSetOf, loadDataSet, MOST_CIRCLES, randomSeed, sourceOf } from '../data-sets.ts'
import type { FilesClient } from '../files/files-client.ts'
import type { Catalogue, Family, Figure, Pictured, Recipe } from '../generators/generators.ts'
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

/** Number of circles in the thumbnails of random circles, relative to their number, and the least one. */
const SHOWN = 0.05
const LEAST_SHOWN = 40

/**
 * The gallery: data sets, a photo, and hard inputs, which are families of random circles with number and seed, and the
 * figures of the paper. Returns a function that opens the panel.
 */
export function mountGenerate(
  store: Store<State>,
  actions: PageActions,
  files: FilesClient,
  openFile: (file: File) => void,
): () => void {
  const panel = byId('generate', HTMLElement)
  let fields = FIRST
  let shown = ''
  let catalogue: Catalogue | undefined
  let picture: ((sample: Float64s) => TemplateResult) | undefined
  let problem = ''
  let isHardOpen = false
  const thumbnails = new Map<string, SVGElement | undefined>()

  const load = async () => {
    if (catalogue !== undefined) return
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
  /** Draws the thumbnails one by one. Without one, a data set has its name and its line. */
  const drawThumbnails = async () => {
    if (isHardOpen) load()
    for (const dataSet of DATA_SETS) {
      if (thumbnails.has(dataSet.id)) continue
      thumbnails.set(dataSet.id, undefined)
      const text = await textOfThumbnail(dataSet).catch(() => '')
      thumbnails.set(dataSet.id, parsedSvg(text))
      draw()
    }
  }
  const textOfThumbnail = async ({ id, random }: DataSet) => {
    const make = (recipe: Recipe) => files.call('make', recipe)
    if (random === undefined) {
      const { circles, domain } = await loadDataSet(id, make)
      return files.call('thumbnail', circles, id, ringsOf(domain?.region))
    }
    const count = Math.max(Math.round(SHOWN * random.count), LEAST_SHOWN)
    return files.call('thumbnail', await make({ kind: 'family', ...random, count, seed: 1 }), id, [])
  }
  const draw = () => folded.render(body)
  const folded = panelOf(panel, 'Gallery', draw, { onopen: drawThumbnails })

  const generate = (family: string) => actions.data.generate({ kind: 'family', family, ...fields })
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
            actions.data.generate({ kind: 'figure', figure: figure.name }),
          ),
        )}
      </ul>
    `
  }

  const setTile = ({ id, label, about, credit }: DataSet) => html`
    <li>
      <button type="button" class="scene" data-name=${id} aria-current=${id === dataSetOf(shown)?.id} title=${credit ?? nothing} @click=${() => actions.data.load(id)}>
        <span class="frame">${thumbnails.get(id)}</span><b>${label}</b><small>${about}</small>
      </button>
    </li>
  `
  const choosePhoto = ({ target }: Event) => {
    const input = target as HTMLInputElement
    const file = input.files?.[0]
    if (file !== undefined) openFile(file)
    // Allows choosing the same file again.
    input.value = ''
  }
  const photoTile = () => html`
    <li>
      <label class="button scene">
        <span class="frame">${icon(PICTURE)}</span><b>Your photo</b><small>It becomes a mosaic, and stays on your device.</small>
        <input type="file" class="visually-hidden" accept="image/*" aria-label="Your photo" @change=${choosePhoto} />
      </label>
    </li>
  `

  const toggleHard = ({ target }: Event) => {
    isHardOpen = (target as HTMLDetailsElement).open
    if (isHardOpen) load()
  }
  const hard = () => html`
    <p class="quiet">Families of circles that test programs: crowded, hidden, on lines, nearly touching, of very different sizes.</p>
    <div class="fields">
      <label>
        Number of circles
        <input name="count" type="number" min="1" max=${MOST_CIRCLES} step="1" required .value=${String(fields.count)} @change=${change} autocomplete="off" />
      </label>
      <label>
        Random seed
        <input name="seed" type="number" min="0" max=${Number.MAX_SAFE_INTEGER} step="1" required .value=${String(fields.seed)} @change=${change} autocomplete="off" aria-describedby="about-seed" />
      </label>
      <button type="button" class="icon" aria-label="Another seed" title="Another seed" @click=${again}>
        ${icon(DICE)}
      </button>
    </div>
    <p id="about-seed" class="quiet">The same seed always gives the same circles; another seed gives different circles of the same family.</p>
    ${catalogue === undefined ? html`<p class="quiet">${problem === '' ? 'Loading …' : problem}</p>` : list(catalogue)}
  `

  const body = () => html`
    <ul class="gallery" aria-label="Data sets">
      ${DATA_SETS.map(setTile)} ${photoTile()}
    </ul>
    <details ?open=${isHardOpen} @toggle=${toggleHard}>
      <summary>Hard inputs</summary>
      ${hard()}
    </details>
  `

  draw()
  store.subscribe((state) => {
    const dataSet = dataSetName(state)
    if (dataSet === shown) return
    shown = dataSet
    const source = sourceOf(dataSet)
    if (source?.kind === 'family') fields = { seed: source.seed, count: source.count }
    if (source !== undefined && dataSetOf(dataSet) === undefined) isHardOpen = true
    draw()
    if (isHardOpen && folded.isOpen) load()
  })
  return () => {
    folded.open()
    panel.querySelector<HTMLElement>('.body button, .body input')?.focus()
  }
}
