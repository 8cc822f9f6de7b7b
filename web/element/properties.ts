// SPDX-License-Identifier: GPL-3.0-or-later
// The attributes of an element, each with the property of its name. Accessors, observed attributes, values from before the
// definition of the class, and the manifest follow from this table.
import type { OpenRequest } from '../editing/open-request.ts'
import { plainRegion } from '../lib/regions/region-shape.ts'
import { checkedLayers, DEFAULT_LAYERS } from '../view/layers.ts'
import {
  checkedAreas,
  checkedLattice,
  checkedView,
  parseAreas,
  parseControls,
  parseLattice,
  parseLayers,
  parseMethod,
  parseRegion,
  parseSamples,
  parseStep,
  parseView,
} from './attributes.ts'
import { parseCheck } from './check.ts'
import { requestOfText } from './data-of.ts'
import { readCircles } from './read-circles.ts'

/** The part of a figure that a property changes. */
export type Part =
  | 'check'
  | 'circles'
  | 'controls'
  | 'description'
  | 'domain'
  | 'editing'
  | 'form'
  | 'language'
  | 'layers'
  | 'method'
  | 'step'
  | 'view'

/** An attribute and the property of its name. */
export interface Property<Value = unknown> {
  /** Parses the text of the attribute. Throws a `Refusal`. */
  parse(text: string): Value
  /**
   * Checks and copies an object that the property gets, which then replaces the attribute. Other values become the text
   * of the attribute. Throws a `Refusal`.
   */
  copied?(value: never): Value
  /** The value if there is no attribute. Default: `undefined`. */
  readonly none?: Value
  readonly part: Part
}

const TEXT = { parse: (text: string) => text, none: '' }
const FLAG = { parse: (): boolean => true, none: false }

export const PROPERTIES = {
  alt: { ...TEXT, part: 'description' },
  areas: { parse: parseAreas, copied: checkedAreas, part: 'domain' },
  check: { parse: parseCheck, part: 'check' },
  circles: { parse: circlesLater, part: 'circles' },
  controls: { parse: parseControls, none: { hasButtons: false, hasPlayer: false }, part: 'controls' },
  dissolve: { ...FLAG, part: 'domain' },
  lang: { ...TEXT, part: 'language' },
  lattice: { parse: parseLattice, copied: checkedLattice, part: 'domain' },
  layers: { parse: parseLayers, copied: checkedLayers, none: DEFAULT_LAYERS, part: 'layers' },
  method: { parse: parseMethod, none: 'auto', part: 'method' },
  name: { ...TEXT, part: 'form' },
  readonly: { ...FLAG, part: 'editing' },
  region: { parse: parseRegion, copied: plainRegion, part: 'domain' },
  samples: { parse: parseSamples, part: 'method' },
  src: { ...TEXT, part: 'circles' },
  step: { parse: parseStep, part: 'step' },
  view: { parse: parseView, copied: checkedView, part: 'view' },
} as const satisfies Record<string, Property>

export type PropertyName = keyof typeof PROPERTIES

/** The parsed values of attributes. */
export type Values = { [Name in PropertyName]?: ReturnType<(typeof PROPERTIES)[Name]['parse']> | undefined }

/** The value of a property, or its value without an attribute. */
export type ValueOf<Name extends PropertyName> =
  | ReturnType<(typeof PROPERTIES)[Name]['parse']>
  | ((typeof PROPERTIES)[Name] extends { readonly none: unknown } ? never : undefined)

/** Returns the attribute for a value; `undefined` for none. */
export function attributeText(value: unknown): string | undefined {
  if (value === undefined || value === false) return undefined
  if (value === true) return ''
  return typeof value === 'object' ? JSON.stringify(value) : String(value)
}

/** Returns a function that reads circles once they are needed, which may take long. */
function circlesLater(text: string): () => OpenRequest {
  let request: OpenRequest | undefined
  return () => {
    request ??= requestOfText(readCircles(text))
    return request
  }
}
