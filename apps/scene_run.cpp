#include "apps/scene_run.h"

#include <fmt/format.h>

#include <algorithm>

#include "solver/base/error.h"

namespace ease {

namespace {

constexpr int kDefaultInterval = 8;  // time steps between measurements by default

double bodyMotion(const Scene& scene, const SceneInput& input) {
  return bodyMotionPerStep(replaySchedule(scene), input.body_triangles, input.poses, input.garment.positions);
}

}  // namespace

Schedule replaySchedule(const Scene& scene) {
  Schedule schedule;
  schedule.time_step = scene.solver.time_step;
  schedule.poses = scene.body ? static_cast<int>(scene.body->poses.size()) : 0;
  schedule.interpolation_steps = scene.body ? scene.body->steps : 0;
  schedule.steps_per_pose = scene.solver.steps_per_pose;
  schedule.steps_without_body = scene.solver.steps;
  schedule.measure_every = scene.adaption ? scene.adaption->every
                           : scene.output ? scene.output->every
                                          : kDefaultInterval;
  if (writesReplays(scene)) schedule.write_every = scene.output->every;
  return schedule;
}

Schedule adaptingSchedule(const Scene& scene) {
  Schedule schedule = replaySchedule(scene);
  if (scene.output) schedule.write_every = scene.output->every;
  if (!scene.adaption) return schedule;
  if (!fitsInPasses(scene)) schedule.adapt_every = scene.adaption->every;
  schedule.cycles = scene.adaption->cycles;
  schedule.settle = scene.adaption->settle;
  return schedule;
}

RunSettings runSettings(const Scene& scene, const Schedule& schedule) {
  RunSettings settings;
  settings.schedule = schedule;
  settings.method = {scene.solver.method, scene.solver.tolerance, scene.solver.residual, scene.solver.iterations};
  settings.gravity = scene.solver.gravity;
  settings.contact_stiffness = scene.collision.stiffness;
  settings.friction = scene.collision.friction;
  settings.comfort_offset = scene.collision.offset;
  if (scene.adaption) settings.limit = scene.adaption->limit;
  return settings;
}

RunInput runInput(const Scene& scene, const SceneInput& input, MovingBody* body) {
  RunInput run{startOf(input), input.offsets, {}, body, bodyMotion(scene, input)};
  for (size_t k = 0; k < input.pins.size(); ++k) run.pins.push_back({input.pins[k], scene.garment.pins[k].to_body});
  return run;
}

Substeps substepsOf(const Scene& scene, const SceneInput& input) {
  if (input.poses.size() < 2) return {};
  try {
    return chooseSubsteps(replaySchedule(scene), bodyMotion(scene, input), scene.collision.offset);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: [body] steps = {}: {}", scene.file.string(), scene.body->steps, error.what()));
  }
}

MovingBody movingBody(const Scene& scene, const SceneInput& input) {
  const double largest_offset = *std::max_element(input.offsets.begin(), input.offsets.end());
  return MovingBody(input.body_triangles, input.poses, scene.body->steps * substepsOf(scene, input).interpolation,
                    LevelSetOptions{scene.collision.voxel, kBeyondComfort + largest_offset}, input.way);
}

}  // namespace ease
