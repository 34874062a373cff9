// A T-shirt on a mannequin that lowers its arms.  Where the motion stretches the cloth by more than 8 %, its rest shape
// is let out.  This is what `ease run` does with mode = "sequential", with the same classes, without scene file and
// results.
#include <ease/adaption/run.h>
#include <ease/collision/body/mannequin.h>
#include <ease/garment/builtin_garment.h>
#include <ease/garment/named_loop.h>

#include <cstdio>
#include <numeric>

int main() {
  // The body: two poses of the same mesh.
  const ease::TriangleMesh t_pose = ease::mannequin("t"), a_pose = ease::mannequin("a");
  const std::vector<ease::Positions> poses = {t_pose.positions, a_pose.positions};

  // When things happen: 40 shapes of the body from a pose to the next, 4 time steps for each, and 80 steps more to come
  // to rest; every 8 steps the rest shape is adapted, every 40 the garment is shown.
  ease::RunSettings settings;
  settings.schedule = {.poses = 2,
                       .interpolation_steps = 40,
                       .steps_per_pose = 4,
                       .settle = 80,
                       .adapt_every = 8,
                       .measure_every = 8,
                       .write_every = 40};
  settings.method.method = ease::Method::bw1;
  settings.comfort_offset = 0.005;  // m: least distance between garment and body
  settings.limit = 0.08;            // the cloth may be stretched to 1.08 times its length

  // The garment, made on the first pose; its neck follows the body.
  const ease::TriangleMesh shirt = ease::builtinGarment("t-shirt", 1000, settings.comfort_offset);
  ease::Material material;
  material.bending = 1e-6;  // N m
  ease::Cloth cloth(shirt, {0, -1, 0}, material);
  ease::RunInput input;
  input.start = shirt.positions;
  input.offsets.assign(shirt.positions.rows(), settings.comfort_offset);
  input.pins = {{ease::findLoop(cloth.topology(), shirt.positions, "top"), true}};

  // The body in motion, its level sets exact up to 25 mm beyond the comfort offset.  Where it moves far in a time step,
  // the step is divided.
  input.body_motion = ease::bodyMotionPerStep(settings.schedule, t_pose.triangles, poses, shirt.positions);
  const ease::Substeps substeps = ease::chooseSubsteps(settings.schedule, input.body_motion, settings.comfort_offset);
  ease::MovingBody body(t_pose.triangles, poses, settings.schedule.interpolation_steps * substeps.interpolation,
                        {.voxel = 0.01, .band = 0.025 + settings.comfort_offset});
  input.body = &body;

  ease::RunWatch watch;
  watch.on_frame = [](const ease::Snapshot& shot) {
    double largest = 0.0;
    for (const ease::Stretch& s : shot.stretch) largest = std::max(largest, s.sigma_1);
    std::printf("%.2f s: largest stretch %.3f\n", shot.moment.time_s, largest);
  };
  ease::Run run(settings, input, cloth);
  run.run(watch);

  const auto sum = [](const std::vector<double>& areas) { return std::accumulate(areas.begin(), areas.end(), 0.0); };
  double first = 0.0;
  for (const ease::Mat2& edges : cloth.first().edges) first += 0.5 * edges.determinant();
  std::printf("the rest shape has grown by %.2f %%; the deepest vertex was %.2f mm in the body\n",
              100.0 * (sum(cloth.restAreas()) / first - 1.0), 1e3 * run.record().penetration.vertices);
}
