#include "garment/pattern/dxf_file.h"

#include <catch2/catch.hpp>

#include "tests/garment/pattern/programs.h"

using namespace ease;

TEST_CASE("a DXF passes the audit of ezdxf, with the layers, units and lengths of the trade's form") {
  const std::string python = "/usr/bin/python3 ";  // for which Debian's package is
  if (run(python + "-c 'import ezdxf'").code != 0) {
    WARN("ezdxf is not installed");
    return;
  }
  const Drawing sheet = drawSheet("style", {plainPiece("front left"), plainPiece("back")}, 1400.0);
  const TemporaryFile file("pattern.dxf", dxfText(sheet)), script("check.py", R"(
import math, sys, ezdxf
doc = ezdxf.readfile(sys.argv[1])
assert not doc.audit().errors, doc.audit().errors
assert doc.dxfversion == 'AC1009', doc.dxfversion
assert doc.header['$INSUNITS'] == 4
inserts = list(doc.modelspace().query('INSERT'))
assert len(inserts) == 2, len(inserts)
for insert in inserts:
    block = doc.blocks[insert.dxf.name]
    lines = {p.dxf.layer: p for p in block.query('POLYLINE')}
    length = lambda p: sum(math.dist((a.x, a.y), (b.x, b.y)) for a, b in zip(list(p.points()), list(p.points())[1:] + list(p.points())[:1]))
    assert lines['1'].is_closed and abs(length(lines['1']) - 2 * (220 + 320)) < 0.1
    assert lines['14'].is_closed and abs(length(lines['14']) - 2 * (200 + 300)) < 0.1
    notch = [p for p in block.query('POINT') if p.dxf.layer == '4'][0]
    assert abs(notch.dxf.location.z - 5) < 1e-6 and abs(abs(notch.dxf.get('angle')) % 180) < 1e-6
    assert len([l for l in block.query('LINE') if l.dxf.layer == '7']) == 1
    assert any(t.dxf.text.startswith('PIECE NAME: ') for t in block.query('TEXT'))
    words = [t for t in block.query('TEXT') if t.dxf.layer == '15']
    assert words and all(t.dxf.halign == 1 and t.dxf.align_point == t.dxf.insert for t in words)
print('ok')
)");
  const Ran ran = run(python + script.path() + " " + file.path());
  INFO(ran.output);
  CHECK(ran.code == 0);
}

TEST_CASE("a DXF spells letters that its format lacks") {
  const std::string text = dxfText(drawSheet("Größe 38", {plainPiece("Rücken links 袖")}, 1400.0));
  CHECK(text.find("STYLE NAME: Groesse 38\n") != std::string::npos);
  CHECK(text.find("PIECE NAME: Ruecken links ?\n") != std::string::npos);
  CHECK(text.find("1_Ruecken_links__\n") != std::string::npos);
  const std::string two = dxfText(drawSheet("s", {plainPiece("upper left underarm / upper right underarm")}, 1400.0));
  CHECK(two.find("\n1_upper_left_underarm___upper_r\n") != std::string::npos);  // 31 letters
}
