// Where the garment begins on the body: outside of it, near it, and no part of it the body itself.
#pragma once

#include "apps/scene.h"

namespace ease {

/// Throws InputError where a part of the garment is the body, where vertices lie deep inside the body, or where the
/// garment is far from it. Vertices a few millimetres inside are moved out in `input.start`, with a warning.
void checkStart(const std::string& garment_name, const Warn& warn, SceneInput& input);

}  // namespace ease
