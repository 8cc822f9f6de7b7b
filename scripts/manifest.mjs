// SPDX-License-Identifier: GPL-3.0-or-later
// Writes custom-elements.json, the description of the element for editors and frameworks, from its source.
import { readFileSync } from 'node:fs'
import { create, ts } from '@custom-elements-manifest/analyzer'
import { ROOT } from './run.mjs'

const SOURCE = 'web/element/circle-voronoi-element.ts'
const BUILT = 'dist/element/index.js'
const TAG = 'circle-voronoi'
/** Members of all elements, and members that only the browser calls. */
const COMMON = /^(#.*|.*Callback|addEventListener|focus|form|validity|validationMessage|checkValidity|reportValidity)$/

export function manifest() {
  const file = ts.createSourceFile(SOURCE, readFileSync(ROOT + SOURCE, 'utf8'), ts.ScriptTarget.ES2015, true)
  const { schemaVersion, modules } = create({ modules: [file], plugins: [] })
  const element = modules[0].declarations.find(({ name }) => name === 'CircleVoronoiElement')
  const members = element.members
    // The analyzer takes assignments to other objects for members without a description.
    .filter(({ name, description, static: isStatic }) => description && !isStatic && !COMMON.test(name))
    .map(({ readonly, ...member }) => ({ ...plain(member), ...(readonly && { readonly }) }))
  const attributes = [...attributesOf(file), 'name'].sort().map((name) => {
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

/** The names in `ATTRIBUTES`. */
function attributesOf(file) {
  const list = find(file, (node) => ts.isVariableDeclaration(node) && node.name.text === 'ATTRIBUTES')
  return list.initializer.expression.elements.map(({ text }) => text)
}

/** The events in `CircleVoronoiEventMap`. */
function eventsOf(file) {
  const map = find(file, (node) => ts.isInterfaceDeclaration(node) && node.name.text === 'CircleVoronoiEventMap')
  return map.members.map((member) => ({
    name: member.name.text,
    type: { text: member.type.getText(file) },
    description: member.jsDoc[0].comment,
  }))
}

function find(node, is) {
  return is(node) ? node : ts.forEachChild(node, (child) => find(child, is))
}

/** Joins a description's lines. */
function plain({ description, ...rest }) {
  return { ...rest, description: description.replaceAll('\n', ' ') }
}
