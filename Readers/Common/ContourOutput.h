// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ContourOutput.h
 * @brief From the loops of a file to vtkPolyData: what the contour readers share on VTK's side.
 */
#ifndef ContourOutput_h
#define ContourOutput_h

#include "Contours/ContourSet.h"

#include "vtkCellArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <string>
#include <vector>

namespace recon
{
/**
 * Closed chains become polylines whose last point is the first, open ones polylines, single
 * points vertices.
 *
 * @return the chain of every cell, in the order of cells (vtkPolyData puts vertices before lines).
 */
inline std::vector<int> FillPolyData(const LoopSoup& soup, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(soup.Points.size()));
  for (std::size_t i = 0; i < soup.Points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), soup.Points[i].data());
  }
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkCellArray> lines;
  std::vector<int> vertexChains;
  std::vector<int> lineChains;
  for (std::size_t c = 0; c < soup.Chains.size(); ++c)
  {
    const LoopSoup::Chain& chain = soup.Chains[c];
    const bool isPoint = chain.Points.size() == 1;
    vtkCellArray* cells = isPoint ? vertices.Get() : lines.Get();
    const bool repeatsFirst = !isPoint && chain.Closed;
    cells->InsertNextCell(static_cast<int>(chain.Points.size()) + repeatsFirst);
    for (const int point : chain.Points)
    {
      cells->InsertCellPoint(point);
    }
    if (repeatsFirst)
    {
      cells->InsertCellPoint(chain.Points.front());
    }
    (isPoint ? vertexChains : lineChains).push_back(static_cast<int>(c));
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  output->SetLines(lines);
  vertexChains.insert(vertexChains.end(), lineChains.begin(), lineChains.end());
  return vertexChains;
}

/// Field data `Report`, a line for everything odd; none where there is nothing to say.
inline void AddReport(const std::vector<std::string>& report, vtkFieldData* fieldData)
{
  if (report.empty())
  {
    return;
  }
  vtkNew<vtkStringArray> lines;
  lines->SetName("Report");
  for (const std::string& line : report)
  {
    lines->InsertNextValue(line);
  }
  fieldData->AddArray(lines);
}
}

#endif
