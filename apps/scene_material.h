// The table [material] of a scene.
#pragma once

#include "apps/toml_table.h"
#include "solver/model/material.h"

namespace ease {

/// Reads the cloth's material.  Throws InputError as TomlTable does.
Material readMaterial(const TomlTable& table);

}  // namespace ease
