// SPDX-License-Identifier: GPL-3.0-or-later

/** Names of columns with names of things in other programs, the most likely first. */
export const NAME_COLUMN = /^\s*(name|label|title|ort|stadt|city|place|bezeichnung|beschriftung)\s*$/i
/** Names of columns with colors in other programs. `fill` and `marker-color` are those of maps in GeoJSON. */
export const COLOR_COLUMN = /^\s*(color|colour|farbe|fill|marker-color)\s*$/i
