// How many pixels of a PNG file are white, blue or orange, the hues of a scale below and above its limit.
#pragma once

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <catch2/catch.hpp>
#include <filesystem>

namespace test {

struct Pixels {
  int width = 0, height = 0;
  int white = 0, blue = 0, orange = 0;

  explicit Pixels(const std::filesystem::path& file) {
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    vtkImageData* image = reader->GetOutput();
    width = image->GetDimensions()[0];
    height = image->GetDimensions()[1];
    REQUIRE(image->GetNumberOfScalarComponents() == 3);
    const auto* pixel = static_cast<const unsigned char*>(image->GetScalarPointer());
    for (int i = 0; i < width * height; ++i, pixel += 3) {
      if (pixel[0] == 255 && pixel[1] == 255 && pixel[2] == 255) ++white;
      if (pixel[2] > pixel[0] + 40) ++blue;
      if (pixel[0] > pixel[2] + 80) ++orange;
    }
  }
};

}  // namespace test
