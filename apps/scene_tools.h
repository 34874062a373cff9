// Reads the scene's tables for the tools that make a garment.
#pragma once

#include "apps/scene.h"
#include "apps/toml_table.h"

namespace ease {

/// Reads three numbers in `unit`, each between -`most` and `most`; returns `fallback` if the key is absent.
Vec3 readVec3(const TomlTable& table, std::string_view key, const Vec3& fallback, double most, const char* unit);

/// Reads a ball, its centre `at` and its `radius`, m, or a stroke, its `points` and its `radius`.
Brush readBall(const TomlTable& table);

/// Reads boundary, region, resolution, edge_length, smoothing, extension, paint, comfort and seam of [garment].  A
/// draft may have boundaries without a region, and tools without boundaries.
void readGarmentTools(const TomlTable& table, bool has_body, bool may_be_draft, GarmentScene& garment);

}  // namespace ease
