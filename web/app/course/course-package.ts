// SPDX-License-Identifier: GPL-3.0-or-later
// A question as a SCORM 1.2 file for learning management systems: a zip of the frame page with its scripts, and a manifest. The zip
// is written by fflate (8 kB): browsers compress, but write no archives.
import { strToU8, zipSync } from 'fflate'
import courseScript from '../../embed/course.ts?worker&url'
import frameSheet from '../../embed/embed.css?inline'
import page from '../../embed.html?raw'
import { escaped } from '../../lib/drawing/escaped.ts'
import tokens from '../../style/tokens.css?inline'

/** A fixed date, so that the same link gives the same bytes. */
const DATE = '1980-01-01T12:00:00'

export interface Course {
  readonly link: string
  readonly title: string
  readonly lang: string
}

/**
 * Returns the bytes of the zip. `element` is the address of the element's single-file build.
 * @throws Error if a script cannot be loaded
 */
export async function coursePackage(course: Course, element: string): Promise<Uint8Array<ArrayBuffer>> {
  const [elementText, script] = await Promise.all([textOf(element), textOf(courseScript)])
  const files = {
    'imsmanifest.xml': await manifestOf(course),
    'index.html': pageOf(course),
    'element.js': elementText,
    'course.js': script,
  }
  const bytes = Object.fromEntries(Object.entries(files).map(([name, text]) => [name, strToU8(text)]))
  return zipSync(bytes, { level: 9, mtime: DATE }) as Uint8Array<ArrayBuffer>
}

/** The page of the frame with inlined style sheets and the package's scripts. */
function pageOf({ link, title, lang }: Course): string {
  const main = (/<main>[\s\S]*<\/main>/.exec(page)?.[0] ?? '').replace('<main>', `<main data-link="${link}">`)
  return `<!doctype html>
<html lang="${escaped(lang)}">
  <head>
    <meta charset="utf-8" />
    <meta name="viewport" content="width=device-width, initial-scale=1" />
    <meta name="color-scheme" content="light dark" />
    <title>${escaped(title)}</title>
    <link rel="icon" href="data:," />
    <style>
${tokens}
${frameSheet}
    </style>
    <script type="module" src="element.js"></script>
    <script type="module" src="course.js"></script>
  </head>
  <body>
    ${main}
  </body>
</html>
`
}

async function manifestOf({ link, title }: Course): Promise<string> {
  const hash = new Uint8Array(await crypto.subtle.digest('SHA-256', strToU8(link) as Uint8Array<ArrayBuffer>))
  const id = Array.from(hash.subarray(0, 8), (byte) => byte.toString(16).padStart(2, '0')).join('')
  return `<?xml version="1.0" encoding="UTF-8"?>
<manifest identifier="circle-voronoi-${id}" version="1.0"
  xmlns="http://www.imsproject.org/xsd/imscp_rootv1p1p2"
  xmlns:adlcp="http://www.adlnet.org/xsd/adlcp_rootv1p2"
  xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
  xsi:schemaLocation="http://www.imsproject.org/xsd/imscp_rootv1p1p2 imscp_rootv1p1p2.xsd http://www.adlnet.org/xsd/adlcp_rootv1p2 adlcp_rootv1p2.xsd">
  <metadata>
    <schema>ADL SCORM</schema>
    <schemaversion>1.2</schemaversion>
  </metadata>
  <organizations default="organization">
    <organization identifier="organization">
      <title>${escaped(title)}</title>
      <item identifier="item" identifierref="resource">
        <title>${escaped(title)}</title>
      </item>
    </organization>
  </organizations>
  <resources>
    <resource identifier="resource" type="webcontent" adlcp:scormtype="sco" href="index.html">
      <file href="index.html" />
      <file href="element.js" />
      <file href="course.js" />
    </resource>
  </resources>
</manifest>
`
}

async function textOf(address: string): Promise<string> {
  const url = new URL(address, document.baseURI)
  const response = await fetch(url).catch(() => undefined)
  if (response?.ok !== true) throw new Error(`The file cannot be made: ${url.pathname} cannot be loaded.`)
  return response.text()
}
