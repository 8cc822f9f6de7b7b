// SPDX-License-Identifier: GPL-3.0-or-later

/** The element of index.html with this id and type. */
export function byId<Type extends HTMLElement>(id: string, type: new () => Type): Type {
  const element = document.getElementById(id)
  if (!(element instanceof type)) throw new Error(`index.html has no ${type.name} with id ${id}`)
  return element
}
