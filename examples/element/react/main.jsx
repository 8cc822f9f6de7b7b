// SPDX-License-Identifier: GPL-3.0-or-later
// React 19 sets properties and listens to events of custom elements by itself.
import 'circle-voronoi/element'
import { StrictMode, useState } from 'react'
import { createRoot } from 'react-dom/client'

const START = [
  { x: 0, y: 0, r: 2 },
  { x: 10, y: 0, r: 1 },
  { x: 5, y: 8, r: 1.5 },
]

function Page() {
  const [circles, setCircles] = useState(START)
  const [counts, setCounts] = useState()
  return (
    <>
      <h1>With React</h1>
      <circle-voronoi
        circles={circles}
        controls
        oncircleschange={({ detail }) => setCircles(detail.circles)}
        ondiagramchange={({ detail }) => setCounts(detail)}
      />
      <p>
        <output>{counts && `${counts.circles} circles, ${counts.edges} edges`}</output>{' '}
        <button type="button" onClick={() => setCircles(START)}>
          Reset
        </button>
      </p>
    </>
  )
}

createRoot(document.querySelector('#root')).render(
  <StrictMode>
    <Page />
  </StrictMode>,
)
