#include "apps/studio/studio.h"

#include <fmt/format.h>

#include <chrono>

#include "solver/base/error.h"

namespace ease {

namespace {

/// A message without the file's name in front, which the window's title tells.
std::string shortened(std::string message, const std::filesystem::path& file) {
  const std::string name = file.string();
  if (message.compare(0, name.size(), name) != 0) return message;
  const size_t end = message.find(": ", name.size());
  return end == std::string::npos ? message : message.substr(end + 2);
}

}  // namespace

Studio::Studio(Document document, std::function<void()> on_news)
    : on_news_(std::move(on_news)), document_(std::move(document)) {
  if (!scene().body)
    throw InputError(
        fmt::format("{}: has no [body]: expected one, which the garment is made on", document_.file().string()));
  body_ = readBodyInput(scene());
  body_mesh_ = {body_.poses.front(), body_.body_triangles};
  body_topology_ = buildTopology(body_mesh_, "body");
  body_paths_ = std::make_unique<SurfacePaths>(body_mesh_, body_topology_);
  stage.setBody(body_mesh_.triangles, body_mesh_.positions);
  adapts_ = scene().adaption.has_value();
  simulation_ = std::make_unique<Simulation>(on_news_);
  startMaking(false);
}

Studio::~Studio() {
  gives_up_ = true;
  if (making_.valid()) making_.wait();
}

void Studio::say(const std::string& words) {
  words_ = words;
  is_refusal_ = false;
}

void Studio::refuse(const std::string& why) {
  words_ = shortened(why, document_.file());
  is_refusal_ = true;
}

bool Studio::refuseWhileMaking() {
  if (!isMaking()) return false;
  refuse("the garment is still being made: wait a moment, then try again");
  return true;
}

bool Studio::gesture(const std::string& text, const std::string& name) {
  if (refuseWhileMaking()) return false;
  try {
    document_.apply(text, name);
  } catch (const InputError& error) {
    refuse(error.what());
    return false;
  }
  ++text_revision_;
  say(name + " ...");
  startMaking(true);
  return true;
}

bool Studio::finishMaking() {
  if (!isMaking()) return true;
  say("");
  takeMade();
  return !isRefusal();
}

void Studio::undo() {
  if (!finishMaking()) return;
  const std::string gesture = document_.undo();
  if (gesture.empty()) return refuse("nothing to undo");
  ++text_revision_;
  say("undone: " + gesture);
  startMaking(false);
}

void Studio::redo() {
  if (!finishMaking()) return;
  const std::string gesture = document_.redo();
  if (gesture.empty()) return refuse("nothing to redo");
  ++text_revision_;
  say("redone: " + gesture);
  startMaking(false);
}

void Studio::startMaking(bool by_gesture) {
  made_by_gesture_ = by_gesture;
  making_ = std::async(std::launch::async, [this, text = text(), scene = scene(), last = made_] {
    const auto pause = [this] {
      if (gives_up_) throw Interrupted();
    };
    struct News {  // also when making fails
      const std::function<void()>& tell;
      ~News() {
        if (tell) tell();
      }
    } news{on_news_};
    return makeGarment(text, scene, body_, last.get(), pause);
  });
}

void Studio::takeMade() {
  try {
    auto made = std::make_shared<const MadeGarment>(making_.get());
    made_ = std::move(made);
    if (!made_->input.warnings.empty()) say(shortened(made_->input.warnings.back(), document_.file()));
    showMade();
  } catch (const std::exception& error) {
    if (made_by_gesture_) document_.dropLast();
    ++text_revision_;
    refuse(error.what());
  }
  ++mesh_revision_;
}

void Studio::showMade() {
  if (!made_->hasGarment()) {
    simulation_->play(false);
    simulation_->post([](std::unique_ptr<LiveRun>& run) {
      run.reset();
      return std::string();
    });
    frame_.reset();
    stage.removeCloth();
    stage.moveBody(body_.poses[pose_]);
    if (!is_refusal_ && words_.size() > 4 && words_.substr(words_.size() - 4) == " ...")
      words_.resize(words_.size() - 4);
    return;
  }
  simulation_->post([made = made_, adapts = adapts_, pose = pose_](std::unique_ptr<LiveRun>& run) {
    if (run) return run->change(made);
    run = std::make_unique<LiveRun>(made);
    run->setAdapting(adapts);
    if (pose > 0) run->goTo(pose);
    return fmt::format("the garment has {} vertices, made in {:.2f} s; Space lets it move",
                       made->input.garment.positions.rows(), made->seconds);
  });
}

void Studio::putOnStage(LiveFrame frame) {
  if (!hasGarment()) return;  // undone since
  frame_ = std::move(frame);
  stage.setCloth(frame_->made, frame_->garment);
  stage.moveBody(frame_->body);
}

bool Studio::poll() {
  bool is_new = false;
  if (making_.valid() && making_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
    takeMade();
    is_new = true;
  }
  if (std::optional<LiveFrame> frame = simulation_->takeFrame()) {
    putOnStage(std::move(*frame));
    if (is_on_tour_ && frame_ && frame_->pose == pose_ && frame_->way >= 1.0) goOnTour();
    is_new = true;
  }
  for (const std::string& message : simulation_->takeMessages()) {
    const bool is_fault = message.compare(0, 8, "stopped:") == 0;
    if (is_fault)
      refuse(message);
    else
      say(message);
    is_new = true;
  }
  return is_new;
}

void Studio::finishWork() {
  while (isMaking()) {
    making_.wait();
    poll();
  }
  simulation_->finishWork();
  poll();
}

bool Studio::refuseWithoutGarment() {
  if (hasGarment()) return false;
  if (!refuseWhileMaking()) refuse("there is no garment yet: draw boundaries, then click a region");
  return true;
}

void Studio::play(bool plays) {
  if (plays && refuseWithoutGarment()) return;
  simulation_->play(plays);
  say(plays ? "simulating; Space pauses" : "paused");
}

void Studio::step(int steps) {
  if (refuseWithoutGarment()) return;
  simulation_->play(false);
  simulation_->stepOnce(steps);
}

void Studio::startOver() {
  if (refuseWithoutGarment()) return;
  pose_ = 0;
  simulation_->post([made = made_, adapts = adapts_](std::unique_ptr<LiveRun>& run) {
    run = std::make_unique<LiveRun>(made);
    run->setAdapting(adapts);
    return std::string("started over on the first pose");
  });
}

void Studio::goTo(int pose) {
  if (pose < 0 || pose >= static_cast<int>(body_.poses.size())) return refuse("there is no such pose");
  pose_ = pose;
  if (!hasGarment()) {
    stage.moveBody(body_.poses[pose]);
    return say("pose '" + body_.pose_names[pose] + "'; what you draw here is taken to the first pose");
  }
  std::string words = "the body goes to pose '" + body_.pose_names[pose] + "'";
  if (!simulation_->plays()) words += " as soon as the cloth moves (Space)";
  simulation_->post([pose, words](std::unique_ptr<LiveRun>& run) {
    if (run) run->goTo(pose);
    return words;
  });
}

void Studio::tour(bool goes_on) {
  if (goes_on && refuseWithoutGarment()) return;
  if (goes_on && body_.poses.size() < 2) return refuse("the scene has one pose only");
  is_on_tour_ = goes_on;
  if (!goes_on) return say("the body goes on to pose '" + body_.pose_names[pose_] + "' and stays there");
  if (!simulation_->plays()) play(true);
  goOnTour();
}

void Studio::goOnTour() {
  if (pose_ == 0) tour_direction_ = 1;
  if (pose_ + 1 == std::ssize(body_.poses)) tour_direction_ = -1;
  goTo(pose_ + tour_direction_);
}

void Studio::setAdapting(bool adapts) {
  adapts_ = adapts;
  std::string words = adapts ? "the rest shape is let out where it is too tight" : "the rest shape stays as it is";
  if (adapts && !scene().adaption) words += "; Run lets nothing out until the scene has a limit: set Limit under Cloth";
  simulation_->post([adapts, words](std::unique_ptr<LiveRun>& run) {
    if (run) run->setAdapting(adapts);
    return words;
  });
}

}  // namespace ease
