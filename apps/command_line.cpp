#include "apps/command_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>

#include "apps/commands.h"
#include "apps/words.h"

namespace ease {

namespace {

constexpr const char* kExamples = R"(
Examples:
  ease run scenes/t-shirt.toml                    results in results/t-shirt
  ease run scenes/t-shirt.toml -o out/shirt      results in out/shirt
  ease check scenes/t-shirt.toml                  reads and checks everything, simulates nothing
  ease pattern scenes/tunic.toml                  sewing pattern
Every key of a scene, with its unit, is explained in scenes/t-shirt.toml; those of the tools that make a garment, in
scenes/tunic.toml.
Exit codes: 0 done, 1 wrong input, 2 the computation failed, 3 done, but the stretch cannot be trusted: the garment left
the body, was never on it, slid, was thrown, or fell because nothing holds it, 130 interrupted.)";

constexpr const char* kRunExamples = R"(
Examples:
  ease run scenes/t-shirt.toml
  ease run scenes/t-shirt.toml -o out/shirt --threads 1
  ease run scenes/t-shirt.toml --resume results/t-shirt      goes on where it was interrupted
Open garment.pvd, body.pvd and rest.pvd of the results in ParaView; report.json has the figures.
Ctrl-C ends a run early and leaves what is written whole; once more, it ends at once.)";

constexpr const char* kGarmentExamples = R"(
Examples:
  ease garment scenes/tunic.toml                 garment.obj, garment.vtp, garment.json, garment.png in results/tunic
  ease garment scenes/tunic.toml --pieces        cut along its seams as well)";

constexpr const char* kPatternExamples = R"(
Examples:
  ease pattern scenes/tunic.toml                 runs the scene if its results are not there yet, then makes the pattern
  ease pattern results/tunic                     of a finished run
Print pattern_a4.pdf at 100 %, or cut pattern.pdf, .svg or .dxf; pattern_resewn.png shows the garment sewn from it.)";

constexpr const char* kCheckExamples = R"(
Example:
  ease check scenes/t-shirt.toml)";

std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

void onSignal(int) {
  if (interrupted.exchange(true)) ::_exit(kInterrupted);
}

ExitCode wrongUsage(const std::string& line) {
  say("error", line + "; see: ease --help");
  return kWrongInput;
}

/// Returns the message about an unknown word of the command line, with a suggestion of what was probably meant.
std::string unknownText(const CLI::App& app, const std::string& word) {
  const bool is_option = word.front() == '-', has_command = !app.get_subcommands().empty();
  std::vector<std::string> known = {"run", "check", "garment", "pattern"};
  if (is_option || has_command) known.clear();
  if (is_option)
    for (const CLI::Option* option : (has_command ? app.get_subcommands().front() : &app)->get_options())
      if (!option->get_lnames().empty()) known.push_back("--" + option->get_lnames().front());
  const std::string nearest = nearestWord(word, known);
  return fmt::format("unknown {} '{}'{}",
                     is_option     ? "option"
                     : has_command ? "argument"
                                   : "command",
                     word, nearest.empty() ? "" : fmt::format(", did you mean '{}'?", nearest));
}

ExitCode parsed(int argc, char** argv) {
  CLI::App app("Ease fits a garment to a moving body: poses and a garment in, a rest shape that fits every pose out.",
               "ease");
  app.footer(kExamples);
  app.set_version_flag("--version", "ease " EASE_VERSION, "Print the version and end");
  app.set_help_flag("-h,--help", "Print this help and end");
  app.require_subcommand(0, 1);
  app.allow_extras();  // also unknown commands; the first unknown word is reported below

  Arguments arguments;
  CLI::App* run = app.add_subcommand("run", "Simulate and adapt; write series, rest shape, report and picture");
  run->add_option("SCENE", arguments.scene, "Scene file, TOML")->required();
  run->add_option("-o,--output", arguments.directory, "Directory for the results; by default results/<scene's name>")
      ->check([](const std::string& directory) { return directory.empty() ? "expected a directory's name" : ""; });
  run->add_option("--threads", arguments.threads, "Number of threads, 0 for all; by default as the scene says")
      ->check(CLI::Range(0, 1024));
  run->add_option("--resume", arguments.resumed,
                  "Go on where the run in this directory stopped; the scene may have other pins, paint, material, "
                  "offset, adaption, method, or more poses or cycles after those that the body has met.  Results go "
                  "there too, unless -o says otherwise")
      ->check([](const std::string& directory) { return directory.empty() ? "expected a directory's name" : ""; });
  run->add_flag("--force", arguments.force, "Replace the results of another scene in that directory");
  run->footer(kRunExamples);
  CLI::App* check = app.add_subcommand("check", "Read and check all that run would use; simulate and write nothing");
  check->add_option("SCENE", arguments.scene, "Scene file, TOML")->required();
  check->footer(kCheckExamples);

  CLI::App* garment = app.add_subcommand("garment", "Make the garment with the scene's tools; write it and a picture");
  garment->add_option("SCENE", arguments.scene, "Scene file, TOML")->required();
  garment->add_option("-o,--output", arguments.directory, "Directory for the files; by default results/<scene's name>");
  garment->add_flag("--pieces", arguments.pieces, "Cut it along its seams as well: pieces.obj, .vtp, .json");
  garment->footer(kGarmentExamples);

  CLI::App* pattern = app.add_subcommand("pattern", "Make the sewing pattern of the fitted garment, and check it");
  pattern->add_option("SCENE", arguments.scene, "Scene file, TOML, or the directory of a finished run")->required();
  pattern->add_option("-o,--output", arguments.directory,
                      "Directory for the files; by default that of the run, results/<scene's name>");
  pattern->add_option("--threads", arguments.threads, "Number of threads, 0 for all; by default as the scene says")
      ->check(CLI::Range(0, 1024));
  pattern->footer(kPatternExamples);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return static_cast<ExitCode>(app.exit(error));  // --help, --version
    return wrongUsage(error.what());
  }
  if (const auto unknown = app.remaining(true); !unknown.empty()) return wrongUsage(unknownText(app, unknown.front()));
  if (run->parsed()) return guarded([&] { return runCommand(arguments, interrupted); });
  if (check->parsed()) return guarded([&] { return checkCommand(arguments, interrupted); });
  if (garment->parsed()) return guarded([&] { return garmentCommand(arguments, interrupted); });
  if (pattern->parsed()) return guarded([&] { return patternCommand(arguments, interrupted); });
  return wrongUsage("no command: expected 'run', 'garment', 'pattern' or 'check'");
}

/// Whether everything that was printed could be written; prints an error if not.
bool isPrinted() {
  errno = 0;
  if (std::cout.flush() && std::fflush(stdout) == 0 && !std::ferror(stdout)) return true;
  say("error", fmt::format("standard output: {}", errno != 0 ? std::strerror(errno) : "cannot be written"));
  return false;
}

}  // namespace

int commandLine(int argc, char** argv) {
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
  std::signal(SIGXFSZ, SIG_IGN);  // writing beyond the file size limit then fails with an error
  const ExitCode code = guarded([&] { return parsed(argc, argv); });
  return isPrinted() ? code : kFailed;
}

}  // namespace ease
