// SPDX-License-Identifier: GPL-3.0-or-later
// The package has types to older compilers, too.
import { join } from 'node:path'
import { after } from 'node:test'
import { BIN, Project } from '../pack/project.mjs'
import { hasTypes } from '../pack/types.mjs'
import { ToolProjects } from './tool-project.mjs'

/** TypeScript 5.2 has the libraries and the syntax that the declarations use. */
const VERSIONS = ['5.2', '5.3', '5.4', '5.5', '5.6', '5.7', '5.8', '5.9']

const project = new Project()
const tools = new ToolProjects()
after(() => {
  project.remove()
  tools.remove()
})
const aliases = VERSIONS.map((version) => `typescript-${version}@npm:typescript@${version}`)
const folder = tools.create('compilers', aliases, {})
hasTypes(project, {
  'TypeScript 6': join(BIN, 'tsc6'),
  ...Object.fromEntries(
    VERSIONS.map((version) => [`TypeScript ${version}`, join(folder, `node_modules/typescript-${version}/bin/tsc`)]),
  ),
})
