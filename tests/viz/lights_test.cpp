#include "viz/lights.h"

#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <catch2/catch.hpp>

TEST_CASE("two lamps stand beside the camera, the brighter one on the left") {
  vtkNew<vtkRenderer> renderer;
  ease::addLights(renderer);
  vtkLightCollection* lights = renderer->GetLights();
  REQUIRE(lights->GetNumberOfItems() == 2);
  auto* left = vtkLight::SafeDownCast(lights->GetItemAsObject(0));
  auto* right = vtkLight::SafeDownCast(lights->GetItemAsObject(1));
  CHECK(left->LightTypeIsCameraLight());
  CHECK(left->GetPosition()[0] < 0.0);
  CHECK(right->GetPosition()[0] > 0.0);
  CHECK(left->GetIntensity() > right->GetIntensity());
}
