// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as contours, through each writer and its reader: what is read is what was written.
#include "DrawnContours.h"
#include "FuzzTarget.h"

#include "Common/TracedFile.h"
#include "DICOM/StructureSetFile.h"
#include "DICOM/StructureSetFormatter.h"
#include "NUAGES/NUAGESFormatter.h"
#include "NUAGES/NUAGESParser.h"
#include "Readers/Soundness.h"
#include "Table/ContourTableFormatter.h"
#include "Table/ContourTableParser.h"

#include <functional>

namespace
{
recon::Monitor Silent;

/// An Error of a writer is its answer; what it has written can be read.
bool Writes(const std::function<std::vector<std::string>()>& write)
{
  try
  {
    fuzz::RequireNone(readertesting::FaultOf(write()));
    return true;
  }
  catch (const recon::Error& error)
  {
    fuzz::RequireNone(readertesting::FaultOf(std::string(error.what())));
    return false;
  }
}

/// What was read writes the same file again.
void TryNUAGES(const recon::LoopSoup& soup)
{
  const std::string name = fuzz::Name("a.cnt");
  if (Writes([&] { return recon::WriteNUAGES(name, soup, Silent); }))
  {
    const recon::ContourFile read = recon::ReadNUAGES(name, Silent);
    fuzz::Require(read.Soup.Chains.size() == soup.Chains.size(), "NUAGES: contours got lost");
    const std::string again = fuzz::Name("b.cnt");
    recon::WriteNUAGES(again, read.Soup, Silent);
    fuzz::Require(fuzz::Bytes(name) == fuzz::Bytes(again), "NUAGES: other contours");
  }
}

void TryTable(const recon::TracedFile& file)
{
  const std::string name = fuzz::Name("a.csv");
  if (Writes([&] { return recon::WriteContourTable(name, file, Silent); }))
  {
    const recon::TracedFile read = recon::ReadContourTable(name, {}, Silent);
    fuzz::RequireNone(readertesting::FaultOf(read));
    const std::string again = fuzz::Name("b.csv");
    recon::WriteContourTable(again, read, Silent);
    fuzz::Require(fuzz::Bytes(name) == fuzz::Bytes(again), "table: other contours");
  }
}

/// Six decimals are written, and DICOM has 16 characters a number.
bool IsNear(double a, double b)
{
  return std::abs(a - b) <= 1e-6 + 1e-8 * std::abs(a);
}

void TryStructureSet(const recon::LoopSoup& soup, const std::string& roiName)
{
  recon::WrittenROI roi;
  roi.Description.Name = roiName;
  for (const recon::LoopSoup::Chain& chain : soup.Chains)
  {
    recon::WrittenContour contour;
    for (const int p : chain.Points)
    {
      contour.Points.push_back(soup.Points[static_cast<std::size_t>(p)]);
    }
    contour.GeometricType = chain.Closed ? "CLOSED_PLANAR" : "OPEN_PLANAR";
    contour.Where = "cell " + std::to_string(chain.Source);
    roi.Contours.push_back(contour);
  }
  const std::string name = fuzz::Name("a.dcm");
  if (!Writes([&] { return recon::WriteStructureSet(name, { roi }, {}, Silent); }))
  {
    return;
  }
  recon::StructureSetFile file(name);
  fuzz::RequireNone(readertesting::FaultOf(file, Silent));
  const recon::LoopSoup read = file.ReadContours(0, Silent).File.Soup;
  fuzz::Require(!read.Chains.empty(), "structure set: no contours");
  for (const recon::LoopSoup::Chain& chain : read.Chains)
  {
    // In their order, where some were left out with a line.
    const recon::Point3& first = read.Points[static_cast<std::size_t>(chain.Points[0])];
    const bool isThere = std::any_of(soup.Points.begin(), soup.Points.end(),
      [&first](const recon::Point3& p)
      { return IsNear(p[0], first[0]) && IsNear(p[1], first[1]) && IsNear(p[2], first[2]); });
    fuzz::Require(isThere, "structure set: a point that was not written");
  }
}
}

void fuzz::Try(const std::string& bytes)
{
  InputBytes input(bytes);
  recon::TracedFile file;
  for (int objects = input.Between(1, 3); objects > 0; --objects)
  {
    recon::TracedObject object;
    object.Name = recon::CleanName(input.Text(static_cast<std::size_t>(input.Below(24))));
    object.Soup = DrawStack(input);
    object.Slices.assign(object.Soup.Chains.size(), 0);
    int slice = 0;
    for (std::size_t c = 0; c < object.Slices.size(); ++c)
    {
      const auto& soup = object.Soup;
      const auto height = [&soup](std::size_t i)
      { return soup.Points[static_cast<std::size_t>(soup.Chains[i].Points[0])][2]; };
      slice += c > 0 && height(c) != height(c - 1);
      object.Slices[c] = slice;
    }
    TryNUAGES(object.Soup);
    TryStructureSet(object.Soup, object.Name);
    file.Objects.push_back(std::move(object));
  }
  TryTable(file);
}
