// Look and behaviour of the page of a run.
#pragma once

namespace ease {

/// On narrow screens the four sides stand two by two.
constexpr const char* kPageStyle = R"(
:root { color-scheme: light; }
body { font: 16px/1.5 system-ui, sans-serif; color: #222; background: #fbfbf9; max-width: 1160px; margin: 0 auto;
  padding: 0 16px 48px; }
h1 { margin: 24px 0 8px; } h2 { margin: 40px 0 8px; border-bottom: 1px solid #ccc; } h3 { margin: 20px 0 4px; }
h4 { margin: 12px 0 4px; font-weight: 600; }
.verdict { font-size: 20px; padding: 12px 16px; border-left: 6px solid; background: #fff; margin: 8px 0; }
.good { border-color: #2b6ca3; } .fair { border-color: #d98a1f; } .bad { border-color: #a32b2b; }
.figures { display: flex; flex-wrap: wrap; gap: 8px 32px; margin: 12px 0; }
.figures dt { color: #666; font-size: 14px; } .figures dd { margin: 0; font-size: 22px; }
figure { margin: 0; } figcaption { color: #666; font-size: 14px; text-align: center; }
img { width: 100%; height: auto; display: block; }
.sides { display: grid; grid-template-columns: repeat(4, 1fr); gap: 8px; }
.motion { max-width: 520px; } .motion figure { display: none; } .motion .now { display: block; }
.motion input { width: 100%; }
.legend { width: 420px; max-width: 100%; display: block; margin: 4px 0; }
.legend text, .charts text { font: 11px system-ui, sans-serif; fill: #444; } .mark { stroke: #000; }
.crumpled { margin: 0 0 4px; font-size: 13px; color: #444; }
.crumpled span { display: inline-block; width: 28px; height: 12px; }
.wide { overflow-x: auto; } table { border-collapse: collapse; font-size: 15px; }
td, th { padding: 3px 12px; border-bottom: 1px solid #ddd; text-align: right; font-weight: 400; }
tr:first-child th { font-size: 13px; color: #555; vertical-align: bottom; } th:first-child { text-align: left; white-space: nowrap; }
tr:last-child { font-weight: 600; }
.charts { display: grid; grid-template-columns: 1fr 1fr; gap: 16px; }
.charts .title { font-size: 13px; } .charts .y { text-anchor: end; } .charts .x { text-anchor: middle; }
.line { fill: none; stroke-width: 1.6; } .grid { stroke: #e2e2de; } .limit { stroke: #a32b2b; stroke-dasharray: 5 4; }
pre { background: #f2f2ee; padding: 12px; overflow-x: auto; font-size: 13px; }
@media (max-width: 640px) { .sides { grid-template-columns: 1fr 1fr; } .charts { grid-template-columns: 1fr; } }
@page { size: A4; margin: 14mm; }
@media print { body { background: #fff; font-size: 12px; padding: 0; print-color-adjust: exact; }
  .motion { max-width: 320px; } .motion input { display: none; } .figures dd { font-size: 16px; }
  figure, svg, .wide, .sides, .verdict { break-inside: avoid; }
  h2, h2 + p, h3, h4, .legend, .crumpled { break-after: avoid; } }
)";

/// The slider shows one moment of the motion; fit.html#moment=5 opens the page at the sixth.
constexpr const char* kPageScript = R"(
const motion = document.getElementById("motion");
if (motion) {
  const moments = motion.querySelectorAll("figure"), slider = motion.querySelector("input");
  const show = () => {
    moments.forEach((m, k) => m.classList.toggle("now", k === Number(slider.value)));
    document.documentElement.dataset.moment = slider.value;
  };
  slider.addEventListener("input", show);
  const asked = location.hash.match(/^#moment=(\d+)$/);
  if (asked) slider.value = asked[1];
  show();
}
window.addEventListener("load", () => {
  const empty = Array.from(document.images).filter((picture) => picture.naturalWidth === 0);
  document.documentElement.dataset.emptyPictures = empty.length;
});
)";

}  // namespace ease
