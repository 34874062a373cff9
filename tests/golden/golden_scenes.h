// Three small scenes whose results are kept as text, so that a change of these shows.
//
//   hung      a sheet held at two corners falls
//   pressed   a sphere rises into a taut sheet held at its edges
//   let_out   a tube of cloth on a cylinder that grows too thick for it adapts
//
// Each runs through the main job's own loop.  All are smooth: none buckles or slides so that rounding would decide.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/mesh/triangle_mesh.h"

namespace ease {

struct GoldenResult {
  Positions positions;       // last, n x 3, m
  Positions rest_positions;  // adapted, n x 3, m
};

struct GoldenCase {
  std::string scene, method;
  std::string name() const { return scene + "_" + method; }
};

/// Every scene by every method that is meant for it.
std::vector<GoldenCase> goldenCases();

/// Runs one.  `disturbance`: by how much the vertices of the start shape and of the body's poses are moved at random,
/// at most, m.
GoldenResult runGolden(const GoldenCase& which, double disturbance = 0.0);

/// Compiler, its instruction set and optimisation: within one, results are the same to 1e-8 m; between two, to 1e-6 m.
std::string buildName();

/// A kept result and the build it comes from.
struct KeptResult {
  std::string build;
  GoldenResult result;
};
void writeKept(const std::filesystem::path& file, const GoldenResult& result);
/// Throws InputError naming the file.
KeptResult readKept(const std::filesystem::path& file);

/// Largest difference of a coordinate, m; infinite where the numbers of vertices differ.
double difference(const GoldenResult& a, const GoldenResult& b);

}  // namespace ease
