// SPDX-License-Identifier: GPL-3.0-or-later
// The view of the globe: the place in its middle, north up, and how far it is zoomed in.
import { geoInterpolate, geoOrthographic } from 'd3-geo'

const DEGREE = Math.PI / 180
const ZOOM = { least: 0.6, most: 5000 }
/** The share of the canvas that the globe fills. */
const FILLED = 0.94
/** A view of the whole globe. */
const WHOLE = { longitude: 15, latitude: 25, zoom: 1 }
/** d3-geo fails on borders exactly along the horizon, so the view is turned by so many degrees. */
const ASIDE = 2e-4

/** Returns the globe's radius in pixels. */
export function scaleOf({ zoom }, { width, height }) {
  return (zoom * FILLED * Math.min(width, height)) / 2
}

/** Returns the projection of d3-geo. */
export function projectionOf(view, size) {
  return geoOrthographic()
    .translate([size.width / 2, size.height / 2])
    .scale(scaleOf(view, size))
    .rotate([ASIDE - view.longitude, ASIDE - view.latitude])
    .clipAngle(90)
    .clipExtent([
      [-10, -10],
      [size.width + 10, size.height + 10],
    ])
}

/** Returns the place at a point of the canvas as longitude and latitude; `undefined` beside the globe. */
export function placeAt(view, size, [x, y]) {
  const isOn = Math.hypot(x - size.width / 2, y - size.height / 2) < scaleOf(view, size)
  return isOn ? projectionOf(view, size).invert([x, y]) : undefined
}

/** Returns the view that has a place at a point of the canvas; `undefined` if no view with north up has. */
export function withPlaceAt(view, size, [longitude, latitude], [x, y]) {
  const scale = scaleOf(view, size)
  const across = (x - size.width / 2) / scale
  const up = (size.height / 2 - y) / scale
  const cosine = Math.cos(latitude * DEGREE)
  if (Math.hypot(across, up) >= 1 || Math.abs(across) >= cosine) return undefined
  const depth = Math.sqrt(1 - across ** 2 - up ** 2)
  const turn = Math.asin(across / cosine)
  // The place is on the near side of the pole, or beyond it.
  const views = [turn, Math.PI - turn].map((angle) => ({
    ...view,
    longitude: turned(longitude - angle / DEGREE),
    latitude: (Math.atan2(Math.sin(latitude * DEGREE), cosine * Math.cos(angle)) - Math.atan2(up, depth)) / DEGREE,
  }))
  const distance = (other) => Math.abs(turned(other.longitude - view.longitude))
  return views.filter((other) => Math.abs(other.latitude) <= 90).sort((a, b) => distance(a) - distance(b))[0]
}

/** Returns the view after a drag by some pixels. */
export function dragged(view, size, [right, down]) {
  const perPixel = 1 / (scaleOf(view, size) * DEGREE)
  return turnedBy(view, -right * perPixel, down * perPixel)
}

/** Returns the view turned by some degrees to the east and to the north. */
export function turnedBy(view, east, north) {
  return {
    ...view,
    longitude: turned(view.longitude + east),
    latitude: Math.min(Math.max(view.latitude + north, -90), 90),
  }
}

/** Returns the view zoomed by a factor, with the place at a point of the canvas where it was. */
export function zoomedAt(view, size, factor, point) {
  const zoom = Math.min(Math.max(view.zoom * factor, ZOOM.least), ZOOM.most)
  const place = placeAt(view, size, point)
  const zoomed = { ...view, zoom }
  return (place && withPlaceAt(zoomed, size, place, point)) ?? zoomed
}

/** Returns a view of all places: of the side of the globe where they are, or of the whole globe. */
export function viewOf(places) {
  const sum = [0, 0, 0]
  const vectors = []
  for (let k = 0; k < places.length; k += 3) {
    const vector = vectorOf([places[k], places[k + 1]])
    vectors.push(vector)
    for (const i of [0, 1, 2]) sum[i] += vector[i]
  }
  const length = Math.hypot(...sum)
  if (length <= 0.3 * vectors.length) return WHOLE
  const middle = sum.map((value) => value / length)
  const [longitude, latitude] = [Math.atan2(middle[1], middle[0]), Math.asin(middle[2])].map((angle) => angle / DEGREE)
  const chord = (vector) => Math.hypot(...vector.map((value, i) => value - middle[i]))
  const farthest = vectors.reduce((most, vector) => Math.max(most, chord(vector)), 0)
  // A chord of 1 is 60 degrees. A single place has its country around it.
  const zoom = farthest >= 1 ? 1 : Math.min(0.8 / Math.max(farthest, 0.05), 0.8 * ZOOM.most)
  return { longitude, latitude, zoom: Math.max(zoom, 1) }
}

/** Returns the views on the way to a place, as a function of a number from 0 to 1. */
export function flight(view, place) {
  const way = geoInterpolate([view.longitude, view.latitude], place)
  return (share) => {
    const [longitude, latitude] = way(share * share * (3 - 2 * share))
    return { ...view, longitude, latitude }
  }
}

/** Returns the unit vector of a place. */
export function vectorOf([longitude, latitude]) {
  const [a, b] = [longitude * DEGREE, latitude * DEGREE]
  return [Math.cos(b) * Math.cos(a), Math.cos(b) * Math.sin(a), Math.sin(b)]
}

/** Returns a longitude within 180 degrees. */
function turned(longitude) {
  return longitude - 360 * Math.floor((longitude + 180) / 360)
}
