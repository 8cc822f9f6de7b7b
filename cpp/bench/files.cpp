// SPDX-License-Identifier: GPL-3.0-or-later
#include "files.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>

#include "circle_voronoi/certify.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/export.h"
#include "circle_voronoi/io.h"
#include "circle_voronoi_families/families.h"
#include "median.h"
#include "processor_seconds.h"

namespace circle_voronoi::bench {
namespace {

namespace fs = std::filesystem;

struct Task {
  std::string name;
  std::function<void()> run;
  std::vector<double> seconds = {};
};

std::string readAll(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text(fs::file_size(file), ' ');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  return text;
}

template <class Write>
void writeTo(const fs::path& file, Write write) {
  std::ofstream out(file, std::ios::binary);
  if (!write(out)) std::abort();
}

/// A line of the table for each task.
void benchCircles(const std::string& name, const std::vector<Circle>& circles, const fs::path& folder,
                  int repetitions) {
  const Diagram diagram = compute(circles).value();
  const auto path = [&](const char* file) { return folder / file; };
  writeTo(path("circles.csv"), [&](std::ostream& out) { return writeCirclesCsv(out, circles); });
  std::vector<Task> tasks = {
      {"compute", [&] { (void)compute(circles); }},
      {"csv read", [&] { (void)readCircles(readAll(path("circles.csv")), "csv"); }},
      {"json written", [&] { writeTo(path("json"), [&](std::ostream& out) { return writeJson(out, diagram); }); }},
      {"certify",
       [&] {
         const auto read = readDiagram(readAll(path("json")), "json");
         if (!certify(read.value()).value().certified()) std::abort();
       }},
      {"geojson written",
       [&] { writeTo(path("geojson"), [&](std::ostream& out) { return writeGeoJson(out, diagram); }); }},
      {"svg written", [&] { writeTo(path("svg"), [&](std::ostream& out) { return writeSvg(out, diagram); }); }}};
  for (int i = 0; i < repetitions; ++i) {
    for (Task& task : tasks) task.seconds.push_back(processorSeconds(task.run));
  }
  const std::vector<const char*> files = {nullptr, "circles.csv", "json", "json", "geojson", "svg"};
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    std::vector<double> ratios;
    for (int k = 0; k < repetitions; ++k) ratios.push_back(tasks[i].seconds[k] / tasks[0].seconds[k]);
    const double megabytes = files[i] == nullptr ? 0 : static_cast<double>(fs::file_size(path(files[i]))) / 1e6;
    std::printf("%-14s %8zu  %-14s %10.3f %10.2f %9.0f\n", name.c_str(), circles.size(), tasks[i].name.c_str(),
                median(tasks[i].seconds), median(ratios), megabytes);
  }
  std::fflush(stdout);
}

}  // namespace

void benchFiles(const std::vector<std::string>& families, const std::vector<std::size_t>& sizes, int repetitions) {
  const fs::path folder = fs::temp_directory_path() / "circle-voronoi-bench-files";
  fs::create_directories(folder);
  std::printf("%-14s %8s  %-14s %10s %10s %9s\n", "family", "n", "task", "median s", "/ compute", "MB");
  for (const std::string& name : families) {
    const Family family = familyFromName(name).value();
    for (const std::size_t size : sizes) benchCircles(name, generate(family, size, 1), folder, repetitions);
  }
  fs::remove_all(folder);
}

}  // namespace circle_voronoi::bench
