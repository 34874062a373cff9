// The command line on damaged files, one child process an input: what each came to.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/apps/temporary_directory.h"

namespace ease {

/// A command, the files that it reads, and which of them is to be damaged.
struct FuzzKind {
  std::string name;
  std::vector<std::string> arguments;
  std::map<std::string, std::string> files;  // bytes by name
  std::string damaged;
};

/// Scenes for `run` and `garment`, every mesh format as garment and as body, a checkpoint.
std::vector<FuzzKind> fuzzKinds();

enum class End {
  done,
  silent,    // done without a warning, although the damaged mesh has another size than the whole one
  doubtful,  // done, and told that the figures cannot be trusted
  wrong_input,
  failed,
  not_tried,  // it asks for a long job, rightly
  crash,
  hang,
  unclear  // another exit code, more or less than one clear line, or files left that are not whole
};

struct FuzzOutcome {
  End end;
  std::string text;  // what the command printed on stderr, or what is wrong with its end

  bool isFault() const { return end == End::crash || end == End::hang || end == End::unclear || end == End::silent; }
};

class CommandFuzz {
 public:
  /// `program`: the executable to start; empty: commandLine() in a child of this process, which has no thread yet.
  explicit CommandFuzz(const FuzzKind& kind, const std::string& program = "");

  /// The damage is that of the seed; none for 0.
  FuzzOutcome attempt(unsigned seed) const;

 private:
  int inDirectory() const;
  FuzzOutcome outcomeOf(const std::string& bytes) const;

  FuzzKind kind_;
  std::string program_;
  TemporaryDirectory directory_;
  std::string whole_size_;  // of the meshes of the undamaged input
};

}  // namespace ease
