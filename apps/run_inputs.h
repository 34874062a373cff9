// What the result of a run depends on, so that a pattern is not cut from the rest shape of another body or motion.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "apps/scene.h"
#include "apps/toml_table.h"

namespace ease {

/// The tables of a scene that a run depends on as they are written, but for names of files, seams and the number of
/// threads.  `has_files`: the body's poses are files.
std::map<std::string, std::string> tablesOfRun(const TomlTable& root, bool has_files);

/// A hash for each of the scene's tables that a run depends on, of what is written there and of the mesh files named
/// there: the same on every machine.  Seams are left out, since a garment can be cut otherwise after the run.
std::map<std::string, std::string> runInputs(const Scene& scene);

/// Names of the tables whose hashes differ, "[body]"; a table that one of them lacks differs.
std::vector<std::string> differingTables(const std::map<std::string, std::string>& a,
                                         const std::map<std::string, std::string>& b);

}  // namespace ease
