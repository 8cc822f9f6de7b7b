// SPDX-License-Identifier: GPL-3.0-or-later
import type { PageActions } from '../page-actions.ts'
import { byId } from './by-id.ts'

export function mountViewControls(actions: PageActions): void {
  byId('zoom-in', HTMLButtonElement).addEventListener('click', () => actions.camera.zoomAtMiddle(1))
  byId('zoom-out', HTMLButtonElement).addEventListener('click', () => actions.camera.zoomAtMiddle(-1))
  byId('fit', HTMLButtonElement).addEventListener('click', () => actions.camera.fit())
}
