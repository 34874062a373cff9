// Whole files: reading one, and writing one so that it appears complete or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace ease {

/// The name under which `file` is written until it is complete.
std::filesystem::path temporaryName(const std::filesystem::path& file);

/// Writes `bytes` to the temporary name and renames it to `file`, replacing what was there.  Throws ComputationError
/// with the file and the system's reason (disk full, directory gone, no permission), and leaves no temporary file.
void writeWholeFile(const std::filesystem::path& file, std::string_view bytes);

/// The bytes of a file; empty where it cannot be read.
std::string contentOf(const std::filesystem::path& file);

}  // namespace ease
