// SPDX-License-Identifier: GPL-3.0-or-later
import type { HtmlTagDescriptor } from 'vite'
import { defineConfig } from 'vitest/config'

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

const headers = { 'Content-Security-Policy': CONTENT_SECURITY_POLICY }

/** The policy again as a tag in the built page, for servers that send no headers. */
const policyTag: HtmlTagDescriptor = {
  tag: 'meta',
  attrs: { 'http-equiv': 'Content-Security-Policy', content: CONTENT_SECURITY_POLICY },
  injectTo: 'head-prepend',
}

export default defineConfig({
  root: 'web',
  base: './',
  publicDir: '../public',
  build: { outDir: '../dist/app', emptyOutDir: true, target: 'es2022', assetsInlineLimit: 0 },
  worker: { format: 'es' },
  preview: { headers },
  // The limit is for what hangs: on a busy machine a test of many random inputs may take long.
  test: {
    root: '.',
    include: ['tests/{web,scripts}/**/*.test.{ts,mjs}', 'tests/files/*.test.ts'],
    testTimeout: 60_000,
  },
  plugins: [{ name: 'content-security-policy', apply: 'build', transformIndexHtml: () => [policyTag] }],
})
