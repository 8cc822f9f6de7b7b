// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "json_reading.h"
#include "text.h"

namespace circle_voronoi {
namespace {

/// Takes the parser's events; false stops it.
class CircleHandler : public Json::json_sax_t {
 public:
  CircleHandler(std::string_view name, JsonPosition& position) : name_(name), position_(position) {}

  Result<NumberedCircles> take() && {
    if (error_) return *std::move(error_);
    return std::move(result_);
  }

  bool null() override { return other("null"); }
  bool boolean(bool) override { return other("a boolean"); }
  bool string(std::string&) override { return other("a string"); }
  bool binary(Json::binary_t&) override { return other("binary data"); }
  bool number_integer(Json::number_integer_t value) override { return number(negative(value)); }
  bool number_unsigned(Json::number_unsigned_t value) override { return number(static_cast<double>(value)); }
  bool number_float(Json::number_float_t value, const std::string&) override { return number(value); }

  bool start_array(std::size_t) override {
    if (skipped_ > 0 || isSkippedKey()) return startSkipped();
    if (place_ == Place::outside) return enter(Place::list);
    if (place_ == Place::list) return enter(Place::array);
    return fail(expected() + ", not an array.");
  }

  bool end_array() override {
    if (skipped_ > 0) return endSkipped();
    if (place_ == Place::list) return enter(Place::outside);
    return finishCircle();
  }

  bool start_object(std::size_t) override {
    if (skipped_ > 0 || isSkippedKey()) return startSkipped();
    if (place_ == Place::list) return enter(Place::object);
    return fail(expected() + ", not an object.");
  }

  bool key(std::string& key) override {
    if (skipped_ > 0) return true;
    const auto* found = std::find(kKeys.begin(), kKeys.end(), key);
    field_ = static_cast<std::size_t>(found - kKeys.begin());
    return true;
  }

  bool end_object() override { return skipped_ > 0 ? endSkipped() : finishCircle(); }

  bool parse_error(std::size_t, const std::string&, const Json::exception& exception) override {
    return fail(reasonOf(exception));
  }

 private:
  enum class Place { outside, list, array, object };

  static constexpr std::array<std::string_view, 3> kKeys = {"x", "y", "r"};

  std::string expected() const {
    switch (place_) {
      case Place::outside:
        return "expected an array of circles";
      case Place::list:
        return "expected a circle, [x,y,r] or {\"x\":..,\"y\":..,\"r\":..}";
      default:
        return "expected a number for " + std::string(field_ < kKeys.size() ? kKeys[field_] : "a circle");
    }
  }

  bool fail(const std::string& reason) {
    error_ = errorAt(name_, position_.line(), reason);
    return false;
  }

  bool isSkippedKey() const { return place_ == Place::object && field_ == kKeys.size(); }
  bool startSkipped() {
    ++skipped_;
    return true;
  }
  bool endSkipped() {
    --skipped_;
    return true;
  }

  bool enter(Place place) {
    place_ = place;
    field_ = 0;
    values_ = {};
    return true;
  }

  bool number(double value) {
    if (skipped_ > 0 || isSkippedKey()) return true;
    if (place_ != Place::array && place_ != Place::object) return fail(expected() + ", not a number.");
    if (field_ == kKeys.size()) return fail("a circle has three numbers, not more.");
    if (values_[field_]) return fail(std::string(kKeys[field_]) + " is given twice.");
    values_[field_] = value;
    if (place_ == Place::array) ++field_;
    return true;
  }

  bool other(const std::string& what) {
    return skipped_ > 0 || isSkippedKey() || fail(expected() + ", not " + what + ".");
  }

  bool finishCircle() {
    for (std::size_t i = 0; i < kKeys.size(); ++i) {
      if (!values_[i]) return fail("a circle has no " + std::string(kKeys[i]) + ".");
    }
    result_.circles.push_back({*values_[0], *values_[1], *values_[2]});
    result_.lines.push_back(position_.line());
    return enter(Place::list);
  }

  std::string_view name_;
  JsonPosition& position_;
  NumberedCircles result_;
  std::optional<Error> error_;

  Place place_ = Place::outside;
  std::size_t field_ = 0;  ///< which of kKeys comes next; their number: none of them
  std::array<std::optional<double>, 3> values_;
  int skipped_ = 0;  ///< the depth inside the value of another key
};

}  // namespace

Result<NumberedCircles> readJson(std::string_view text, std::string_view name) {
  JsonPosition position(text);
  CircleHandler handler(name, position);
  parseJson(text, position, handler);
  return std::move(handler).take();
}

}  // namespace circle_voronoi
