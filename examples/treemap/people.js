// SPDX-License-Identifier: GPL-3.0-or-later
// The people of the earth in millions, in 1950 and in 2020: the countries with most people of each continent, and the
// rest. Rounded from United Nations, World Population Prospects 2022.
const PEOPLE = {
  Asia: {
    China: [544, 1425],
    India: [357, 1396],
    Indonesia: [69, 272],
    Pakistan: [38, 227],
    Bangladesh: [39, 167],
    Japan: [84, 125],
    Philippines: [19, 112],
    Vietnam: [25, 97],
    Iran: [17, 88],
    Turkey: [21, 84],
    Others: [166, 671],
  },
  Africa: {
    Nigeria: [37, 208],
    Ethiopia: [18, 117],
    Egypt: [21, 107],
    Congo: [12, 93],
    'South Africa': [14, 59],
    Others: [126, 777],
  },
  Europe: {
    Russia: [103, 146],
    Germany: [71, 83],
    'United Kingdom': [50, 67],
    France: [42, 64],
    Italy: [47, 60],
    Others: [237, 326],
  },
  'Latin America': { Brazil: [54, 213], Mexico: [28, 126], Colombia: [12, 51], Argentina: [17, 45], Others: [57, 217] },
  'Northern America': { 'United States': [148, 336], Canada: [14, 38] },
  Oceania: { Australia: [8, 26], Others: [5, 18] },
}

export const YEARS = [1950, 2020]

/** Returns the tree of people in a year between the two. Numbers grow by equal factors each year. */
export function peopleIn(year) {
  const part = (year - YEARS[0]) / (YEARS[1] - YEARS[0])
  return {
    name: 'People',
    children: Object.entries(PEOPLE).map(([name, countries]) => ({
      name,
      children: Object.entries(countries).map(([country, [before, after]]) => ({
        name: country,
        value: before * (after / before) ** part,
      })),
    })),
  }
}

/** Returns a disc as a ring of points. */
export function disc({ x, y, r }, corners = 180) {
  const angles = Array.from({ length: corners }, (_, k) => (2 * Math.PI * k) / corners)
  return angles.map((angle) => [x + r * Math.cos(angle), y + r * Math.sin(angle)])
}
