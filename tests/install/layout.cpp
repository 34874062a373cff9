// Prints how this program, compiled with its own flags, lays out types that it shares with the library: the same for
// any instruction set.
#include <ease/collision/moving_body.h>
#include <ease/solver/step/time_step.h>

#include <iostream>

template <class Type>
void print(const char* name) {
  std::cout << name << ' ' << sizeof(Type) << ' ' << alignof(Type) << '\n';
}

int main() {
  print<ease::Vec3>("Vec3");
  print<ease::Mat2>("Mat2");
  print<ease::Mat32>("Mat32");
  print<ease::Lanes>("Lanes");
  print<ease::Positions>("Positions");
  print<ease::Cloth>("Cloth");
  print<ease::ContactPlane>("ContactPlane");
  print<ease::StepOptions>("StepOptions");
  print<ease::IncrementalPotential>("IncrementalPotential");
  print<ease::TimeStep>("TimeStep");
  print<ease::ContactFinder>("ContactFinder");
  print<ease::MovingBody>("MovingBody");
  std::cout << "allocation " << EIGEN_DEFAULT_ALIGN_BYTES << '\n';
}
