// SPDX-License-Identifier: GPL-3.0-or-later

/** Video formats by decreasing support in other programs. Browsers write at least one. */
const TYPES = ['video/mp4', 'video/webm;codecs=vp9', 'video/webm'] as const
/** Bits per second, enough for sharp edges. */
const QUALITY = 8_000_000

/** A video and the ending of its file name. */
export interface Film {
  readonly film: Blob
  readonly ending: string
}

/** @throws Error if the browser cannot record video */
export async function filmed(stream: MediaStream, seconds: number): Promise<Film> {
  try {
    const type = TYPES.find((type) => globalThis.MediaRecorder?.isTypeSupported(type))
    if (type === undefined) throw new Error('This browser cannot record a video.')
    const recorder = new MediaRecorder(stream, { mimeType: type, videoBitsPerSecond: QUALITY })
    const parts: Blob[] = []
    recorder.ondataavailable = ({ data }) => parts.push(data)
    const stopped = new Promise((resolve, reject) => {
      recorder.onstop = resolve
      recorder.onerror = () => reject(new Error('The browser could not record the video.'))
    })
    recorder.start()
    setTimeout(() => recorder.stop(), 1000 * seconds)
    await stopped
    return { film: new Blob(parts, { type }), ending: type.startsWith('video/mp4') ? '.mp4' : '.webm' }
  } finally {
    for (const track of stream.getTracks()) track.stop()
  }
}
