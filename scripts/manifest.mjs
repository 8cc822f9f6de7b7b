// SPDX-License-Identifier: GPL-3.0-or-later
// Writes custom-elements.json, the description of the element for editors and frameworks, from its source.
import { readFileSync } from 'node:fs'
import { create, ts } from '@custom-elements-manifest/analyzer'
import { ROOT } from './run.mjs'

const SOURCE = 'web/element/circle-voronoi-element.ts'
const TABLE = 'web/element/properties.ts'
const BUILT = 'dist/element/index.js'
const TAG = 'circle-voronoi'
/** Members of all elements, and members that only the browser calls. */
const COMMON = /^(#.*|.*Callback|addEventListener|focus|form|validity|validationMessage|checkValidity|reportValidity)$/

export function manifest() {
  const file = parsed(SOURCE)
  const { schemaVersion, modules } = create({ modules: [file], plugins: [] })
  const element = modules[0].declarations.find(({ name }) => name === 'CircleVoronoiElement')
  const members = [...element.members, ...accessorsOf(file)]
    // The analyzer takes assignments to other objects for members without a description.
    .filter(({ name, description, static: isStatic }) => description && !isStatic && !COMMON.test(name))
    .map(({ readonly, ...member }) => ({ ...plain(member), ...(readonly && { readonly }) }))
  const attributes = attributesOf(parsed(TABLE)).map((name) => {
    const { type, description } = members.find((member) => member.name === name)
    const isText = !/^(number|boolean|'.*')( \| undefined)?$/.test(type.text)
    const text = isText ? 'string' : type.text.replace(' | undefined', '')
    return { name, type: { text }, description, fieldName: name }
  })
  for (const member of members) if (attributes.some(({ name }) => name === member.name)) member.attribute = member.name
  const { kind, name, description, slots, cssParts, cssStates } = element
  const cssProperties = element.cssProperties.map(({ type, ...property }) => ({ ...property, syntax: type.text }))
  const shown = { slots, cssParts, cssStates, cssProperties }
  const declaration = { name, module: BUILT }
  return {
    schemaVersion,
    modules: [
      {
        kind: 'javascript-module',
        path: BUILT,
        declarations: [
          {
            ...{ kind, name, tagName: TAG, customElement: true, superclass: { name: 'HTMLElement' } },
            ...{ description, attributes, members, events: eventsOf(file), ...shown },
          },
        ],
        exports: [
          { kind: 'js', name, declaration },
          { kind: 'custom-element-definition', name: TAG, declaration },
        ],
      },
    ],
  }
}

function parsed(source) {
  return ts.createSourceFile(source, readFileSync(ROOT + source, 'utf8'), ts.ScriptTarget.ES2015, true)
}

/** The names of the rows of `PROPERTIES`. */
function attributesOf(file) {
  const table = find(file, (node) => ts.isVariableDeclaration(node) && node.name.text === 'PROPERTIES')
  return find(table, ts.isObjectLiteralExpression).properties.map(({ name }) => name.text)
}

/** The accessors that the class defines from the table. */
function accessorsOf(file) {
  return membersOf(file, 'CircleVoronoiElement')
    .filter(ts.isGetAccessor)
    .map(({ name, type, jsDoc }) => ({
      kind: 'field',
      name: name.text,
      type: { text: type.getText(file) },
      description: jsDoc[0].comment,
    }))
}

/** The events in `CircleVoronoiEventMap`. */
function eventsOf(file) {
  return membersOf(file, 'CircleVoronoiEventMap').map(({ name, type, jsDoc }) => ({
    name: name.text,
    type: { text: type.getText(file) },
    description: jsDoc[0].comment,
  }))
}

function membersOf(file, name) {
  return find(file, (node) => ts.isInterfaceDeclaration(node) && node.name.text === name).members
}

function find(node, is) {
  return is(node) ? node : ts.forEachChild(node, (child) => find(child, is))
}

/** Joins a description's lines. */
function plain({ description, ...rest }) {
  return { ...rest, description: description.replaceAll('\n', ' ') }
}
