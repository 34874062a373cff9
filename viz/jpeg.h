// Pictures as text that a web page can hold.
#pragma once

#include <string>

#include "viz/live_view.h"

namespace ease {

/// The picture as a JPEG in a data URI: "data:image/jpeg;base64,...".  `quality`: 0 to 100.
std::string jpegDataUri(const Picture& picture, int quality = 80);

/// Bytes of a file in a data URI of this type, such as "image/png".
std::string dataUri(const std::string& bytes, const std::string& type);

}  // namespace ease
