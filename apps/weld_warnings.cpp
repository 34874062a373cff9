#include "apps/weld_warnings.h"

#include <fmt/format.h>

#include "apps/words.h"
#include "solver/io/mesh_io.h"

namespace ease {

void warnOfWeld(const Weld& weld, const std::string& file, const std::string& table, const Warn& warn) {
  if (weld.left_open > 0)
    warn(fmt::format(
        "{}: {} lie at the place of another one and could not be welded: their triangles face opposite ways, "
        "or more than two meet there; what they should join falls apart",
        file, counted(weld.left_open, "open edge")));
  if (sharesNoVertices(file)) return;  // welding such a file changes nothing that its author wrote
  if (weld.welded > 0)
    warn(
        fmt::format("{}: {} lay at the place of another one along open edges and were welded to it ([{}] weld = false "
                    "keeps them apart)",
                    file, counted(weld.welded, "vertex"), table));
  if (weld.unused > 0) warn(fmt::format("{}: left out {} that no triangle uses", file, counted(weld.unused, "vertex")));
}

}  // namespace ease
