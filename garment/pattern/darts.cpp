#include "garment/pattern/darts.h"

namespace ease {

std::vector<CutLine> withDarts(const RestGarment&, const std::vector<CutLine>& lines, const FlatSettings&) {
  return lines;
}

}  // namespace ease
