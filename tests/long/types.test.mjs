// SPDX-License-Identifier: GPL-3.0-or-later
// The package has types to older compilers, too.
import { after } from 'node:test'
import { Project } from '../pack/project.mjs'
import { hasTypes } from '../pack/types.mjs'

const project = new Project()
after(() => project.remove())
hasTypes(project, (compiler) => compiler !== 'tsc')
