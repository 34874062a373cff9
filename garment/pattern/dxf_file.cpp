#include "garment/pattern/dxf_file.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace ease {
namespace {

constexpr double kTextHeight = 2.5;  // mm
constexpr double kCorner = 15.0;     // degrees: a larger turn of the cut line is a corner

/// ASCII for the letters U+00C0 to U+00FF, by which they are spelt where there is no better.
constexpr const char* kSpelt[] = {"A", "A", "A", "A", "Ae", "A", "Ae", "C", "E", "E", "E", "E", "I",  "I", "I",  "I",
                                  "D", "N", "O", "O", "O",  "O", "Oe", "x", "O", "U", "U", "U", "Ue", "Y", "Th", "ss",
                                  "a", "a", "a", "a", "ae", "a", "ae", "c", "e", "e", "e", "e", "i",  "i", "i",  "i",
                                  "d", "n", "o", "o", "o",  "o", "oe", "/", "o", "u", "u", "u", "ue", "y", "th", "y"};

static_assert(std::size(kSpelt) == 64);

/// A text in UTF-8 without letters that the format lacks; a question mark for what cannot be spelt.
std::string ascii(const std::string& words) {
  std::string text;
  for (size_t i = 0; i < words.size(); ++i) {
    const auto c = static_cast<unsigned char>(words[i]);
    if (c < 0x80)
      text += words[i];
    else if (c == 0xC3 && i + 1 < words.size())
      text += kSpelt[static_cast<unsigned char>(words[++i]) & 0x3F];
    else if ((c & 0xC0) != 0x80)  // the first byte of a letter
      text += '?';
  }
  return text;
}

/// A name of a block: at most 31 letters, digits and underscores, as R12 allows.
std::string blockName(const DrawnPiece& piece) {
  std::string name;
  for (const char c : ascii(piece.name)) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return fmt::format("{}_{}", piece.number, name).substr(0, 31);
}

class DxfWriter {
 public:
  std::string write(const Drawing& drawing) {
    group(999, "sewing pattern in millimetres");
    section("HEADER");
    variable("$ACADVER", 1, "AC1009");
    variable("$INSUNITS", 70, "4");
    variable("$MEASUREMENT", 70, "1");
    variable("$CLAYER", 8, "1");
    corner("$EXTMIN", 0.0, 0.0);
    corner("$EXTMAX", drawing.width, drawing.height);
    end("ENDSEC");
    tables();
    section("BLOCKS");
    for (const DrawnPiece& piece : drawing.pieces) block(drawing, piece);
    end("ENDSEC");
    section("ENTITIES");
    text("1", {0.0, -10.0}, "STYLE NAME: " + ascii(drawing.title));
    text("1", {0.0, -15.0}, "UNITS: METRIC");
    text("1", {0.0, -20.0}, "SAMPLE SIZE: 1");
    text("1", {0.0, -25.0}, "AUTHOR: Ease");
    for (const DrawnPiece& piece : drawing.pieces) {
      group(0, "INSERT");
      group(8, "1");
      group(2, blockName(piece));
      point({0.0, 0.0});
    }
    end("ENDSEC");
    group(0, "EOF");
    return std::move(text_);
  }

 private:
  void group(int code, const std::string& value) {
    fmt::format_to(std::back_inserter(text_), "{:>3}\n{}\n", code, value);
  }
  void number(int code, double value) { group(code, fmt::format("{:.4f}", value)); }
  void section(const char* name) {
    group(0, "SECTION");
    group(2, name);
  }
  void end(const char* what) { group(0, what); }
  void variable(const char* name, int code, const char* value) {
    group(9, name);
    group(code, value);
  }
  void corner(const char* name, double x, double y) {
    group(9, name);
    point({x, y});
  }
  void point(const PaperPoint& at, double z = 0.0) {
    number(10, at.x());
    number(20, at.y());
    number(30, z);
  }

