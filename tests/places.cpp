#include "tests/places.h"

namespace ease {

const char* const kSharedData = EASE_SHARED_DATA;
const char* const kSourceDirectory = EASE_SOURCE_DIR;

}  // namespace ease
