// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace circle_voronoi {

/// An observer that is notified of faces while other code changes a dual.
class FaceWatcher {
 public:
  virtual ~FaceWatcher() = default;

  /// Called before the half-edges or the disc of a face change.
  virtual void willChange(int face) = 0;
};

/// A class that maintains a dual, and the places of its faces, while other code changes it.
class DualKeeper : public FaceWatcher {
 public:
  /// Returns a new face. The caller must set its half-edges and its disc.
  virtual int addFace() = 0;
  virtual void removeFace(int face) = 0;

  /// Called before a circle is marked as hidden.
  virtual void willHide(int circle) = 0;

  /// Called when half-edge `to` replaces half-edge `from`. A half-edge can replace two others in turn.
  virtual void replaceEdge(int from, int to) = 0;

  /// Called when a half-edge is removed together with the circle that it starts from.
  virtual void dropEdge(int h) = 0;
};

}  // namespace circle_voronoi
