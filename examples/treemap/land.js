// SPDX-License-Identifier: GPL-3.0-or-later
// The land of the earth in thousands of square kilometers: the largest countries of each continent, and the rest.
const CONTINENTS = {
  Africa: {
    Algeria: 2382,
    Congo: 2345,
    Sudan: 1861,
    Libya: 1760,
    Chad: 1284,
    Niger: 1267,
    Angola: 1247,
    Mali: 1240,
    'South Africa': 1221,
    Ethiopia: 1104,
    Others: 14_659,
  },
  Asia: {
    'Russia in Asia': 13_083,
    China: 9597,
    India: 3287,
    Kazakhstan: 2725,
    'Saudi Arabia': 2150,
    Indonesia: 1905,
    Iran: 1648,
    Mongolia: 1564,
    Others: 8620,
  },
  'North America': { Canada: 9985, 'United States': 9834, Greenland: 2166, Mexico: 1964, Others: 760 },
  'South America': { Brazil: 8516, Argentina: 2780, Peru: 1285, Colombia: 1142, Bolivia: 1099, Others: 3018 },
  Antarctica: { Antarctica: 14_200 },
  Europe: {
    'Russia in Europe': 3995,
    Ukraine: 604,
    France: 544,
    Spain: 506,
    Sweden: 450,
    Norway: 385,
    Germany: 358,
    Others: 3338,
  },
  Oceania: { Australia: 7692, 'Papua New Guinea': 463, 'New Zealand': 268, Others: 87 },
}

export const LAND = {
  name: 'Land',
  children: Object.entries(CONTINENTS).map(([name, countries]) => ({
    name,
    children: Object.entries(countries).map(([country, value]) => ({ name: country, value })),
  })),
}

/** Returns a disc as a ring of points. */
export function disc({ x, y, r }, corners = 180) {
  const angles = Array.from({ length: corners }, (_, k) => (2 * Math.PI * k) / corners)
  return angles.map((angle) => [x + r * Math.cos(angle), y + r * Math.sin(angle)])
}
