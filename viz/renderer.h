// What draws pictures: software draws the same one on every machine, a graphics card is faster.
#pragma once

namespace ease {

enum class Renderer { software_first, hardware_first };

}  // namespace ease
