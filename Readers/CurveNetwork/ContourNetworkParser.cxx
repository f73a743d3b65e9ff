// SPDX-License-Identifier: GPL-3.0-or-later
#include "CurveNetwork/ContourNetworkParser.h"

#include "Common/TextScanner.h"
#include "CurveNetwork/MaterialWalker.h"
#include "CurveNetwork/PlaneCheck.h"

#include <map>
#include <set>

namespace recon
{
namespace
{
// The shortest of each: "0 0 1 0 0 0 ", "0 0 0 ", "0 1 0 1 ".
constexpr std::size_t BytesPerPlane = 12;
constexpr std::size_t BytesPerVertex = 6;
constexpr std::size_t BytesPerEdge = 8;

class ContourNetworkParser
{
public:
  ContourNetworkParser(const std::string& fileName, Monitor& monitor)
    : Scanner(fileName),
      Progress(monitor)
  {
  }

  CurveNetwork Read()
  {
    const int planes = this->Scanner.NextCount("the number of planes", BytesPerPlane);
    for (this->Plane = 0; this->Plane < planes; ++this->Plane)
    {
      this->ReadPlane();
      this->Progress.Update(this->Scanner.GetFraction(), "reading planes");
    }
    this->Scanner.ExpectEnd("after " + std::to_string(planes) + " planes");
    for (auto& [label, material] : this->Materials)
    {
      this->Result.Materials.push_back(std::move(material));
    }
    return std::move(this->Result);
  }

private:
  void Note(const std::string& sentence)
  {
    this->Result.Report.push_back("Plane " + std::to_string(this->Plane + 1) + ": " + sentence);
  }

  void ReadPlane()
  {
    Vector3 normal{};
    for (double& component : normal)
    {
      component = this->Scanner.NextNumber("a, b and c of the plane");
    }
    const double d = this->Scanner.NextNumber("d of the plane");
    const int vertexCount =
      this->Scanner.NextCount("the number of vertices of the plane", BytesPerVertex);
    const int edgeCount = this->Scanner.NextCount("the number of edges of the plane", BytesPerEdge);
    std::vector<Point3> vertices(static_cast<std::size_t>(vertexCount));
    for (Point3& vertex : vertices)
    {
      for (double& coordinate : vertex)
      {
        coordinate = this->Scanner.NextNumber("x, y and z of a vertex");
      }
    }
    std::vector<NetworkEdge> edges;
    for (int edge = 0; edge < edgeCount; ++edge)
    {
      this->ReadEdge(vertexCount, edges);
    }
    this->AddMaterials(this->CheckedNormal(normal, d, vertices), vertices, edges);
  }

  void ReadEdge(int vertexCount, std::vector<NetworkEdge>& edges)
  {
    NetworkEdge edge;
    for (int* end : { &edge.From, &edge.To })
    {
      *end = this->Scanner.NextInteger("the index of a vertex of an edge");
      if (*end < 0 || *end >= vertexCount)
      {
        this->Scanner.Fail("vertex index " + std::to_string(*end) +
          " is out of range; the plane has " + std::to_string(vertexCount) +
          " vertices, counted from 0.");
      }
    }
    for (int* material : { &edge.Left, &edge.Right })
    {
      *material = this->Scanner.NextInteger("the material beside an edge");
      if (*material < 0)
      {
        this->Scanner.Fail("expected a material of 0 (outside) or more beside an edge, found " +
          std::to_string(*material) + ".");
      }
    }
    if (edge.From == edge.To || edge.Left == edge.Right)
    {
      this->Note("the edge of line " + std::to_string(this->Scanner.GetLine()) +
        " is left out, it " +
        (edge.From == edge.To ? "joins a vertex to itself."
                              : "has the same material on both sides."));
      return;
    }
    edges.push_back(edge);
  }

  /// Both signs of d are usual; a plane that fits with neither is reported.
  Vector3 CheckedNormal(const Vector3& given, double d, const std::vector<Point3>& vertices)
  {
    const PlaneFit fit = CheckPlane(given, d, vertices);
    if (fit == PlaneFit::WrongOffset || fit == PlaneFit::WrongNormal)
    {
      this->Note("a, b, c, d do not fit its vertices; the vertices were taken as they are, and the "
                 "plane from them.");
    }
    return NormalOf(vertices, given);
  }

  void AddMaterials(const Vector3& normal, const std::vector<Point3>& vertices,
    const std::vector<NetworkEdge>& edges)
  {
    MaterialWalker walker(normal, vertices, edges);
    if (walker.SwapSidesWhereZeroIsInside())
    {
      this->Note(
        "left and right are swapped; they were swapped back, so that material 0 is outside.");
    }
    for (const int label : walker.GetMaterials())
    {
      MaterialContours& material = this->Materials[label];
      material.Label = label;
      this->AddWalks(walker.Walk(label), vertices, material);
    }
  }

  void AddWalks(const std::vector<MaterialWalk>& walks, const std::vector<Point3>& vertices,
    MaterialContours& material)
  {
    std::vector<int> known(vertices.size(), -1);
    for (const MaterialWalk& walk : walks)
    {
      if (!walk.Closed)
      {
        this->Note("the boundary of material " + std::to_string(material.Label) +
          " is not closed, it ends at vertex " + std::to_string(walk.Vertices.back()) + ".");
      }
      LoopSoup::Chain chain;
      chain.Closed = walk.Closed;
      chain.Source = static_cast<int>(material.Soup.Chains.size());
      for (const int vertex : walk.Vertices)
      {
        int& number = known[static_cast<std::size_t>(vertex)];
        if (number < 0)
        {
          number = static_cast<int>(material.Soup.Points.size());
          material.Soup.Points.push_back(vertices[static_cast<std::size_t>(vertex)]);
        }
        chain.Points.push_back(number);
      }
      material.Soup.Chains.push_back(std::move(chain));
      material.Planes.push_back(this->Plane);
    }
  }

  TextScanner Scanner;
  Monitor& Progress;
  CurveNetwork Result;
  std::map<int, MaterialContours> Materials;
  int Plane = 0;
};
}

CurveNetwork ReadContourNetwork(const std::string& fileName, Monitor& monitor)
{
  return ContourNetworkParser(fileName, monitor).Read();
}
}
