#include "garment/pattern/svg_file.h"

#include <fmt/format.h>

#include <iterator>

#include "garment/pattern/sheet.h"

namespace ease {
namespace {

/// Writes into a string; y runs downwards from the upper end of the sheet.
class SvgWriter {
 public:
  explicit SvgWriter(const Drawing& drawing) : height_(drawing.height) {
    put("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
        "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" width=\"{0:.3f}mm\" height=\"{1:.3f}mm\" "
        "viewBox=\"0 0 {0:.3f} {1:.3f}\">\n<title>{2}</title>\n",
        drawing.width, drawing.height, escaped(drawing.title));
    open("paper");
    for (const DrawnLine& line : drawing.lines) path(line);
    for (const DrawnText& text : drawing.texts) words(text);
    close();
    for (const DrawnPiece& p : drawing.pieces) piece(p);
    put("</svg>\n");
  }

  std::string take() { return std::move(text_); }

 private:
  template <class... Args>
  void put(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
  }

  void open(const std::string& name) {
    put("<g inkscape:groupmode=\"layer\" inkscape:label=\"{0}\">\n", escaped(name));
  }
  void close() { put("</g>\n"); }

  void path(const DrawnLine& line) {
    put("<path fill=\"none\" stroke=\"#{:06x}\" stroke-width=\"0.35\" d=\"", colourOf(line.ink));
    for (size_t i = 0; i < line.points.size(); ++i)
      put("{}{:.3f},{:.3f}", i == 0 ? "M" : " L", line.points[i].x(), height_ - line.points[i].y());
    put("{}\"/>\n", line.is_closed ? " Z" : "");
  }

  void words(const DrawnText& text) {
    const double x = text.at.x(), y = height_ - text.at.y();
    put("<text x=\"{0:.2f}\" y=\"{1:.2f}\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"{2:.2f}\" "
        "text-anchor=\"middle\"",
        x, y, text.height / 0.718);
    if (text.angle != 0.0) put(" transform=\"rotate({:.2f} {:.2f} {:.2f})\"", -text.angle, x, y);
    put(">{}</text>\n", escaped(text.words));
  }

  void piece(const DrawnPiece& piece) {
    open(piece.name);
    open("cut");
    path({Ink::cut, piece.cut, true});
    close();
    open("sew");
    path({Ink::sew, piece.sew, true});
    close();
    open("notch");
    for (const Notch& notch : piece.notches) path(notchLine(notch));
    for (const PaperPoint& hole : piece.drills)
      put("<circle cx=\"{:.3f}\" cy=\"{:.3f}\" r=\"1.5\" fill=\"none\" stroke=\"#{:06x}\" stroke-width=\"0.35\"/>\n",
          hole.x(), height_ - hole.y(), colourOf(Ink::drill));
    close();
    open("grain");
    for (const DrawnLine& line : piece.lines)
      if (line.ink == Ink::grain) path(line);
    close();
    open("text");
    for (const DrawnText& text : piece.texts) words(text);
    close();
    close();
  }

  double height_;
  std::string text_;
};

}  // namespace

int colourOf(Ink ink) {
  switch (ink) {
    case Ink::cut:
      return 0xd00000;
    case Ink::sew:
      return 0x0040d0;
    case Ink::inner:
      return 0x0040d0;
    case Ink::notch:
    case Ink::drill:
    case Ink::grain:
      return 0x008030;
    case Ink::paper:
      return 0x000000;
  }
  return 0;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) switch (c) {
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '&':
        result += "&amp;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  return result;
}

std::string svgText(const Drawing& drawing) {
  return SvgWriter(drawing).take();
}

}  // namespace ease
