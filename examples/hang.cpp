// A square of cloth hangs by its two upper corners.  Prints how far the middle of its upper edge sags.
#include <ease/solver/linear/gradient_system.h>
#include <ease/solver/step/time_step.h>

#include <cstdio>

#include "square_sheet.h"

int main() {
  const int n = 20;  // cells along a side
  const ease::TriangleMesh sheet = squareSheet(n, 1.0, {1, 0, 0}, {0, 1, 0});

  // What the cloth is made of: by default 0.15 kg/m^2 and 800 N/m along warp and weft; its warp runs downwards.
  const ease::Material material;
  const ease::Cloth cloth(sheet, {0, -1, 0}, material);

  // The linear systems of a time step are ordered once for a mesh.  By default the method is `auto`.
  const std::vector<int> ordering = ease::systemOrdering(cloth.vertexCount(), cloth.triangles());
  ease::TimeStep time_step(cloth, ease::MethodOptions(), ordering);

  const int left = n * (n + 1), right = left + n, middle = left + n / 2;
  const ease::Pins pins{{left, right}, {sheet.positions.row(left), sheet.positions.row(right)}};
  const auto touch_nothing = [](const ease::Positions&, ease::Contacts&) {};

  ease::State state{sheet.positions, ease::Positions::Zero(cloth.vertexCount(), 3)};
  ease::StepOptions options;
  options.h = 0.01;  // s
  for (int step = 1; step <= 300; ++step) {
    time_step.step(state, options, pins, touch_nothing);
    if (step % 50 == 0)
      std::printf("%.1f s: sags by %.4f m\n", step * options.h,
                  sheet.positions(middle, 1) - state.positions(middle, 1));
  }
}
