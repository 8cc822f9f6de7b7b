// SPDX-License-Identifier: GPL-3.0-or-later
import { openFirefox } from './firefox.ts'
import { openWebKit } from './webkit.ts'

/** The engines that are tested beside Chromium. */
export const ENGINES = [
  ['Firefox', openFirefox],
  ['WebKit', openWebKit],
] as const
