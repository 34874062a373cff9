#include "solver/io/mesh_readers.h"
#include "tests/io/mesh_files.h"

using namespace ease;
using Catch::Matchers::Contains;

namespace {

std::string messageOn(const std::string& bytes) {
  try {
    checkVtpCounts(bytes, "a.vtp");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// Counts alone, as they stand in the file.
std::string counted(const std::string& points, const std::string& components = "3") {
  return "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=" + points +
         " NumberOfPolys=\"1\"><DataArray NumberOfComponents=\"" + components +
         "\" format=\"ascii\">0</DataArray></Piece></PolyData></VTKFile>";
}

/// A compressed array's three first words, in base64 within its tag.
std::string compressed(const std::string& header) {
  return "<VTKFile compressor=\"vtkZLibDataCompressor\"><PolyData><Piece NumberOfPoints=\"4\"><DataArray "
         "NumberOfComponents=\"3\" format=\"binary\">" +
         header + "</DataArray></Piece></PolyData></VTKFile>";
}

/// A compressed array's three first words as raw bytes in the appended part of the file.
template <class Word>
std::string appended(Word blocks, Word block, Word last, bool big) {
  std::string bytes = std::string("<VTKFile compressor=\"vtkZLibDataCompressor\" header_type=\"") +
                      (sizeof(Word) == 8 ? "UInt64" : "UInt32") + "\" byte_order=\"" +
                      (big ? "BigEndian" : "LittleEndian") +
                      "\"><DataArray format=\"appended\" offset=\"2\"/><AppendedData encoding=\"raw\">_..";
  for (const Word word : {blocks, block, last}) append(bytes, word, big);
  return bytes + "</AppendedData></VTKFile>";
}

}  // namespace

TEST_CASE("counts of a VTP that its bytes can fill are taken") {
  CHECK(messageOn(counted("\"4\"")).empty());
  CHECK(messageOn(counted("'+ 4'")).empty());
  CHECK(messageOn(compressed("AQAAAACAAAAMAAAA")).empty());  // 1 block, 32768 bytes, 12 bytes
  for (const bool big : {false, true}) {
    CHECK(messageOn(appended<std::uint32_t>(1, 32768, 12, big)).empty());
    CHECK(messageOn(appended<std::uint64_t>(1, 32768, 0, big)).empty());
  }
}

TEST_CASE("a VTP whose counts its bytes cannot fill is refused before VTK takes memory for them") {
  for (const std::string count : {"4000000000", "-4", " -4", "99999999999999999999"}) {
    CHECK_THAT(messageOn(counted("'" + count + "'")),
               Contains("a.vtp: damaged: NumberOfPoints = " + count + " in a file of"));
    CHECK_THAT(messageOn(counted("'4'", count)), Contains("damaged: NumberOfComponents = " + count));
  }
}

TEST_CASE("a compressed VTP with blocks of no bytes, or more than the file can hold, is refused") {
  CHECK_THAT(messageOn(compressed("AQAAAAAAAAAAAAAA")), Contains("damaged: an array in blocks of 0 bytes"));
  CHECK_THAT(messageOn(compressed("////fwCAAAAAAAAA")), Contains("damaged: blocks of an array = 2147483647"));
  CHECK_THAT(messageOn(compressed("AQAAAP///38AAAAA")), Contains("damaged: bytes in a block of an array = 2147483647"));
  for (const bool big : {false, true}) {
    CHECK_THAT(messageOn(appended<std::uint32_t>(1, 0, 12, big)), Contains("an array in blocks of 0 bytes"));
    CHECK_THAT(messageOn(appended<std::uint64_t>(1, 32768, 1ULL << 40, big)),
               Contains("bytes in the last block of an array = 1099511627776"));
  }
}

TEST_CASE("a VTP whose counts VTK would crash over is refused by the reader") {
  const Folder folder;
  CHECK_THAT(messageOf(folder.write("a.vtp", counted("'-4'"))), Contains("damaged: NumberOfPoints = -4"));
}
