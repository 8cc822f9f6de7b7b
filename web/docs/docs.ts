// SPDX-License-Identifier: GPL-3.0-or-later
// What a page of the documentation does beyond being read: its search finds, and its examples run.
import { offerSearch } from '../reading/search.ts'
import { runExamples } from './gallery.ts'

offerSearch(document)
runExamples(document)
