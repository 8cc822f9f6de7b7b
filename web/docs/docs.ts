// SPDX-License-Identifier: GPL-3.0-or-later
// Starts the interactive parts of a documentation page: its search and its examples.
import { offerSearch } from '../reading/search.ts'
import { runExamples } from './gallery.ts'

offerSearch(document)
runExamples(document)
