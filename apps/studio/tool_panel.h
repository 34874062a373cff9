// The settings of the tool: radius, how much, mirrored or not.
#pragma once

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QWidget>

#include "apps/studio/tool.h"

namespace ease {

class ToolPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ToolPanel(Studio& studio, QWidget* parent = nullptr);

  /// Shows the settings that this tool uses.
  void setTool(PartKind kind);
  /// Shows what the settings are now.
  void showSettings();

 Q_SIGNALS:
  void changed();

 private:
  QDoubleSpinBox* addNumber(const char* name, const QString& label, const QString& unit, double low, double high,
                            double step, const QString& tip);

  Studio& studio_;
  QFormLayout* form_;
  QLabel* does_;
  QDoubleSpinBox *radius_, *scale_, *offset_;
  QCheckBox* mirror_;
};

}  // namespace ease
