// A T-shirt on a mannequin that lowers its arms.  Where the motion stretches the cloth by more than 8 %, its rest shape
// is let out.  This is what `ease run` does, written out with the classes that it uses.
#include <ease/adaption/clip.h>
#include <ease/adaption/stitch.h>
#include <ease/collision/body/mannequin.h>
#include <ease/collision/body_pins.h>
#include <ease/collision/moving_body.h>
#include <ease/garment/builtin_garment.h>
#include <ease/garment/named_loop.h>
#include <ease/solver/linear/gradient_system.h>
#include <ease/solver/step/time_step.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace {

constexpr double kOffset = 0.005;         // comfort: least distance between garment and body, m
constexpr double kLimit = 0.08;           // the cloth may be stretched to 1 + limit
constexpr int kShapes = 40;               // shapes of the body from a pose to the next
constexpr int kStepsPerShape = 4;         // time steps from a shape of the body to the next
constexpr int kSettlingSteps = 80;        // time steps after the motion
constexpr int kAdaptEvery = 8;            // time steps
constexpr double kMaxRecovery = 0.015;    // m: how far a contact may move cloth outwards in a time step
constexpr double kLevelSetReach = 0.025;  // m: distances are exact this far beyond the comfort offset

double largestStretch(const std::vector<ease::Stretch>& stretch) {
  double largest = 0.0;
  for (const ease::Stretch& s : stretch) largest = std::max(largest, s.sigma_1);
  return largest;
}

}  // namespace

int main() {
  // The body: two poses of the same mesh, and the shapes between them.
  const ease::TriangleMesh t_pose = ease::mannequin("t"), a_pose = ease::mannequin("a");
  ease::MovingBody body(t_pose.triangles, {t_pose.positions, a_pose.positions}, kShapes,
                        {.voxel = 0.01, .band = kLevelSetReach + kOffset});

  // The garment, made on the first pose.
  const ease::TriangleMesh shirt = ease::builtinGarment("t-shirt", 1000, kOffset);
  ease::Material material;
  material.bending = 1e-6;  // N m
  ease::Cloth cloth(shirt, {0, -1, 0}, material);
  const std::vector<int> ordering = ease::systemOrdering(cloth.vertexCount(), cloth.triangles());
  ease::TimeStep time_step(cloth, {.method = ease::Method::bw1}, ordering);
  ease::State state{shirt.positions, ease::Positions::Zero(cloth.vertexCount(), 3)};

  // Its neck follows the body.
  const std::vector<int>& neck = ease::findLoop(cloth.topology(), shirt.positions, "top");
  const std::vector<ease::BodyTie> ties = ease::tieToBody(neck, shirt.positions, t_pose.positions, t_pose.triangles);

  // Contact is sought at the vertices, edges' midpoints and triangles' centroids of the cloth: its samples.
  const std::vector<ease::Edge>& edges = cloth.topology().edges;
  std::vector<ease::Vec3> samples;
  std::vector<double> offsets;
  ease::sampleOffsets(std::vector<double>(cloth.vertexCount(), kOffset), cloth.triangles(), edges, offsets);
  ease::ContactFinder finder;

  // Adaption of the rest shape: what every triangle asks for, and one mesh made of that.
  ease::StretchClip clip(cloth, kLimit);
  ease::Stitcher stitcher(cloth, ordering);
  std::vector<ease::Stretch> stretch;
  std::vector<ease::Mat2> growth;

  int prepared = -1;  // number of the last shape whose level set is there
  for (int step = 1; step <= kShapes * kStepsPerShape + kSettlingSteps; ++step) {
    // Where the body is at the end of this step.  Each shape's level set stands for the body half a shape before and
    // after it.
    const double s = std::min(double(kShapes), step / double(kStepsPerShape));
    ease::sampleCloth(state.positions, cloth.triangles(), edges, samples);
    while (prepared < std::lround(s)) body.prepare(++prepared, samples);
    const ease::BodyMoment moment = body.at(s);

    ease::Pins pins{neck, {}};
    for (const ease::BodyTie& tie : ties) pins.positions.push_back(ease::placeOf(tie, moment));

    time_step.step(state, ease::StepOptions(), pins, [&](const ease::Positions& x, ease::Contacts& contacts) {
      ease::sampleCloth(x, cloth.triangles(), edges, samples);
      finder.find(moment, samples, offsets, kMaxRecovery, contacts);
    });

    if (step % kAdaptEvery != 0) continue;
    ease::measureStretch(cloth, state.positions, stretch);
    if (clip.clip(cloth, stretch, growth)) stitcher.stitch(cloth, growth);
    if (step % (5 * kAdaptEvery) == 0)
      std::printf("body at %.2f of its way: largest stretch %.3f\n", s / kShapes, largestStretch(stretch));
  }

  std::vector<double> distances;
  ease::sampleCloth(state.positions, cloth.triangles(), edges, samples);
  finder.distances(body.at(kShapes), samples, distances);
  double grown = 0.0, first = 0.0;
  for (double area : cloth.restAreas()) grown += area;
  for (int t = 0; t < cloth.triangleCount(); ++t) first += ease::triangleArea(shirt.positions, shirt.triangles, t);
  std::printf("the rest shape has grown by %.2f %%; nearest sample %.2f mm from the body\n",
              100.0 * (grown / first - 1.0), 1e3 * *std::min_element(distances.begin(), distances.end()));
}
