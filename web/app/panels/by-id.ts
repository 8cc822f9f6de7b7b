// SPDX-License-Identifier: GPL-3.0-or-later

/** Returns the element of index.html with an id and a type. */
export function byId<Type extends HTMLElement>(id: string, type: new () => Type): Type {
  const element = document.getElementById(id)
  if (!(element instanceof type)) throw new Error(`index.html has no ${type.name} with id ${id}`)
  return element
}