  void tables() {
    section("TABLES");
    group(0, "TABLE");
    group(2, "LTYPE");
    group(70, "1");
    group(0, "LTYPE");
    group(2, "CONTINUOUS");
    group(70, "0");
    group(3, "Solid line");
    group(72, "65");
    group(73, "0");
    number(40, 0.0);
    end("ENDTAB");
    const std::pair<const char*, const char*> layers[] = {{"1", "1"}, {"2", "7"},  {"3", "7"},  {"4", "3"}, {"7", "3"},
                                                          {"8", "5"}, {"13", "3"}, {"14", "5"}, {"15", "7"}};
    group(0, "TABLE");
    group(2, "LAYER");
    group(70, std::to_string(std::size(layers)));
    for (const auto& [name, colour] : layers) {
      group(0, "LAYER");
      group(2, name);
      group(70, "0");
      group(62, colour);
      group(6, "CONTINUOUS");
    }
    end("ENDTAB");
    group(0, "TABLE");
    group(2, "STYLE");
    group(70, "1");
    group(0, "STYLE");
    group(2, "STANDARD");
    group(70, "0");
    number(40, 0.0);
    number(41, 1.0);
    number(50, 0.0);
    group(71, "0");
    number(42, kTextHeight);
    group(3, "txt");
    group(4, "");
    end("ENDTAB");
    end("ENDSEC");
  }

  /// A text that begins at a point.
  void text(const char* layer, const PaperPoint& at, const std::string& words, double height = kTextHeight,
            double angle = 0.0) {
    group(0, "TEXT");
    group(8, layer);
    point(at);
    number(40, height);
    group(1, words);
    if (angle != 0.0) number(50, angle);
  }

  /// A text about the middle of its baseline.
  void centred(const char* layer, const DrawnText& drawn) {
    text(layer, drawn.at, ascii(drawn.words), drawn.height, drawn.angle);
    group(72, "1");
    number(11, drawn.at.x());
    number(21, drawn.at.y());
    number(31, 0.0);
  }

  void polyline(const char* layer, const std::vector<PaperPoint>& points, bool is_closed) {
    group(0, "POLYLINE");
    group(8, layer);
    group(66, "1");
    point({0.0, 0.0});
    group(70, is_closed ? "1" : "0");
    for (const PaperPoint& at : points) {
      group(0, "VERTEX");
      group(8, layer);
      point(at);
    }
    group(0, "SEQEND");
    group(8, layer);
  }

  void mark(const char* layer, const PaperPoint& at, double z = 0.0) {
    group(0, "POINT");
    group(8, layer);
    point(at, z);
  }

  void block(const Drawing& drawing, const DrawnPiece& piece) {
    group(0, "BLOCK");
    group(8, "1");
    group(2, blockName(piece));
    group(70, "0");
    point({0.0, 0.0});
    group(3, blockName(piece));
    polyline("1", piece.cut, true);
    const size_t n = piece.cut.size();
    for (size_t i = 0; i < n; ++i) {
      const PaperPoint a = piece.cut[i] - piece.cut[(i + n - 1) % n], b = piece.cut[(i + 1) % n] - piece.cut[i];
      const double turn = std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b))) * 180.0 / M_PI;
      mark(turn > kCorner ? "2" : "3", piece.cut[i]);
    }
    polyline("14", piece.sew, true);
    for (const Notch& notch : piece.notches) {
      mark("4", notch.at, notch.depth);
      number(50, std::atan2(notch.inward.y(), notch.inward.x()) * 180.0 / M_PI);
    }
    for (const DrawnLine& line : piece.lines) {
      if (line.ink == Ink::inner) polyline("8", line.points, line.is_closed);
      if (line.ink == Ink::grain && line.points.size() == 2) {
        group(0, "LINE");
        group(8, "7");
        point(line.points[0]);
        number(11, line.points[1].x());
        number(21, line.points[1].y());
        number(31, 0.0);
      }
    }
    for (const PaperPoint& at : piece.drills) mark("13", at);
    const PaperPoint middle = piece.texts.empty() ? piece.cut.front() : piece.texts.front().at;
    const std::string words[] = {"PIECE NAME: " + ascii(piece.name), "SIZE: 1",
                                 piece.mirrored ? "QUANTITY: 1,1" : "QUANTITY: " + std::to_string(piece.quantity),
                                 "STYLE NAME: " + ascii(drawing.title)};
    for (size_t i = 0; i < std::size(words); ++i)
      text("1", middle - PaperPoint(0.0, 20.0 + 4.0 * static_cast<double>(i)), words[i]);
    for (const DrawnText& drawn : piece.texts) centred("15", drawn);
    group(0, "ENDBLK");
    group(8, "1");
  }

  std::string text_;
};

}  // namespace

std::string dxfText(const Drawing& drawing) {
  return DxfWriter().write(drawing);
}

}  // namespace ease
