// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/CertificateText.h"

#include <charconv>
#include <cmath>
#include <utility>

namespace recon
{
namespace
{
using Figures = std::vector<CertificateFigure>;

void AddFlag(Figures& figures, const char* name, bool value)
{
  figures.push_back({ name, CertificateFigure::Flag, value ? 1.0 : 0.0 });
}

template <typename Number>
void AddCount(Figures& figures, const char* name, Number value)
{
  figures.push_back({ name, CertificateFigure::Count, static_cast<double>(value) });
}

void AddReal(Figures& figures, const std::string& name, const std::optional<double>& value)
{
  figures.push_back({ name, CertificateFigure::Real, value });
}

void AddPoint(Figures& figures, const std::string& name, const std::optional<Point3>& p)
{
  for (int k = 0; k < 3; ++k)
  {
    AddReal(figures, name + "XYZ"[k], p ? std::optional<double>((*p)[k]) : std::nullopt);
  }
}

void AddTopology(Figures& figures, const TopologyFigures& t)
{
  AddFlag(figures, "Closed", t.Closed);
  AddFlag(figures, "EdgeManifold", t.EdgeManifold);
  AddFlag(figures, "VertexManifold", t.VertexManifold);
  AddFlag(figures, "Oriented", t.Oriented);
  AddFlag(figures, "Outward", t.Outward);
  AddCount(figures, "Components", t.Components);
  AddCount(figures, "Points", t.Points);
  AddCount(figures, "Edges", t.Edges);
  AddCount(figures, "Triangles", t.Triangles);
  AddCount(figures, "OpenEdges", t.OpenEdges);
  AddCount(figures, "OverusedEdges", t.OverusedEdges);
  AddCount(figures, "MisorientedEdges", t.MisorientedEdges);
  AddCount(figures, "PinchedVertices", t.PinchedVertices);
  AddCount(figures, "DuplicateTriangles", t.DuplicateTriangles);
  AddCount(figures, "DegenerateTriangles", t.DegenerateTriangles);
  AddCount(figures, "Euler", t.Euler);
  figures.push_back({ "Genus", CertificateFigure::Count,
    t.Genus ? std::optional<double>(*t.Genus) : std::nullopt });
}

/// The shortest text that reads back to the same double, whatever the locale.
std::string ToText(double value)
{
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return std::string(buffer, end);
}

std::string ToJsonValue(const CertificateFigure& figure)
{
  if (!figure.Value || !std::isfinite(*figure.Value))
  {
    return "null";
  }
  if (figure.Kind == CertificateFigure::Flag)
  {
    return *figure.Value != 0 ? "true" : "false";
  }
  return figure.Kind == CertificateFigure::Count
    ? std::to_string(static_cast<long long>(*figure.Value))
    : ToText(*figure.Value);
}

std::string ToJsonObject(const Figures& figures)
{
  std::string text = "{";
  for (const auto& figure : figures)
  {
    text += (text.size() > 1 ? ", \"" : "\"") + figure.Name + "\": " + ToJsonValue(figure);
  }
  return text + "}";
}

template <typename Range, typename ToText>
std::string ToJsonArray(const Range& range, const ToText& toText)
{
  std::string text = "[";
  for (const auto& item : range)
  {
    text += (text.size() > 1 ? ",\n  " : "\n  ") + toText(item);
  }
  return text + (text.size() > 1 ? "\n ]" : "]");
}

Figures ListDoubt(const VolumeDoubt& doubt)
{
  Figures figures;
  AddReal(figures, "Offset", doubt.Offset);
  AddReal(figures, "Width", doubt.Width);
  return figures;
}

Figures ListSection(const SectionDifference& section)
{
  Figures figures;
  AddCount(figures, "Level", section.Level);
  AddReal(figures, "Offset", section.Offset);
  AddReal(figures, "ContourArea", section.ContourArea);
  AddReal(figures, "SurfaceArea", section.SurfaceArea);
  AddReal(figures, "Difference", section.SymmetricDifference);
  AddReal(figures, "Percent", section.Percent);
  return figures;
}

/// A number for people, whatever the locale.
std::string Round(double value, int digits)
{
  char buffer[64];
  const auto end =
    std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, digits).ptr;
  return std::string(buffer, end);
}

std::string Count(long long number, const std::string& one, const std::string& many)
{
  return std::to_string(number) + " " + (number == 1 ? one : many);
}

/// "a, b and c" of what is wrong, or empty.
std::string ListDefects(const ComponentCertificate& total)
{
  const TopologyFigures& t = total.Topology;
  const std::vector<std::pair<long long, std::pair<const char*, const char*>>> defects{
    { t.OpenEdges, { "open edge", "open edges" } },
    { t.OverusedEdges, { "edge with more than two faces", "edges with more than two faces" } },
    { t.MisorientedEdges,
      { "edge between faces that disagree", "edges between faces that disagree" } },
    { t.PinchedVertices, { "pinched vertex", "pinched vertices" } },
    { t.DuplicateTriangles, { "duplicate triangle", "duplicate triangles" } },
    { t.DegenerateTriangles, { "degenerate triangle", "degenerate triangles" } },
    { total.Pairs.Crossing, { "pair of triangles that cross", "pairs of triangles that cross" } },
    { total.Pairs.Overlapping,
      { "pair of triangles that overlap", "pairs of triangles that overlap" } },
    { total.CrossingEdges, { "edge at which sheets cross", "edges at which sheets cross" } },
  };
  std::string text;
  for (const auto& [number, names] : defects)
  {
    if (number > 0)
    {
      text += (text.empty() ? "" : ", ") + Count(number, names.first, names.second);
    }
  }
  return text;
}

std::string DescribeState(const ComponentCertificate& total)
{
  const TopologyFigures& t = total.Topology;
  if (t.Components == 0)
  {
    return "There is no surface.";
  }
  if (total.IsSound())
  {
    return "Sound: closed, manifold, oriented outward, no triangles cross or overlap.";
  }
  std::string text = "Not sound: ";
  text += t.Closed ? "closed" : "not closed";
  text += t.Manifold() ? ", manifold" : ", not manifold";
  text += !t.Oriented ? ", not consistently oriented"
    : t.Outward       ? ", oriented outward"
    : t.Closed        ? ", oriented, but not outward everywhere"
                      : ", oriented";
  return text + ".";
}

std::string YesOrNo(bool value)
{
  return value ? "yes" : "NO";
}

/// Digits of a figure that is read, not computed with.
constexpr int ReadDigits = 6;

std::string RoundOr(const std::optional<double>& value, int digits = ReadDigits)
{
  return value ? Round(*value, digits) : "-";
}

std::string VerdictWord(const ComponentCertificate& total)
{
  return total.Topology.Components == 0 ? "no surface" : total.IsSound() ? "sound" : "NOT sound";
}

constexpr double CubicMillimetres = 1000; ///< of a cubic centimetre
constexpr double SquareMillimetres = 100; ///< of a square centimetre

std::optional<double> Divided(const std::optional<double>& value, double by)
{
  return value ? std::optional<double>(*value / by) : std::nullopt;
}

/// "12.3 (11.9 to 12.8)"
std::string IntervalText(const VolumeInterval& volume, double unit)
{
  return Round(volume.Estimate / unit, ReadDigits) + " (" +
    Round(volume.Lowest / unit, ReadDigits) + " to " + Round(volume.Highest / unit, ReadDigits) +
    ")";
}

/// Where another slice would tell most about the volume, and how much of what is open: "12.5 (40%)".
std::string DoubtText(const VolumeInterval& volume)
{
  const double width = volume.Highest - volume.Lowest;
  const VolumeDoubt& most = volume.Doubts.front();
  return Round(most.Offset, ReadDigits) +
    (width > 0 ? " (" + Round(100 * most.Width / width, 2) + "%)" : "");
}

void AddContourLines(
  const SurfaceCertificate& certificate, bool millimetres, std::vector<CertificateLine>& lines)
{
  const std::string unit = millimetres ? ", mm" : "";
  const auto& drawn = certificate.Drawn;
  lines.push_back({ millimetres ? "Volume by the contours, cm3" : "Volume by the contours",
    drawn ? IntervalText(*drawn, millimetres ? CubicMillimetres : 1) : "-" });
  lines.push_back({ "Slice that would tell most, at" + unit, drawn ? DoubtText(*drawn) : "-" });
  const auto& distance = certificate.Distance;
  const auto of = [&](double ContourDistance::*figure)
  { return distance ? std::optional<double>((*distance).*figure) : std::nullopt; };
  lines.push_back(
    { "Farthest contour point" + unit, RoundOr(of(&ContourDistance::FarthestVertex)) });
  lines.push_back({ "Mean of contour points" + unit, RoundOr(of(&ContourDistance::MeanVertex)) });
  lines.push_back({ "Farthest contour edge" + unit, RoundOr(of(&ContourDistance::FarthestEdge)) });
  lines.push_back({ "Worst section, %", RoundOr(certificate.WorstSectionPercent()) });
  lines.push_back({ "All sections, %", RoundOr(certificate.TotalSectionPercent()) });
}

std::string DescribeShape(const ComponentCertificate& total)
{
  const TopologyFigures& t = total.Topology;
  std::string text = Count(t.Triangles, "triangle", "triangles") + ", " +
    Count(t.Components, "component", "components") + ", Euler number " + std::to_string(t.Euler);
  if (t.Genus)
  {
    text += ", genus " + std::to_string(*t.Genus);
  }
  text += total.Mass.Volume ? ", volume " + Round(*total.Mass.Volume, 10) : ", no volume";
  return text + ", area " + Round(total.Mass.Area, 10) + ", smallest angle " +
    Round(total.Mass.SmallestAngle, 3) + " degrees.";
}

std::string DescribeContours(const SurfaceCertificate& certificate)
{
  std::string text = "Contours:";
  if (certificate.Distance)
  {
    text += " vertices at most " + Round(certificate.Distance->FarthestVertex, 3) +
      ", edges at most " + Round(certificate.Distance->FarthestEdge, 3) + " from the surface;";
  }
  const auto worst = certificate.WorstSectionPercent();
  return text +
    (worst ? " sections differ by at most " + Round(*worst, 3) + " % of a level's area."
           : " sections cannot be compared at every level.");
}
}

