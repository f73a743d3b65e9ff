// SPDX-License-Identifier: GPL-3.0-or-later
#include "CurveNetwork/PlaneByPlane.h"

#include "Base/FarthestPoint.h"

#include <utility>

namespace recon
{
CurveNetwork PlaneByPlane::ReadPlanes(int count)
{
  for (this->Plane = 0; this->Plane < count; ++this->Plane)
  {
    this->Numbers.clear();
    this->ReadPlane();
    this->Progress.Update(this->Scanner.GetFraction(), "reading planes");
  }
  this->Scanner.ExpectEnd("after " + std::to_string(count) + " planes");
  for (auto& [label, material] : this->Materials)
  {
    this->Result.Materials.push_back(std::move(material));
  }
  return std::move(this->Result);
}

std::vector<Point3> PlaneByPlane::ReadVertices(int count)
{
  std::vector<Point3> vertices(static_cast<std::size_t>(count));
  for (Point3& vertex : vertices)
  {
    for (double& coordinate : vertex)
    {
      coordinate = this->Scanner.NextNumber("x, y and z of a vertex");
    }
    if (Norm(vertex) > FarthestPoint)
    {
      this->Scanner.Fail("a vertex is farther from the origin than 1e60.");
    }
  }
  return vertices;
}

int PlaneByPlane::ReadIndex(const char* what, int vertexCount)
{
  const int index = this->Scanner.NextInteger(what);
  if (index < 0 || index >= vertexCount)
  {
    this->Scanner.Fail("vertex index " + std::to_string(index) +
      " is out of range; the plane has " + std::to_string(vertexCount) +
      " vertices, counted from 0.");
  }
  return index;
}

void PlaneByPlane::Note(const std::string& sentence)
{
  this->Result.Report.push_back(this->PlaneName() + ": " + sentence);
}

void PlaneByPlane::AddChain(
  int material, const std::vector<Point3>& vertices, const std::vector<int>& chain, bool closed)
{
  MaterialContours& contours = this->Materials[material];
  contours.Label = material;
  std::vector<int>& known = this->Numbers[material];
  known.resize(vertices.size(), -1);
  LoopSoup::Chain added;
  added.Closed = closed;
  added.Source = static_cast<int>(contours.Soup.Chains.size());
  for (const int vertex : chain)
  {
    int& number = known[static_cast<std::size_t>(vertex)];
    if (number < 0)
    {
      number = static_cast<int>(contours.Soup.Points.size());
      contours.Soup.Points.push_back(vertices[static_cast<std::size_t>(vertex)]);
    }
    added.Points.push_back(number);
  }
  contours.Soup.Chains.push_back(std::move(added));
  contours.Planes.push_back(this->Plane);
}
}
