// The scene's table [pattern]: what its sewing pattern is to be like.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/toml_table.h"
#include "garment/pattern/draw_piece.h"
#include "garment/pattern/flat_pattern.h"
#include "garment/pattern/paper_tiles.h"
#include "garment/pattern/variational_cut.h"

namespace ease {

/// The table [pattern.cuts]: seams that the program finds.
struct CutsScene {
  bool finds = true;  // method: "variational", else "none"
  CutSettings settings;
};

constexpr int kMaxLetOut = 20;

struct PatternScene {
  bool is_given = false;  // whether the scene has the table
  StrainLimits limits;
  int max_darts = FlatSettings().max_darts;
  std::vector<PieceName> names;
  Allowances allowances;
  double fabric_width = 1.40;  // m
  bool free_grain = false;     // grain: "free", else "garment"
  std::string paper = "a4";    // or "a3", "a0", "letter", "tabloid"
  std::vector<std::string> formats = {"svg", "pdf", "dxf", "json"};
  bool check = true;              // simulate the garment sewn from the pattern
  std::optional<CutsScene> cuts;  // none: seams are found where the garment has none
  int let_out = 8;                // rounds of letting out on the paper, at most
};

/// Reads [pattern].  Throws InputError as the other tables of a scene do.
PatternScene readPattern(const TomlTable& table);

/// The size of a page of paper of this name.
Paper paperNamed(const std::string& name);

}  // namespace ease