std::vector<CertificateFigure> ListFigures(const ComponentCertificate& certificate)
{
  Figures figures;
  AddFlag(figures, "Sound", certificate.IsSound());
  AddTopology(figures, certificate.Topology);
  AddCount(figures, "Nesting", certificate.Nesting);
  AddCount(figures, "CrossingPairs", certificate.Pairs.Crossing);
  AddCount(figures, "OverlappingPairs", certificate.Pairs.Overlapping);
  AddCount(figures, "TouchingPairs", certificate.Pairs.Touching);
  AddCount(figures, "CrossingEdges", certificate.CrossingEdges);
  AddReal(figures, "Volume", certificate.Mass.Volume);
  AddReal(figures, "Area", certificate.Mass.Area);
  AddPoint(figures, "Centroid", certificate.Mass.Centroid);
  AddPoint(figures, "Low", certificate.Mass.Low);
  AddPoint(figures, "High", certificate.Mass.High);
  AddReal(figures, "SmallestAngle", certificate.Mass.SmallestAngle);
  return figures;
}

std::vector<CertificateFigure> ListContourFigures(const SurfaceCertificate& certificate)
{
  const auto& distance = certificate.Distance;
  const auto of = [&](double ContourDistance::*figure)
  { return distance ? std::optional<double>((*distance).*figure) : std::nullopt; };
  Figures figures;
  figures.push_back({ "ContourVertices", CertificateFigure::Count,
    distance ? std::optional<double>(distance->Vertices) : std::nullopt });
  AddReal(figures, "FarthestContourVertex", of(&ContourDistance::FarthestVertex));
  AddReal(figures, "MeanContourVertex", of(&ContourDistance::MeanVertex));
  AddReal(figures, "FarthestContourEdge", of(&ContourDistance::FarthestEdge));
  AddReal(figures, "MeanContourEdge", of(&ContourDistance::MeanEdge));
  AddPoint(figures, "FarthestContour",
    distance ? std::optional<Point3>(distance->FarthestAt) : std::nullopt);
  AddReal(figures, "WorstSectionPercent", certificate.WorstSectionPercent());
  AddReal(figures, "TotalSectionPercent", certificate.TotalSectionPercent());
  const auto& drawn = certificate.Drawn;
  const auto volume = [&](double VolumeInterval::*figure)
  { return drawn ? std::optional<double>((*drawn).*figure) : std::nullopt; };
  AddReal(figures, "VolumeByContours", volume(&VolumeInterval::Estimate));
  AddReal(figures, "LowestVolume", volume(&VolumeInterval::Lowest));
  AddReal(figures, "HighestVolume", volume(&VolumeInterval::Highest));
  return figures;
}

