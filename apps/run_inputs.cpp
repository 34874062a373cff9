#include "apps/run_inputs.h"

#include <fmt/format.h>

#include "apps/fingerprint.h"
#include "solver/base/whole_file.h"

namespace ease {

namespace {

std::string hashOf(const std::string& text) {
  return fmt::format("{:016x}", fingerprint(text.data(), text.size()));
}

}  // namespace

std::map<std::string, std::string> tablesOfRun(const TomlTable& root, bool has_files) {
  std::map<std::string, std::string> texts;
  for (const char* name : {"body", "garment", "material", "solver", "collision", "adaption"})
    if (const auto table = root.table(name))
      texts[name] = table->written({has_files ? "poses" : "", "mesh", "seam", "threads"});
  return texts;
}

std::map<std::string, std::string> runInputs(const Scene& scene) {
  std::map<std::string, std::string> texts = scene.tables_of_run;
  const std::filesystem::path folder = scene.file.parent_path();
  if (scene.body && scene.body->builtin.empty())
    for (const std::string& pose : scene.body->poses) texts["body"] += hashOf(contentOf(folder / pose));
  if (!scene.garment.mesh.empty()) texts["garment"] += hashOf(contentOf(folder / scene.garment.mesh));
  for (auto& [table, text] : texts) text = hashOf(text);
  return texts;
}

std::vector<std::string> differingTables(const std::map<std::string, std::string>& a,
                                         const std::map<std::string, std::string>& b) {
  std::map<std::string, std::string> both = a;
  both.insert(b.begin(), b.end());
  std::vector<std::string> names;
  for (const auto& [table, hash] : both) {
    const auto of_a = a.find(table), of_b = b.find(table);
    if (of_a == a.end() || of_b == b.end() || of_a->second != of_b->second) names.push_back("[" + table + "]");
  }
  return names;
}

}  // namespace ease
