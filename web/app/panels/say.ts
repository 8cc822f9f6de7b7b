// SPDX-License-Identifier: GPL-3.0-or-later
import { html, nothing, render } from 'lit/html.js'
import { dataSetName, type State } from '../../editing/state.ts'
import type { Store } from '../../view/store.ts'
import { dataSetOf } from '../data-sets.ts'
import { byId } from './by-id.ts'

const BY_MOUSE = 'Drag a rim to resize. Double-click to add a circle.'
const BY_FINGER = 'Tap one to resize it. Double-tap to add a circle.'
/** Duration of a new data set's caption, in milliseconds. */
const LASTING = 12_000

/** A link-like field for a photo, which becomes circles. */
function photoOf(open: (file: File) => void) {
  const choose = ({ target }: Event) => {
    const file = (target as HTMLInputElement).files?.[0]
    if (file !== undefined) open(file)
  }
  return html`<label class="photo">Or open a photo.<input type="file" class="visually-hidden" accept="image/*" @change=${choose} /></label>`
}

/** A one-line caption of the circles until they are touched. Without circles, it says how to begin. */
export function mountSay(store: Store<State>, open: (file: File) => void): void {
  const place = byId('say', HTMLElement)
  let shown = ''
  let timer: ReturnType<typeof setTimeout> | undefined
  const fingers = matchMedia('(pointer: coarse)')

  const hide = () => {
    clearTimeout(timer)
    place.hidden = true
  }
  const isEmpty = ({ edited }: State) => edited?.counts.circles === 0

  const show = (state: State) => {
    clearTimeout(timer)
    const hint = fingers.matches ? BY_FINGER : BY_MOUSE
    const about = dataSetOf(dataSetName(state))
    place.hidden = !isEmpty(state) && about === undefined
    if (isEmpty(state)) {
      const how = fingers.matches ? 'Double-tap' : 'Double-click'
      render(html`<p>No circles.</p><small>${how} to add one, or choose a data set above.</small>`, place)
      return
    }
    if (about === undefined) return
    const { credit, id } = about
    // The first data set introduces the page itself.
    const small = id === 'start' ? hint : credit
    const photo = id === 'start' ? photoOf(open) : nothing
    place.classList.toggle('first', id === 'start')
    render(html`<p>${about.about}</p>${small === undefined ? nothing : html`<small>${small} ${photo}</small>`}`, place)
    if (id !== 'start') timer = setTimeout(hide, LASTING)
  }

  /** Shows what else can be done after the first try. */
  const remind = () => {
    clearTimeout(timer)
    place.classList.remove('first')
    render(html`<small>${fingers.matches ? BY_FINGER : BY_MOUSE}</small>`, place)
    timer = setTimeout(hide, LASTING)
  }

  store.subscribe((state) => {
    if (state.edited === undefined) return
    const { history, selection, problem, step } = state
    const isTouched =
      step !== undefined || history.done.at(-1)?.kind === 'edits' || selection.length > 0 || problem !== ''
    const now = isEmpty(state) ? 'empty' : isTouched ? 'touched' : `${dataSetName(state)} ${history.done.length}`
    if (now === shown) return
    const isFirst = shown.startsWith('start ')
    shown = now
    if (now !== 'touched') show(state)
    else if (isFirst && step === undefined && problem === '') remind()
    else hide()
  })
  fingers.addEventListener('change', () => !place.hidden && show(store.get()))
}
