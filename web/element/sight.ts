// SPDX-License-Identifier: GPL-3.0-or-later

/** Where an element is: `near` what is seen, or so `far` that it needs no pixels. */
export type Sight = 'near' | 'far'

/** In heights of the window: between the two, all stays as it is. */
const NEAR = '25%'
const FAR = '150%'

const listeners = new WeakMap<Element, (sight: Sight) => void>()
let observers: readonly IntersectionObserver[] | undefined

/** Has a function told where an element comes to be, and returns what ends that. One pair of observers serves all. */
export function watchSight(element: Element, tell: (sight: Sight) => void): () => void {
  observers ??= [observer(NEAR, true, 'near'), observer(FAR, false, 'far')]
  listeners.set(element, tell)
  for (const each of observers) each.observe(element)
  return () => {
    listeners.delete(element)
    for (const each of observers ?? []) each.unobserve(element)
  }
}

function observer(margin: string, isWithin: boolean, sight: Sight): IntersectionObserver {
  return new IntersectionObserver(
    (entries) => {
      for (const { target, isIntersecting } of entries) {
        if (isIntersecting === isWithin) listeners.get(target)?.(sight)
      }
    },
    { rootMargin: `${margin} 0px` },
  )
}
