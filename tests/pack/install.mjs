// SPDX-License-Identifier: GPL-3.0-or-later
// Installs the packed package in an empty project, without a network. The projects of tests copy the result.
import { execFileSync } from 'node:child_process'
import { mkdirSync, renameSync, rmSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { INSTALLED, ROOT, tarball } from './project.mjs'

const folder = join(ROOT, 'build/installing')
for (const old of [folder, INSTALLED]) rmSync(old, { recursive: true, force: true })
mkdirSync(folder, { recursive: true })
writeFileSync(join(folder, 'package.json'), '{"private":true}')
execFileSync('npm', ['install', '--silent', '--offline', '--no-audit', '--no-fund', tarball()], { cwd: folder })
renameSync(join(folder, 'node_modules'), INSTALLED)
rmSync(folder, { recursive: true })
