// The scene's tables of the six garment tools.
#pragma once

#include "apps/scene.h"
#include "apps/toml_table.h"

namespace ease {

/// Three numbers of at most `most` in size, in `unit`; `fallback` where absent.
Vec3 readVec3(const TomlTable& table, std::string_view key, const Vec3& fallback, double most, const char* unit);

/// `at` and `radius`, m, both required.
Brush readBall(const TomlTable& table);

/// Reads boundary, region, resolution, edge_length, smoothing, extension, paint, comfort and seam of [garment].
void readGarmentTools(const TomlTable& table, bool has_body, GarmentScene& garment);

}  // namespace ease
