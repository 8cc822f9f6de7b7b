// SPDX-License-Identifier: GPL-3.0-or-later

/** The position of an element relative to the window. `far` elements need no pixels. */
export type Visibility = 'near' | 'far'

/** Distances as multiples of the window's height. Between the two, the state does not change. */
const NEAR = '25%'
const FAR = '150%'

const listeners = new WeakMap<Element, (sight: Visibility) => void>()
let observers: readonly IntersectionObserver[] | undefined

/**
 * Reports when an element comes near or goes far. Returns a function that stops the reports. All elements share two
 * observers.
 */
export function watchVisibility(element: Element, tell: (sight: Visibility) => void): () => void {
  observers ??= [observer(NEAR, true, 'near'), observer(FAR, false, 'far')]
  listeners.set(element, tell)
  for (const each of observers) each.observe(element)
  return () => {
    listeners.delete(element)
    for (const each of observers ?? []) each.unobserve(element)
  }
}

function observer(margin: string, isWithin: boolean, sight: Visibility): IntersectionObserver {
  return new IntersectionObserver(
    (entries) => {
      for (const { target, isIntersecting } of entries) {
        if (isIntersecting === isWithin) listeners.get(target)?.(sight)
      }
    },
    { rootMargin: `${margin} 0px` },
  )
}
