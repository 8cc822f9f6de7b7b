// SPDX-License-Identifier: GPL-3.0-or-later
// The element in the tools that tutorials are written with, in their default configuration: built for production, and
// with development servers that bundle. Each figure has a region, and a circle is dragged.
import assert from 'node:assert/strict'
import { cpSync } from 'node:fs'
import { join } from 'node:path'
import { after, afterEach, before, it } from 'node:test'
import { blocksRunBy } from '../readme/blocks.mjs'
import { recipeOf } from '../readme/put-it-into.mjs'
import {
  CIRCLES,
  closeBrowser,
  FIGURE,
  launchBrowser,
  REGION,
  run,
  ToolProjects,
  useFigure,
  withFiles,
  withServer,
} from './tool-project.mjs'

const BLOCKS = blocksRunBy('tests/long/builds.test.mjs')
/** The files that docs/put-it-into.md gives for a tool. */
const recipe = (tool) => recipeOf(BLOCKS, tool)
/** A component in the page, with a listener for changes. */
const telling = (code) => code.replace(' />', " onCirclesChange={() => { document.title = 'changed' }} />")
const IMPORT = "import 'circle-voronoi/element'\n"
const page = (script, figure = FIGURE) =>
  `<!doctype html><html lang="en"><link rel="icon" href="data:,"><title>Circles</title>${script}${figure}</html>`
let projects
before(async () => {
  projects = new ToolProjects()
  await launchBrowser()
})
afterEach(() => projects.clear())
after(async () => {
  await closeBrowser()
  projects.remove()
})

for (const version of ['5.4.9', '6.4.6', '7.3.8']) {
  it(`Vite ${version}`, async () => {
    const files = { 'index.html': page('<script type="module" src="/main.js"></script>'), 'main.js': IMPORT }
    const folder = projects.create(`vite-${version}`, [`vite@${version}`], files)
    run(folder, 'vite', ['build', '--logLevel', 'warn'])
    await withFiles(join(folder, 'dist'), useFigure)
    await withServer(folder, 'vite', (port) => ['--port', port, '--strictPort'], useFigure)
  })
}

for (const [version, config] of [
  ['6.4.6', "{ optimizeDeps: { exclude: ['circle-voronoi'] } }"],
  ['8.3.8', '{}'],
]) {
  it(`Vite ${version}, with the WebAssembly that the page gives`, async () => {
    const folder = projects.create(`vite-define-${version}`, [`vite@${version}`], {
      'index.html': page('<script type="module" src="/main.js"></script>'),
      'vite.config.js': `export default ${config}\n`,
      'main.js': `import { defineCircleVoronoi } from 'circle-voronoi/element/define'
import wasm from 'circle-voronoi/circle-voronoi.wasm?url'
defineCircleVoronoi({ wasm: fetch(wasm).then((response) => { document.title = 'given'; return response }) })\n`,
    })
    const given = async (page) => assert.equal(await page.title(), 'given')
    await withServer(
      folder,
      'vite',
      (port) => ['--port', port, '--strictPort'],
      (address) => useFigure(address, { afterwards: given }),
    )
  })
}

it('webpack 5.102', async () => {
  const folder = projects.create('webpack', ['webpack@5.102.1', 'webpack-cli@6.0.1'], { 'src/index.js': IMPORT })
  for (const mode of ['production', 'development']) {
    run(folder, 'webpack', ['--mode', mode, '--no-color'])
    projects.write(folder, 'dist/index.html', page('<script src="main.js" defer></script>'))
    await withFiles(join(folder, 'dist'), useFigure)
  }
})

it('esbuild 0.25, by the module in one file', async () => {
  const folder = projects.create('esbuild', ['esbuild@0.25.11'], {
    'main.js': "import 'circle-voronoi/element/inline'\n",
  })
  run(folder, 'esbuild', ['main.js', '--bundle', '--minify', '--format=esm', '--outdir=dist', '--log-level=error'])
  projects.write(folder, 'dist/index.html', page('<script type="module" src="main.js"></script>'))
  await withFiles(join(folder, 'dist'), useFigure)
})

it('VitePress 1.6', async () => {
  const folder = projects.create('vitepress', ['vitepress@1.6.3'], recipe('VitePress'))
  run(folder, 'vitepress', ['build'])
  await withFiles(join(folder, '.vitepress/dist'), useFigure)
  await withServer(folder, 'vitepress', (port) => ['dev', '--port', port, '--strictPort'], useFigure)
})

