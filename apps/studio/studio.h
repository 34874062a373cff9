// The editor without its window: a scene that is being edited, the garment made of it, and its simulation.
//
// Gestures are edits of the scene's text.  A garment is made in a thread of its own; the gesture counts once that has
// succeeded, and is taken back if it fails.  All functions are for one thread; news of the others is taken by poll().
#pragma once

#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "apps/studio/document.h"
#include "apps/studio/parts.h"
#include "apps/studio/simulation.h"
#include "apps/studio/stage.h"
#include "garment/surface_path.h"

namespace ease {

/// What the tools are set to.
struct ToolSettings {
  double radius = 0.08;   // m, of brushes and pins
  double scale = 1.1;     // of paint: times as long
  double offset = 0.015;  // m, of comfort
  bool mirror = false;    // everything on the other side of the body too
};

class Studio {
 public:
  /// Reads the body's poses and begins to make the garment.  `on_news`: called in other threads when poll() has
  /// something to take.  Throws InputError if the body cannot be read, or there is none.
  explicit Studio(Document document, std::function<void()> on_news = nullptr);
  ~Studio();
  Studio(const Studio&) = delete;
  Studio& operator=(const Studio&) = delete;

  const Document& document() const { return document_; }
  Document& document() { return document_; }
  const Scene& scene() const { return document_.scene(); }
  const std::string& text() const { return document_.text(); }
  const SceneInput& bodyInput() const { return body_; }
  /// The body on the first pose, and shortest paths on it.
  const TriangleMesh& bodyMesh() const { return body_mesh_; }
  const Topology& bodyTopology() const { return body_topology_; }
  const SurfacePaths& bodyPaths() const { return *body_paths_; }
  /// What was made last; null until then.
  const std::shared_ptr<const MadeGarment>& made() const { return made_; }

  Stage stage;
  ToolSettings settings;

  /// Takes a gesture's text.  Returns false, and has said why, if it is refused at once.
  bool gesture(const std::string& text, const std::string& name);
  /// Both wait until what is being made is there; a gesture that is refused then is all that they take back.
  void undo();
  void redo();
  /// Whether a garment is being made.
  bool isMaking() const { return making_.valid(); }
  /// Refuses a gesture while a garment is being made; returns whether it did.
  bool refuseWhileMaking();

  /// A hint, what was done, or why something was refused.
  void say(const std::string& words);
  void refuse(const std::string& why);
  const std::string& words() const { return words_; }
  bool isRefusal() const { return is_refusal_; }

  /// Takes what the other threads have finished.  Returns whether there is something new to show.
  bool poll();
  /// Waits until the garment is made and the simulation has nothing left to do, then polls.  It must not play.
  void finishWork();

  // The simulation.
  Simulation& simulation() { return *simulation_; }
  void play(bool plays);
  void step(int steps = 1);
  void startOver();
  void goTo(int pose);
  /// Whether the body goes on to the next pose as soon as it has reached one: to the last pose, back to the first, and
  /// forth again, as in a run.
  void tour(bool goes_on);
  bool isOnTour() const { return is_on_tour_; }
  void setAdapting(bool adapts);
  bool adapts() const { return adapts_; }
  int pose() const { return pose_; }
  /// The newest state of the simulation; null before there is a garment.
  const LiveFrame* frame() const { return frame_ ? &*frame_ : nullptr; }

  /// Counts what has changed, so that others know what to show anew.
  int textRevision() const { return text_revision_; }
  int meshRevision() const { return mesh_revision_; }

 private:
  void startMaking(bool by_gesture);
  void takeMade();
  void showMade();
  void putOnStage(LiveFrame frame);
  void goOnTour();
  bool hasGarment() const { return made_ && made_->hasGarment(); }
  /// Refuses what needs a garment where there is none; returns whether it did.
  bool refuseWithoutGarment();
  /// Waits for the garment that is being made; returns whether it could be made.
  bool finishMaking();

  const std::function<void()> on_news_;
  Document document_;
  SceneInput body_;
  TriangleMesh body_mesh_;
  Topology body_topology_;
  std::unique_ptr<SurfacePaths> body_paths_;
  std::shared_ptr<const MadeGarment> made_;
  std::future<MadeGarment> making_;
  std::atomic<bool> gives_up_ = false;
  bool made_by_gesture_ = false;
  std::string words_;
  bool is_refusal_ = false;
  std::unique_ptr<Simulation> simulation_;
  std::optional<LiveFrame> frame_;
  bool adapts_ = false;
  bool is_on_tour_ = false;
  int tour_direction_ = 1;  // -1: back to the first pose
  int pose_ = 0, text_revision_ = 0, mesh_revision_ = 0;
};

}  // namespace ease
