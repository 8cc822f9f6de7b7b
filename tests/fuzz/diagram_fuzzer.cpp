// SPDX-License-Identifier: GPL-3.0-or-later
// A libFuzzer target over compute and certify. Any bytes are an input (fuzz_input.h); whatever they are,
// - compute neither crashes nor hangs, by any method;
// - by Method::automatic there is a certified diagram, or an error that describes the fault of the circles;
// - certify agrees with the certificate that a diagram comes with, and survives any diagram.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "circle_voronoi/certify.h"
#include "circle_voronoi/compute.h"
#include "fuzz_input.h"

namespace circle_voronoi::fuzz {
namespace {

void require(bool holds, const std::string& what) {
  if (holds) return;
  std::fprintf(stderr, "%s\n", what.c_str());
  std::abort();
}

bool blamesCircles(ErrorCode code) {
  return code == ErrorCode::nonFinite || code == ErrorCode::negativeRadius || code == ErrorCode::coordinateTooLarge ||
         code == ErrorCode::coordinateTooSmall;
}

/// The methods, with few samples so that a run is short.
std::vector<Options> manualOptions() {
  std::vector<Options> list;
  Options options;
  options.method = Method::flip;
  list.push_back(options);
  options.method = Method::touchingDisc;
  for (const int samples : {0, 3}) {
    options.samples = samples;
    list.push_back(options);
  }
  options.resample = true;
  list.push_back(options);
  options.resample = false;
  options.candidates = Candidates::uniform;
  options.samples = 5;
  list.push_back(options);
  options.candidates = Candidates::allPairs;
  options.samples = std::nullopt;
  list.push_back(options);
  return list;
}

void run(const Input& input) {
  const auto automatic = compute(input.circles);
  if (!automatic) {
    require(blamesCircles(automatic.error().code), "automatic: " + automatic.error().message);
  } else {
    require(automatic.value().certificate.certified(), "automatic: " + automatic.value().certificate.message);
    const auto certificate = certify(automatic.value());
    require(certificate.ok() && certificate.value().certified(), "the diagram of automatic is not certified again");
    Diagram wrong = corrupted(automatic.value(), input.edits);
    (void)certify(wrong);
    linkSides(wrong);
    (void)certify(wrong);
  }

  for (const Options& options : manualOptions()) {
    const auto diagram = compute(input.circles, options);
    require(automatic.ok() == diagram.ok(), "methods do not agree that the circles are good");
    if (!diagram) continue;
    const auto certificate = certify(diagram.value());
    require(certificate.ok() && certificate.value().certified() == diagram.value().certificate.certified(),
            "certify does not agree with the certificate of " + std::string(methodName(options.method)));
  }
}

}  // namespace
}  // namespace circle_voronoi::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  circle_voronoi::fuzz::run(circle_voronoi::fuzz::decode({data, size}));
  return 0;
}
