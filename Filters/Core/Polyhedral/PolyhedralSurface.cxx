// SPDX-License-Identifier: GPL-3.0-or-later
#include "PolyhedralSurface.h"

#include "../Parallel.h"
#include "JointVoronoi.h"
#include "LevelTriangulation.h"
#include "Lifting.h"
#include "SolidBoundary.h"
#include "SolidComplex.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <sstream>

namespace recon
{
namespace
{
/// The stages of the method in their order; every one is timed and takes its share of the progress bar.
class Pipeline
{
public:
  Pipeline(const ContourSet& contours, const PolyhedralOptions& options, Monitor& monitor)
    : Contours(contours)
    , Options(options)
    , Observer(monitor)
    , LevelCount(static_cast<int>(contours.Levels.size()))
  {
  }

  PolyhedralSurface Run()
  {
    this->TriangulateLevels();
    this->BuildSlabs();
    this->LiftPoints();
    this->ExtractSurface();
    return std::move(this->Result);
  }

private:
  template <typename Work>
  void Timed(const char* stage, Work work)
  {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    this->Result.StageSeconds.emplace_back(stage, seconds.count());
  }

  /// body(i) for every level or slab on the threads that the user allows.
  template <typename Body>
  void ForAll(int count, const ProgressRange& range, Body body)
  {
    ParallelFor(count, this->Options.Threads, body, this->Observer, range);
  }

  void TriangulateLevels()
  {
    std::vector<std::unique_ptr<LevelTriangulator>> triangulators(this->LevelCount);
    this->Timed("triangulate levels", [&] {
      this->ForAll(this->LevelCount, { 0, 0.3, "triangulating levels" }, [&](int i) {
        triangulators[i] = std::make_unique<LevelTriangulator>(this->Contours, i);
      });
    });
    this->Triangulations.resize(this->LevelCount);
    this->Timed("insert internal points", [&] {
      std::vector<std::vector<Point2>> skeletons(this->LevelCount);
      if (this->Options.InternalPoints)
      {
        this->ForAll(this->LevelCount, { 0.3, 0.35, "tracing Voronoi skeletons" },
          [&](int i) { skeletons[i] = triangulators[i]->ExternalVoronoiVertices(); });
      }
      this->ForAll(this->LevelCount, { 0.35, 0.5, "inserting internal points" }, [&](int i) {
        if (i > 0)
        {
          triangulators[i]->AddInternalPoints(skeletons[i - 1], LevelTriangulation::LevelBelow);
        }
        if (i + 1 < this->LevelCount)
        {
          triangulators[i]->AddInternalPoints(skeletons[i + 1], LevelTriangulation::LevelAbove);
        }
        this->Triangulations[i] = triangulators[i]->Finish();
      });
    });
    for (int i = 0; i < this->LevelCount; ++i)
    {
      this->Levels.push_back({ &this->Triangulations[i], this->Contours.Levels[i].Offset });
    }
  }

  void BuildSlabs()
  {
    this->Slabs.resize(this->LevelCount - 1);
    this->Timed("join Voronoi diagrams", [&] {
      this->ForAll(this->LevelCount - 1, { 0.5, 0.8, "joining Voronoi diagrams" }, [&](int i) {
        this->Slabs[i] = BuildJointVoronoi(this->Triangulations[i], this->Triangulations[i + 1]);
        EliminateTetrahedra(this->Triangulations[i], this->Triangulations[i + 1], this->Slabs[i]);
      });
    });
  }

  void LiftPoints()
  {
    this->Lifted.resize(this->LevelCount);
    if (!this->Options.InternalPoints || !this->Options.LiftInternalPoints)
    {
      return;
    }
    this->Timed("lift internal points", [&] {
      this->ForAll(this->LevelCount - 1, { 0.8, 0.88, "lifting internal points" }, [&](int i) {
        LiftInternalPoints(this->Levels[i], this->Levels[i + 1], this->Slabs[i], this->Lifted[i],
          this->Lifted[i + 1]);
      });
    });
  }

  void ExtractSurface()
  {
    this->Timed("extract surface", [&] {
      this->Observer.Update(0.88, "extracting the surface");
      const SolidComplex solid = BuildSolidComplex(this->Levels, this->Slabs, this->Lifted);
      this->Observer.Update(0.93, "extracting the surface");
      const SolidBoundary boundary = ExtractSolidBoundary(solid);
      this->Observer.Update(0.97, "extracting the surface");
      this->CopyPoints(solid, boundary);
      this->CopyFaces(solid, boundary);
      this->ReportContoursLeftOut(solid);
    });
    this->Observer.Update(1, "extracting the surface");
  }

  Point3 PositionOf(const SolidComplex::Vertex& vertex) const
  {
    const int source = vertex.Lifted ? -1 : this->Triangulations[vertex.Level].Source[vertex.Local];
    return source >= 0 ? this->Contours.Points[source]
                       : this->Contours.Levels[0].Frame.ToSpace(vertex.Planar, vertex.Height);
  }

  int KindOf(const SolidComplex::Vertex& vertex) const
  {
    return this->Triangulations[vertex.Level].Kind[vertex.Local];
  }

