#include "garment/pattern/pdf_file.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>

#include "garment/pattern/sheet.h"
#include "garment/pattern/svg_file.h"

namespace ease {
namespace {

constexpr double kPoint = 72.0 / 25.4;    // in a millimetre
constexpr double kLargestPage = 14400.0;  // units; larger pages have larger units
constexpr double kCapital = 0.718;        // height of a capital letter of Helvetica, of its size

// Widths of Helvetica's letters from blank to ~, thousandths of its size (Adobe's font metrics).
constexpr std::array kWidths = {278,  278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278,
                                556,  556, 556, 556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556,
                                1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833, 722, 778,
                                667,  778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469, 556,
                                333,  556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556,
                                556,  556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584};

/// UTF-8 as Latin-1, with question marks for what that lacks.
std::string latin1(const std::string& utf8) {
  std::string text;
  for (size_t i = 0; i < utf8.size(); ++i) {
    const auto c = static_cast<unsigned char>(utf8[i]);
    if (c < 0x80) {
      text += static_cast<char>(c);
    } else if (c == 0xc2 || c == 0xc3) {
      if (++i < utf8.size()) text += static_cast<char>((c == 0xc3 ? 0x40 : 0) + static_cast<unsigned char>(utf8[i]));
    } else if (c >= 0xc4) {
      text += '?';
    }
  }
  return text;
}

std::string escapedForPdf(const std::string& words) {
  std::string text;
  for (const char c : words) {
    if (c == '(' || c == ')' || c == '\\') text += '\\';
    text += c;
  }
  return text;
}

double widthOf(const std::string& words) {
  double width = 0.0;
  for (const char c : words) width += c >= ' ' && c <= '~' ? kWidths[static_cast<size_t>(c - ' ')] : 556;
  return 1e-3 * width;
}

/// Commands of a page or a form; lengths in millimetres.
class Commands {
 public:
  template <class... Args>
  void put(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
  }

  void line(const DrawnLine& line) {
    colour(line.ink, "RG");
    for (size_t i = 0; i < line.points.size(); ++i)
      put("{:.3f} {:.3f} {}\n", line.points[i].x(), line.points[i].y(), i == 0 ? "m" : "l");
    put("{}\n", line.is_closed ? "s" : "S");
  }

  void hole(const PaperPoint& at) {
    std::vector<PaperPoint> circle;
    for (int k = 0; k < 16; ++k)
      circle.push_back(at + 1.5 * PaperPoint(std::cos(k * M_PI / 8.0), std::sin(k * M_PI / 8.0)));
    line({Ink::drill, circle, true});
  }

  void words(const DrawnText& text) {
    const std::string words = latin1(text.words);
    const double size = text.height / kCapital, angle = text.angle * M_PI / 180.0, c = std::cos(angle),
                 s = std::sin(angle), half = 0.5 * size * widthOf(words);
    put("BT 0 g /F1 {:.3f} Tf {:.5f} {:.5f} {:.5f} {:.5f} {:.3f} {:.3f} Tm ({}) Tj ET\n", size, c, s, -s, c,
        text.at.x() - half * c, text.at.y() - half * s, escapedForPdf(words));
  }

  void piece(const DrawnPiece& piece) {
    line({Ink::cut, piece.cut, true});
    line({Ink::sew, piece.sew, true});
    for (const Notch& notch : piece.notches) line(notchLine(notch));
    for (const DrawnLine& drawn : piece.lines)
      if (drawn.ink == Ink::grain) line(drawn);
    for (const PaperPoint& at : piece.drills) hole(at);
    for (const DrawnText& text : piece.texts) words(text);
  }

  std::string take() { return std::move(text_); }

 private:
  void colour(Ink ink, const char* command) {
    const int rgb = colourOf(ink);
    put("{:.3f} {:.3f} {:.3f} {} ", (rgb >> 16) / 255.0, (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0, command);
  }

  std::string text_;
};

/// Numbers objects and remembers where they begin.
class PdfWriter {
 public:
  PdfWriter() { text_ = "%PDF-1.6\n%\xE2\xE3\xCF\xD3\n"; }

