#include "tests/fuzz/command_fuzz.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <sstream>

#include "apps/command_line.h"
#include "apps/scene.h"
#include "apps/scene_run.h"
#include "solver/base/error.h"
#include "tests/apps/result_check.h"
#include "tests/fuzz/mutate.h"

namespace ease {

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif
constexpr unsigned kHang = kSanitized ? 600 : 120;  // s, also on a machine with much else to do
constexpr rlim_t kMaxMemory = rlim_t{8} << 30;      // bytes of address space; sanitizers take more
constexpr int kNotTried = 99;                       // exit code
constexpr int kMaxSteps = 80, kMaxVertices = 1000;
constexpr double kSmallestVoxel = 2e-3, kShortestEdge = 0.01;  // m

std::string contentOf(const std::filesystem::path& file) {
  std::ostringstream content;
  content << std::ifstream(file, std::ios::binary).rdbuf();
  return content.str();
}

/// Whether the scene is refused, or asks for little.
bool isSmall(const std::filesystem::path& file) {
  try {
    const Scene scene = readScene(file);
    long steps = timeStepsOfMotion(replaySchedule(scene));
    if (scene.adaption) steps = steps * scene.adaption->cycles + scene.adaption->settle;
    if (const auto& tools = scene.garment.tools)
      if (tools->resolution > kMaxVertices || (tools->edge_length > 0.0 && tools->edge_length < kShortestEdge))
        return false;
    return steps <= kMaxSteps && scene.collision.voxel >= kSmallestVoxel && scene.solver.iterations <= 1000;
  } catch (const InputError&) {
    return true;
  }
}

/// The status that a child process ends with which does `work` and exits with what that returns.
int statusOf(const std::function<int()>& work) {
  std::cout.flush();
  std::fflush(nullptr);
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process can be made");
  if (child == 0) {
    for (const int signal : {SIGINT, SIGTERM, SIGSEGV, SIGABRT, SIGFPE, SIGILL, SIGBUS}) std::signal(signal, SIG_DFL);
    ::alarm(kHang);
    const int code = work();
    std::fflush(nullptr);
    std::_Exit(code);  // what libraries do at the end would wait for threads that the fork did not bring along
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

void leadTo(const char* file, int stream) {
  const int descriptor = ::open(file, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (descriptor < 0 || ::dup2(descriptor, stream) < 0) ::_exit(kNotTried);
  ::close(descriptor);
}

bool isPrintable(const std::string& line) {
  return std::none_of(line.begin(), line.end(), [](unsigned char c) { return c < ' ' || c == 127; });
}

/// What is wrong with the lines on stderr; of a wrong input a file must be named.
std::string faultOfLines(const std::string& err, int code, const FuzzKind& kind) {
  int errors = 0;
  std::istringstream lines(err);
  for (std::string line; std::getline(lines, line);) {
    if (!isPrintable(line)) return "a line that is not text";
    if (line.size() > 1000) return "a line of more than 1000 characters";
    for (const char* internal : {"std::", "basic_string", "vector::", "json.exception", "CGAL", "Assertion"})
      if (line.find(internal) != std::string::npos) return "the words of a library";
    if (line.starts_with("ease: warning: ")) continue;
    if (!line.starts_with("ease: error: ")) return "a line that is neither warning nor error";
    ++errors;
    const bool names_file = std::any_of(kind.files.begin(), kind.files.end(),
                                        [&](const auto& file) { return line.find(file.first) != std::string::npos; });
    if (code == 1 && !names_file) return "an error without its file";
  }
  if (errors != (code == 0 || code == 3 ? 0 : 1)) return fmt::format("{} errors with exit code {}", errors, code);
  return {};
}

/// What follows each of the words in the text, up to a character that is no digit.
std::string numbersAfter(const std::vector<std::string>& words, const std::string& text) {
  std::string numbers;
  for (const std::string& word : words) {
    const size_t at = text.find(word);
    if (at == std::string::npos) continue;
    const size_t begin = at + word.size();
    numbers += text.substr(begin, text.find_first_not_of("0123456789", begin) - begin) + ' ';
  }
  return numbers;
}

/// Numbers of vertices and triangles of garment and body, from the results of a run.
std::string meshSizesIn(const std::filesystem::path& out) {
  return numbersAfter({"\"vertices\": ", "\"triangles\": "}, contentOf(out / "report.json")) +
         numbersAfter({"NumberOfPoints=\"", "NumberOfPolys=\""}, contentOf(out / "body/body_000000.vtp"));
}

}  // namespace

CommandFuzz::CommandFuzz(const FuzzKind& kind, const std::string& program) : kind_(kind), program_(program) {
  for (const auto& [name, bytes] : kind_.files) {
    std::filesystem::create_directories((directory_.path / name).parent_path());
    directory_.write(name, bytes);
  }
  if (kind_.damaged == "scene.toml") return;
  outcomeOf(kind_.files.at(kind_.damaged));
  whole_size_ = meshSizesIn(directory_.path / "out");
}

/// In the child process: the command, its exit code.
int CommandFuzz::inDirectory() const {
  if (::chdir(directory_.path.c_str()) != 0) return kNotTried;
  leadTo("stdout.txt", STDOUT_FILENO);
  leadTo("stderr.txt", STDERR_FILENO);
  if (!isSmall("scene.toml")) return kNotTried;
  const rlimit memory{kMaxMemory, kMaxMemory};
  if (!kSanitized) ::setrlimit(RLIMIT_AS, &memory);
  std::vector<std::string> words = {"ease"};
  words.insert(words.end(), kind_.arguments.begin(), kind_.arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  ::setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null", 1);  // no pictures, which take longer than all the rest
  if (!program_.empty()) {
    ::execv(program_.c_str(), pointers.data());
    return kNotTried;
  }
  return commandLine(static_cast<int>(words.size()), pointers.data());
}

FuzzOutcome CommandFuzz::attempt(unsigned seed) const {
  const std::string& whole = kind_.files.at(kind_.damaged);
  const FuzzOutcome outcome = outcomeOf(seed == 0 ? whole : Mutator(seed).damaged(whole));
  const bool is_silent = outcome.end == End::done && outcome.text.empty() && kind_.damaged != "scene.toml" &&
                         meshSizesIn(directory_.path / "out") != whole_size_;
  return is_silent ? FuzzOutcome{End::silent, "another mesh without a word"} : outcome;
}

FuzzOutcome CommandFuzz::outcomeOf(const std::string& bytes) const {
  directory_.write(kind_.damaged, bytes);
  const std::filesystem::path out = directory_.path / "out";
  std::filesystem::remove_all(out);
  const int status = statusOf([&] { return inDirectory(); });
  const std::string err = contentOf(directory_.path / "stderr.txt");
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    return {signal == SIGALRM ? End::hang : End::crash, fmt::format("signal {}; {}", signal, err)};
  }
  const int code = WEXITSTATUS(status);
  if (code == kNotTried) return {End::not_tried, err};
  if (code > 3) return {End::unclear, fmt::format("exit code {}; {}", code, err)};
  if (const std::string fault = faultOfLines(err, code, kind_); !fault.empty())
    return {End::unclear, fmt::format("{}: {}", fault, err)};
  if (code == 1 && std::filesystem::exists(out)) return {End::unclear, "results of a wrong input; " + err};
  const int faulty = statusOf([&] {
    const std::string fault = faultIn(out);
    directory_.write("fault.txt", fault);
    return fault.empty() ? 0 : 1;
  });
  if (faulty != 0) return {End::unclear, fmt::format("{}; {}", contentOf(directory_.path / "fault.txt"), err)};
  constexpr End kEnds[] = {End::done, End::wrong_input, End::failed, End::doubtful};
  return {kEnds[code], err};
}

}  // namespace ease
