#include "apps/studio/tool_panel.h"

#include <QSignalBlocker>
#include <QVBoxLayout>

#include "apps/studio/number_box.h"

namespace ease {

ToolPanel::ToolPanel(Studio& studio, QWidget* parent) : QWidget(parent), studio_(studio) {
  auto* column = new QVBoxLayout(this);
  does_ = new QLabel;
  does_->setWordWrap(true);
  form_ = new QFormLayout;
  form_->setRowWrapPolicy(QFormLayout::WrapLongRows);
  column->addLayout(form_);
  column->addWidget(does_);
  column->addStretch();
  radius_ = addNumber("radius", "Radius", " cm", 0.0, 100.0, 1.0,
                      "radius of the brush: full strength within half of it, then fading");
  scale_ =
      addNumber("scale", "Cloth", " times", 1.01, 2.0, 0.01, "how many times as long the cloth is under the brush");
  offset_ = addNumber("offset", "Distance", " mm", 0.0, 100.0, 1.0, "least distance from the body under the brush");
  mirror_ = new QCheckBox("Mirror left and right");
  mirror_->setObjectName("mirror");
  mirror_->setToolTip("Draws the same on the other side of the body (M)");
  form_->addRow(mirror_);
  connect(mirror_, &QCheckBox::toggled, this, [this](bool on) {
    studio_.settings.mirror = on;
    Q_EMIT changed();
  });
  const auto bind = [this](QDoubleSpinBox* box, double ToolSettings::*value, double unit) {
    connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this, value, unit](double x) {
      studio_.settings.*value = x * unit;
      Q_EMIT changed();
    });
  };
  bind(radius_, &ToolSettings::radius, 0.01);
  bind(scale_, &ToolSettings::scale, 1.0);
  bind(offset_, &ToolSettings::offset, 0.001);
  showSettings();
}

QDoubleSpinBox* ToolPanel::addNumber(const char* name, const QString& label, const QString& unit, double low,
                                     double high, double step, const QString& tip) {
  auto* box = new NumberBox;
  box->setObjectName(name);
  box->setRange(low, high);
  box->setSingleStep(step);
  box->setSuffix(unit);
  box->setToolTip(tip);
  form_->addRow(label, box);
  return box;
}

void ToolPanel::setTool(PartKind kind) {
  does_->setText(textOf(kind).does);
  const auto show = [this](QWidget* box, bool is_used) {
    box->setVisible(is_used);
    form_->labelForField(box)->setVisible(is_used);
  };
  show(radius_, kind == PartKind::paint || kind == PartKind::comfort || kind == PartKind::pin);
  show(scale_, kind == PartKind::paint);
  show(offset_, kind == PartKind::comfort);
  mirror_->setEnabled(kind != PartKind::region);
}

void ToolPanel::showSettings() {
  const ToolSettings& set = studio_.settings;
  const auto show = [](QDoubleSpinBox* box, double value) {
    const QSignalBlocker block(box);
    box->setValue(value);
  };
  show(radius_, 100.0 * set.radius);
  show(scale_, set.scale);
  show(offset_, 1000.0 * set.offset);
  const QSignalBlocker block(mirror_);
  mirror_->setChecked(set.mirror);
}

}  // namespace ease
