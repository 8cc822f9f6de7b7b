// SPDX-License-Identifier: GPL-3.0-or-later
import { existsSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import sirv, { type Options } from 'sirv'
import type { HtmlTagDescriptor, Plugin } from 'vite'
import { defineConfig } from 'vitest/config'
import { PAGE_KEYS } from './web/app/page-keys.ts'
import { ENGLISH_KEYS, spokenKeys } from './web/editing/key-help.ts'
import * as icons from './web/view/icons.ts'

const CONTENT_SECURITY_POLICY = [
  "default-src 'self'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "style-src 'self'",
  "img-src 'self' data:",
  "worker-src 'self'",
  "connect-src 'self'",
  "object-src 'none'",
  "base-uri 'none'",
].join('; ')

/** The pages to build: absolute, because the build and the server of `npm run dev` resolve names differently. */
const PAGES = ['index.html', 'embed.html', 'tutorial/page.html', 'docs/page.html'].map((page) =>
  fileURLToPath(new URL(`web/${page}`, import.meta.url)),
)
/**
 * The files of modules that several parts of the site share. Without the second group each page begins with forty
 * files, many of a few hundred bytes, that compress badly. The threshold, in bytes, merges files that different parts
 * need; it keeps the first files of every page small. Merged files may import each other, so constants are not made of
 * constants of other modules (`initialState`), and with 20,000 a class may be evaluated before the one that it extends.
 */
const SHARED = [
  { name: 'preload', test: /preload-helper/, priority: 1 },
  {
    name: 'shared',
    tags: ['$initial' as const],
    test: /web.(app|editing|lib|player|view).|node_modules.lit/,
    minShareCount: 2,
    entriesAware: true,
    entriesAwareMergeThreshold: 10_000,
  },
]
/** The name of a shared file would list all entries that need it, in each file that imports it. */
const chunkFileNames = ({ name }: { name: string }) => `assets/${name.replace(/^shared~.*/, 'shared')}-[hash].js`
const PAGE = fileURLToPath(new URL('build/page', import.meta.url))
/** The folder of the built site. */
const SITE = fileURLToPath(new URL('dist/site', import.meta.url))

/** The policy again as a tag in the built page, for servers that send no headers. */
const policyTag: HtmlTagDescriptor = {
  tag: 'meta',
  attrs: { 'http-equiv': 'Content-Security-Policy', content: CONTENT_SECURITY_POLICY },
  injectTo: 'head-prepend',
}

/**
 * Preloads files of the first diagram that the page's own script would request late: the painting thread and
 * WebAssembly.
 */
const preloads: Plugin = {
  name: 'preloads',
  apply: 'build',
  transformIndexHtml: {
    order: 'post',
    handler(_html, { path, bundle = {} }) {
      if (path.startsWith('/docs/')) return []
      const root = path.startsWith('/tutorial/') ? '../' : './'
      const file = (pattern: RegExp) => root + Object.keys(bundle).find((name) => pattern.test(name))
      const link = (attrs: Record<string, string | boolean>): HtmlTagDescriptor => ({
        tag: 'link',
        attrs,
        injectTo: 'head',
      })
      return [
        link({
          rel: 'preload',
          as: 'fetch',
          crossorigin: true,
          href: file(/^assets\/circle-voronoi-[\w-]{8}\.wasm$/),
        }),
        link({ rel: 'modulepreload', href: file(/^assets\/start-thread-[\w-]{8}\.js$/) }),
      ]
    },
  },
}

/** Inserts parts of the page's HTML that are kept elsewhere: icons by name, and the text of its shortcuts. */
const pageParts: Plugin = {
  name: 'page-parts',
  transformIndexHtml: {
    order: 'pre',
    handler: (html) =>
      html
        .replace('<!-- keys -->', spokenKeys(ENGLISH_KEYS, false, Object.values(PAGE_KEYS)))
        .replace(/<svg data-icon="(\w+)" aria-hidden="true">/g, (_, name: string) => {
          const path = (icons as Readonly<Record<string, string>>)[name.toUpperCase()]
          if (path === undefined) throw new Error(`There is no icon ${name} in web/view/icons.ts.`)
          return `<svg viewBox="0 0 20 20" aria-hidden="true"><path d="${path}" />`
        }),
  },
}

/** Ends `npm run dev` with one sentence if the modules are missing. Each import of them would print a stack trace. */
const builtModules: Plugin = {
  name: 'built-modules',
  apply: (_config, { command, isPreview }) => command === 'serve' && !isPreview && process.env.VITEST === undefined,
  configResolved({ logger }) {
    if (existsSync(new URL('web/lib/generated/circle-voronoi.js', import.meta.url))) return
    logger.error('The WebAssembly modules are missing. Build them with: npm run build:wasm')
    process.exit(1)
  },
}

/** Serves the compressed files of the build; Vite itself would send WebAssembly uncompressed. */
const compressedFiles: Plugin = {
  name: 'compressed-files',
  configurePreviewServer({ middlewares, config: { base } }) {
    const options: Options = {
      // Looks for each file on request, because some are built later (`npm start`).
      dev: true,
      brotli: true,
      gzip: true,
      etag: true,
      setHeaders(response, path) {
        // Examples have policies of their own, or none.
        if (!path.startsWith('/examples/')) response.setHeader('Content-Security-Policy', CONTENT_SECURITY_POLICY)
        // Assets have a hash in their names, so that they never change.
        const isLasting = path.startsWith('/assets/')
        response.setHeader('Cache-Control', isLasting ? 'public, max-age=31536000, immutable' : 'no-cache')
      },
    }
    middlewares.use(base.startsWith('/') ? base : '/', sirv(SITE, options))
  },
}

export default defineConfig(({ isPreview }) => ({
  root: 'web',
  base: './',
  publicDir: '../public',
  build: {
    outDir: isPreview ? SITE : PAGE,
    emptyOutDir: true,
    target: 'es2022',
    // The first versions with `light-dark()`.
    cssTarget: ['chrome123', 'firefox120', 'safari17.5'],
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    rolldownOptions: { input: PAGES, output: { codeSplitting: { groups: SHARED }, chunkFileNames } },
  },
  worker: { format: 'es' },
  // The time limit is for hanging tests. On a busy machine a test of many random inputs may take long.
  test: {
    root: '.',
    include: ['tests/{web,scripts}/**/*.test.{ts,mjs}', 'tests/files/*.test.ts'],
    setupFiles: ['tests/random-inputs.ts'],
    // Colors that programs read from style sheets.
    css: { include: [/(theme|player)\.css/] },
    testTimeout: 60_000,
    hookTimeout: 60_000,
    maxWorkers: '100%',
  },
  plugins: [
    { name: 'content-security-policy', apply: 'build', transformIndexHtml: () => [policyTag] },
    builtModules,
    pageParts,
    preloads,
    compressedFiles,
  ],
}))
