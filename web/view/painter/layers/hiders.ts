// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../../../lib/base/diagram-data.ts'
import { addDisc } from '../disc-path.ts'
import type { Layer } from '../paint-context.ts'
import { addSegment } from '../segment-path.ts'

const LINE = 1.25
const DOT = 2

/**
 * A line from each hidden circle to the rim of a circle that contains it, away from the containing center, so that
 * lines do not cross.
 */
export const hiders: Layer = {
  id: 'hidden',
  isOn: (layers) => layers.hidden,
  draw(painting) {
    const { picture, frame, pixelRatio, style } = painting
    const { circles } = picture.diagram
    const lines = painting.drawing.path()
    const dots = painting.drawing.path()
    const sink = painting.sink()
    const x = (i: number) => sink.x(at(circles, 3 * i))
    const y = (i: number) => sink.y(at(circles, 3 * i + 1))
    // The line lies entirely in the containing disc.
    for (const hider of painting.circles) {
      for (const hidden of picture.hiddenBy(hider)) {
        const [dx, dy] = [x(hidden) - x(hider), y(hidden) - y(hider)]
        const distance = Math.hypot(dx, dy)
        const radius = at(circles, 3 * hider + 2) * frame.scale
        // With a common center, any direction will do.
        const [ux, uy] = distance === 0 ? [1, 0] : [dx / distance, dy / distance]
        addSegment(lines, frame, x(hidden), y(hidden), x(hider) + radius * ux, y(hider) + radius * uy)
        addDisc(dots, frame, x(hidden), y(hidden), DOT * pixelRatio)
      }
    }
    painting.stroke(lines, style.hidden, LINE * pixelRatio)
    painting.fill(dots, style.hidden)
  },
}
