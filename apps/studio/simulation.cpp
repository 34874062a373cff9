#include "apps/studio/simulation.h"

namespace ease {

Simulation::Simulation(std::function<void()> on_news) : on_news_(std::move(on_news)), thread_([this] { work(); }) {}

Simulation::~Simulation() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void Simulation::post(Change change) {
  {
    const std::lock_guard lock(mutex_);
    changes_.push_back(std::move(change));
  }
  wake_.notify_all();
}

void Simulation::play(bool plays) {
  {
    const std::lock_guard lock(mutex_);
    plays_ = plays;
    if (!plays) is_wanted_ = true;
  }
  wake_.notify_all();
}

bool Simulation::plays() const {
  const std::lock_guard lock(mutex_);
  return plays_;
}

void Simulation::stepOnce(int steps) {
  {
    const std::lock_guard lock(mutex_);
    steps_left_ += steps;
  }
  wake_.notify_all();
}

void Simulation::wantFrame(bool all) {
  {
    const std::lock_guard lock(mutex_);
    is_wanted_ = true;
    wants_all_ = all;
  }
  wake_.notify_all();
}

std::optional<LiveFrame> Simulation::takeFrame() {
  const std::lock_guard lock(mutex_);
  return std::exchange(frame_, std::nullopt);
}

std::vector<std::string> Simulation::takeMessages() {
  const std::lock_guard lock(mutex_);
  return std::exchange(messages_, {});
}

long Simulation::stepsMade() const {
  const std::lock_guard lock(mutex_);
  return steps_made_;
}

void Simulation::finishWork() {
  std::unique_lock lock(mutex_);
  idle_.wait(lock, [this] { return !is_busy_ && !hasWork(); });
}

void Simulation::tell(const std::string& message) {
  if (message.empty()) return;
  const std::lock_guard lock(mutex_);
  messages_.push_back(message);
}

void Simulation::makeChange(const Change& change) {
  try {
    tell(change(run_));
  } catch (const std::exception& error) {
    tell(error.what());
  }
}

void Simulation::makeStep() {
  try {
    run_->step();
  } catch (const std::exception& error) {
    tell(std::string("stopped: ") + error.what() + "; start over, or undo the last change");
    const std::lock_guard lock(mutex_);
    plays_ = false;
    steps_left_ = 0;
    is_wanted_ = true;
  }
}

void Simulation::work() {
  for (;;) {
    std::deque<Change> changes;
    bool steps = false, publishes = false, all = false;
    {
      std::unique_lock lock(mutex_);
      is_busy_ = false;
      idle_.notify_all();
      wake_.wait(lock, [this] { return hasWork(); });
      if (ends_) return;
      is_busy_ = true;
      changes.swap(changes_);
    }
    for (const Change& change : changes) makeChange(change);
    {
      const std::lock_guard lock(mutex_);
      has_run_ = run_ != nullptr;
      steps = has_run_ && (plays_ || steps_left_ > 0);
      if (steps_left_ > 0) --steps_left_;
      all = wants_all_;
      if (steps) ++steps_made_;
    }
    if (steps) makeStep();
    {
      const std::lock_guard lock(mutex_);
      publishes = run_ && (is_wanted_ || !changes.empty() || (!plays_ && steps_left_ == 0));
      is_wanted_ = false;
    }
    if (publishes) {
      LiveFrame frame = run_->frame(all);
      const std::lock_guard lock(mutex_);
      frame_ = std::move(frame);
    }
    if ((publishes || !changes.empty()) && on_news_) on_news_();
  }
}

}  // namespace ease
