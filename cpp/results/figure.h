// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "circle_voronoi/diagram.h"
#include "circle_voronoi/export.h"
#include "printed_algorithm.h"
#include "sample.h"

namespace circle_voronoi::results {

// The layers of the paper's figures.

SvgLayer samplesLayer(const Samples& samples);
/// The Delaunay graph of the centers.
SvgLayer centersLayer(std::span<const Circle> circles);
/// The Delaunay graph of the samples.
SvgLayer sampleGraphLayer(const Samples& samples);
/// The directed edges that the touching disc method with all pairs leaves over: the hull's.
SvgLayer leftoverLayer(std::span<const Circle> circles);
/// The antipodal discs that the method finds empty. Intersecting circles have a negative radius here and no disc to
/// draw.
SvgLayer antipodalLayer(std::span<const Circle> circles);
SvgLayer leftoverLayer(std::span<const Circle> circles, const PrintedResult& printed);
/// The finished Voronoi segments inside a box.
SvgLayer segmentsLayer(std::span<const Circle> circles, const PrintedResult& printed);

/// The style of all figures, light and dark.
std::string figureStyle();

/// Writes FOLDER/NAME.svg.
void draw(const std::filesystem::path& folder, const std::string& name, std::span<const Circle> circles,
          const Diagram& diagram, SvgFigure figure);

}  // namespace circle_voronoi::results
