#include "viz/jpeg.h"

#include <vtkBase64Utilities.h>
#include <vtkImageData.h>
#include <vtkJPEGWriter.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

namespace ease {

std::string dataUri(const std::string& bytes, const std::string& type) {
  std::string text(4 * (bytes.size() / 3 + 1), '\0');
  const auto length = vtkBase64Utilities::Encode(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(),
                                                 reinterpret_cast<unsigned char*>(text.data()));
  text.resize(length);
  return "data:" + type + ";base64," + text;
}

std::string jpegDataUri(const Picture& picture, int quality) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(picture.size.width, picture.size.height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* out = static_cast<unsigned char*>(image->GetScalarPointer());
  for (size_t i = 0; i < picture.pixels.size(); i += 4)
    for (size_t k = 0; k < 3; ++k) *out++ = picture.pixels[i + k];
  vtkNew<vtkJPEGWriter> writer;
  writer->SetInputData(image);
  writer->SetQuality(quality);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  const auto* first = bytes->GetPointer(0);
  return dataUri(std::string(first, first + bytes->GetNumberOfValues()), "image/jpeg");
}

}  // namespace ease