it('Astro 5.9 with Starlight 0.34', async () => {
  const folder = projects.create('starlight', ['astro@5.9.4', '@astrojs/starlight@0.34.4', 'sharp@0.34.2'], {
    'astro.config.mjs': `import starlight from '@astrojs/starlight'
import { defineConfig } from 'astro/config'
export default defineConfig({ integrations: [starlight({ title: 'Circles' })] })\n`,
    'src/content.config.ts': `import { docsLoader } from '@astrojs/starlight/loaders'
import { docsSchema } from '@astrojs/starlight/schema'
import { defineCollection } from 'astro:content'
export const collections = { docs: defineCollection({ loader: docsLoader(), schema: docsSchema() }) }\n`,
    ...recipe('Astro Starlight'),
  })
  run(folder, 'astro', ['build'])
  await withFiles(join(folder, 'dist'), useFigure)
})

it('SvelteKit 2', async () => {
  const packages = ['@sveltejs/kit@2.21.5', '@sveltejs/adapter-static@3.0.8', '@sveltejs/vite-plugin-svelte@5.1.0']
  const folder = projects.create('sveltekit', [...packages, 'svelte@5.34.0', 'vite@6.4.6'], {
    'svelte.config.js': `import adapter from '@sveltejs/adapter-static'
export default { kit: { adapter: adapter({ pages: 'site' }) } }\n`,
    'vite.config.js': `import { sveltekit } from '@sveltejs/kit/vite'
export default { plugins: [sveltekit()] }\n`,
    'src/app.html':
      '<!doctype html><html lang="en"><head>%sveltekit.head%</head><body><div>%sveltekit.body%</div></body></html>',
    'src/routes/+layout.js': 'export const prerender = true\n',
    'src/routes/+page.svelte': `<script>import 'circle-voronoi/element'</script>\n<h1>Circles</h1>\n${FIGURE.replace('[[', '{JSON.stringify([[').replace(']]', ']])}').replace('circles="', 'circles=').replace(')}"', ')}')}\n`,
  })
  run(folder, 'vite', ['build'])
  await withFiles(join(folder, 'site'), useFigure)
  await withServer(folder, 'vite', (port) => ['dev', '--port', port, '--strictPort'], useFigure)
})

for (const bundler of ['webpack', 'turbopack']) {
  it(`Next 15 with ${bundler} and React 19`, async () => {
    const folder = projects.create(`next-${bundler}`, ['next@15.5.6', 'react@19.2.0', 'react-dom@19.2.0'], {
      'next.config.mjs': "export default { output: 'export', outputFileTracingRoot: import.meta.dirname }\n",
      'app/layout.jsx': 'export default ({ children }) => <html lang="en"><body>{children}</body></html>\n',
      'app/page.jsx': `import { Figure } from './figure'
export default function Page() { return <main><h1>Circles</h1><Figure /></main> }\n`,
      'app/figure.jsx': telling(recipe('Next')['app/figure.jsx']),
    })
    run(folder, 'next', ['build', ...(bundler === 'turbopack' ? ['--turbopack'] : [])])
    const changed = async (page) => assert.equal(await page.title(), 'changed')
    await withFiles(join(folder, 'out'), (address) => useFigure(address, { afterwards: changed }))
  })
}

it('Nuxt 3', async () => {
  const folder = projects.create('nuxt', ['nuxt@3.21.11'], recipe('Nuxt'))
  run(folder, 'nuxt', ['generate'])
  await withFiles(join(folder, '.output/public'), useFigure)
})

it('Angular 19', async () => {
  const names = ['common', 'compiler', 'core', 'platform-browser'].map((name) => `@angular/${name}@19.2.14`)
  const tools = ['@angular/cli@19.2.15', '@angular/build@19.2.15', '@angular/compiler-cli@19.2.14', 'typescript@5.8.3']
  const options = {
    browser: 'src/main.ts',
    index: 'src/index.html',
    polyfills: ['zone.js'],
    tsConfig: 'tsconfig.json',
    outputPath: 'dist',
  }
  const build = { builder: '@angular/build:application', options: { ...options, progress: false } }
  const folder = projects.create('angular', [...names, ...tools, 'rxjs@7.8.2', 'tslib@2.8.1', 'zone.js@0.15.1'], {
    'package.json': JSON.stringify({ private: true }),
    'angular.json': JSON.stringify({
      version: 1,
      projects: { circles: { projectType: 'application', root: '', sourceRoot: 'src', architect: { build } } },
    }),
    'tsconfig.json': JSON.stringify({
      compilerOptions: { target: 'ES2022', module: 'ES2022', moduleResolution: 'bundler', lib: ['ES2022', 'DOM'] },
      files: ['src/main.ts'],
    }),
    'src/index.html':
      '<!doctype html><html lang="en"><base href="/"><title>Circles</title><app-root></app-root></html>',
    ...recipe('Angular'),
  })
  run(folder, 'ng', ['build'])
  await withFiles(join(folder, 'dist/browser'), useFigure)
})

