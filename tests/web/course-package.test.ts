// SPDX-License-Identifier: GPL-3.0-or-later
// The SCORM file with a question: its files, its manifest and its page.
import { strFromU8, unzipSync } from 'fflate'
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { coursePackage } from '../../web/app/course/course-package.ts'

let isThere = true
beforeEach(() => {
  isThere = true
  vi.stubGlobal('document', { baseURI: 'https://a.example/b/' })
  vi.stubGlobal('fetch', async ({ href }: URL) => {
    if (!isThere) throw new Error('no network')
    return { ok: !href.includes('gone'), text: async () => `text of ${href}` }
  })
})
afterEach(() => vi.unstubAllGlobals())

const COURSE = { link: 'v1.abc', title: 'A "title" <&>', lang: 'de' }
const ELEMENT = 'https://a.example/b/element.js'
const ESCAPED = 'A &quot;title&quot; &#60;&#38;&#62;'

it('has the page, its scripts and a manifest that names them', async () => {
  const files = unzipSync(await coursePackage(COURSE, ELEMENT))
  const text = (name: string) => strFromU8(files[name] ?? new Uint8Array())
  expect(Object.keys(files)).toEqual(['imsmanifest.xml', 'index.html', 'element.js', 'course.js'])
  expect(text('element.js')).toBe(`text of ${ELEMENT}`)
  expect(text('course.js')).toMatch(/^text of https:\/\/a\.example\/.*course/)
  const manifest = text('imsmanifest.xml')
  for (const name of ['index.html', 'element.js', 'course.js']) expect(manifest).toContain(`<file href="${name}" />`)
  expect(manifest.match(new RegExp(`<title>${ESCAPED}</title>`, 'g'))).toHaveLength(2)
  expect(manifest).toMatch(/ adlcp:scormtype="sco" href="index\.html">/)
  expect(manifest).toContain('<schemaversion>1.2</schemaversion>')
  // The beginning of the hash of the link.
  const hash = new Uint8Array(await crypto.subtle.digest('SHA-256', new TextEncoder().encode(COURSE.link)))
  const id = Buffer.from(hash.subarray(0, 8)).toString('hex')
  expect(manifest).toContain(`<manifest identifier="circle-voronoi-${id}"`)
  const page = text('index.html')
  expect(page).toContain('<html lang="de">')
  expect(page).toContain(`<title>${ESCAPED}</title>`)
  expect(page).toMatch(/<main data-link="v1\.abc">[\s\S]*<\/main>/)
  for (const name of ['element.js', 'course.js'])
    expect(page).toContain(`<script type="module" src="${name}"></script>`)
})

it('has the same bytes for the same link, and another identifier for another link', async () => {
  const bytes = await coursePackage(COURSE, ELEMENT)
  expect(await coursePackage(COURSE, ELEMENT)).toEqual(bytes)
  const manifestOf = (bytes: Uint8Array) =>
    /identifier="(circle-voronoi-\w+)"/.exec(strFromU8(unzipSync(bytes)['imsmanifest.xml'] as Uint8Array))?.[1]
  expect(manifestOf(await coursePackage({ ...COURSE, link: 'v1.abd' }, ELEMENT))).not.toBe(manifestOf(bytes))
})

it('cannot be made without its scripts, which is said', async () => {
  const error = 'The file cannot be made: /b/gone.js cannot be loaded.'
  await expect(coursePackage(COURSE, 'gone.js')).rejects.toThrow(error)
  isThere = false
  await expect(coursePackage(COURSE, 'gone.js')).rejects.toThrow(error)
})
