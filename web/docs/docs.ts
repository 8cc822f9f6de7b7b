// SPDX-License-Identifier: GPL-3.0-or-later
// What a page of the documentation does beyond being read: its search finds.
import { offerSearch } from '../reading/search.ts'

offerSearch(document)
