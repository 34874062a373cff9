// The text of the scene, with the lines marked that changed last.  It is read here, not written: gestures edit it.
#pragma once

#include <QPlainTextEdit>

namespace ease {

class ScenePanel : public QPlainTextEdit {
  Q_OBJECT

 public:
  explicit ScenePanel(QWidget* parent = nullptr);
  void show(const QString& text);

 private:
  QString before_;
};

}  // namespace ease