  /// Objects are numbered from 1, in the order of these calls.
  void object(const std::string& body) {
    starts_.push_back(text_.size());
    fmt::format_to(std::back_inserter(text_), "{} 0 obj\n{}\nendobj\n", starts_.size(), body);
  }
  void stream(const std::string& entries, const std::string& commands) {
    object(fmt::format("<< {} /Length {} >>\nstream\n{}\nendstream", entries, commands.size(), commands));
  }
  std::string finish() {
    const size_t table = text_.size();
    fmt::format_to(std::back_inserter(text_), "xref\n0 {}\n0000000000 65535 f \n", starts_.size() + 1);
    for (const size_t start : starts_) fmt::format_to(std::back_inserter(text_), "{:010} 00000 n \n", start);
    fmt::format_to(std::back_inserter(text_), "trailer\n<< /Size {} /Root 1 0 R >>\nstartxref\n{}\n%%EOF\n",
                   starts_.size() + 1, table);
    return std::move(text_);
  }

 private:
  std::string text_;
  std::vector<size_t> starts_;
};

std::string pageCommands(const PdfPage& page, double unit) {
  Commands commands;
  commands.put("{0:.9f} 0 0 {0:.9f} 0 0 cm 0.35 w 1 j\n", kPoint / unit);
  for (const PdfPage::View& view : page.views)
    commands.put("q {:.3f} {:.3f} {:.3f} {:.3f} re W n {:.6f} 0 0 {:.6f} {:.3f} {:.3f} cm /D Do Q\n", view.lower.x(),
                 view.lower.y(), view.upper.x() - view.lower.x(), view.upper.y() - view.lower.y(), view.scale,
                 view.scale, view.at.x(), view.at.y());
  for (const DrawnLine& line : page.lines) commands.line(line);
  for (const DrawnText& text : page.texts) commands.words(text);
  return commands.take();
}

}  // namespace

std::string pdfText(const Drawing& drawing, const std::vector<PdfPage>& pages) {
  PdfWriter pdf;
  constexpr size_t kFirstPage = 5;  // objects: catalogue, list of pages, font, drawing, then two for each page
  pdf.object("<< /Type /Catalog /Pages 2 0 R /ViewerPreferences << /PrintScaling /None >> >>");
  std::string kids;
  for (size_t i = 0; i < pages.size(); ++i) kids += fmt::format("{} 0 R ", kFirstPage + 2 * i);
  pdf.object(fmt::format("<< /Type /Pages /Count {} /Kids [ {}] >>", pages.size(), kids));
  pdf.object("<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >>");
  Commands commands;
  commands.put("0.35 w 1 j\n");
  for (const DrawnLine& line : drawing.lines) commands.line(line);
  for (const DrawnText& text : drawing.texts) commands.words(text);
  for (const DrawnPiece& piece : drawing.pieces) commands.piece(piece);
  pdf.stream(
      fmt::format("/Type /XObject /Subtype /Form /BBox [0 0 {:.3f} {:.3f}] /Resources << /Font << /F1 3 0 R >> >>",
                  drawing.width, drawing.height),
      commands.take());
  for (size_t i = 0; i < pages.size(); ++i) {
    const PdfPage& page = pages[i];
    const double unit = std::max(1.0, std::ceil(kPoint * std::max(page.width, page.height) / kLargestPage));
    pdf.object(
        fmt::format("<< /Type /Page /Parent 2 0 R /MediaBox [0 0 {:.3f} {:.3f}] /UserUnit {:g} /Contents {} 0 R "
                    "/Resources << /Font << /F1 3 0 R >> /XObject << /D 4 0 R >> >> >>",
                    kPoint * page.width / unit, kPoint * page.height / unit, unit, kFirstPage + 2 * i + 1));
    pdf.stream("", pageCommands(page, unit));
  }
  return pdf.finish();
}

PdfPage wholePage(const Drawing& drawing) {
  PdfPage page{drawing.width, drawing.height, {}, {}, {}};
  page.views.push_back({PaperPoint::Zero(), 1.0, PaperPoint::Zero(), {drawing.width, drawing.height}});
  return page;
}

}  // namespace ease
