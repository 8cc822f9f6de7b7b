// SPDX-License-Identifier: GPL-3.0-or-later
export const ROOT: string
export const BIN: string

export function tarball(): string

export class Project {
  readonly folder: string
  path(name: string): string
  write(name: string, text: string): void
  run(program: string, ...args: string[]): string
  remove(): void
}

export function run(folder: string, program: string, ...args: string[]): string
