// SPDX-License-Identifier: GPL-3.0-or-later
import { use } from './main.js'
import { show } from './show.js'

show(use())
