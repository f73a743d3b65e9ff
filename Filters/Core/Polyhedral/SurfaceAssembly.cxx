// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/SurfaceAssembly.h"

#include "Base/Parallel.h"
#include "Base/SubMonitor.h"

#include <algorithm>
#include <thread>
#include <utility>

namespace recon
{
namespace
{
/// Slabs that are looked at together, with two more: the more, the less is looked at twice, and the more memory.
constexpr int MostSlabsAPart = 32;
constexpr int LeastSlabsAPart = 8;

/// Room that is kept for points and faces, for every contour point; what is not used takes no memory.
constexpr double PointsAContourPoint = 1.25;
constexpr double FacesAContourPoint = 2.5;

/// As equal as can be, and as many as threads can share.
std::vector<SlabRange> PartsOf(int first, int end, int threads)
{
  const int count = end - first;
  int parts = (count + MostSlabsAPart - 1) / MostSlabsAPart;
  parts = (parts + threads - 1) / threads * threads;
  parts = std::clamp(parts, 1, std::max(1, count / LeastSlabsAPart));
  std::vector<SlabRange> ranges;
  for (int i = 0; i < parts; ++i)
  {
    const auto at = [&](int part)
    { return first + static_cast<int>(static_cast<long long>(count) * part / parts); };
    ranges.push_back({ at(i), at(i + 1) });
  }
  return ranges;
}

int ThreadsOf(const PolyhedralOptions& options)
{
  return options.Threads > 0 ? options.Threads
                             : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// The corners of faces before edges were halved; ask for them in their order.
class WholeFaces
{
public:
  explicit WholeFaces(const SolidBoundary& boundary) : Boundary(boundary) {}

  /// Sets Split where there are pieces in its place, else it is none.
  const std::array<int, 3>& At(std::size_t face)
  {
    const auto& splits = this->Boundary.Splits;
    while (this->Next < splits.size() && static_cast<std::size_t>(splits[this->Next].Face) < face)
    {
      ++this->Next;
    }
    const bool isSplit =
      this->Next < splits.size() && static_cast<std::size_t>(splits[this->Next].Face) == face;
    this->Split = isSplit ? std::make_optional(this->Next) : std::nullopt;
    return isSplit ? splits[this->Next].Whole : this->Boundary.Faces[face].Points;
  }

  std::optional<std::size_t> Split; ///< into SolidBoundary::Splits

private:
  const SolidBoundary& Boundary;
  std::size_t Next = 0;
};

int FaceKindOf(bool inPlane)
{
  return inPlane ? PolyhedralSurface::Cap : PolyhedralSurface::Wall;
}
}

SurfaceAssembly::SurfaceAssembly(
  const ContourSet& contours, const PolyhedralOptions& options, Monitor& monitor)
  : Contours(contours),
    Options(options),
    Observer(monitor)
{
}

std::size_t SurfaceAssembly::Add(const PolyhedralStages& stages, std::size_t levels)
{
  if (!this->Groups)
  {
    this->Groups.emplace(this->Contours, stages.Mapping);
    this->Reserve();
  }
  const int slabs = static_cast<int>(stages.Slabs.size());
  const int finished = static_cast<int>(levels);
  // A part is looked at with one slab above it, and so with one level more.
  const int end = levels == stages.Levels.size() ? slabs : std::max(this->NextSlab, finished - 2);
  if (end > this->NextSlab)
  {
    AbortMonitor stop(this->Observer);
    const int threads = ThreadsOf(this->Options);
    const std::vector<SlabRange> ranges = PartsOf(this->NextSlab, end, threads);
    const int count = static_cast<int>(ranges.size());
    for (int from = 0; from < count; from += threads)
    {
      std::vector<SurfacePart> parts(static_cast<std::size_t>(std::min(threads, count - from)));
      ParallelFor(static_cast<int>(parts.size()), threads,
        [&](int i)
        { parts[i] = BuildSurfacePart(this->Contours, stages, *this->Groups, ranges[from + i]); },
        stop, {});
      for (const SurfacePart& part : parts)
      {
        this->Append(part);
      }
    }
    this->NextSlab = end;
  }
  return static_cast<std::size_t>(std::max(0, this->NextSlab - 1));
}

void SurfaceAssembly::Reserve()
{
  const double points = static_cast<double>(this->Contours.Points.size());
  PolyhedralSurface& surface = this->Result.Surface;
  const auto morePoints = static_cast<std::size_t>(PointsAContourPoint * points);
  surface.Mesh.Points.reserve(morePoints);
  surface.PointKind.reserve(morePoints);
  this->Result.IsPointExact.reserve(morePoints);
  const auto moreFaces = static_cast<std::size_t>(FacesAContourPoint * points);
  surface.Mesh.Triangles.reserve(moreFaces);
  for (std::vector<int>* ofTriangle :
    { &surface.Slab, &surface.FaceKind, &surface.MappingGroup, &surface.Piece })
  {
    ofTriangle->reserve(moreFaces);
  }
}

void SurfaceAssembly::Append(const SurfacePart& part)
{
  std::vector<int> numbers = this->KnownNumbers(part);
  this->AppendFaces(part, numbers);
  this->AppendLateFaces(part, numbers);
}

/// Of the points of the part those that faces of the slab below it have, else -1.
std::vector<int> SurfaceAssembly::KnownNumbers(const SurfacePart& part) const
{
  std::vector<int> numbers(part.FirstMiddle(), -1);
  if (part.Slabs.First == part.Solid.Slabs.First)
  {
    return numbers;
  }
  const int firstCell = part.FirstCellOf(part.Slabs.First - 1);
  WholeFaces whole(part.Boundary);
  auto known = this->LastSlab.begin();
  const std::size_t end = part.FirstFaceOf(part.FirstCellOf(part.Slabs.First));
  for (std::size_t f = part.FirstFaceOf(firstCell); f < end; ++f)
  {
    // Here there are more faces: those in the plane below, beyond which the part does not see.
    const SolidBoundary::Face& face = part.Boundary.Faces[f];
    const auto place = std::make_pair(face.Cell - firstCell, face.Opposite);
    while (known != this->LastSlab.end() && std::make_pair(known->Cell, known->Opposite) < place)
    {
      ++known;
    }
    if (known == this->LastSlab.end() || std::make_pair(known->Cell, known->Opposite) != place)
    {
      continue;
    }
    const auto& points = whole.At(f);
    for (int k = 0; k < 3; ++k)
    {
      numbers[points[k]] = known->Points[k];
    }
  }
  return numbers;
}

void SurfaceAssembly::AddPoint(const PointOnSurface& point)
{
  this->Result.Surface.Mesh.Points.push_back(point.Position);
  this->Result.Surface.PointKind.push_back(point.Kind);
  this->Result.IsPointExact.push_back(point.IsExact ? 1 : 0);
}

void SurfaceAssembly::AppendFaces(const SurfacePart& part, std::vector<int>& numbers)
{
  PolyhedralSurface& surface = this->Result.Surface;
  const int firstCell = part.FirstCellOf(part.Slabs.First);
  const int endCell = part.FirstCellOf(part.Slabs.End);
  const int lastSlab = part.FirstCellOf(part.Slabs.End - 1);
  const int pieceShift = firstCell < endCell ? this->Pieces - part.Pieces[firstCell] : 0;
  this->LastSlab.clear();
  WholeFaces whole(part.Boundary);
  const std::size_t end = part.FirstFaceOf(endCell);
  for (std::size_t f = part.FirstFaceOf(firstCell); f < end; ++f)
  {
    const SolidBoundary::Face& face = part.Boundary.Faces[f];
    const auto& points = whole.At(f);
    std::array<int, 3> triangle{};
    for (int k = 0; k < 3; ++k)
    {
      int& number = numbers[points[k]];
      if (number < 0)
      {
        number = static_cast<int>(surface.Mesh.Points.size());
        this->AddPoint(part.Points[points[k]]);
      }
      triangle[k] = number;
    }
    if (face.Cell >= lastSlab)
    {
      this->LastSlab.push_back({ face.Cell - lastSlab, face.Opposite, triangle });
    }
    if (whole.Split)
    {
      this->Splits.push_back(
        this->SplitOf(part, *whole.Split, surface.Mesh.Triangles.size(), numbers, nullptr));
    }
    surface.Mesh.Triangles.push_back(triangle);
    surface.Slab.push_back(part.Solid.Cells[face.Cell].Slab);
    surface.FaceKind.push_back(FaceKindOf(LiesInPlane(part, points)));
    surface.MappingGroup.push_back(part.Groups[f]);
    surface.Piece.push_back(part.Pieces[face.Cell] + pieceShift);
  }
  for (int c = firstCell; c < endCell; ++c)
  {
    const SolidComplex::Cell& cell = part.Solid.Cells[c];
    this->Pieces = std::max(this->Pieces, part.Pieces[c] + pieceShift + 1);
    if (cell.Part != SolidComplex::BetweenLevels)
    {
      this->AddVolume(cell.Part, VolumeOf(part.Solid, cell));
    }
  }
}

void SurfaceAssembly::AddVolume(SolidComplex::PartType kind, double volume)
{
  PolyhedralSurface& surface = this->Result.Surface;
  (kind == SolidComplex::EndCap ? surface.EndCapVolume : surface.IsolatedVolume) += volume;
}

/// late: of the points of the part their numbers among late ones; null where there are none.
SurfaceAssembly::SplitFace SurfaceAssembly::SplitOf(const SurfacePart& part, std::size_t split,
  std::size_t face, const std::vector<int>& numbers, const std::vector<int>* late)
{
  const SolidBoundary& boundary = part.Boundary;
  const auto cornerOf = [&](int point) -> Corner
  {
    const auto index = static_cast<std::size_t>(point);
    if (index >= part.FirstMiddle())
    {
      const auto [known, isNew] = this->MiddleNumbers.emplace(
        part.Halved[index - part.FirstMiddle()], static_cast<int>(this->Middles.size()));
      if (isNew)
      {
        this->Middles.push_back(part.Points[index]);
      }
      return { Corner::Middle, known->second };
    }
    return numbers[index] >= 0 ? Corner{ Corner::Numbered, numbers[index] }
                               : Corner{ Corner::Late, (*late)[index] };
  };
  SplitFace pieces{ face, {}, {} };
  const auto addPiece = [&](int f)
  {
    const auto& points = boundary.Faces[f].Points;
    pieces.Pieces.push_back({ { cornerOf(points[0]), cornerOf(points[1]), cornerOf(points[2]) } });
    pieces.Groups.push_back(part.Groups[f]);
  };
  addPiece(boundary.Splits[split].Face);
  for (int f = split > 0 ? boundary.Splits[split - 1].End : boundary.WholeFaces;
       f < boundary.Splits[split].End; ++f)
  {
    addPiece(f);
  }
  return pieces;
}

/// Of the cells after those of the slabs, what they are where the part is the one that gives them.
std::vector<SurfaceAssembly::LateCell> SurfaceAssembly::TakeLateCells(const SurfacePart& part)
{
  const SolidComplex& solid = part.Solid;
  const int slabs = static_cast<int>(this->Contours.Levels.size()) - 1;
  std::vector<LateCell> cells;
  std::map<int, int> pieces; // by number in the part
  for (auto c = static_cast<std::size_t>(solid.FirstCell.back()); c < solid.Cells.size(); ++c)
  {
    const SolidComplex::Cell& cell = solid.Cells[c];
    const int level = solid.Vertices[cell.Vertices[3]].Level;
    const bool isOwn = part.Slabs.First <= level &&
      (level < part.Slabs.End || (level == slabs && part.Slabs.End == slabs));
    if (!isOwn)
    {
      cells.push_back({ LateKinds, -1 });
      continue;
    }
    const bool isPyramid = cell.Slab >= 0 && cell.Slab < slabs;
    const LateKind kind = isPyramid ? Pyramids : (cell.Slab < 0 ? BelowFirst : AboveLast);
    LateFaces& late = this->Late[kind];
    const auto [known, isNew] = pieces.emplace(part.Pieces[c], late.Pieces);
    late.Pieces += isNew ? 1 : 0;
    cells.push_back({ kind, known->second });
    if (cell.Part != SolidComplex::BetweenLevels)
    {
      late.Volumes.emplace_back(cell.Part, VolumeOf(solid, cell));
    }
  }
  return cells;
}

void SurfaceAssembly::AppendLateFaces(const SurfacePart& part, const std::vector<int>& numbers)
{
  const int firstLate = part.Solid.FirstCell.back();
  const std::vector<LateCell> cells = this->TakeLateCells(part);
  std::vector<int> lateNumbers(cells.empty() ? 0 : numbers.size(), -1);
  WholeFaces whole(part.Boundary);
  const auto end = static_cast<std::size_t>(part.Boundary.WholeFaces);
  for (std::size_t f = part.FirstFaceOf(firstLate); f < end; ++f)
  {
    const int c = part.Boundary.Faces[f].Cell;
    const LateCell& cell = cells[c - firstLate];
    if (cell.Kind == LateKinds)
    {
      continue;
    }
    LateFaces& late = this->Late[cell.Kind];
    const auto& points = whole.At(f);
    Corners corners{};
    for (int k = 0; k < 3; ++k)
    {
      const int point = points[k];
      if (numbers[point] < 0 && lateNumbers[point] < 0)
      {
        lateNumbers[point] = static_cast<int>(late.Points.size());
        late.Points.push_back(part.Points[point]);
      }
      corners[k] = numbers[point] >= 0 ? Corner{ Corner::Numbered, numbers[point] }
                                       : Corner{ Corner::Late, lateNumbers[point] };
    }
    if (whole.Split)
    {
      late.Splits.push_back(
        this->SplitOf(part, *whole.Split, late.Faces.size(), numbers, &lateNumbers));
    }
    late.Faces.push_back(corners);
    late.Slab.push_back(part.Solid.Cells[c].Slab);
    late.FaceKind.push_back(FaceKindOf(LiesInPlane(part, points)));
    late.Group.push_back(part.Groups[f]);
    late.Piece.push_back(cell.Piece);
  }
}

AssembledSurface SurfaceAssembly::Finish()
{
  for (LateFaces& late : this->Late)
  {
    this->FinishLate(late);
  }
  this->FinishSplits();
  return std::move(this->Result);
}

void SurfaceAssembly::FinishLate(LateFaces& late)
{
  PolyhedralSurface& surface = this->Result.Surface;
  const int firstPoint = static_cast<int>(surface.Mesh.Points.size());
  const std::size_t firstFace = surface.Mesh.Triangles.size();
  for (const PointOnSurface& point : late.Points)
  {
    this->AddPoint(point);
  }
  const auto settle = [&](Corners& corners)
  {
    for (Corner& corner : corners)
    {
      if (corner.Kind == Corner::Late)
      {
        corner = { Corner::Numbered, firstPoint + corner.Number };
      }
    }
  };
  for (std::size_t f = 0; f < late.Faces.size(); ++f)
  {
    settle(late.Faces[f]);
    const Corners& corners = late.Faces[f];
    surface.Mesh.Triangles.push_back(
      { { corners[0].Number, corners[1].Number, corners[2].Number } });
    surface.Slab.push_back(late.Slab[f]);
    surface.FaceKind.push_back(late.FaceKind[f]);
    surface.MappingGroup.push_back(late.Group[f]);
    surface.Piece.push_back(this->Pieces + late.Piece[f]);
  }
  for (SplitFace& split : late.Splits)
  {
    split.Face += firstFace;
    std::for_each(split.Pieces.begin(), split.Pieces.end(), settle);
    this->Splits.push_back(std::move(split));
  }
  for (const auto& [kind, volume] : late.Volumes)
  {
    this->AddVolume(kind, volume);
  }
  this->Pieces += late.Pieces;
}

void SurfaceAssembly::FinishSplits()
{
  PolyhedralSurface& surface = this->Result.Surface;
  std::vector<int> numbers(this->Middles.size());
  for (const auto& [edge, middle] : this->MiddleNumbers)
  {
    numbers[middle] = static_cast<int>(surface.Mesh.Points.size());
    this->AddPoint(this->Middles[middle]);
  }
  for (const SplitFace& split : this->Splits)
  {
    for (std::size_t i = 0; i < split.Pieces.size(); ++i)
    {
      std::array<int, 3> triangle{};
      for (int k = 0; k < 3; ++k)
      {
        const Corner& corner = split.Pieces[i][k];
        triangle[k] = corner.Kind == Corner::Middle ? numbers[corner.Number] : corner.Number;
      }
      if (i == 0)
      {
        surface.Mesh.Triangles[split.Face] = triangle;
        continue;
      }
      surface.Mesh.Triangles.push_back(triangle);
      surface.Slab.push_back(surface.Slab[split.Face]);
      surface.FaceKind.push_back(surface.FaceKind[split.Face]);
      surface.MappingGroup.push_back(split.Groups[i]);
      surface.Piece.push_back(surface.Piece[split.Face]);
    }
  }
}
}
