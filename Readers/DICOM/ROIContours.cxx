// SPDX-License-Identifier: GPL-3.0-or-later
#include "DICOM/ROIContours.h"

#include "Common/ClosedLoops.h"
#include "Contours/ContourSetBuilder.h"
#include "DICOM/Keyholes.h"

#include <algorithm>

namespace recon
{
namespace
{
WrittenContour ContourOf(
  const LoopSoup& soup, const LoopSoup::Chain& chain, const std::string& type)
{
  WrittenContour contour;
  contour.GeometricType = type;
  contour.Where = "cell " + std::to_string(chain.Source);
  for (const int p : chain.Points)
  {
    contour.Points.push_back(soup.Points[p]);
  }
  return contour;
}

std::string TypeOf(const ROIPiece& piece, const LoopSoup::Chain& chain)
{
  const auto& types = piece.GeometricTypes;
  return chain.Source >= 0 && chain.Source < static_cast<int>(types.size()) ? types[chain.Source]
                                                                            : std::string();
}
}

void ROIContours::Add(int cell, WrittenContour contour)
{
  this->Contours.emplace_back(cell, std::move(contour));
}

/// Takes points and open lines out of the soup, whose rest is or becomes closed.
void ROIContours::Sort(ROIPiece& piece)
{
  std::vector<LoopSoup::Chain> rest;
  for (LoopSoup::Chain& chain : piece.Soup.Chains)
  {
    const std::string type = TypeOf(piece, chain);
    const bool isPoint = type == "POINT" || (type.empty() && piece.OnlyVertices);
    const bool isOpenLine = type == "OPEN_PLANAR" || type == "OPEN_NONPLANAR";
    if (!chain.Closed && chain.Points.size() == 1 && isPoint)
    {
      this->Add(chain.Source, ContourOf(piece.Soup, chain, "POINT"));
    }
    else if (!chain.Closed && isOpenLine)
    {
      this->Add(chain.Source, ContourOf(piece.Soup, chain, type));
    }
    else
    {
      rest.push_back(std::move(chain));
    }
  }
  piece.Soup.Chains = std::move(rest);
}

void ROIContours::AddClosed(const LoopSoup& closed)
{
  for (const LoopSoup::Chain& chain : closed.Chains)
  {
    this->Add(chain.Source,
      ContourOf(closed, chain, chain.ExclusiveOr ? "CLOSEDPLANAR_XOR" : "CLOSED_PLANAR"));
  }
}

void ROIContours::AddKeyholes(const LoopSoup& closed, const std::string& where)
{
  ContourSetOptions options;
  options.Parallel = false;
  const ContourSet set = BuildContourSet(closed, options, this->Progress);
  for (KeyholeContour& keyhole : JoinHoles(set))
  {
    WrittenContour contour;
    contour.Points = std::move(keyhole.Points);
    contour.GeometricType = "CLOSED_PLANAR";
    contour.Where = "cell " + std::to_string(keyhole.Source);
    this->Add(keyhole.Source, std::move(contour));
  }
  for (const std::string& line : set.Report)
  {
    this->Report.push_back(where + ": " + line);
  }
}

void ROIContours::Collect(ROIPiece piece, WrittenROI& roi)
{
  const std::string where = "ROI \"" + roi.Description.Name + "\"";
  this->Contours.clear();
  this->Sort(piece);
  int looseVertices = 0;
  const LoopSoup closed = CloseLoops(std::move(piece.Soup),
    where + ", where the cell array GeometricType does not say OPEN_PLANAR, holds", looseVertices,
    this->Progress);
  if (this->Keyholes && !closed.Chains.empty())
  {
    this->AddKeyholes(closed, where);
  }
  else
  {
    this->AddClosed(closed);
  }
  std::stable_sort(this->Contours.begin(), this->Contours.end(),
    [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& contour : this->Contours)
  {
    roi.Contours.push_back(std::move(contour.second));
  }
  for (const std::string& line : piece.Report)
  {
    this->Report.push_back(where + ": " + line);
  }
  if (looseVertices > 0)
  {
    this->Report.push_back(
      where + ": " + std::to_string(looseVertices) + " loose vertices are no contours; left out.");
  }
}
}