  void CopyPoints(const SolidComplex& solid, const SolidBoundary& boundary)
  {
    for (const auto& point : boundary.Points)
    {
      const auto& vertex = solid.Vertices[point.Vertex];
      Point3 position = this->PositionOf(vertex);
      int kind = this->KindOf(vertex);
      if (point.OtherVertex >= 0)
      {
        position = 0.5 * (position + this->PositionOf(solid.Vertices[point.OtherVertex]));
        kind = PolyhedralSurface::Internal;
      }
      this->Result.Mesh.Points.push_back(position);
      this->Result.PointKind.push_back(kind);
    }
  }

  void CopyFaces(const SolidComplex& solid, const SolidBoundary& boundary)
  {
    const std::vector<int> groups = GroupCells(solid);
    for (const auto& face : boundary.Faces)
    {
      bool inPlane = true;
      const int level = solid.Vertices[boundary.Points[face.Points[0]].Vertex].Level;
      for (int p : face.Points)
      {
        const auto& vertex = solid.Vertices[boundary.Points[p].Vertex];
        inPlane = inPlane && !vertex.Lifted && vertex.Level == level;
      }
      this->Result.Mesh.Triangles.push_back(face.Points);
      this->Result.Slab.push_back(solid.Cells[face.Cell].Slab);
      this->Result.FaceKind.push_back(inPlane ? PolyhedralSurface::Cap : PolyhedralSurface::Wall);
      this->Result.MappingGroup.push_back(groups[face.Cell]);
    }
  }

  /// Pieces of solid that hang together within a slab, numbered in the order of the cells.
  static std::vector<int> GroupCells(const SolidComplex& solid)
  {
    std::vector<int> groups(solid.Cells.size(), -1);
    std::vector<int> stack;
    int count = 0;
    for (std::size_t c = 0; c < groups.size(); ++c)
    {
      if (groups[c] >= 0)
      {
        continue;
      }
      groups[c] = count;
      stack.push_back(static_cast<int>(c));
      while (!stack.empty())
      {
        const auto& cell = solid.Cells[stack.back()];
        stack.pop_back();
        for (int n : cell.Neighbours)
        {
          if (n >= 0 && groups[n] < 0 && solid.Cells[n].Slab == cell.Slab)
          {
            groups[n] = count;
            stack.push_back(n);
          }
        }
      }
      ++count;
    }
    return groups;
  }

  /// A contour that no solid touches is named; so is a part of one that nothing faces.
  void ReportContoursLeftOut(const SolidComplex& solid)
  {
    std::vector<unsigned char> used(solid.Vertices.size(), 0);
    for (const auto& cell : solid.Cells)
    {
      for (int v : cell.Vertices)
      {
        used[v] = 1;
      }
    }
    std::vector<int> missing(this->Contours.Contours.size(), 0);
    std::vector<int> contourOf(this->Contours.Points.size(), -1);
    for (std::size_t c = 0; c < this->Contours.Contours.size(); ++c)
    {
      for (int p : this->Contours.Contours[c].Points)
      {
        contourOf[p] = static_cast<int>(c);
      }
    }
    for (std::size_t v = 0; v < solid.Vertices.size(); ++v)
    {
      const auto& vertex = solid.Vertices[v];
      const int source = this->Triangulations[vertex.Level].Source[vertex.Local];
      if (!vertex.Lifted && source >= 0 && !used[v])
      {
        ++missing[contourOf[source]];
      }
    }
    for (std::size_t c = 0; c < missing.size(); ++c)
    {
      if (missing[c] == 0)
      {
        continue;
      }
      const auto& contour = this->Contours.Contours[c];
      const bool whole = missing[c] == static_cast<int>(contour.Points.size());
      std::ostringstream line;
      line << "Contour " << c << " (level " << contour.Level << ", offset "
           << this->Contours.Levels[contour.Level].Offset << ", " << contour.Points.size()
           << " points): "
           << (whole ? "left out" : std::to_string(missing[c]) + " of its points left out")
           << ", as no contour of the levels next to it lies opposite.";
      this->Result.Report.push_back(line.str());
    }
  }

  const ContourSet& Contours;
  const PolyhedralOptions& Options;
  Monitor& Observer;
  int LevelCount;
  std::vector<LevelTriangulation> Triangulations;
  std::vector<LevelGeometry> Levels;
  std::vector<SlabTetrahedra> Slabs;
  std::vector<LiftedHeights> Lifted;
  PolyhedralSurface Result;
};
}

PolyhedralSurface BuildPolyhedralSurface(
  const ContourSet& contours, const PolyhedralOptions& options, Monitor& monitor)
{
  if (!contours.Parallel)
  {
    throw Error("The contours lie in planes of several directions; the polyhedral surface needs parallel "
                "planes. Use Implicit Surface for these.");
  }
  if (contours.Levels.size() < 2)
  {
    throw Error("The contours lie in one plane only; a solid needs at least two parallel levels.");
  }
  return Pipeline(contours, options, monitor).Run();
}
}
