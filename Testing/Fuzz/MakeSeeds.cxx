// SPDX-License-Identifier: GPL-3.0-or-later
// Writes what fuzzing begins with, FOLDER/TARGET/NAME: small whole files of every format in its variants, and random
// bytes for the targets that make contours of bytes. Nothing of anybody else's data.
#include "Readers/DICOM/ReferenceBuilder.h"
#include "Readers/DICOM/StructureSetBuilder.h"
#include "Readers/TraceBuilder.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

namespace
{
namespace fs = std::filesystem;
fs::path Into;

std::string Path(const std::string& target, const std::string& name)
{
  fs::create_directories(Into / target);
  return (Into / target / name).string();
}

void Write(const std::string& target, const std::string& name, const std::string& bytes)
{
  std::ofstream file(Path(target, name), std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

void WriteTexts()
{
  Write("NUAGES", "two",
    "S 2\nv 4 z 0\n{\n0 0\n4 0\n4 4\n0 4\n}\nv 7 z 1.5\n{\n0 0\n4 0\n4 4\n}\n{\n1 1\n2 1\n2 2\n1e0 "
    "2\n}\n");
  Write("CurveNetwork", "sections",
    "CSLC\n2 2\n\n1 4 1 0 0 1 -2\n\n0 0 2\n4 0 2\n4 4 2\n0 4 2\n\n4 1 0 1 2 3\n"
    "2 7 2 0 0 1 -3\n0 0 3\n4 0 3\n4 4 3\n0 4 3\n1 1 3\n1 2 3\n2 1 3\n4 1 0 1 2 3\n3h0 2 4 5 6\n");
  Write("CurveNetwork", "network",
    "1\n0 0 2 6\n6 7\n0 0 3\n1 0 3\n2 0 3\n2 1 3\n1 1 3\n0 1 3\n"
    "0 1 1 0\n1 2 2 0\n2 3 2 0\n3 4 2 0\n4 5 1 0\n5 0 1 0\n1 4 1 2\n");
  Write("BRep", "tetrahedron",
    "NUM_SHELL_SETS 1 # sets\nBEGIN_SHELL_SET\nNUM_SHELLS 1\nBEGIN_SHELL\nVERTICES 4\n0 0 0\n1 0 "
    "0\n0 1 0\n0 0 1\n"
    "EDGES 12\n0 2\n2 1\n1 0\n0 1\n1 3\n3 0\n1 2\n2 3\n3 1\n2 0\n0 3\n3 2\n"
    "FACES 4\n0(9)1(6)2(3)\n3(2)4(8)5(10)\n6(1)7(11)8(4)\n9(0)10(5)11(7)\n"
    "CONTOURS 1\n(3) 0 1 2\nEND_SHELL\nEND_SHELL_SET\n");
  Write("SVG", "layers",
    "<svg xmlns:i=\"http://www.inkscape.org/namespaces/inkscape\" width=\"9mm\" viewBox=\"0 0 9 "
    "9\">"
    "<g i:groupmode=\"layer\" transform=\"rotate(9) scale(2)\"><path d=\"M1 1C2 3 4 5 6 7S9 9 8 "
    "8q1 2 3 4t5 6"
    "A1 2 3 0 1 9 9z\"/></g><g i:groupmode=\"layer\" style=\"display:none\"><circle r=\"4\" "
    "i:label=\"a\"/></g>"
    "<rect x=\"1\" y=\"2\" width=\"3\" height=\"4\"/><ellipse cx=\"1\" rx=\"2\" ry=\"3\"/>"
    "<polygon points=\"0,0 1,0 1,1\"/><polyline points=\"0 0 1 0\"/><line x1=\"1\" "
    "y2=\"3\"/><text/></svg>");
  Write("Table", "objects",
    "object,slice,contour,x (mm),y,z\na,1,1,0,0,0\na,1,1,1,0,0\na,1,1,1,1,0\n"
    "\"b, c\",2,1,0,0,1\n\"b, c\",2,1,1,0,1\n\"b, c\",2,1,1,1,1\n");
  Write("Table", "columns", "x y z contour\n0 0 0 1\n1 0 0 1\n1 1 0 1\n");
  Write(
    "Table", "semicolons", "# a comment\nslice;x;y\n1;0;0\n1;2;0\n1;2;2\n2;0;0\n2;2;0\n2;2;2\n");
  Write("Reconstruct", "json", tracebuilder::JSONSeries);
  Write("Reconstruct", "xml",
    std::string(tracebuilder::SeriesFile) + '\f' +
      tracebuilder::SectionFile(1, tracebuilder::NoTransform, "0 0, 1 0, 1 1,") + '\f' +
      tracebuilder::SectionFile(
        2, "dim=\"6\" xcoef=\"0 1 .1 .1 .1 .1\" ycoef=\"0 0 1 .1 .1 .1\"", "0 0, 1 0, 1 1,"));
}

void WriteBinaries()
{
  const std::vector<recon::Point3> corners{ { 0, 0, 4 }, { 8, 0, 4 }, { 8, 8, 4 }, { 0, 8, 4 } };
  Write("IMOD", "two",
    tracebuilder::IMODHeader(2) + tracebuilder::IMODObject("axon", 2) +
      tracebuilder::IMODContour(corners) + tracebuilder::IMODContour(corners, 8) +
      tracebuilder::IMODObject("spots", 1, 512) + tracebuilder::IMODContour(corners) + "IEOF");
  const std::string polygon = tracebuilder::ROI({ { 1, 2 }, { 5, 2 }, { 5, 9 } }, 3, "first");
  Write("ImageJ", "polygon", polygon);
  for (int type = 1; type <= 10; ++type)
  {
    Write("ImageJ", "type" + std::to_string(type),
      tracebuilder::ROI({ { 1, 2 }, { 5, 2 }, { 5, 9 } }, type, "r", type, 4));
  }
  Write("ImageJ", "archive",
    tracebuilder::ZIP(
      { { "a.roi", polygon }, { "b.roi", tracebuilder::ROI({}, 0, "oval", 2, 4) } }));
}

void WriteDICOM()
{
  using readertesting::StructureSetBuilder;
  const auto fill = [](StructureSetBuilder& builder)
  {
    StructureSetBuilder::Put(builder.Data(), DCM_SpecificCharacterSet, "\\ISO 2022 IR 87");
    builder.AddROI(1, "Lung");
    builder.AddContour("CLOSED_PLANAR", "0\\0\\5\\8\\0\\5\\8\\8\\5", 3);
    builder.AddContour("POINT", "1\\2\\3", 1);
    builder.AddROI(2, "\x1b$B;3\x1b(B", "PTV");
    builder.AddContour("OPEN_PLANAR", "0\\0\\5\\8\\0\\5\\8\\8\\5\\", 3);
    builder.AddContour("CLOSEDPLANAR_XOR", "0\\0\\9\\8\\0\\9\\8\\8\\9", 4);
  };
  const std::pair<const char*, E_TransferSyntax> syntaxes[] = {
    { "explicit", EXS_LittleEndianExplicit },
    { "implicit", EXS_LittleEndianImplicit },
    { "big", EXS_BigEndianExplicit },
    { "deflated", EXS_DeflatedLittleEndianExplicit },
  };
  for (const auto& [name, syntax] : syntaxes)
  {
    StructureSetBuilder builder;
    fill(builder);
    builder.Save(Path("StructureSet", name), syntax);
    StructureSetBuilder bare;
    fill(bare);
    bare.Save(
      Path("StructureSet", std::string(name) + "-undefined"), syntax, true, EET_UndefinedLength);
  }
  StructureSetBuilder bare;
  fill(bare);
  bare.Save(Path("StructureSet", "bare"), EXS_LittleEndianImplicit, false);
  StructureSetBuilder reference;
  readertesting::FillReference(reference, { 0, 1, 2 }, 4);
  reference.Save(Path("Reference", "set"));
  readertesting::SaveImage(Path("Reference", "image"), 1);
}

void WriteRandom()
{
  std::mt19937 random(1);
  for (const char* target : { "Polyhedral", "Fair", "Implicit", "Certificate", "Writers" })
  {
    for (int i = 0; i < 40; ++i)
    {
      std::string bytes(std::size_t(20 + 10 * i), '\0');
      for (char& byte : bytes)
      {
        byte = static_cast<char>(random() & 0xff);
      }
      Write(target, "random" + std::to_string(i), bytes);
    }
  }
}
}

int main(int count, char** arguments)
{
  if (count != 2)
  {
    std::fprintf(stderr, "Usage: FuzzSeeds FOLDER\n");
    return 1;
  }
  Into = arguments[1];
  WriteTexts();
  WriteBinaries();
  WriteDICOM();
  WriteRandom();
  return 0;
}
