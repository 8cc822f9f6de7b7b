// SPDX-License-Identifier: GPL-3.0-or-later
import { html, render } from 'lit/html.js'
import type { Stage } from '../../editing/opening-actions.ts'
import { wholeNumber } from '../../view/whole-number.ts'
import type { PageActions } from '../page-actions.ts'
import { byId } from './by-id.ts'
import { toast } from './toast.ts'

/** Delay before the bar appears, in milliseconds. */
const SOON = 300

const DOING: Readonly<Partial<Record<Stage, string>>> = {
  computing: 'Computing the diagram',
  clipping: 'Clipping the cells',
  fitting: 'Fitting the areas',
  repeating: 'Computing the cells',
}

/** A progress bar with the current stage and a button to cancel. */
export function mountProgress(actions: PageActions): void {
  const place = byId('progress', HTMLElement)
  const figure = byId('figure', HTMLElement)
  let stage = ''
  let isCancelable = false
  let timer: ReturnType<typeof setTimeout> | undefined

  const draw = () => {
    place.hidden = stage === ''
    const stop = () => {
      actions.data.cancel()
      toast('Canceled. Nothing has changed.')
    }
    const cancel = html`<button type="button" @click=${stop}>Cancel</button>`
    render(
      html`<span>${stage}</span><progress aria-label=${stage}></progress>${isCancelable ? cancel : undefined}`,
      place,
    )
  }
  const show = (text: string, canBeCanceled: boolean) => {
    const isNew = stage === ''
    stage = text
    isCancelable = canBeCanceled
    if (text === '') {
      clearTimeout(timer)
      draw()
    } else if (!isNew && !place.hidden) draw()
    else if (isNew) timer = setTimeout(draw, SOON)
  }
  const isPainting = () => figure.getAttribute('aria-busy') === 'true'
  // New circles are painted tile by tile.
  new MutationObserver(() => stage.startsWith('Painting') && !isPainting() && show('', false)).observe(figure, {
    attributeFilter: ['aria-busy'],
  })
  actions.opening.onstage = (now, circles) => {
    const count = `${wholeNumber(circles)} ${circles === 1 ? 'circle' : 'circles'}`
    if (now === 'loading') show('Loading …', true)
    else if (DOING[now] !== undefined) show(`${DOING[now]} of ${count} …`, true)
    else if (!place.hidden && isPainting() && now === 'opened') show(`Painting ${count} …`, false)
    else show('', false)
  }
}
