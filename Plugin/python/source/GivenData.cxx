// SPDX-License-Identifier: GPL-3.0-or-later
#include "GivenData.h"

#include <cstdint>
#include <utility>

namespace recon
{
namespace
{
using GivenFlags = GivenValues<bool>;
using GivenNumbers = GivenValues<std::int64_t>;

/// The array of that name, if it was given.
template <typename Array>
std::optional<Array> Optional(const nb::dict& data, const char* name)
{
  if (!data.contains(name) || nb::object(data[name]).is_none())
  {
    return std::nullopt;
  }
  return nb::cast<Array>(data[name]);
}

std::optional<std::vector<int>> OptionalNumbers(const nb::dict& data, const char* name)
{
  const auto array = Optional<GivenValues<int>>(data, name);
  return array ? std::optional<std::vector<int>>(ToVector<int>(*array)) : std::nullopt;
}

/// The points of loop i, which must be points that there are.
std::vector<int> PointsOf(
  std::size_t i, const GivenNumbers& offsets, const GivenNumbers& connectivity, std::size_t points)
{
  const std::int64_t from = offsets.data()[i];
  const std::int64_t to = offsets.data()[i + 1];
  const std::string where = "Loop " + std::to_string(i) + " ";
  if (from < 0 || to < from || to > static_cast<std::int64_t>(connectivity.shape(0)))
  {
    throw Error(where + "begins at " + std::to_string(from) + " and ends at " + std::to_string(to) +
      " of " + std::to_string(connectivity.shape(0)) +
      " entries of connectivity: offsets must increase from 0 to their number.");
  }
  std::vector<int> loop;
  for (std::int64_t k = from; k < to; ++k)
  {
    const std::int64_t p = connectivity.data()[k];
    if (p < 0 || p >= static_cast<std::int64_t>(points))
    {
      throw Error(where + "has point " + std::to_string(p) + ", and there are " +
        std::to_string(points) + " points, numbered from 0.");
    }
    loop.push_back(static_cast<int>(p));
  }
  return loop;
}

void AddKnownLevels(const nb::dict& loops, LoopSoup& soup)
{
  const auto level = OptionalNumbers(loops, "level");
  const auto normal = Optional<GivenPoints>(loops, "level_normal");
  const auto offset = Optional<GivenValues<double>>(loops, "level_offset");
  const auto thickness = Optional<GivenValues<double>>(loops, "level_thickness");
  if (!level || !normal || !offset || !thickness || normal->shape(0) != offset->shape(0) ||
    thickness->shape(0) != offset->shape(0) || level->size() != soup.Chains.size())
  {
    return;
  }
  const std::vector<Vector3> normals = ToRows<double>(*normal);
  for (std::size_t l = 0; l < normals.size(); ++l)
  {
    soup.Levels.push_back({ normals[l], offset->data()[l], thickness->data()[l] });
  }
  for (std::size_t c = 0; c < soup.Chains.size(); ++c)
  {
    soup.Chains[c].Level = (*level)[c];
  }
}
}

nb::list ToList(const std::vector<std::string>& lines)
{
  nb::list list;
  for (const std::string& line : lines)
  {
    list.append(nb::str(line.data(), line.size()));
  }
  return list;
}

std::vector<std::string> ToLines(nb::handle lines)
{
  std::vector<std::string> result;
  for (const nb::handle line : lines)
  {
    result.push_back(nb::cast<std::string>(line));
  }
  return result;
}

LoopSoup SoupOf(const nb::dict& loops)
{
  const auto offsets = nb::cast<GivenNumbers>(loops["offsets"]);
  const auto connectivity = nb::cast<GivenNumbers>(loops["connectivity"]);
  const auto closed = nb::cast<GivenFlags>(loops["closed"]);
  const auto exclusive = Optional<GivenFlags>(loops, "exclusive_or");
  LoopSoup soup;
  soup.Points = ToRows<double>(nb::cast<GivenPoints>(loops["points"]));
  soup.Millimetres = exclusive.has_value(); // only DICOM has such types, and its unit is that
  for (std::size_t i = 0; i + 1 < offsets.shape(0); ++i)
  {
    LoopSoup::Chain chain;
    chain.Points = PointsOf(i, offsets, connectivity, soup.Points.size());
    chain.Closed = i < closed.shape(0) && closed.data()[i];
    chain.ExclusiveOr = exclusive && i < exclusive->shape(0) && exclusive->data()[i];
    chain.Source = static_cast<int>(i);
    soup.Chains.push_back(std::move(chain));
  }
  if (soup.Chains.empty())
  {
    throw Error("There are no contours: give closed loops, an array of points each.");
  }
  AddKnownLevels(loops, soup);
  return soup;
}

nb::dict FromSoup(const LoopSoup& soup, std::vector<int>& order)
{
  order.clear();
  for (const bool vertices : { true, false })
  {
    for (std::size_t c = 0; c < soup.Chains.size(); ++c)
    {
      if ((soup.Chains[c].Points.size() == 1) == vertices)
      {
        order.push_back(static_cast<int>(c));
      }
    }
  }
  std::vector<std::int64_t> offsets{ 0 };
  std::vector<std::int64_t> connectivity;
  std::vector<unsigned char> closed;
  for (const int c : order)
  {
    const LoopSoup::Chain& chain = soup.Chains[c];
    connectivity.insert(connectivity.end(), chain.Points.begin(), chain.Points.end());
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
    closed.push_back(chain.Closed && chain.Points.size() > 1 ? 1 : 0);
  }
  nb::dict loops;
  loops["points"] = ToNumpy(soup.Points);
  loops["offsets"] = ToNumpy(std::move(offsets));
  loops["connectivity"] = ToNumpy(std::move(connectivity));
  loops["closed"] = ToNumpy(std::move(closed));
  return loops;
}

nb::dict LevelsOf(const ContourSet& contours)
{
  nb::dict levels;
  levels["LevelNormal"] = ArrayOf(contours.Levels, [](const Level& l) { return l.Frame.Normal; });
  levels["LevelOffset"] = ArrayOf(contours.Levels, [](const Level& l) { return l.Offset; });
  levels["LevelThickness"] = ArrayOf(contours.Levels, [](const Level& l) { return l.Thickness; });
  return levels;
}

nb::dict FromContours(const ContourSet& contours)
{
  const auto& all = contours.Contours;
  LoopSoup soup;
  soup.Points = contours.Points;
  std::vector<int> ids;
  std::vector<std::string> holes;
  for (const Contour& contour : all)
  {
    ids.push_back(static_cast<int>(ids.size()));
    LoopSoup::Chain chain;
    chain.Points = contour.Points;
    chain.Closed = true;
    soup.Chains.push_back(std::move(chain));
  }
  for (const Level& level : contours.Levels)
  {
    holes.push_back(level.HoleNote);
  }
  std::vector<int> order;
  nb::dict result = FromSoup(soup, order);
  nb::dict cells;
  cells["Level"] = ArrayOf(all, [](const Contour& c) { return c.Level; });
  cells["ContourId"] = ToNumpy(std::move(ids));
  cells["Depth"] = ArrayOf(all, [](const Contour& c) { return c.Depth; });
  cells["Parent"] = ArrayOf(all, [](const Contour& c) { return c.Parent; });
  cells["SignedArea"] = ArrayOf(all, [](const Contour& c) { return c.SignedArea; });
  nb::dict field = LevelsOf(contours);
  field["LevelHoleRule"] = ToList(holes);
  result["cell_data"] = cells;
  result["field_data"] = field;
  result["source"] = ArrayOf(all, [](const Contour& c) { return c.Source; });
  return result;
}

TriangleMesh MeshOf(const GivenPoints& points, const GivenTriangles& triangles)
{
  TriangleMesh mesh;
  mesh.Points = ToRows<double>(points);
  mesh.Triangles = ToRows<int>(triangles);
  return mesh;
}

std::vector<std::pair<int, int>> PairsOf(const nb::dict& properties, const char* name)
{
  std::vector<std::pair<int, int>> pairs;
  for (const nb::handle pair : properties[name])
  {
    pairs.emplace_back(nb::cast<int>(pair[0]), nb::cast<int>(pair[1]));
  }
  return pairs;
}

std::optional<CarriedMapping> CarriedMappingOf(const nb::dict& loops)
{
  const auto lower = OptionalNumbers(loops, "join_lower");
  const auto upper = OptionalNumbers(loops, "join_upper");
  const auto joined = OptionalNumbers(loops, "join_joined");
  if (!lower || !upper || !joined)
  {
    return std::nullopt;
  }
  return CarriedMapping{ *lower, *upper, *joined,
    OptionalNumbers(loops, "contour_id").value_or(std::vector<int>{}) };
}

ContourSetOptions ContourSetOptionsOf(const nb::dict& properties, bool parallel)
{
  ContourSetOptions options;
  options.Parallel = parallel;
  options.PlaneTolerance = ValueOf<double>(properties, "PlaneTolerance");
  options.SnapTolerance = ValueOf<double>(properties, "SnapTolerance");
  options.Holes = ChoiceOf<HoleRule>(properties, "HoleRule");
  options.OpenLines = ChoiceOf<OpenLineRule>(properties, "OpenLines");
  return options;
}

PolyhedralOptions PolyhedralOptionsOf(const nb::dict& properties)
{
  PolyhedralOptions options;
  options.InternalPoints = ValueOf<bool>(properties, "InternalPoints");
  options.LiftInternalPoints = ValueOf<bool>(properties, "LiftInternalPoints");
  options.Mapping = ChoiceOf<PolyhedralOptions::MappingType>(properties, "Mapping");
  options.OverlapThreshold = ValueOf<double>(properties, "OverlapThreshold");
  options.MaximumGap = ValueOf<double>(properties, "MaximumGap");
  options.ExpectedPieces = ValueOf<int>(properties, "ExpectedPieces");
  options.ExpectedHandles = ValueOf<int>(properties, "ExpectedHandles");
  options.AlignLevels = ChoiceOf<LevelAlignmentMode>(properties, "AlignLevels");
  options.EndCaps = ChoiceOf<PolyhedralOptions::EndCapsType>(properties, "EndCaps");
  options.IsolatedContours =
    ChoiceOf<PolyhedralOptions::IsolatedContoursType>(properties, "IsolatedContours");
  if (properties.contains("PinchGap")) // Fair Surface has its own
  {
    options.PinchGap = ValueOf<double>(properties, "PinchGap");
  }
  options.Threads = ValueOf<int>(properties, "Threads");
  return options;
}

ConstraintOptions ConstraintOptionsOf(const nb::dict& properties)
{
  ConstraintOptions options;
  options.Mode = ChoiceOf<ConstraintOptions::ModeType>(properties, "Mode");
  options.Values = ChoiceOf<ConstraintOptions::ValuesType>(properties, "Values");
  options.Normals = ChoiceOf<ConstraintOptions::NormalsType>(properties, "Normals");
  options.MarginDistance = ValueOf<double>(properties, "MarginDistance");
  options.ReachAcrossSteps = ValueOf<bool>(properties, "ReachAcrossSteps");
  options.MergeBox = ValueOf<double>(properties, "MergeBox");
  options.ThinOut = ValueOf<bool>(properties, "ThinOut");
  options.FillLongEdges = ValueOf<bool>(properties, "FillLongEdges");
  options.FollowDrawnPlanes = ValueOf<bool>(properties, "FollowDrawnPlanes");
  options.ResampleSpacing = ValueOf<double>(properties, "ResampleSpacing");
  options.ResampleTolerance = ValueOf<double>(properties, "ResampleTolerance");
  return options;
}

FunctionOptions FunctionOptionsOf(const nb::dict& properties)
{
  FunctionOptions options;
  options.Kind = ChoiceOf<Kernel::KindType>(properties, "Kernel");
  options.SupportRadius = ValueOf<double>(properties, "SupportRadius");
  options.Solver = ChoiceOf<FunctionOptions::SolverType>(properties, "Solver");
  options.Tolerance = ValueOf<double>(properties, "Tolerance");
  options.CentreReduction = ValueOf<double>(properties, "CentreReduction");
  options.Smoothing = ValueOf<double>(properties, "Smoothing");
  options.Threads = ValueOf<int>(properties, "Threads");
  return options;
}

std::optional<Bounds> BoundsOf(const nb::dict& properties)
{
  if (!ValueOf<bool>(properties, "UseBounds"))
  {
    return std::nullopt;
  }
  Bounds box{};
  for (std::size_t i = 0; i < box.size(); ++i)
  {
    box[i] = nb::cast<double>(properties["Bounds"][i]);
  }
  return box;
}

ImplicitSurfaceOptions ImplicitSurfaceOptionsOf(const nb::dict& properties)
{
  ImplicitSurfaceOptions options;
  options.Constraints = ConstraintOptionsOf(properties);
  options.Function = FunctionOptionsOf(properties);
  options.EndsBeyond = ValueOf<double>(properties, "EndsBeyond");
  PolygonizerOptions& meshing = options.Polygonizer;
  meshing.Detail = ChoiceOf<PolygonizerOptions::DetailType>(properties, "Detail");
  meshing.CellSize = ValueOf<double>(properties, "CellSize");
  meshing.Box = BoundsOf(properties);
  meshing.ClosedAtBounds = ValueOf<bool>(properties, "ClosedAtBounds");
  meshing.CleanUp = ValueOf<bool>(properties, "CleanUp");
  meshing.SnapToSeeds = ValueOf<bool>(properties, "SnapToContours");
  meshing.MaximumCells = ValueOf<double>(properties, "MaximumCells");
  meshing.Threads = ValueOf<int>(properties, "Threads");
  return options;
}
}
