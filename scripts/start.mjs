// SPDX-License-Identifier: GPL-3.0-or-later
// `npm start`: installs missing dependencies, builds changed parts, and serves the page until interrupted. Serving starts as
// soon as diagrams can be computed. The other modules of WebAssembly, the tutorial and the documentation are built meanwhile;
// requests for them wait until they are built.
import { build, main, ROOT, run } from './run.mjs'
import { setup } from './setup.mjs'

const DEFAULT_PORT = 8080
/**
 * The page that is served until everything is built. Modules that may be missing are not bundled but served as files.
 */
const FIRST = `${ROOT}build/first`
const LATER = /^.*\/generated\/(?!circle-voronoi\.)([\w-]+\.js)$/
const LATER_WASM = /new URL\('[./]*\/generated\/(?!circle-voronoi\.)([\w-]+\.wasm)', import\.meta\.url\)/g

await main(async () => {
  await setup('page', async () => {
    await run('emcmake', ['cmake', '--preset', 'wasm'])
    // npm goes first, because it waits for files and the network in between.
    await run('nice', ['cmake', '--build', '--preset', 'wasm-first'])
  })
  await buildFirst()
  await serve()
})

async function buildFirst() {
  const vite = await import('vite')
  const later = {
    name: 'later',
    enforce: 'pre',
    resolveId: (source) =>
      LATER.test(source) ? { id: source.replace(LATER, '/generated/$1'), external: 'absolute' } : null,
    transform: (code) => code.replaceAll(LATER_WASM, "new URL('/generated/$1', location.origin)"),
  }
  await vite.build({
    configFile: `${ROOT}vite.config.ts`,
    logLevel: 'warn',
    plugins: [later],
    worker: { plugins: () => [later] },
    build: { outDir: FIRST },
  })
}

async function serve() {
  const [{ preview }, { default: sirv }] = await Promise.all([import('vite'), import('sirv')])
  let begin
  const begun = new Promise((resolve) => {
    begin = resolve
  })
  const modules = begun.then(() => run('cmake', ['--build', '--preset', 'wasm-modules']))
  const site = modules.then(() => build('build'))
  let isWhole = false

  const first = sirv(FIRST, { dev: true })
  const generated = ['app', 'lib', 'tutorial'].map((part) => sirv(`${ROOT}web/${part}/generated`, { dev: true }))
  // If a build fails, the terminal shows the error, and its files are not found.
  const after = (built, next) =>
    built.then(
      () => next(),
      () => next(),
    )
  const untilWhole = {
    name: 'until-whole',
    enforce: 'pre',
    configurePreviewServer({ middlewares }) {
      middlewares.use('/generated', (_request, _response, next) => after(modules, next))
      for (const files of generated) middlewares.use('/generated', files)
      middlewares.use((request, response, next) => {
        // Pages that were opened before request their own assets.
        if (isWhole && !request.url.startsWith('/assets/')) next()
        else first(request, response, () => after(site, next))
      })
    },
  }
  const chosen = process.env.PORT
  const server = await preview({
    root: `${ROOT}web`,
    configFile: `${ROOT}vite.config.ts`,
    plugins: [untilWhole],
    // A port that was requested is used or refused. The default gives way to the next free port.
    preview: { port: Number(chosen ?? DEFAULT_PORT), strictPort: chosen !== undefined },
  })
  console.log(`The page is at ${server.resolvedUrls?.local[0]}`)
  begin()
  await site
  isWhole = true
}
