// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "circle_voronoi/editor.h"

namespace circle_voronoi::cli {

/// An edit and its line in the script, from 1.
struct ScriptEdit {
  Edit edit;
  int line = 0;
};

/// Returns the edits of a script, one a line: `insert,x,y,r`, `remove,id` or `replace,id,x,y,r`; `insert,id,x,y,r` for
/// a removed circle. The script is UTF-8, which may begin with a byte-order mark. It may have blanks anywhere, blank
/// lines and lines that begin with #. Errors call it `name`. Throws CommandError. The editor checks the circles.
std::vector<ScriptEdit> readScript(std::string_view text, const std::string& name);

}  // namespace circle_voronoi::cli
