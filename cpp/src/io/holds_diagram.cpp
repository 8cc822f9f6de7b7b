// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/io.h"
#include "json_reading.h"

namespace circle_voronoi {
namespace {

/// Looks at the keys of the outermost object until one tells a diagram from GeoJSON.
class KindHandler : public Json::json_sax_t {
 public:
  bool isDiagram() const { return isDiagram_; }

  bool null() override { return isInside(); }
  bool boolean(bool) override { return isInside(); }
  bool number_integer(Json::number_integer_t) override { return isInside(); }
  bool number_unsigned(Json::number_unsigned_t) override { return isInside(); }
  bool number_float(Json::number_float_t, const std::string&) override { return isInside(); }
  bool string(std::string&) override { return isInside(); }
  bool binary(Json::binary_t&) override { return isInside(); }
  bool start_array(std::size_t) override { return ++depth_ > 1; }
  bool end_array() override { return --depth_ > 0; }
  bool start_object(std::size_t) override { return ++depth_ > 0; }
  bool end_object() override { return --depth_ > 0; }
  bool parse_error(std::size_t, const std::string&, const Json::exception&) override { return false; }

  bool key(std::string& key) override {
    if (depth_ > 1) return true;
    isDiagram_ = key == "format";
    return !isDiagram_ && key != "type" && key != "features";
  }

 private:
  bool isInside() const { return depth_ > 0; }

  int depth_ = 0;
  bool isDiagram_ = false;
};

}  // namespace

bool holdsDiagram(std::string_view text) {
  JsonPosition position(text);
  KindHandler handler;
  parseJson(text, position, handler);
  return handler.isDiagram();
}

}  // namespace circle_voronoi
