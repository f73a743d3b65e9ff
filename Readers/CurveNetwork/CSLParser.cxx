// SPDX-License-Identifier: GPL-3.0-or-later
#include "CurveNetwork/CSLParser.h"

#include "CurveNetwork/PlaneByPlane.h"
#include "CurveNetwork/PlaneCheck.h"

#include <string_view>

namespace recon
{
namespace
{
// The shortest of each: "1 0 0 0 0 1 0 ", "0 0 0 ", "0 1 ", "0 ".
constexpr std::size_t BytesPerPlane = 14;
constexpr std::size_t BytesPerVertex = 6;
constexpr std::size_t BytesPerRing = 4;
constexpr std::size_t BytesPerIndex = 2;

struct Ring
{
  int Label = 0;
  int Parent = -1; ///< the ring that this is a hole of, among those of its plane
  std::vector<int> Points;
};

class CSLParser : private PlaneByPlane
{
public:
  using PlaneByPlane::PlaneByPlane;

  CurveNetwork Read()
  {
    this->Scanner.Expect("CSLC", "'CSLC', as a cross-section set begins");
    const int planes = this->Scanner.NextCount("the number of planes", BytesPerPlane);
    this->Scanner.NextInteger("the number of labels");
    return this->ReadPlanes(planes);
  }

private:
  void ReadPlane() override
  {
    this->Scanner.NextInteger("the id of the next plane");
    const int vertexCount =
      this->Scanner.NextCount("the number of vertices of the plane", BytesPerVertex);
    const int ringCount =
      this->Scanner.NextCount("the number of components of the plane", BytesPerRing);
    Vector3 normal{};
    for (double& component : normal)
    {
      component = this->Scanner.NextNumber("A, B and C of the plane");
    }
    const double d = this->Scanner.NextNumber("D of the plane");
    const std::vector<Point3> vertices = this->ReadVertices(vertexCount);
    this->ReportPlane(CheckPlane(normal, d, vertices));
    std::vector<Ring> rings;
    for (int ring = 0; ring < ringCount; ++ring)
    {
      rings.push_back(this->ReadRing(ring, ringCount, vertexCount));
    }
    this->AddRings(rings, vertices);
  }

  void ReportPlane(PlaneFit fit)
  {
    if (fit == PlaneFit::Fits)
    {
      return;
    }
    this->Note(std::string(fit == PlaneFit::WrongSign ? "D has the wrong sign"
                                                      : "A, B, C, D do not fit its vertices") +
      "; the vertices were taken as they are.");
  }

  Ring ReadRing(int number, int ringCount, int vertexCount)
  {
    const char* const expected =
      "the number of vertices of a component ('78', or '78h0' for a hole)";
    const std::string_view token = this->Scanner.Next(expected);
    const std::size_t mark = token.find('h');
    int count = 0;
    Ring ring;
    if (!ParseInteger(token.substr(0, mark), count) || count < 0 ||
      (mark != std::string_view::npos && !ParseInteger(token.substr(mark + 1), ring.Parent)))
    {
      this->Scanner.FailExpected(expected, token);
    }
    this->Scanner.CheckCount(expected, count, BytesPerIndex);
    const bool isHole = mark != std::string_view::npos;
    if (isHole && (ring.Parent < 0 || ring.Parent >= ringCount || ring.Parent == number))
    {
      this->Scanner.Fail("component " + std::to_string(number) + " is a hole of component " +
        std::to_string(ring.Parent) + ", but its plane has the other ones of 0 to " +
        std::to_string(ringCount - 1) + " only.");
    }
    ring.Label = this->Scanner.NextInteger("the label of the component");
    for (int i = 0; i < count; ++i)
    {
      ring.Points.push_back(this->ReadIndex("the index of a vertex of the component", vertexCount));
    }
    return ring;
  }

  /// The label of the outermost ring: holes bound the material that they are cut out of.
  int MaterialOf(const std::vector<Ring>& rings, std::size_t number) const
  {
    std::size_t outer = number;
    for (std::size_t steps = 0; rings[outer].Parent >= 0; ++steps)
    {
      if (steps == rings.size())
      {
        this->Scanner.Fail(this->PlaneName() + ": component " + std::to_string(number) +
          " is a hole of itself, by way of others.");
      }
      outer = static_cast<std::size_t>(rings[outer].Parent);
    }
    return rings[outer].Label;
  }

  void AddRings(const std::vector<Ring>& rings, const std::vector<Point3>& vertices)
  {
    for (std::size_t r = 0; r < rings.size(); ++r)
    {
      if (rings[r].Points.empty())
      {
        this->Result.Report.push_back(this->PlaneName() + ", component " + std::to_string(r) +
          ": left out, it has no vertices.");
        continue;
      }
      this->AddChain(this->MaterialOf(rings, r), vertices, rings[r].Points, true);
    }
  }
};
}

CurveNetwork ReadCSL(const std::string& fileName, Monitor& monitor)
{
  return CSLParser(fileName, monitor).Read();
}
}
