// SPDX-License-Identifier: GPL-3.0-or-later
// The functions that the public headers declare, as Clang reads them, and a program that refers to all of them.
import { execFileSync } from 'node:child_process'
import { readdirSync } from 'node:fs'

const FUNCTION = /^(?:Function|CXXMethod|CXXConstructor|CXXDestructor|CXXConversion)Decl$/

/** Returns a C++ source that includes all headers below `include`. */
export function sourceWithHeaders(include) {
  const headers = readdirSync(include, { recursive: true }).filter((path) => path.endsWith('.h'))
  return headers.map((path) => `#include "${path}"\n`).join('')
}

/** Returns the linker's names of all functions and variables that a library with the headers in `include` must define. */
export function declaredNames(include) {
  const tree = execFileSync(
    'clang++',
    [
      ...['-std=c++20', `-I${include}`, '-fsyntax-only', '-x', 'c++', '-'],
      ...['-Xclang', '-ast-dump=json', '-Xclang', '-ast-dump-filter=circle_voronoi'],
    ],
    { input: sourceWithHeaders(include), encoding: 'utf8', maxBuffer: 2 ** 30 },
  )
  const declared = new Set()
  const defined = new Set()
  // Clang prints a JSON text for each namespace block.
  for (const root of JSON.parse(`[${tree.replaceAll(/^\}\n(?=\{)/gm, '},\n')}]`)) collect(root, declared, defined)
  return [...declared].filter((name) => !defined.has(name))
}

function collect(node, declared, defined) {
  // Friends may be internal. A library defines no templates.
  if (node.kind === 'FriendDecl' || /Template/.test(node.kind)) return
  const isFunction = FUNCTION.test(node.kind)
  if (!isFunction && node.kind !== 'VarDecl') {
    for (const child of node.inner ?? []) collect(child, declared, defined)
    return
  }
  const isDefined = isFunction
    ? node.inline || node.pure || node.isImplicit || node.explicitlyDefaulted || node.explicitlyDeleted
    : node.inline || (node.storageClass !== 'extern' && node.storageClass !== 'static')
  const hasBody = node.inner?.some(({ kind }) => /^(?:Compound|CXXTry)Stmt$/.test(kind))
  if (isDefined || node.constexpr || hasBody) defined.add(node.mangledName)
  else declared.add(node.mangledName)
}

/** Returns a C++ program that has the addresses of all these names. */
export function programWith(names) {
  const declarations = names.map((name, i) => `void name${i}() __asm__("${name}");\n`).join('')
  const addresses = names.map((_, i) => `name${i}`).join(', ')
  return `${declarations}void (*volatile all[])() = {${addresses}};\nint main() { return all[0] == nullptr; }\n`
}
