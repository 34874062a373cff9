#include "viz/rendered_file.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include "solver/base/error.h"
#include "solver/base/whole_file.h"
#include "viz/offscreen.h"
#include "viz/quiet.h"

namespace ease {

namespace {

constexpr int kLevelStep = 3;  // of 255 levels; invisible, and files are a third smaller

/// Returns the window's pixels, each of them the mean of the samples rendered for it.
vtkSmartPointer<vtkImageData> averagedPixels(vtkRenderWindow* window, int width, int height) {
  vtkNew<vtkUnsignedCharArray> samples;
  window->GetPixelData(0, 0, kSamplesPerPixel * width - 1, kSamplesPerPixel * height - 1, 0, samples);
  if (samples->GetNumberOfTuples() != kSamplesPerPixel * width * kSamplesPerPixel * height) {
    throw ComputationError("OpenGL gave no pixels back");
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* out = static_cast<unsigned char*>(image->GetScalarPointer());
  const unsigned char* in = samples->GetPointer(0);
  const int row_length = 3 * kSamplesPerPixel * width;  // of the samples
  constexpr int kCount = kSamplesPerPixel * kSamplesPerPixel;
  for (int y = 0; y < height; ++y) {
    for (int i = 0; i < 3 * width; ++i) {
      const unsigned char* first = in + (kSamplesPerPixel * y) * row_length + 3 * kSamplesPerPixel * (i / 3) + i % 3;
      int sum = 0;
      for (int sy = 0; sy < kSamplesPerPixel; ++sy)
        for (int sx = 0; sx < kSamplesPerPixel; ++sx) sum += first[sy * row_length + 3 * sx];
      *out++ = static_cast<unsigned char>(kLevelStep * ((2 * sum + kCount * kLevelStep) / (2 * kCount * kLevelStep)));
    }
  }
  return image;
}

void writePng(const std::filesystem::path& file, vtkImageData* image) {
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetCompressionLevel(4);  // 6 takes twice as long for files a tenth smaller
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  writeWholeFile(file, {reinterpret_cast<const char*>(bytes->GetPointer(0)),
                        static_cast<std::size_t>(bytes->GetNumberOfValues())});
}

}  // namespace

void renderToFile(const std::filesystem::path& file, int width, int height,
                  const std::function<void(vtkRenderWindow*, Overlay&)>& compose) {
  const Quiet quiet;
  const OffscreenContext context;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  context.lend(*window);
  window->SetMultiSamples(0);
  window->SetSize(kSamplesPerPixel * width, kSamplesPerPixel * height);
  window->SetNumberOfLayers(2);
  window->OpenGLInitContext();
  Overlay overlay(kSamplesPerPixel);
  compose(window, overlay);
  window->AddRenderer(overlay.renderer());
  window->Render();
  writePng(file, averagedPixels(window, width, height));
  window->Finalize();
}

}  // namespace ease
