// SPDX-License-Identifier: GPL-3.0-or-later
// `npm start`: installs what is missing, builds what has changed, and serves the page until interrupted. The tutorial and
// the documentation are built while it is served.
import { build, main, ROOT } from './run.mjs'

const DEFAULT_PORT = 8080

await main(async () => {
  await build('build:page')
  await serve()
  await build('build')
})

async function serve() {
  const { preview } = await import('vite')
  const chosen = process.env.PORT
  const server = await preview({
    root: `${ROOT}web`,
    // The page as it has just been built, and what of the site is there.
    build: { outDir: `${ROOT}build/page` },
    configFile: `${ROOT}vite.config.ts`,
    // A port that was asked for is taken or refused; the default gives way to the next free one.
    preview: { port: Number(chosen ?? DEFAULT_PORT), strictPort: chosen !== undefined },
  })
  console.log(`The page is at ${server.resolvedUrls.local[0]}`)
}
