// Finds where the body's surface passes through itself, and which triangles bound the union of what it encloses.
//
//     ___  ___        boundary: outer arcs
//    /   \/   \       buried:   the arcs within the other ball
//   |    /\    |      crossing: triangles where the arcs meet
//    \__ \/ __/
//
// First come the pairs of triangles that cross.  Crossing triangles divide the others into connected patches.  No
// patch crosses anything, so that one ray from it tells whether the whole patch is buried.
//
// Only the triangles asked for, and those that share a leaf of the tree with them, are classified; each is classified
// with regard to the whole surface.
#pragma once

#include <span>
#include <vector>

#include "collision/triangle_tree.h"

namespace ease {

class BodySelfOverlap {
 public:
  /// Classifies the triangles t for which asked[t] is not zero.  `known`: exposures found before in the same pose, one
  /// a triangle, which are taken over; empty: none.
  void find(const TriangleTree& tree, std::span<const unsigned char> asked, std::span<const Exposure> known = {});

  /// One entry a triangle; `unknown` if it was not classified.
  std::span<const Exposure> exposures() const { return exposures_; }

  long crossing() const { return crossing_; }  // number of crossing triangles
  long buried() const { return buried_; }      // number of buried triangles

  size_t memoryBytes() const;

 private:
  /// Marks the triangles that cross another one.
  void findCrossings(const TriangleTree::Data& tree);
  /// Marks the patches between crossing triangles that lie within the body.
  void buryPatches(const TriangleTree& tree);

  std::vector<Exposure> exposures_;
  std::vector<unsigned char> leaf_in_region_;
  std::vector<unsigned char> folded_;   // by vertex: whether its triangles do not all face one way
  std::vector<unsigned char> visited_;  // by triangle
  std::vector<int> patch_;
  long crossing_ = 0, buried_ = 0;
};

}  // namespace ease
