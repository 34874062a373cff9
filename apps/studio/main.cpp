// ease-studio [SCENE]: makes, changes and fits a garment by hand.
#include <QApplication>
#include <QTimer>
#include <cstdio>
#include <cstring>
#include <exception>

#include "apps/studio/keep_on_screen.h"
#include "apps/studio/main_window.h"

int main(int argc, char** argv) {
  constexpr const char* kUsage =
      "usage: ease-studio [SCENE | --help | --version]\n"
      "  SCENE   scene file (TOML); the garment may be unfinished. Without SCENE, studio.toml in this folder is "
      "opened;\n"
      "          where there is none, a new scene on the built-in body is begun under that name\n";
  for (int k = 1; k < argc; ++k) {
    if (!std::strcmp(argv[k], "--help") || !std::strcmp(argv[k], "-h")) return std::fputs(kUsage, stdout), 0;
    if (!std::strcmp(argv[k], "--version")) return std::puts("ease-studio " EASE_VERSION), 0;
  }
  QApplication application(argc, argv);
  const QStringList arguments = QApplication::arguments();
  if (arguments.size() > 2) return std::fputs(kUsage, stderr), 1;
  try {
    const bool is_new = arguments.size() < 2;
    const std::filesystem::path file = is_new ? "studio.toml" : arguments[1].toStdString();
    ease::Document document =
        is_new && !std::filesystem::exists(file) ? ease::Document::builtin(file) : ease::Document::open(file);
    auto* window = new ease::MainWindow(std::move(document));
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
