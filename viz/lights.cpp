#include "viz/lights.h"

#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

namespace ease {

void addLights(vtkRenderer* renderer) {
  struct Lamp {
    double x, y, z, intensity;  // direction towards the lamp in the camera's frame
  };
  renderer->AutomaticLightCreationOff();
  for (const Lamp& lamp : {Lamp{-0.6, 0.8, 1.0, 1.1}, Lamp{0.9, 0.1, 0.6, 0.35}}) {
    vtkNew<vtkLight> light;
    light->SetLightTypeToCameraLight();
    light->SetPosition(lamp.x, lamp.y, lamp.z);
    light->SetIntensity(lamp.intensity);
    renderer->AddLight(light);
  }
}

}  // namespace ease
