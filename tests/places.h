// Where tests and benchmarks find the scans that may lie beside the project, and the project's own files.
#pragma once

namespace ease {

extern const char* const kSharedData;       // ../shared/data of the project; there may be no such folder
extern const char* const kSourceDirectory;  // of the project

}  // namespace ease
