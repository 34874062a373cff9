// Where a closed surface passes through itself: which of its triangles still bound the union of what it encloses.
//
// Triangles that cross others are found pair by pair; they cut the rest into patches, and as no patch is crossed, one
// ray a patch tells whether all of it is buried.  Only the triangles asked for and those that share a leaf of the tree
// with them are looked at, but what is said of them holds for the whole surface.
#pragma once

#include <span>
#include <vector>

#include "collision/triangle_tree.h"

namespace ease {

class SelfOverlap {
 public:
  /// Looks at the triangles for which asked[t] is not zero.
  void find(const TriangleTree& tree, std::span<const unsigned char> asked);

  /// One a triangle; `unknown` where not looked at.
  std::span<const Exposure> exposures() const { return exposures_; }

  long crossing() const { return crossing_; }  // triangles
  long buried() const { return buried_; }      // triangles

  size_t memoryBytes() const;

 private:
  void findCrossings(const TriangleTree::Data& tree);
  void buryPatches(const TriangleTree& tree);

  std::vector<Exposure> exposures_;
  std::vector<unsigned char> leaf_in_region_;
  std::vector<unsigned char> folded_;   // vertices whose triangles do not all face one way
  std::vector<unsigned char> visited_;  // triangles
  std::vector<int> patch_;
  long crossing_ = 0, buried_ = 0;
};

}  // namespace ease
