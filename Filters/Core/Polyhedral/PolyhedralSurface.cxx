// SPDX-License-Identifier: GPL-3.0-or-later
#include "PolyhedralSurface.h"

#include "../Parallel.h"
#include "Coverage.h"
#include "JointVoronoi.h"
#include "LevelTriangulation.h"
#include "Lifting.h"
#include "SolidBoundary.h"
#include "SolidComplex.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>

namespace recon
{
namespace
{
/// The stages of the method in their order; every one is timed and takes its share of the progress
/// bar.
class Pipeline
{
public:
  Pipeline(const ContourSet& contours, const PolyhedralOptions& options, Monitor& monitor)
    : Contours(contours),
      Options(options),
      Observer(monitor),
      LevelCount(static_cast<int>(contours.Levels.size()))
  {
  }

  PolyhedralSurface Run()
  {
    this->TriangulateLevels();
    this->BuildSlabs();
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
    for (auto& known : this->Result.StageSeconds)
    {
      if (known.first == stage)
      {
        known.second += seconds.count();
        return;
      }
    }
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
    this->Triangulators.resize(this->LevelCount);
    this->Triangulations.resize(this->LevelCount);
    this->Timed("triangulate levels",
      [&]
      {
        this->ForAll(this->LevelCount, { 0, 0.3, "triangulating levels" },
          [&](int i)
          { this->Triangulators[i] = std::make_unique<LevelTriangulator>(this->Contours, i); });
      });
    this->Timed("insert internal points", [&] { this->InsertInternalPoints(); });
    for (int i = 0; i < this->LevelCount; ++i)
    {
      this->Levels.push_back({ &this->Triangulations[i], this->Contours.Levels[i].Offset });
    }
  }

  void InsertInternalPoints()
  {
    std::vector<std::vector<Point2>> skeletons(this->LevelCount);
    if (this->Options.InternalPoints)
    {
      this->ForAll(this->LevelCount, { 0.3, 0.35, "tracing Voronoi skeletons" },
        [&](int i) { skeletons[i] = this->Triangulators[i]->ExternalVoronoiVertices(); });
    }
    this->ForAll(this->LevelCount, { 0.35, 0.5, "inserting internal points" },
      [&](int i)
      {
        if (i > 0)
        {
          this->Triangulators[i]->AddInternalPoints(
            skeletons[i - 1], LevelTriangulation::LevelBelow);
        }
        if (i + 1 < this->LevelCount)
        {
          this->Triangulators[i]->AddInternalPoints(
            skeletons[i + 1], LevelTriangulation::LevelAbove);
        }
        this->Triangulations[i] = this->Triangulators[i]->Finish();
      });
  }

  /**
   * Tetrahedra and heights of all slabs, once more for levels that had bare parts.
   *
   * Cover points change their level and the two slabs at it, which can lay others bare; a few
   * rounds do.
   */
  void BuildSlabs()
  {
    constexpr int Rounds = 3;
    this->Slabs.resize(this->LevelCount - 1);
    this->Lifted.resize(this->LevelCount);
    std::vector<unsigned char> changed(this->LevelCount, 1);
    const double share = 0.38 / Rounds;
    for (int round = 0; round < Rounds; ++round)
    {
      const double from = 0.5 + share * round;
      this->Timed("join Voronoi diagrams",
        [&]
        {
          this->ForAll(this->LevelCount - 1,
            { from, from + 0.7 * share, "joining Voronoi diagrams" },
            [&](int i)
            {
              if (changed[i] || changed[i + 1])
              {
                this->Slabs[i] =
                  BuildJointVoronoi(this->Triangulations[i], this->Triangulations[i + 1]);
                EliminateTetrahedra(
                  this->Triangulations[i], this->Triangulations[i + 1], this->Slabs[i]);
              }
            });
        });
      this->Timed("lift internal points",
        [&] {
          this->LiftPoints({ from + 0.7 * share, from + share, "lifting internal points" });
        });
      if (round + 1 == Rounds || !this->CoverBareParts(changed))
      {
        return;
      }
    }
  }

  const SlabTetrahedra* SlabOrNull(int i) const
  {
    return i >= 0 && i + 1 < this->LevelCount ? &this->Slabs[i] : nullptr;
  }

  void LiftPoints(const ProgressRange& range)
  {
    this->Coverages.resize(this->LevelCount);
    this->ForAll(this->LevelCount, { range.From, range.From, range.Stage },
      [&](int i)
      {
        this->Coverages[i] =
          FindCoverage(this->Triangulations[i], this->SlabOrNull(i - 1), this->SlabOrNull(i));
      });
    this->ForAll(this->LevelCount - 1, range,
      [&](int i)
      {
        LiftInternalPoints(this->Levels[i], this->Levels[i + 1], this->Slabs[i],
          this->WantedPoints(i, LevelTriangulation::LevelAbove),
          this->WantedPoints(i + 1, LevelTriangulation::LevelBelow), this->Lifted[i],
          this->Lifted[i + 1]);
      });
  }

