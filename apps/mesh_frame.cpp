#include "apps/mesh_frame.h"

#include <fmt/format.h>

#include <array>

namespace ease {

namespace {

const std::vector<std::string> kAxes = {"x", "y", "z", "-x", "-y", "-z"};
constexpr std::array<std::pair<const char*, double>, 6> kUnits = {
    {{"m", 1.0}, {"dm", 0.1}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}, {"ft", 0.3048}}};
constexpr double kLowest = 1.2, kTallest = 2.6;  // m: of a standing person, for guesses

Vec3 axisNamed(const std::string& name) {
  Vec3 axis = Vec3::Zero();
  axis[name.back() - 'x'] = name.front() == '-' ? -1.0 : 1.0;
  return axis;
}

}  // namespace

MeshFrame readFrame(const TomlTable& table, const MeshFrame& fallback) {
  MeshFrame frame = fallback;
  std::vector<std::string> units;
  for (const auto& [name, metres] : kUnits) units.emplace_back(name);
  const std::string unit = table.choice("unit", "", units);
  for (const auto& [name, metres] : kUnits)
    if (unit == name) frame.metres_per_unit = metres;
  if (!table.has("up") && !table.has("facing")) return frame;
  const Vec3 up = axisNamed(table.choice("up", "y", kAxes));
  const bool z_up = std::abs(up.z()) > 0.5;
  const Vec3 facing = axisNamed(table.choice("facing", z_up ? "-y" : "z", kAxes));
  if (std::abs(up.dot(facing)) > 0.5)
    table.refuse(table.has("facing") ? "facing" : "up", "an axis across the other of up and facing");
  frame.turn.row(0) = up.cross(facing);
  frame.turn.row(1) = up;
  frame.turn.row(2) = facing;
  return frame;
}

void toMetres(const MeshFrame& frame, Positions& positions) {
  if (frame.changesNothing()) return;
  positions = (frame.metres_per_unit * positions * frame.turn.transpose()).eval();
}

std::string frameAdvice(const Vec3& size) {
  std::string advice;
  double height = size.y(), longest = size.maxCoeff();
  for (const auto& [name, metres] : kUnits) {
    const double factor = metres;
    if (factor == 1.0 || longest * factor < kLowest || longest * factor > kTallest) continue;
    advice = fmt::format("unit = \"{}\" would make it {:.3g} m", name, longest * factor);
    break;
  }
  if (size.z() > 1.5 * height) advice += advice.empty() ? "up = \"z\"?" : ", with up = \"z\"?";
  return advice;
}

}  // namespace ease
