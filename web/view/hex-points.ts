// SPDX-License-Identifier: GPL-3.0-or-later

/** The positions of a POINT or a MULTIPOINT, and the reference system that it names. */
export interface TextPoints {
  readonly srid: string | undefined
  readonly points: readonly (readonly number[])[]
}

const [POINT, MULTIPOINT] = [1, 4]
/** Flags of PostGIS. The standard adds 1000 for Z, 2000 for M and 3000 for both. */
const [HAS_Z, HAS_M, HAS_SRID] = [0x80000000, 0x40000000, 0x20000000]

/**
 * Reads a POINT or a MULTIPOINT in well-known binary, as hexadecimal digits, as PostGIS prints it. Returns `undefined` if a
 * text is neither, or it has no points.
 */
export function hexPoints(text: string): TextPoints | undefined {
  if (!/^0[01](?:[\da-f]{2}){4,}$/i.test(text)) return undefined
  const bytes = Uint8Array.from(text.match(/../g) ?? [], (pair) => Number.parseInt(pair, 16))
  const data = new DataView(bytes.buffer)
  let at = 0
  let srid: string | undefined
  const points: number[][] = []

  const read = (depth: number): boolean => {
    const isLittle = data.getUint8(at) === 1
    const integer = (offset: number) => data.getUint32(offset, isLittle)
    const code = integer(at + 1)
    const plain = (code & ~(HAS_Z | HAS_M | HAS_SRID)) >>> 0
    const dimensions = Math.floor(plain / 1000)
    at += 5
    if ((code & HAS_SRID) !== 0) {
      if (depth === 0) srid = `${integer(at)}`
      at += 4
    }
    if (plain % 1000 === POINT) {
      const hasZ = (code & HAS_Z) !== 0 || dimensions % 2 === 1
      const hasM = (code & HAS_M) !== 0 || dimensions >= 2
      const numbers = Array.from({ length: 2 + Number(hasZ) + Number(hasM) }, (_, k) =>
        data.getFloat64(at + 8 * k, isLittle),
      )
      at += 8 * numbers.length
      const point = numbers.slice(0, 2)
      if (point.every(Number.isNaN)) return true
      points.push(point)
      return numbers.every(Number.isFinite)
    }
    if (plain % 1000 !== MULTIPOINT || depth > 0) return false
    const count = integer(at)
    at += 4
    for (let k = 0; k < count; k++) if (!read(depth + 1)) return false
    return true
  }

  try {
    const isRead = read(0) && at === bytes.length && points.length > 0
    return isRead ? { srid, points } : undefined
  } catch (error) {
    // The text ends too early.
    if (error instanceof RangeError) return undefined
    throw error
  }
}
