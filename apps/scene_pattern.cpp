#include "apps/scene_pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "apps/scene_tools.h"
#include "apps/words.h"

namespace ease {

namespace {

constexpr Range kAllowance{0.0, 0.2, false, "m"};

/// `allowance = 0.01`, or a table with `default` and the names of seams and loops.
Allowances readAllowances(const TomlTable& table) {
  Allowances allowances;
  const auto by_name = table.isTable("allowance") ? table.table("allowance") : std::nullopt;
  if (!by_name) {
    allowances.all = table.number("allowance", allowances.all, kAllowance);
    return allowances;
  }
  for (const std::string& name : by_name->keys()) {
    const double width = by_name->number(name, 0.0, kAllowance);
    if (name == "default")
      allowances.all = width;
    else
      allowances.by_name[name] = width;
  }
  return allowances;
}

CutsScene readCuts(const TomlTable& table) {
  table.allow({"method", "distortion_weight", "length_weight", "steps", "keep", "symmetric", "remove", "straighten"});
  CutsScene cuts;
  cuts.finds = table.choice("method", "variational", {"variational", "none"}) == "variational";
  for (const std::string& key : table.keys())
    if (!cuts.finds && key != "method")
      table.refuse(key, "no such key with method = 'none': it belongs to method = 'variational'");
  CutSettings& settings = cuts.settings;
  settings.flow.weights.distortion =
      table.number("distortion_weight", settings.flow.weights.distortion, {0.0, 1e4, true, ""});
  settings.flow.weights.length = table.number("length_weight", settings.flow.weights.length, {0.0, 1e4, true, ""});
  settings.flow.steps = table.integer("steps", settings.flow.steps, 0, 100000);
  settings.keep = table.boolean("keep", settings.keep);
  if (table.has("symmetric") && !table.isBoolean("symmetric")) {
    settings.is_symmetric = true;
    settings.plane = table.number("symmetric", 0.0, {-100.0, 100.0, false, "m, or true or false"});
  } else {
    settings.is_symmetric = table.boolean("symmetric", false);
  }
  settings.remove = table.boolean("remove", settings.remove);
  settings.straighten = table.boolean("straighten", settings.straighten);
  return cuts;
}

}  // namespace

PatternScene readPattern(const TomlTable& table) {
  table.allow({"thread_limit", "shear_limit", "share", "darts", "allowance", "fabric_width", "paper", "formats",
               "grain", "piece", "check", "let_out", "cuts"});
  PatternScene pattern;
  pattern.is_given = true;
  pattern.limits.thread = table.number("thread_limit", pattern.limits.thread, {0.0, 1.0, true, ""});
  const double degrees = table.number("shear_limit", 180.0 / M_PI * pattern.limits.shear, {0.0, 60.0, true, "degrees"});
  pattern.limits.shear = degrees * M_PI / 180.0;
  pattern.limits.share = table.number("share", pattern.limits.share, {0.0, 1.0, false, ""});
  if (table.has("darts") && (table.isText("darts") || table.isArray("darts") || table.isTable("darts")))
    table.refuse("darts", "true, false, or how many at most, 0 to 100");
  if (table.isBoolean("darts"))
    pattern.max_darts = table.boolean("darts", true) ? pattern.max_darts : 0;
  else
    pattern.max_darts = table.integer("darts", pattern.max_darts, 0, 100);
  pattern.allowances = readAllowances(table);
  pattern.fabric_width = table.number("fabric_width", pattern.fabric_width, {0.1, 10.0, false, "m"});
  constexpr double kMinRoom = 0.04;  // m: no piece is narrower
  if (const double least = kMinRoom + 2.0 * pattern.allowances.widest(); pattern.fabric_width < least)
    table.refuse("fabric_width", fmt::format("at least {:.2f} m, for the narrowest piece with its allowance", least));
  pattern.free_grain = table.choice("grain", "garment", {"garment", "free"}) == "free";
  pattern.paper = table.choice("paper", pattern.paper, {"a4", "a3", "a0", "letter", "tabloid"});
  if (table.has("formats")) pattern.formats = table.texts("formats");
  const std::vector<std::string> known = {"svg", "pdf", "dxf", "json"};
  for (const std::string& format : pattern.formats)
    if (std::find(known.begin(), known.end(), format) == known.end())
      table.refuse("formats", "some of " + listWords(known) + "; '" + format + "' is none of them");
  pattern.check = table.boolean("check", pattern.check);
  if (!pattern.check && table.has("let_out"))
    table.refuse("let_out", "no such key with check = false: the garment that is checked is let out");
  pattern.let_out = table.integer("let_out", pattern.let_out, 0, kMaxLetOut);
  if (const auto cuts = table.table("cuts")) pattern.cuts = readCuts(*cuts);
  for (const TomlTable& piece : table.tables("piece")) {
    piece.allow({"name", "at"});
    if (!piece.has("name")) piece.refuse("name", "a name for the piece, e.g. 'front'");
    if (!piece.has("at")) piece.refuse("at", "a point on the piece, [x, y, z], m");
    const std::string name = piece.text("name", "");
    if (std::any_of(pattern.names.begin(), pattern.names.end(), [&](const PieceName& p) { return p.name == name; }))
      piece.refuse("name", "a name that no other piece has");
    pattern.names.push_back({name, readVec3(piece, "at", Vec3::Zero(), 100.0, "m")});
  }
  return pattern;
}

Paper paperNamed(const std::string& name) {
  const std::map<std::string, Paper> sizes = {
      {"a3", {297.0, 420.0}}, {"a0", {841.0, 1189.0}}, {"letter", {215.9, 279.4}}, {"tabloid", {279.4, 431.8}}};
  const auto size = sizes.find(name);
  return size == sizes.end() ? Paper{} : size->second;
}

}  // namespace ease
