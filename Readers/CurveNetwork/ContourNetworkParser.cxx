// SPDX-License-Identifier: GPL-3.0-or-later
#include "CurveNetwork/ContourNetworkParser.h"

#include "CurveNetwork/MaterialWalker.h"
#include "CurveNetwork/PlaneByPlane.h"
#include "CurveNetwork/PlaneCheck.h"

namespace recon
{
namespace
{
// The shortest of each: "0 0 1 0 0 0 ", "0 0 0 ", "0 1 0 1 ".
constexpr std::size_t BytesPerPlane = 12;
constexpr std::size_t BytesPerVertex = 6;
constexpr std::size_t BytesPerEdge = 8;

class ContourNetworkParser : private PlaneByPlane
{
public:
  using PlaneByPlane::PlaneByPlane;

  CurveNetwork Read()
  {
    return this->ReadPlanes(this->Scanner.NextCount("the number of planes", BytesPerPlane));
  }

private:
  void ReadPlane() override
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
    const std::vector<Point3> vertices = this->ReadVertices(vertexCount);
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
      *end = this->ReadIndex("the index of a vertex of an edge", vertexCount);
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
      this->AddWalks(walker.Walk(label), vertices, label);
    }
  }

  void AddWalks(
    const std::vector<BorderWalk>& walks, const std::vector<Point3>& vertices, int material)
  {
    for (const BorderWalk& walk : walks)
    {
      if (!walk.Closed)
      {
        this->Note("the boundary of material " + std::to_string(material) +
          " is not closed, it ends at vertex " + std::to_string(walk.Points.back()) + ".");
      }
      this->AddChain(material, vertices, walk.Points, walk.Closed);
    }
  }
};
}

CurveNetwork ReadContourNetwork(const std::string& fileName, Monitor& monitor)
{
  return ContourNetworkParser(fileName, monitor).Read();
}
}