std::vector<CertificateLine> ListLines(
  const SurfaceCertificate& certificate, bool millimetres, bool withContours)
{
  const ComponentCertificate& total = certificate.Total;
  const TopologyFigures& t = total.Topology;
  const std::string defects = ListDefects(total);
  const double cubes = millimetres ? CubicMillimetres : 1;
  const double squares = millimetres ? SquareMillimetres : 1;
  std::vector<CertificateLine> lines{
    { "Verdict", VerdictWord(total) },
    { "Found", defects.empty() ? "nothing wrong" : defects },
    { millimetres ? "Volume, cm3" : "Volume", RoundOr(Divided(total.Mass.Volume, cubes)) },
    { millimetres ? "Area, cm2" : "Area", RoundOr(total.Mass.Area / squares) },
    { "Closed", YesOrNo(t.Closed) },
    { "Manifold", YesOrNo(t.Manifold()) },
    { "Oriented outward", YesOrNo(t.Oriented && t.Outward) },
    { "Triangles cross",
      total.Pairs.Crossing + total.Pairs.Overlapping + total.CrossingEdges > 0 ? "YES" : "no" },
    { "Pieces", std::to_string(t.Components) },
    { "Tunnels", t.Genus ? std::to_string(*t.Genus) : "-" },
    { "Triangles", std::to_string(t.Triangles) },
    { "Smallest angle, degrees", RoundOr(total.Mass.SmallestAngle, 3) },
  };
  if (withContours)
  {
    AddContourLines(certificate, millimetres, lines);
  }
  return lines;
}

