// SPDX-License-Identifier: GPL-3.0-or-later
// The icons of the page, the element and the player, as paths in 20 by 20 units.

const RING = 'M3 10a7 7 0 1 0 14 0a7 7 0 1 0-14 0'

export const ADD = `${RING}M10 7v6M7 10h6`
export const AGAIN = 'M16 5v4h-4M4 15v-4h4M15.4 9A6 6 0 0 0 5 6.2M4.6 11A6 6 0 0 0 15 13.8'
export const ASK = 'M7 7a3 3 0 1 1 4 3c-1 .6-1 1.2-1 2.5M10 16v.1'
export const BIN = 'M4 6h12M8 6V4h4v2M6 6l.7 10h6.6L14 6'
export const CARD = 'M3 4.5h14v11H3zM5.500 12.500h6M5.500 9.500h9'
export const CHAIN = 'M8 12l4-4M7 9l-2 2a2.8 2.8 0 0 0 4 4l2-2M13 11l2-2a2.8 2.8 0 0 0-4-4L9 7'
export const CLOSE = 'm6 6 8 8M14 6l-8 8'
export const CODE = 'm7 6-4 4 4 4M13 6l4 4-4 4'
export const DICE =
  'M6 4h8a2 2 0 0 1 2 2v8a2 2 0 0 1-2 2H6a2 2 0 0 1-2-2V6a2 2 0 0 1 2-2ZM7.5 7.5v.1M12.5 7.5v.1M10 10v.1M7.5 12.5v.1M12.5 12.5v.1'
export const DOTS = 'M4.5 10h.1M10 10h.1M15.5 10h.1'
export const DOWN = 'M10 4v8m-3-3 3 3 3-3M4 16h12'
export const FILM = 'M3 5h9.500v10H3zM12.500 8.700 17 6.500v7l-4.500-2.200'
export const FIT = 'M4 8V4h4M12 4h4v4M16 12v4h-4M8 16H4v-4'
export const FOLDER = 'M3 6v9h14V7h-7L8 5H3Z'
export const GALLERY = 'M3 3.500h6v6H3zM11 3.500h6v6h-6zM3 11.500h6v5H3zM11 11.500h6v5h-6z'
export const HELP = 'M7.5 8a2.5 2.5 0 1 1 3.7 2.2c-.8.4-1.2.9-1.2 1.8M10 14.5v.1'
export const LAYERS = 'm10 3 7 4-7 4-7-4zM3 10.5l7 4 7-4M3 14l7 4 7-4'
export const METHOD = 'M2.5 16.5h4v-4h4v-4h4v-4h3.5'
export const MINUS = 'M5 10h10'
export const MOTION = 'M9 10a4 4 0 1 0 8 0a4 4 0 1 0-8 0M2 6.5h5M1.5 10h3.5M2 13.5h5'
export const NEXT = 'M4 4l6 6-6 6M10 4l6 6-6 6'
export const NUMBERS = 'M4 16V9M8 16V4M12 16v-5M16 16v-8M2 16h16'
export const PAN =
  'M6.5 11V5.2a1.2 1.2 0 0 1 2.4 0V9.500V3.700a1.2 1.2 0 0 1 2.400 0v5.800V4.700a1.2 1.2 0 0 1 2.400 0v5.300V7a1.2 1.2 0 0 1 2.400 0v5.500c0 3-2 5-4.600 5h-1c-2 0-3-.8-4-2.300L3.700 12a1.2 1.2 0 0 1 1.900-1.500l.9 1'
export const PAUSE = 'M7 4v12M13 4v12'
export const PEN = 'm4 16 1-4 8.5-8.5 3 3L8 15zM11.5 5.5l3 3'
export const PICTURE = 'M3 4h14v12H3zM3 13.500l4-4 3.500 3.500 2.500-2.500 4 4M12.500 7.500v.1'
export const PLUS = 'M10 5v10M5 10h10'
export const PREVIOUS = 'M10 4l-6 6 6 6M16 4l-6 6 6 6'
export const PRINT = 'M6 8V3.500h8V8M6 13.500H3.500V8h13v5.500H14M6 11.500h8v5H6z'
export const REDO = 'm13 4 3.5 3.5L13 11M16 7.5H8.5a4 4 0 0 0 0 8H12'
export const REGION = 'm4 8 6-5 7 4-2 8-9 2zM8 9.5l4-.5-.5 3.5z'
export const REMOVE = `${RING}M7 10h6`
export const SELECT = 'm5 3 11 6-5 1.5L8.5 16Z'
export const SEND = 'M10 12V3m-3 3 3-3 3 3M5 9H4v8h12V9h-1'
export const STOP = 'M5.5 5.5h9v9h-9z'
export const TABLE = 'M3 4.5h14v11H3zM3 8.5h14M3 12h14M8 4.5v11'
export const TARGET = 'M4.5 10a5.5 5.5 0 1 0 11 0a5.5 5.5 0 1 0-11 0M10 2v4M10 14v4M2 10h4M14 10h4'
export const UNDO = 'M7 4 3.5 7.5 7 11M4 7.5h7.5a4 4 0 0 1 0 8H8'

// The following icons are filled.
export const BACK = 'M6 4v12M15 4l-7 6 7 6z'
export const DOT = 'M5.5 10a4.5 4.5 0 1 0 9 0a4.5 4.5 0 1 0-9 0'
export const FORTH = 'M14 4v12M5 4l7 6-7 6z'
export const PLAY = 'M6 4l10 6-10 6z'
