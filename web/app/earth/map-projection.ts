// SPDX-License-Identifier: GPL-3.0-or-later
// The projection `equal-area` of the program (cpp/cli/projection.cpp): Lambert's azimuthal projection of the WGS 84 ellipsoid.
import { at } from '../../lib/base/diagram-data.ts'
import type { Float64s, Point } from '../../lib/index.ts'

const EQUATOR = 6_378_137
const FLATTENING = 1 / 298.257223563
/** The square of the eccentricity. */
const SQUARE = FLATTENING * (2 - FLATTENING)
const ECCENTRICITY = Math.sqrt(SQUARE)
const DEGREE = Math.PI / 180
/** The largest distance of a place from the center of the map, in degrees. */
const FARTHEST = 60
/** The largest latitude of a center: at a pole itself, the formulas divide by zero. */
const NORTHERNMOST = 90 - 1e-6

/** The center of a map in degrees. */
export interface MapCenter {
  readonly longitude: number
  readonly latitude: number
}

/** Circles on a map: meters to the east and to the north of its center. */
export interface MappedCircles {
  readonly circles: Float64s
  readonly center: MapCenter
}

/**
 * Projects circles to an equal-area map around their middle. Centers are longitude and latitude, radii are meters.
 *
 * @throws Error if places are too far apart for one map
 */
export function mapped(circles: Float64s): MappedCircles {
  const center = middleOf(circles)
  const project = projectionAround(center)
  const points = new Float64Array(circles)
  for (let k = 0; k < circles.length; k += 3) {
    const place = { longitude: at(circles, k), latitude: at(circles, k + 1) }
    if (angleBetween(place, center) > FARTHEST * DEGREE) {
      throw new Error(
        `Circle ${k / 3} is more than ${FARTHEST}° from the middle of all circles, too far for one map. Show them on a globe.`,
      )
    }
    const { x, y } = project(place)
    points[k] = toMicrometers(x)
    points[k + 1] = toMicrometers(y)
  }
  return { circles: points, center }
}

/** The member `projection` of a file's collection, as the program writes it: it can convert the file to degrees again. */
export function recordOf({ longitude, latitude }: MapCenter): string {
  return `"projection":{"type":"equal-area","longitude":${longitude},"latitude":${latitude},"unit":"meter"}`
}

function projectionAround(center: MapCenter): (place: MapCenter) => Point {
  const middle = authalic(center.latitude)
  const { sine, cosine } = angleOf(center.latitude)
  const radius = EQUATOR * Math.sqrt(areaOf(1) / 2)
  const stretch = (EQUATOR * cosine) / (Math.sqrt(1 - SQUARE * sine * sine) * radius * middle.cosine)
  return ({ longitude, latitude }) => {
    const place = authalic(latitude)
    const turn = angleOf(wrapped(longitude - center.longitude))
    const across = place.cosine * turn.sine
    const along = middle.cosine * place.sine - middle.sine * place.cosine * turn.cosine
    const nearness = middle.sine * place.sine + middle.cosine * place.cosine * turn.cosine
    const factor = radius * Math.sqrt(2 / (1 + nearness))
    return { x: factor * stretch * across, y: (factor / stretch) * along }
  }
}

/** The middle of places on a sphere, to a millionth of a degree. */
function middleOf(circles: Float64s): MapCenter {
  let [x, y, z] = [0, 0, 0]
  for (let k = 0; k < circles.length; k += 3) {
    const east = angleOf(wrapped(at(circles, k)))
    const north = angleOf(at(circles, k + 1))
    x += north.cosine * east.cosine
    y += north.cosine * east.sine
    z += north.sine
  }
  const [longitude, latitude] = [Math.atan2(y, x), Math.atan2(z, Math.hypot(x, y))].map(
    (angle) => Math.floor((angle / DEGREE) * 1e6 + 0.5) / 1e6,
  ) as [number, number]
  return { longitude, latitude: Math.min(Math.max(latitude, -NORTHERNMOST), NORTHERNMOST) }
}

function angleBetween(one: MapCenter, other: MapCenter): number {
  const [north, otherNorth] = [angleOf(one.latitude), angleOf(other.latitude)]
  const turn = angleOf(wrapped(one.longitude - other.longitude))
  const cosine = north.sine * otherNorth.sine + north.cosine * otherNorth.cosine * turn.cosine
  return Math.acos(Math.min(Math.max(cosine, -1), 1))
}

interface SineCosine {
  readonly sine: number
  readonly cosine: number
}

function angleOf(degrees: number): SineCosine {
  return { sine: Math.sin(degrees * DEGREE), cosine: Math.cos(degrees * DEGREE) }
}

/** The authalic latitude: the latitude on a sphere with the same areas (Snyder 1987, 3-11). */
function authalic(latitude: number): SineCosine {
  const sine = Math.min(Math.max(areaOf(Math.sin(latitude * DEGREE)) / areaOf(1), -1), 1)
  return { sine, cosine: Math.sqrt(Math.max((1 - sine) * (1 + sine), 0)) }
}

/** Snyder's q (3-12), which is proportional to the area south of a latitude. */
function areaOf(sine: number): number {
  return (1 - SQUARE) * (sine / (1 - SQUARE * sine * sine) + Math.atanh(ECCENTRICITY * sine) / ECCENTRICITY)
}

function wrapped(degrees: number): number {
  return degrees - 360 * Math.floor((degrees + 180) / 360)
}

/** Rounds meters, because the last digits of sines differ between browsers. */
function toMicrometers(meters: number): number {
  return Math.round(meters * 1e6) / 1e6
}
