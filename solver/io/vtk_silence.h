// Keeps VTK from printing messages about files that it cannot read, and stores these messages.
#pragma once

#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <mutex>
#include <string>

namespace ease {

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
inline vtkStandardNewMacro(MessageKeeper);

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

}  // namespace ease
