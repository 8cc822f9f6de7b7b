// SPDX-License-Identifier: GPL-3.0-or-later
// Compresses text to the characters that an address may contain (base64url), with the streams of browsers and Node.
import { CircleVoronoiError } from './errors.ts'

/** The largest number of arguments of `String.fromCharCode`. */
const PART = 0x8000
/** The largest number of bytes in a stored block of deflate. */
const LONGEST_BLOCK = 0xffff
const BLOCK_HEAD = 5

export async function compressText(text: string): Promise<string> {
  return lettersOf(
    await readUpTo(new TextEncoder().encode(text), streamOf('CompressionStream'), Number.POSITIVE_INFINITY),
  )
}

/** Encodes a text that is not empty synchronously, in uncompressed blocks of deflate (RFC 1951, section 3.2.4). */
export function storeText(text: string): string {
  const bytes = new TextEncoder().encode(text)
  const blocks = Math.ceil(bytes.length / LONGEST_BLOCK)
  const all = new Uint8Array(bytes.length + blocks * BLOCK_HEAD)
  for (let k = 0; k < blocks; k++) {
    const block = bytes.subarray(k * LONGEST_BLOCK, (k + 1) * LONGEST_BLOCK)
    const place = k * (LONGEST_BLOCK + BLOCK_HEAD)
    const head = new DataView(all.buffer, place, BLOCK_HEAD)
    head.setUint8(0, k === blocks - 1 ? 1 : 0)
    head.setUint16(1, block.length, true)
    head.setUint16(3, ~block.length & 0xffff, true)
    all.set(block, place + BLOCK_HEAD)
  }
  return lettersOf(all)
}

function lettersOf(bytes: Uint8Array): string {
  let binary = ''
  for (let i = 0; i < bytes.length; i += PART) binary += String.fromCharCode(...bytes.subarray(i, i + PART))
  return btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '')
}

/**
 * Reverses `compressText` and `storeText`. Returns `undefined` if the text has more than `most` bytes.
 *
 * @param most the largest number of bytes
 * @throws any error of decoding
 */
export async function decompressText(letters: string, most: number): Promise<string | undefined> {
  const binary = atob(letters.replaceAll('-', '+').replaceAll('_', '/'))
  const bytes = new Uint8Array(binary.length)
  for (let i = 0; i < bytes.length; i++) bytes[i] = binary.charCodeAt(i)
  const text = await readUpTo(bytes, streamOf('DecompressionStream'), most)
  return text.length > most ? undefined : new TextDecoder('utf-8', { fatal: true }).decode(text)
}

type Transformation = ReadableWritablePair<Uint8Array<ArrayBuffer>, BufferSource>

function streamOf(name: 'CompressionStream' | 'DecompressionStream'): Transformation {
  const Stream = globalThis[name]
  if (Stream === undefined) throw new CircleVoronoiError('notLoaded', `Links need ${name}, which is missing here.`)
  return new Stream('deflate-raw') as Transformation
}

/** Reads a stream until it exceeds `most` bytes, because a small text may unpack to one that fills the memory. */
async function readUpTo(
  bytes: Uint8Array<ArrayBuffer>,
  stream: Transformation,
  most: number,
): Promise<Uint8Array<ArrayBuffer>> {
  const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader()
  const parts: Uint8Array<ArrayBuffer>[] = []
  let length = 0
  for (let next = await reader.read(); !next.done; next = await reader.read()) {
    parts.push(next.value)
    length += next.value.length
    if (length <= most) continue
    await reader.cancel()
    break
  }
  const all = new Uint8Array(length)
  let place = 0
  for (const part of parts) {
    all.set(part, place)
    place += part.length
  }
  return all
}
