// SPDX-License-Identifier: GPL-3.0-or-later
// Cells as a GeoJSON file

/**
 * Returns the text of a file: the cells with the columns of the table as properties. The columns stay text, so that no
 * number loses digits.
 */
export function geoJsonOf({ diagram, table }) {
  const features = diagram.toGeoJSON().features.map(({ properties, geometry }, circle) => {
    const measured = JSON.stringify(properties)
    const known = table.properties[circle]?.replace(/^\s*\{\s*|\s*\}\s*$/g, '') ?? ''
    const all = known === '' ? measured : `{${known},${measured.slice(1)}`
    return `{"type":"Feature","properties":${all},"geometry":${JSON.stringify(geometry)}}`
  })
  return `{"type":"FeatureCollection","features":[\n${features.join(',\n')}\n]}\n`
}

/** Saves a file with the cells. */
export function saveCells(shown) {
  const link = document.createElement('a')
  link.href = URL.createObjectURL(new Blob([geoJsonOf(shown)], { type: 'application/geo+json' }))
  link.download = `${shown.table.name.replace(/\.\w+$/, '')}-cells.geojson`
  link.click()
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000)
}
