// SPDX-License-Identifier: GPL-3.0-or-later
// `npm start`: installs what is missing, builds what has changed, and serves the page until interrupted. The tutorial and
// the documentation are built while it is served.
import { buildSite, buildWasm } from './build.mjs'
import { main, ROOT } from './run.mjs'
import { setup } from './setup.mjs'

const DEFAULT_PORT = 8080

await main(async () => {
  await setup('page')
  await buildWasm('page')
  await buildSite(serve)
})

async function serve() {
  const { preview } = await import('vite')
  const chosen = process.env.PORT
  const server = await preview({
    root: `${ROOT}web`,
    configFile: `${ROOT}vite.config.ts`,
    // A port that was asked for is taken or refused; the default gives way to the next free one.
    preview: { port: Number(chosen ?? DEFAULT_PORT), strictPort: chosen !== undefined },
  })
  console.log(`The page is at ${server.resolvedUrls.local[0]}`)
}
