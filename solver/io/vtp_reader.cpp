#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <exception>
#include <mutex>

#include "solver/base/error.h"
#include "solver/io/mesh_readers.h"

namespace ease {
namespace {

/// Stores VTK's messages instead of printing them.
class MessageKeeper : public vtkOutputWindow {
 public:
  static MessageKeeper* New();
  void DisplayText(const char*) override {}
  void DisplayErrorText(const char* text) override { errors_ += text; }

  /// Sentence of the first error. VTK writes an error as "ERROR: In file, line n\nclass (address): sentence".
  std::string firstSentence() const {
    const std::size_t line_end = errors_.find('\n');
    if (line_end == std::string::npos) return errors_;
    std::string sentence = errors_.substr(line_end + 1, errors_.find('\n', line_end + 1) - line_end - 1);
    if (const std::size_t address_end = sentence.find("): "); address_end != std::string::npos) {
      sentence.erase(0, address_end + 3);
    }
    return sentence;
  }
  bool hasError() const { return !errors_.empty(); }

 private:
  std::string errors_;
};
vtkStandardNewMacro(MessageKeeper);

/// Replaces VTK's global message window by a MessageKeeper during its lifetime. It also turns off VTK's log to the
/// terminal for that time.
class Silence {
 public:
  Silence()
      : lock_(mutex()),
        former_window_(vtkOutputWindow::GetInstance()),
        former_verbosity_(vtkLogger::GetCurrentVerbosityCutoff()) {
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    vtkOutputWindow::SetInstance(keeper);
  }
  ~Silence() {
    vtkOutputWindow::SetInstance(former_window_);
    vtkLogger::SetStderrVerbosity(former_verbosity_);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

  vtkNew<MessageKeeper> keeper;

 private:
  static std::mutex& mutex() {
    static std::mutex only_one;
    return only_one;
  }
  std::lock_guard<std::mutex> lock_;
  vtkSmartPointer<vtkOutputWindow> former_window_;
  vtkLogger::Verbosity former_verbosity_;
};

void addPolygons(vtkCellArray& polygons, const std::string& name, RawMesh& mesh) {
  std::vector<long long> corners;
  for (vtkIdType cell = 0; cell < polygons.GetNumberOfCells(); ++cell) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    polygons.GetCellAtId(cell, count, ids);
    if (count < 3) throw InputError(fmt::format("{}: polygon {} has {} vertices", name, cell, count));
    corners.assign(ids, ids + count);
    mesh.addPolygon(corners);
  }
}

}  // namespace

RawMesh readVtp(std::string_view bytes, const std::string& name) {
  checkVtpCounts(bytes, name);
  const Silence silence;
  const vtkNew<vtkXMLPolyDataReader> reader;
  try {
    reader->ReadFromInputStringOn();
    reader->SetInputString(std::string(bytes));
    reader->Update();
  } catch (const std::exception&) {  // out of memory: its own message does not name the file
    throw InputError(fmt::format("{}: damaged: VTK finds counts in it that cannot be", name));
  }
  if (silence.keeper->hasError()) {
    throw InputError(fmt::format("{}: not a VTP file, or damaged: {}", name, silence.keeper->firstSentence()));
  }
  vtkPolyData& data = *reader->GetOutput();
  RawMesh mesh;
  mesh.points.resize(data.GetNumberOfPoints());
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) data.GetPoint(i, mesh.points[i].data());
  addPolygons(*data.GetPolys(), name, mesh);
  for (vtkIdType strip = 0; strip < data.GetNumberOfStrips(); ++strip) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    data.GetStrips()->GetCellAtId(strip, count, ids);
    mesh.addStrip(std::vector<long long>(ids, ids + count));
  }
  return mesh;
}

}  // namespace ease
