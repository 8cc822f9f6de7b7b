// SPDX-License-Identifier: GPL-3.0-or-later
// The progress line at times that the test gives. cli_progress_test.cpp has the line of the program itself.
#include "cli/progress_text.h"

#include <gtest/gtest.h>

#include <string>

namespace circle_voronoi::cli {
namespace {

using std::chrono::milliseconds;

/// The text that erases a line of a number of characters.
std::string erased(std::size_t size) { return "\r" + std::string(size, ' ') + "\r"; }

TEST(ProgressText, SaysEachStageAtOnceItsPartAndTheSeconds) {
  ProgressText text(milliseconds(0));
  EXPECT_EQ(text.refresh(milliseconds(400)), "") << "there is no stage";
  EXPECT_EQ(text.show("read", 0, milliseconds(500)), "read, 0 s");
  EXPECT_EQ(text.show("read", 0, milliseconds(1500)), "") << "nothing is new, and time is told by refresh";
  EXPECT_EQ(text.refresh(milliseconds(999)), "");
  EXPECT_EQ(text.refresh(milliseconds(1000)), erased(9) + "read, 1 s");
  EXPECT_EQ(text.show("touch", 0.072, milliseconds(1000)), erased(9) + "touch 7 %, 1 s");
  EXPECT_EQ(text.show("touch", 0.073, milliseconds(1900)), "") << "the same percent";
  EXPECT_EQ(text.show("touch", 0.076, milliseconds(1900)), erased(14) + "touch 8 %, 1 s");
  EXPECT_EQ(text.show("write", 0, milliseconds(12000)), erased(14) + "write, 12 s");
  EXPECT_EQ(text.end(), erased(11));
}

TEST(ProgressText, SaysNothingBeforeItsDelay) {
  ProgressText text(ProgressText::kDelay);
  EXPECT_EQ(text.show("read", 0, milliseconds(0)), "");
  EXPECT_EQ(text.refresh(milliseconds(900)), "");
  EXPECT_EQ(text.show("triangulate", 0.5, milliseconds(999)), "");
  EXPECT_EQ(text.refresh(milliseconds(1000)), "triangulate 50 %, 1 s");
  EXPECT_EQ(text.end(), erased(21));
  ProgressText quick(ProgressText::kDelay);
  EXPECT_EQ(quick.show("read", 0, milliseconds(0)) + quick.show("write", 0, milliseconds(999)) + quick.end(), "");
}

TEST(ProgressText, IsShownOrNotAsTheUserSays) {
  for (const bool isTerminal : {false, true}) {
    EXPECT_EQ(ProgressText::delayOf("never", isTerminal), std::nullopt);
    EXPECT_EQ(ProgressText::delayOf("always", isTerminal), milliseconds(0));
  }
  EXPECT_EQ(ProgressText::delayOf("auto", true), milliseconds(1000));
  EXPECT_EQ(ProgressText::delayOf("auto", false), std::nullopt);
}

}  // namespace
}  // namespace circle_voronoi::cli
