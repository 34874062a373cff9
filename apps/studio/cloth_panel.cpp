#include "apps/studio/cloth_panel.h"

#include <fmt/format.h>

#include <QFormLayout>
#include <QSignalBlocker>
#include <cmath>

#include "apps/studio/number_box.h"

namespace ease {

const std::vector<ClothPanel::Entry>& ClothPanel::entries() {
  static const std::vector<Entry> kEntries = {
      {"limit", "Limit", " %", "adaption", "limit", "how far the cloth may be stretched in comfort", 1.0, 50.0, 1.0, 1,
       [](const Scene& scene) { return 100.0 * (scene.adaption ? scene.adaption->limit : AdaptionScene().limit); }},
      {"density", "Weight", " g/m²", "material", "density", "mass of the cloth per area", 10.0, 2000.0, 10.0, 0,
       [](const Scene& scene) { return 1000.0 * scene.material.density; }},
      {"stretch_warp", "Stretch, warp", " N/m", "material", "stretch", "stiffness along the warp", 0.0, 1e5, 50.0, 0,
       [](const Scene& scene) { return scene.material.stretch_warp; }},
      {"stretch_weft", "Stretch, weft", " N/m", "material", "stretch", "stiffness along the weft", 0.0, 1e5, 50.0, 0,
       [](const Scene& scene) { return scene.material.stretch_weft; }},
      {"shear", "Shear", " N/m", "material", "shear", "stiffness against shearing", 0.0, 1e5, 20.0, 0,
       [](const Scene& scene) { return scene.material.shear; }},
      {"friction", "Friction", "", "collision", "friction", "coefficient between cloth and body", 0.0, 2.0, 0.05, 2,
       [](const Scene& scene) { return scene.collision.friction; }},
      {"resolution", "Vertices", "", "garment", "resolution",
       "about how many the garment gets; more take longer to simulate", 300.0, 40000.0, 500.0, 0,
       [](const Scene& scene) { return scene.garment.tools ? double(scene.garment.tools->resolution) : 3000.0; }}};
  return kEntries;
}

ClothPanel::ClothPanel(Studio& studio, QWidget* parent) : QWidget(parent), studio_(studio) {
  auto* form = new QFormLayout(this);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  for (const Entry& entry : entries()) {
    auto* box = new NumberBox;
    box->setObjectName(entry.name);
    box->setDecimals(entry.decimals);
    box->setRange(entry.low, entry.high);
    box->setSingleStep(entry.step);
    box->setSuffix(QString::fromUtf8(entry.unit));
    box->setToolTip(entry.tip);
    box->setKeyboardTracking(false);
    form->addRow(entry.label, box);
    boxes_.push_back(box);
    connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
            [this, &entry](double value) { change(entry, value); });
  }
  showScene();
}

void ClothPanel::showScene() {
  for (size_t k = 0; k < boxes_.size(); ++k) {
    const QSignalBlocker block(boxes_[k]);
    boxes_[k]->setValue(entries()[k].of(studio_.scene()));
    const std::string key = entries()[k].key;
    boxes_[k]->setEnabled(studio_.scene().material.membrane == Membrane::woven || (key != "stretch" && key != "shear"));
  }
}

void ClothPanel::change(const Entry& entry, double value) {
  SceneText text(studio_.text());
  const std::string name = entry.name;
  const Material& material = studio_.scene().material;
  if (name == "stretch_warp" || name == "stretch_weft") {
    const double warp = name == "stretch_warp" ? value : material.stretch_warp;
    const double weft = name == "stretch_weft" ? value : material.stretch_weft;
    text.setValue(entry.path, 0, entry.key, fmt::format("[{}, {}]", tomlNumber(warp), tomlNumber(weft)));
  } else if (name == "resolution") {
    text.removeValue(entry.path, 0, "edge_length");
    text.setValue(entry.path, 0, entry.key, std::to_string(std::lround(value)));
  } else {
    const double unit = name == "limit" ? 0.01 : name == "density" ? 0.001 : 1.0;
    text.setValue(entry.path, 0, entry.key, tomlNumber(value * unit));
  }
  if (!studio_.gesture(text.text(), std::string("change of ") + entry.label)) showScene();
  Q_EMIT used();
}

}  // namespace ease
