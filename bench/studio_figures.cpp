// How fast the editor answers: bench_studio SCENE [SECONDS]
//
// Opens the window on a scene whose garment is made by tools, without a display, and prints a line for each figure:
// window, memory, preview of a path, making the garment, paint, another pose, and simulation with and without drawing
// in turns of SECONDS (default 4).  Medians; on a machine that does nothing else.
#include <QApplication>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <functional>
#include <iterator>
#include <thread>

#include "apps/studio/main_window.h"
#include "solver/base/stopwatch.h"

using namespace ease;

namespace {

using Clock = std::chrono::steady_clock;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Processor time of all threads so far, s.
double processorSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Medians of the time that passed and of the processor time, ms.
class Laps {
 public:
  void begin() {
    start_ = Clock::now();
    processor_ = processorSeconds();
  }
  void end() {
    passed_.push_back(1e3 * secondsSince(start_));
    worked_.push_back(1e3 * (processorSeconds() - processor_));
  }
  void print(const char* what) const {
    std::printf("%-34s %7.1f ms, of the processor %7.1f ms\n", what, median(passed_), median(worked_));
  }

 private:
  Clock::time_point start_;
  double processor_ = 0.0;
  std::vector<double> passed_, worked_;
};

/// Lets the window work until the condition holds; returns the seconds that took.
double until(const std::function<bool()>& condition) {
  const auto start = Clock::now();
  while (!condition()) {
    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);  // the window's timer ends the waiting
  }
  return secondsSince(start);
}

double workFor(double seconds) {
  const auto start = Clock::now();
  return until([&] { return secondsSince(start) >= seconds; });
}

/// Memory of this process in MB: VmRSS (now) or VmHWM (at most so far).
double memoryMB(const std::string& what) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind(what + ":", 0) == 0) return std::stod(line.substr(what.size() + 1)) / 1024.0;
  return 0.0;
}

void pathPreview(MainWindow& window) {
  Studio& studio = window.studio();
  window.chooseTool(PartKind::boundary);
  const auto at = [&](const Vec3& point) {
    const Stage& stage = studio.stage;
    const Vec3 on =
        placeOn(nearestPlace(point, stage.body(), stage.bodyTriangles()), stage.body(), stage.bodyTriangles());
    const Projected seen = stage.project(on);
    return Pointer{seen.x, seen.y};
  };
  const Positions& body = studio.stage.firstPose();
  const double middle = (body.col(1).minCoeff() + body.col(1).maxCoeff()) / 2;
  for (const double x : {-0.1, 0.0}) window.tool().press(at({x, middle + 0.1, 0.2}));
  Laps hover, draw;
  for (int k = 0; k < 40; ++k) {
    const Pointer pointer = at({0.1, middle + 0.1 + 0.005 * k, 0.2});
    hover.begin();
    window.tool().hover(pointer);
    hover.end();
    draw.begin();
    window.view().refresh();
    window.view().repaint();
    draw.end();
  }
  window.tool().cancel();
  hover.print("path preview");
  draw.print("a picture");
}

/// Tells how long it takes from a gesture until the simulation has taken it in.
void takenIn(MainWindow& window, const char* what, const std::function<void(int)>& gesture) {
  Studio& studio = window.studio();
  Laps laps;
  for (int k = 0; k < 7; ++k) {
    laps.begin();
    gesture(k);
    while (studio.isMaking()) {
      studio.poll();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    studio.simulation().finishWork();
    laps.end();
    studio.poll();
  }
  laps.print(what);
}

void simulate(MainWindow& window, double turn_s) {
  Studio& studio = window.studio();
  std::vector<double> with, without, pictures;
  studio.setAdapting(false);
  for (int k = 0; k < 5; ++k) {
    studio.startOver();
    studio.finishWork();
    studio.play(true);
    workFor(0.5);
    const long steps = studio.simulation().stepsMade(), drawn = window.view().drawn();
    const double seconds = workFor(turn_s);
    with.push_back(static_cast<double>(studio.simulation().stepsMade() - steps) / seconds);
    pictures.push_back(static_cast<double>(window.view().drawn() - drawn) / seconds);
    studio.play(false);
    studio.startOver();
    studio.finishWork();
    studio.play(true);
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    const long steps_before = studio.simulation().stepsMade();
    const auto start = Clock::now();
    std::this_thread::sleep_for(std::chrono::duration<double>(turn_s));
    without.push_back(static_cast<double>(studio.simulation().stepsMade() - steps_before) / secondsSince(start));
    studio.play(false);
  }
  std::vector<double> kept;
  for (size_t k = 0; k < with.size(); ++k) kept.push_back(100.0 * with[k] / without[k]);
  std::printf("simulating: %.1f pictures/s, %.1f steps/s; without drawing %.1f steps/s; kept %.0f %%\n",
              median(pictures), median(with), median(without), median(kept));
}

}  // namespace

int main(int argc, char** argv) {
  const auto start = Clock::now();
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  if (argc < 2) return std::fputs("usage: bench_studio SCENE [SECONDS]\n", stderr), 1;
  std::ifstream in(argv[1]);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  MainWindow window(Document(text, argv[1]));
  window.resize(1280, 800);
  window.show();
  until([&] { return window.view().drawn() > 0; });
  std::printf("window %.2f s (%.2f s of the processor), body of %ld triangles\n", secondsSince(start),
              processorSeconds(), static_cast<long>(window.studio().bodyMesh().triangles.rows()));
  Studio& studio = window.studio();
  until([&] { return !studio.isMaking() && studio.stage.hasCloth(); });
  const long vertices = static_cast<long>(studio.stage.cloth().rows());
  std::printf("garment %.2f s after the window, %ld vertices\n", secondsSince(start), vertices);
  pathPreview(window);
  const Vec3 seed = studio.scene().garment.tools->seed;
  Laps making;
  for (int k = 0; k < 5; ++k) {
    making.begin();
    studio.gesture(withRegion(studio.text(), seed + Vec3(0, 0.001 * (k + 1), 0)), "region");
    until([&] { return !studio.isMaking() && studio.frame()->made == studio.made(); });
    window.view().repaint();
    making.end();
  }
  making.print("garment made and shown");
  const Vec3 place = studio.stage.clothAsMade().positions.row(0);
  takenIn(window, "paint taken in",
          [&](int k) { studio.gesture(withPaint(studio.text(), {place}, 0.1, 1.05 + 0.01 * k), "paint"); });
  const int poses = static_cast<int>(studio.bodyInput().poses.size());
  takenIn(window, "another pose taken in", [&](int k) { studio.goTo((k + 1) % poses); });
  simulate(window, argc > 2 ? std::atof(argv[2]) : 4.0);
  std::printf("memory %.0f MB now, %.0f MB at most\n", memoryMB("VmRSS"), memoryMB("VmHWM"));
  studio.document().discardUnsaved();
  return 0;
}
