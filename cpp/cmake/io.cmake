# SPDX-License-Identifier: GPL-3.0-or-later
# Reading and writing files: a library of its own, so that the core stays free of it.
find_package(nlohmann_json REQUIRED)

add_library(circle_voronoi_io STATIC
  src/export_frame.cpp
  src/io_csv.cpp
  src/io_geojson.cpp
  src/io_holds_diagram.cpp
  src/io_json.cpp
  src/io_read.cpp
  src/io_read_diagram.cpp
  src/io_read_stats.cpp
  src/io_write_circles.cpp
  src/io_write_csv.cpp
  src/io_write_geojson.cpp
  src/io_write_json.cpp
  src/io_write_obj.cpp
  src/io_write_svg.cpp
  src/io_write_wkt.cpp)
add_library(circle_voronoi::io ALIAS circle_voronoi_io)
set_target_properties(circle_voronoi_io PROPERTIES EXPORT_NAME io)
target_link_libraries(circle_voronoi_io
  PUBLIC circle_voronoi
  PRIVATE $<BUILD_INTERFACE:circle_voronoi_options> $<BUILD_INTERFACE:nlohmann_json::nlohmann_json>)
