// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * Imports a module of the built package that is no entry. It has no declarations, so its exports have no types.
 *
 * @param {string} name
 * @returns {Promise<any>}
 */
export function innerModule(name) {
  return import(new URL(`../../dist/lib/${name}.js`, import.meta.url).href)
}
