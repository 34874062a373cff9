// ease-studio [SCENE | SCAN...]: makes, changes and fits a garment by hand.
#include <QApplication>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>

#include "apps/studio/keep_on_screen.h"
#include "apps/studio/main_window.h"
#include "solver/base/error.h"
#include "solver/io/mesh_io.h"

namespace {

/// Opens the scene or begins one on scans; `arguments`: of the command line, its name first.
ease::Document documentOf(const QStringList& arguments) {
  if (arguments.size() < 2) {
    const std::filesystem::path file = "studio.toml";
    return std::filesystem::exists(file) ? ease::Document::open(file) : ease::Document::builtin(file);
  }
  std::vector<std::filesystem::path> files;
  for (const QString& argument : arguments.mid(1)) files.emplace_back(argument.toStdString());
  if (files.size() == 1 && !ease::isMeshFile(files.front())) return ease::Document::open(files.front());
  for (const std::filesystem::path& file : files)
    if (!ease::isMeshFile(file))
      throw ease::InputError(file.string() + ": expected one scene, or meshes of one person (PLY, OBJ, STL, OFF, VTP)");
  return ease::Document::newOnScans(files, ".");
}

}  // namespace

int main(int argc, char** argv) {
  constexpr const char* kUsage =
      "usage: ease-studio [SCENE | SCAN... | --help | --version]\n"
      "  SCENE   scene file (TOML); the garment may be unfinished. Without one, studio.toml in this folder is opened;\n"
      "          where there is none, a new scene on the built-in body is begun under that name\n"
      "  SCAN... meshes of one person in several poses (PLY, OBJ, STL, OFF, VTP): a new scene on them is begun, in\n"
      "          studio.toml, or in studio 2.toml and so on where that is there\n";
  for (int k = 1; k < argc; ++k) {
    if (!std::strcmp(argv[k], "--help") || !std::strcmp(argv[k], "-h")) return std::fputs(kUsage, stdout), 0;
    if (!std::strcmp(argv[k], "--version")) return std::puts("ease-studio " EASE_VERSION), 0;
  }
  QApplication application(argc, argv);
  const QStringList arguments = QApplication::arguments();
  const bool has_options = std::any_of(arguments.begin() + 1, arguments.end(),
                                       [](const QString& argument) { return argument.startsWith('-'); });
  if (has_options) return std::fputs(kUsage, stderr), 1;
  try {
    auto* window = new ease::MainWindow(documentOf(arguments));
    window->setAttribute(Qt::WA_DeleteOnClose);
    window->showAsBefore();
    QTimer::singleShot(1000, window, [window] { ease::keepOnScreen(*window); });  // a slow window system's frame
    QTimer::singleShot(100, window, [window] {                                    // once the frame around it is known
      ease::keepOnScreen(*window);
      window->offerUnsavedWork();
    });
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ease-studio: error: %s\n", error.what());
    return 1;
  }
  return QApplication::exec();
}
