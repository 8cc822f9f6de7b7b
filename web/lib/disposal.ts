// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * `dispose` for `using`, to compilers that know it.
 *
 * @category Editing
 */
export type Disposal = SymbolConstructor extends { readonly dispose: infer Key extends symbol }
  ? Record<Key, () => void>
  : unknown