std::string ToVerdict(const SurfaceCertificate& certificate, bool millimetres)
{
  const ComponentCertificate& total = certificate.Total;
  if (total.Topology.Components == 0)
  {
    return "no surface";
  }
  const std::string defects = ListDefects(total);
  std::string text = VerdictWord(total);
  text += defects.empty() ? "" : " (" + defects + ")";
  if (!total.Mass.Volume)
  {
    return text + ", no volume";
  }
  return text + ", " +
    (millimetres ? Round(*total.Mass.Volume / CubicMillimetres, ReadDigits) + " cm3"
                 : "volume " + Round(*total.Mass.Volume, ReadDigits));
}

std::string ToJson(const SurfaceCertificate& certificate)
{
  Figures welded;
  AddTopology(welded, certificate.Welded);
  std::string text = "{\n \"Total\": " + ToJsonObject(ListFigures(certificate.Total));
  text += ",\n \"Welded\": " + ToJsonObject(welded);
  text += ",\n \"Components\": " +
    ToJsonArray(certificate.Components,
      [](const ComponentCertificate& c) { return ToJsonObject(ListFigures(c)); });
  text += ",\n \"Contours\": " + ToJsonObject(ListContourFigures(certificate));
  text += ",\n \"Sections\": " +
    ToJsonArray(certificate.Sections,
      [](const SectionDifference& s) { return ToJsonObject(ListSection(s)); });
  text += ",\n \"Doubts\": " +
    ToJsonArray(certificate.Drawn ? certificate.Drawn->Doubts : std::vector<VolumeDoubt>(),
      [](const VolumeDoubt& doubt) { return ToJsonObject(ListDoubt(doubt)); });
  return text + "\n}\n";
}

std::vector<std::string> ToShortText(const SurfaceCertificate& certificate)
{
  std::vector<std::string> lines{ DescribeState(certificate.Total) };
  const std::string defects = ListDefects(certificate.Total);
  if (!defects.empty())
  {
    lines.push_back("Found: " + defects + ".");
  }
  if (certificate.Total.Topology.Components > 0)
  {
    lines.push_back(DescribeShape(certificate.Total));
  }
  if (!certificate.Sections.empty())
  {
    lines.push_back(DescribeContours(certificate));
  }
  if (certificate.Drawn)
  {
    lines.push_back("Volume by the contours: " + IntervalText(*certificate.Drawn, 1) +
      "; another slice would tell most at " + DoubtText(*certificate.Drawn) + " along the stack.");
  }
  return lines;
}
}