it('Docusaurus 3.9', async () => {
  const packages = ['@docusaurus/core@3.9.2', '@docusaurus/preset-classic@3.9.2', 'react@19.2.0', 'react-dom@19.2.0']
  // The progress bar does not support newer versions of webpack.
  packages.push('webpack@5.102.1')
  const folder = projects.create('docusaurus', packages, {
    'package.json': JSON.stringify({ private: true }),
    'docusaurus.config.js': `module.exports = {
  title: 'Circles', url: 'https://example.com', baseUrl: '/',
  presets: [['classic', { docs: { routeBasePath: '/' }, blog: false }]],
}\n`,
    'docs/index.mdx': telling(recipe('Docusaurus')['docs/index.mdx']),
  })
  run(folder, 'docusaurus', ['build'])
  const changed = async (page) => assert.equal(await page.title(), 'changed')
  await withFiles(join(folder, 'build'), (address) => useFigure(address, { afterwards: changed }))
})

it('Eleventy 3, with the files of the package beside its pages', async () => {
  const folder = projects.create('eleventy', ['@11ty/eleventy@3.1.2'], recipe('Eleventy'))
  run(folder, 'eleventy', ['--quiet'])
  await withFiles(join(folder, '_site'), useFigure)
})

it('MkDocs, with a table in Markdown between the tags', async () => {
  const table = `| x | y | r |\n|---|---|---|\n${JSON.parse(CIRCLES)
    .map((row) => `| ${row.join(' | ')} |`)
    .join('\n')}`
  const files = recipe('MkDocs')
  const folder = projects.create('mkdocs', [], {
    ...files,
    // The theme would fetch its highlighter from another site.
    'mkdocs.yml': `${files['mkdocs.yml']}theme: { name: mkdocs, highlightjs: false }\n`,
    'docs/table.md': `# Circles\n\n<circle-voronoi region="${REGION}">\n\n${table}\n\n</circle-voronoi>\n`,
  })
  cpSync(
    join(folder, 'node_modules/circle-voronoi/dist/element/classic.js'),
    join(folder, 'docs/circle-voronoi/classic.js'),
  )
  run(folder, 'mkdocs', ['build', '--quiet'])
  await withFiles(join(folder, 'site'), async (address) => {
    await useFigure(address)
    await useFigure(`${address}table/`)
  })
})

it('Observable Framework 1.13', async () => {
  const folder = projects.create('observable', ['@observablehq/framework@1.13.4'], {
    ...recipe('Observable Framework'),
    // The value is that of an input, which other cells follow.
    'src/view.md': `# View

\`\`\`js
import 'circle-voronoi/element/inline'
const figure = document.createElement('circle-voronoi')
figure.setAttribute('circles', '${CIRCLES}')
figure.setAttribute('region', '${REGION}')
const circles = view(figure)
\`\`\`

<output>\${circles.join(' ')}</output>
`,
  })
  run(folder, 'observable', ['build'])
  await withFiles(join(folder, 'dist'), async (address) => {
    await useFigure(address)
    const follows = async (page) => {
      const circles = await page.locator('circle-voronoi').evaluate((element) => element.circles.join(' '))
      await page.locator('output', { hasText: circles }).waitFor()
    }
    await useFigure(`${address}view`, { afterwards: follows })
  })
})

/** Two sizes of the window, to which slides are scaled. */
const WINDOWS = [
  { width: 1500, height: 1000 },
  { width: 700, height: 500 },
]

it('reveal.js 5: mouse, finger and keys stay on the slide', async () => {
  const folder = projects.create('reveal', ['reveal.js@5.2.1'], recipe('reveal.js'))
  const stays = async (page) => assert.doesNotMatch(page.url(), /#\/[1-9]/)
  await withFiles(folder, async (address) => {
    for (const viewport of WINDOWS) {
      for (const isTouch of [false, true])
        await useFigure(address, { viewport, isTouch, hasKeys: true, afterwards: stays })
    }
  })
})

it('Slidev 51: mouse, finger and keys stay on the slide', async () => {
  const packages = ['@slidev/cli@51.8.1', '@slidev/theme-default@0.25.0', 'vue@3.5.17']
  const files = recipe('Slidev')
  const slides = `${files['slides.md']}\n---\n\n# Next\n`
  const folder = projects.create('slidev', packages, { ...files, 'slides.md': slides })
  run(folder, 'slidev', ['build'])
  const stays = async (page) => assert.match(page.url(), /\/1(\?.*)?$/)
  await withFiles(
    join(folder, 'dist'),
    async (address) => {
      for (const viewport of WINDOWS) {
        for (const isTouch of [false, true]) {
          await useFigure(`${address}1`, { viewport, isTouch, hasKeys: true, afterwards: stays })
        }
      }
    },
    { single: true },
  )
})
