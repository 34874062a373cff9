#include "apps/checkpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#include "apps/fingerprint.h"
#include "solver/base/error.h"
#include "solver/base/whole_file.h"

namespace ease {

namespace {

constexpr std::string_view kKind = "ease checkpoint ", kVersion = "8\n";

// Size of the file's header: kind, version, and the fingerprint of everything that follows, which is the members.
constexpr size_t kHeader = kKind.size() + kVersion.size() + sizeof(std::uint64_t);

/// Writer appends values to a string of bytes and Reader takes them from it; both use one list of members.
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
  template <class T, class Item>
  void list(const std::vector<T>& items, const Item& item) {
    const std::uint64_t count = items.size();
    number(count);
    for (const T& one : items) item(one);
  }
  template <class Rows>
  void rows(const Rows& x) {
    const std::uint64_t count = x.rows();
    number(count);
    raw(x.data(), count * 3 * sizeof *x.data());
  }
};

struct Reader {
  const std::string& bytes;
  size_t at = 0;
  void raw(void* data, size_t size) {
    if (size > bytes.size() - at) throw InputError("is cut short");
    std::copy_n(bytes.data() + at, size, static_cast<char*>(data));  // `data` may be null if `size` is 0
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
  template <class T, class Item>
  void list(std::vector<T>& items, const Item& item) {
    items.resize(count(1));
    for (T& one : items) item(one);
  }
  template <class Rows>
  void rows(Rows& x) {
    x.resize(static_cast<long>(count(3 * sizeof *x.data())), 3);
    raw(x.data(), x.size() * sizeof *x.data());
  }
};

template <class Bytes, class R>
void recordMembers(Bytes& bytes, R& r) {
  bytes.number(r.steps);
  bytes.number(r.settle_steps);
  bytes.number(r.adaptions);
  bytes.number(r.fully_grown);
  bytes.number(r.substeps);
  bytes.number(r.stretch.overall);
  bytes.number(r.stretch.moments);
  bytes.array(r.stretch.poses);
  bytes.number(r.penetration);
  bytes.number(r.final_speed_m_s);
  bytes.number(r.fastest);
  bytes.array(r.on_body);
  bytes.number(r.contact_stiffness);
  bytes.number(r.solver);
  bytes.number(r.contact);
  bytes.number(r.voxels_on_demand);
  bytes.number(r.level_set_MB);
  bytes.number(r.times);
}

template <class Bytes, class F>
void fitMembers(Bytes& bytes, F& fit) {
  bytes.list(fit.passes, [&](auto& pass) {
    recordMembers(bytes, pass.record);
    bytes.number(pass.area_ratio);
  });
  bytes.rows(fit.first_end);
  bytes.number(fit.best);
  bytes.number(fit.best_share);
  bytes.array(fit.best_rest);
  bytes.array(fit.next_rest);
  bytes.number(fit.over);
}

template <class Bytes, class C>
void members(Bytes& bytes, C& c) {
  bytes.number(c.run.done);
  bytes.array(c.poses_met);
  bytes.number(c.time_step_s);
  bytes.number(c.steps_per_pose);
  bytes.number(c.interpolation_steps);
  bytes.rows(c.start.mesh.positions);
  bytes.rows(c.start.mesh.triangles);
  bytes.number(c.start.offset);
  bytes.array(c.numbering.vertices);
  bytes.array(c.numbering.triangles);
  bytes.rows(c.run.cloth.positions);
  bytes.rows(c.run.cloth.velocities);
  bytes.array(c.run.cloth.normal_forces);
  bytes.rows(c.first_rest.positions);
  bytes.array(c.first_rest.edges);
  bytes.rows(c.run.rest.positions);
  bytes.array(c.run.rest.edges);
  bytes.array(c.paint);
  bytes.array(c.run.wanted_edges);
  bytes.array(c.run.pins);
  fitMembers(bytes, c.fit);
  bytes.number(c.fit_setting);
}

}  // namespace

void writeCheckpoint(const std::filesystem::path& file, const Checkpoint& checkpoint) {
  Writer header, content;
  members(content, checkpoint);
  header.bytes.append(kKind).append(kVersion);
  header.number(fingerprint(content.bytes.data(), content.bytes.size()));
  writeWholeFile(file, header.bytes + content.bytes);
}

Checkpoint readCheckpoint(const std::filesystem::path& file) {
  const auto refuse = [&](const char* why) { throw InputError(fmt::format("{}: {}", file.string(), why)); };
  std::ifstream in(file, std::ios::binary);
  if (!in) refuse("cannot be read");
  std::ostringstream content;
  content << in.rdbuf();
  const std::string bytes = content.str();
  if (!bytes.starts_with(kKind)) refuse("is no checkpoint");
  if (!bytes.substr(kKind.size()).starts_with(kVersion))
    refuse("is a checkpoint of another version of ease: expected one of this version; start the run anew");
  if (bytes.size() < kHeader) refuse("is cut short");
  Reader reader{bytes, kKind.size() + kVersion.size()};
  std::uint64_t written = 0;
  reader.number(written);
  if (fingerprint(bytes.data() + kHeader, bytes.size() - kHeader) != written)
    refuse("is damaged or cut short: its content is not what was written");
  Checkpoint checkpoint;
  members(reader, checkpoint);
  return checkpoint;
}

}  // namespace ease
