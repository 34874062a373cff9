#include "viz/overlay.h"

#include <vtkActor2D.h>
#include <vtkCellData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkPropCollection.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <catch2/catch.hpp>

namespace {

/// What an overlay holds, of one kind, in the order in which it was drawn.
template <class Actor>
std::vector<Actor*> drawn(const ease::Overlay& overlay) {
  std::vector<Actor*> actors;
  vtkPropCollection* props = overlay.renderer()->GetViewProps();
  for (int i = 0; i < props->GetNumberOfItems(); ++i)
    if (auto* actor = Actor::SafeDownCast(props->GetItemAsObject(i))) actors.push_back(actor);
  return actors;
}

std::vector<std::string> wordsOf(const ease::Overlay& overlay) {
  std::vector<std::string> words;
  for (vtkTextActor* actor : drawn<vtkTextActor>(overlay)) words.emplace_back(actor->GetInput());
  return words;
}

vtkTextActor* find(const ease::Overlay& overlay, const std::string& words) {
  for (vtkTextActor* actor : drawn<vtkTextActor>(overlay))
    if (actor->GetInput() == words) return actor;
  FAIL("no text \"" << words << "\"");
  return nullptr;
}

/// The boxes of the n-th call of Overlay::boxes, as VTK has them.
vtkPolyData* boxesOf(const ease::Overlay& overlay, int n) {
  std::vector<vtkPolyData*> all;
  for (vtkActor2D* actor : drawn<vtkActor2D>(overlay))
    if (auto* mapper = vtkPolyDataMapper2D::SafeDownCast(actor->GetMapper());
        mapper && !vtkTextActor::SafeDownCast(actor))
      all.push_back(mapper->GetInput());
  REQUIRE(static_cast<int>(all.size()) > n);
  return all[n];
}

const ease::Box kBar = {100, 60, 700, 20};

}  // namespace

TEST_CASE("text and boxes stand where the picture's pixels say, at every scale") {
  const int scale = GENERATE(1, 2);
  ease::Overlay overlay(scale);
  overlay.text(30, 40, ease::Align::center, "words", {16, {200, 100, 0}, true});
  overlay.boxes({{1, 2, 3, 4}, {10, 20, 30, 40}}, {{255, 0, 0}, {0, 128, 255}});
  vtkTextActor* text = find(overlay, "words");
  CHECK(text->GetPosition()[0] == 30.0 * scale);
  CHECK(text->GetPosition()[1] == 40.0 * scale);
  CHECK(text->GetTextProperty()->GetFontSize() == 16 * scale);
  CHECK(text->GetTextProperty()->GetBold() == 1);
  CHECK(text->GetTextProperty()->GetJustification() == VTK_TEXT_CENTERED);
  CHECK(text->GetTextProperty()->GetColor()[1] == Approx(100.0 / 255.0));

  vtkPolyData* boxes = boxesOf(overlay, 0);
  REQUIRE(boxes->GetNumberOfCells() == 2);
  double bounds[6];
  boxes->GetCellBounds(1, bounds);
  CHECK(bounds[0] == 10.0 * scale);
  CHECK(bounds[1] == 40.0 * scale);
  CHECK(bounds[2] == 20.0 * scale);
  CHECK(bounds[3] == 60.0 * scale);
  CHECK(boxes->GetCellData()->GetScalars()->GetComponent(1, 2) == 255.0);
}

TEST_CASE("a scale bar has its colours from end to end, round numbers below, its label and the limit") {
  ease::Overlay overlay(1);
  const ease::ColorScale scale(0.95, 1.3, 1.09);
  ease::drawScaleBar(overlay, scale, "largest principal stretch", kBar);
  CHECK(wordsOf(overlay) == std::vector<std::string>{"0.95", "1.00", "1.05", "1.10", "1.15", "1.20", "1.25", "1.30",
                                                     "limit 1.09", "largest principal stretch"});
  // A number stands below its place on the bar, the limit above.
  CHECK(find(overlay, "0.95")->GetPosition()[0] == Approx(kBar.x));
  CHECK(find(overlay, "1.20")->GetPosition()[0] == Approx(kBar.x + kBar.width * 0.25 / 0.35));
  CHECK(find(overlay, "1.20")->GetPosition()[1] < kBar.y);
  CHECK(find(overlay, "limit 1.09")->GetPosition()[0] == Approx(kBar.x + kBar.width * 0.14 / 0.35));
  CHECK(find(overlay, "limit 1.09")->GetPosition()[1] > kBar.y + kBar.height);

  vtkPolyData* bar = boxesOf(overlay, 0);
  REQUIRE(bar->GetNumberOfCells() == 700);
  const auto colorAt = [&](int i) {
    ease::Rgb color;
    for (int k = 0; k < 3; ++k)
      color[k] = static_cast<std::uint8_t>(bar->GetCellData()->GetScalars()->GetComponent(i, k));
    return color;
  };
  for (const int i : {0, 100, 279, 280, 699}) CHECK(colorAt(i) == scale.color(0.95 + 0.35 * (i + 0.5) / 700));
  CHECK(colorAt(279)[2] > colorAt(279)[0]);  // blue up to the limit, orange beyond
  CHECK(colorAt(280)[0] > colorAt(280)[2]);
}

TEST_CASE("a scale bar's numbers are one, two or five times a power of ten apart, at most nine, zero without a sign") {
  const auto numbers = [](double low, double high) {
    ease::Overlay overlay(1);
    ease::drawScaleBar(overlay, ease::ColorScale(low, high, high), "", kBar);  // the limit is an end: not drawn
    std::vector<std::string> words = wordsOf(overlay);
    words.pop_back();  // the label
    return words;
  };
  CHECK(numbers(0.0, 8.0) == std::vector<std::string>{"0", "1", "2", "3", "4", "5", "6", "7", "8"});
  CHECK(numbers(0.0, 0.01) == std::vector<std::string>{"0.000", "0.002", "0.004", "0.006", "0.008", "0.010"});
  CHECK(numbers(-20.0, 25.0) == std::vector<std::string>{"-20", "-10", "0", "10", "20"});
  CHECK(numbers(1.0, 5000.0) == std::vector<std::string>{"1000", "2000", "3000", "4000", "5000"});
}
