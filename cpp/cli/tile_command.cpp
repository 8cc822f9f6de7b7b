// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <string>
#include <string_view>

#include "box.h"
#include "circle_voronoi/tile.h"
#include "circles_input.h"
#include "command_error.h"
#include "commands.h"
#include "files.h"
#include "progress_line.h"
#include "tiler.h"

namespace circle_voronoi::cli {
namespace {

struct TileArguments {
  CirclesInput input;
  std::string folder;
  double size = 0;
  double halo = 0;
  std::string progress = "auto";
};

void runTile(const CLI::App& command, TileArguments& arguments) {
  settleInput(command, arguments.input);
  ProgressLine progress(arguments.progress);
  TileStream stream(inputName(arguments.input.file), arguments.input.options);
  Tiler tiler(arguments.folder, arguments.size, arguments.halo);
  const auto add = [&](const Result<Tile>& tile) {
    if (!tile) fail(tile.error(), "");
    tiler.add(tile.value());
  };
  progress.show("cut");
  readPieces(arguments.input.file, [&](std::string_view piece, double done) {
    add(stream.read(piece));
    progress.show("cut", done);
  });
  add(stream.end());
  progress.show("write");
  tiler.finish();
}

}  // namespace

void addTileCommand(CLI::App& program) {
  const auto arguments = std::make_shared<TileArguments>();
  CLI::App* command =
      program.add_subcommand("tile", "Cut any number of circles into tiles, a file each, for compute --known");
  addCirclesInput(*command, arguments->input,
                  "Circles: CSV, with ids in a column id if it has one; - is standard input", Skipping::impossible);
  const auto addLength = [&](const char* name, double& length, const char* what) {
    command->add_option(name, length, what)->type_name("LENGTH")->required()->check([](const std::string& text) {
      const auto value = readNumber(text);
      return value && *value > 0 ? "" : "expected a number above 0.";
    });
  };
  addLength("--size", arguments->size, "The side of a tile's core");
  addLength("--halo", arguments->halo, "How far around the core circles are known");
  command->add_option("-o,--output", arguments->folder, "The folder for the tiles, which is empty or new")
      ->type_name("FOLDER")
      ->required();
  addProgressOption(*command, arguments->progress);
  command->footer(
      "Each tile is a file with the columns id, x, y, r, done. The file tiles.txt has a line for each: its name, the\n"
      "number of circles in its core, its core and what is known of it, as compute takes them with --max-radius 0.");
  command->callback([arguments, command] { runTile(*command, *arguments); });
}

}  // namespace circle_voronoi::cli
