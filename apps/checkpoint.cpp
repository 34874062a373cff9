#include "apps/checkpoint.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>

#include "solver/mesh/error.h"
#include "solver/mesh/whole_file.h"

namespace ease {

namespace {

constexpr char kMagic[] = "ease checkpoint 2\n";

/// Appends to, or takes from, a string of bytes: one list of members serves both ways.
struct Writer {
  std::string bytes;
  void raw(const void* data, size_t size) { bytes.append(static_cast<const char*>(data), size); }
  template <class T>
  void number(const T& value) {
    raw(&value, sizeof value);
  }
  template <class T>
  void array(const std::vector<T>& values) {
    const std::uint64_t count = values.size();
    number(count);
    raw(values.data(), count * sizeof(T));
  }
  void rows(const Positions& x) {
    const std::uint64_t count = x.rows();
    number(count);
    raw(x.data(), count * 3 * sizeof(double));
  }
};

struct Reader {
  const std::string& bytes;
  size_t at = 0;
  void raw(void* data, size_t size) {
    if (size > bytes.size() - at) throw InputError("is cut short");
    std::memcpy(data, bytes.data() + at, size);
    at += size;
  }
  template <class T>
  void number(T& value) {
    raw(&value, sizeof value);
  }
  std::uint64_t count(size_t size) {
    std::uint64_t found = 0;
    number(found);
    if (found > (bytes.size() - at) / size) throw InputError("is cut short");
    return found;
  }
  template <class T>
  void array(std::vector<T>& values) {
    values.resize(count(sizeof(T)));
    raw(values.data(), values.size() * sizeof(T));
  }
  void rows(Positions& x) {
    x.resize(static_cast<long>(count(3 * sizeof(double))), 3);
    raw(x.data(), x.size() * sizeof(double));
  }
};

template <class Bytes, class C>
void members(Bytes& bytes, C& c) {
  bytes.number(c.time_steps);
  bytes.number(c.time_step_s);
  bytes.number(c.steps_per_pose);
  bytes.number(c.interpolation_steps);
  bytes.rows(c.state.positions);
  bytes.rows(c.state.velocities);
  bytes.rows(c.rest_positions);
  bytes.array(c.rest_edges);
  bytes.array(c.wanted_edges);
  bytes.array(c.pinned);
  bytes.array(c.numbering.vertices);
  bytes.array(c.numbering.triangles);
}

}  // namespace

void writeCheckpoint(const std::filesystem::path& file, const Checkpoint& checkpoint) {
  Writer writer;
  writer.bytes = kMagic;
  members(writer, checkpoint);
  writeWholeFile(file, writer.bytes);
}

Checkpoint readCheckpoint(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(fmt::format("{}: cannot be read: expected the directory of an earlier run", file.string()));
  std::ostringstream content;
  content << in.rdbuf();
  const std::string bytes = content.str();
  if (!bytes.starts_with(kMagic)) throw InputError(fmt::format("{}: is no checkpoint of this version", file.string()));
  Reader reader{bytes, sizeof kMagic - 1};
  Checkpoint checkpoint;
  try {
    members(reader, checkpoint);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
  return checkpoint;
}

}  // namespace ease