  /// Points of a level to be lifted towards a neighbour: those that it asked for and cover points,
  /// but none of a region that is not part of the surface.
  std::vector<unsigned char> WantedPoints(int level, LevelTriangulation::AskedByType towards) const
  {
    const auto& triangulation = this->Triangulations[level];
    const int askedBy =
      LevelTriangulation::Cover | (this->Options.LiftInternalPoints ? towards : 0);
    std::vector<unsigned char> wanted(triangulation.Points.size());
    for (std::size_t p = 0; p < wanted.size(); ++p)
    {
      wanted[p] = (triangulation.AskedBy[p] & askedBy) != 0 &&
          !this->Coverages[level].Isolated[triangulation.StarTriangle[p]]
        ? 1
        : 0;
    }
    return wanted;
  }

  /// Returns whether any level was changed, and which.
  bool CoverBareParts(std::vector<unsigned char>& changed)
  {
    std::vector<std::vector<Point2>> points(this->LevelCount);
    bool any = false;
    for (int i = 0; i < this->LevelCount; ++i)
    {
      points[i] = FindCoverPoints(this->Triangulations[i], this->Coverages[i], this->Lifted[i]);
      changed[i] = points[i].empty() ? 0 : 1;
      any = any || changed[i];
    }
    this->Timed("cover bare parts",
      [&]
      {
        ParallelFor(this->LevelCount, this->Options.Threads,
          [&](int i)
          {
            if (changed[i])
            {
              this->Triangulators[i]->AddCoverPoints(points[i]);
              this->Triangulations[i] = this->Triangulators[i]->Finish();
            }
          },
          this->Observer, { 0.5, 0.5, "covering bare parts" });
      });
    return any;
  }

  void ExtractSurface()
  {
    this->Timed("extract surface",
      [&]
      {
        this->Observer.Update(0.88, "extracting the surface");
        const SolidComplex solid =
          BuildSolidComplex(this->Levels, this->Slabs, this->Lifted, this->TrianglesToCover());
        this->Observer.Update(0.93, "extracting the surface");
        const SolidBoundary boundary = ExtractSolidBoundary(solid);
        this->Observer.Update(0.97, "extracting the surface");
        this->CopyPoints(solid, boundary);
        this->CopyFaces(solid, boundary);
        this->ReportContoursLeftOut();
      });
    this->Observer.Update(1, "extracting the surface");
  }

  std::vector<MustCover> TrianglesToCover() const
  {
    std::vector<MustCover> cover(this->LevelCount);
    for (int i = 0; i < this->LevelCount; ++i)
    {
      cover[i] = this->Triangulations[i].Inside;
      for (std::size_t t = 0; t < cover[i].size(); ++t)
      {
        cover[i][t] = cover[i][t] && !this->Coverages[i].Isolated[t] ? 1 : 0;
      }
    }
    return cover;
  }

  Point3 PositionOf(const SolidComplex::Vertex& vertex) const
  {
    const int source = vertex.Lifted ? -1 : this->Triangulations[vertex.Level].Source[vertex.Local];
    return source >= 0 ? this->Contours.Points[source]
                       : this->Contours.Levels[0].Frame.ToSpace(vertex.Planar, vertex.Height);
  }

  int KindOf(const SolidComplex::Vertex& vertex) const
  {
    return vertex.Local < 0 ? static_cast<int>(PolyhedralSurface::Internal)
                            : this->Triangulations[vertex.Level].Kind[vertex.Local];
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

  /// Contours of isolated regions are not part of the surface and are named.
  void ReportContoursLeftOut()
  {
    std::vector<unsigned char> leftOut(this->Contours.Contours.size(), 0);
    for (int i = 0; i < this->LevelCount; ++i)
    {
      const auto& triangulation = this->Triangulations[i];
      for (std::size_t t = 0; t < triangulation.Triangles.size(); ++t)
      {
        for (int k = 0; k < 3; ++k)
        {
          const int contour = triangulation.EdgeContour[t][k];
          if (contour >= 0 && this->Coverages[i].Isolated[t])
          {
            leftOut[contour] = 1;
          }
        }
      }
    }
    for (std::size_t c = 0; c < leftOut.size(); ++c)
    {
      if (leftOut[c])
      {
        const auto& contour = this->Contours.Contours[c];
        std::ostringstream line;
        line << "Contour " << c << " (level " << contour.Level << ", offset "
             << this->Contours.Levels[contour.Level].Offset << ", " << contour.Points.size()
             << " points): left out, as no contour of the levels next to it lies opposite.";
        this->Result.Report.push_back(line.str());
      }
    }
  }

  const ContourSet& Contours;
  const PolyhedralOptions& Options;
  Monitor& Observer;
  int LevelCount;
  std::vector<std::unique_ptr<LevelTriangulator>> Triangulators;
  std::vector<LevelTriangulation> Triangulations;
  std::vector<LevelGeometry> Levels;
  std::vector<SlabTetrahedra> Slabs;
  std::vector<Coverage> Coverages;
  std::vector<LiftedHeights> Lifted;
  PolyhedralSurface Result;
};
}

PolyhedralSurface BuildPolyhedralSurface(
  const ContourSet& contours, const PolyhedralOptions& options, Monitor& monitor)
{
  if (!contours.Parallel)
  {
    throw Error(
      "The contours lie in planes of several directions; the polyhedral surface needs parallel "
      "planes. Use Implicit Surface for these.");
  }
  if (contours.Levels.size() < 2)
  {
    throw Error("The contours lie in one plane only; a solid needs at least two parallel levels.");
  }
  return Pipeline(contours, options, monitor).Run();
}
}
