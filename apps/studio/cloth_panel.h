// What the cloth is: its material, how far it may be stretched, how finely it is divided.
#pragma once

#include <QDoubleSpinBox>
#include <QWidget>
#include <vector>

#include "apps/studio/studio.h"

namespace ease {

class ClothPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ClothPanel(Studio& studio, QWidget* parent = nullptr);

  /// Shows what the scene says now.
  void showScene();

 Q_SIGNALS:
  void used();

 private:
  /// A number of the scene that can be changed here.
  struct Entry {
    const char *name, *label, *unit, *path, *key, *tip;
    double low, high, step;
    int decimals;
    double (*of)(const Scene&);
  };
  static const std::vector<Entry>& entries();
  void change(const Entry& entry, double value);

  Studio& studio_;
  std::vector<QDoubleSpinBox*> boxes_;
};

}  // namespace ease
