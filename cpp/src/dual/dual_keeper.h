// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace circle_voronoi {

/// Who is told of faces while others change a dual.
class FaceWatcher {
 public:
  virtual ~FaceWatcher() = default;

  /// Before the half-edges or the disc of a face change.
  virtual void willChange(int face) = 0;
};

/// Who keeps a dual, and has places for its faces, while others change it.
class DualKeeper : public FaceWatcher {
 public:
  /// A face whose half-edges and disc are to be set.
  virtual int addFace() = 0;
  virtual void removeFace(int face) = 0;

  /// Before a circle is marked as hidden.
  virtual void willHide(int circle) = 0;

  /// A half-edge takes the place of another, or of two in turn.
  virtual void replaceEdge(int from, int to) = 0;

  /// A half-edge goes, and with it the circle that it starts from.
  virtual void dropEdge(int h) = 0;
};

}  // namespace circle_voronoi
