// The simulation in a thread of its own.  Changes wait in a queue and are made between two time steps; the newest state
// waits in a place of its own until it is taken.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "apps/studio/live_run.h"

namespace ease {

class Simulation {
 public:
  /// A change made between two steps; it may make, replace or end the run.  Words that it returns are for the user.
  using Change = std::function<std::string(std::unique_ptr<LiveRun>&)>;

  /// `on_news` is called in the simulation's thread when there is a frame or a message to take.
  explicit Simulation(std::function<void()> on_news = nullptr);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  void post(Change change);
  void play(bool plays);
  bool plays() const;
  /// Makes that many steps more, and then stops.
  void stepOnce(int steps = 1);
  /// Asks for a frame after the next step; without steps, at once.  `all`: with gap and pressure.
  void wantFrame(bool all);

  /// The newest state that nobody has taken yet.
  std::optional<LiveFrame> takeFrame();
  /// Lines for the user: what changes did, and why the simulation stopped.
  std::vector<std::string> takeMessages();
  /// Time steps since the thread began.
  long stepsMade() const;
  /// Waits until all changes posted so far are made and no steps are left to make.
  void finishWork();

 private:
  void work();
  bool hasWork() const { return ends_ || !changes_.empty() || is_wanted_ || (has_run_ && (plays_ || steps_left_ > 0)); }
  void tell(const std::string& message);
  void makeChange(const Change& change);
  void makeStep();

  const std::function<void()> on_news_;
  mutable std::mutex mutex_;
  std::condition_variable wake_, idle_;
  std::deque<Change> changes_;
  bool plays_ = false, ends_ = false, is_wanted_ = false, wants_all_ = false, has_run_ = false, is_busy_ = false;
  int steps_left_ = 0;
  long steps_made_ = 0;
  std::optional<LiveFrame> frame_;
  std::vector<std::string> messages_;
  std::unique_ptr<LiveRun> run_;  // of the thread alone
  std::thread thread_;
};

}  // namespace ease
