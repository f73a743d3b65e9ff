// SPDX-License-Identifier: GPL-3.0-or-later
#include "CollectionVerdict.h"

#include "Core/Polyhedral/DegenerateStacks.h"

#include "Implicit/ImplicitSurface.h"
#include "Mesh/Certificate.h"
#include "Mesh/CertificateText.h"

#include <algorithm>
#include <ctime>

namespace recon::collection
{
namespace
{
double ProcessorSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// The first line of a report that has those words, or the last of all.
std::string LineWith(const std::vector<std::string>& report, const std::string& words)
{
  const auto line = std::find_if(report.begin(), report.end(),
    [&](const std::string& text) { return text.find(words) != std::string::npos; });
  return line != report.end() ? *line : report.empty() ? "" : report.back();
}

class Judgement
{
public:
  explicit Judgement(const Case& given) : Given(given) {}

  Verdict Pass()
  {
    const double start = ProcessorSeconds();
    try
    {
      this->Contours = BuildContourSet(this->Given.Soup, this->Given.Cleaning, this->Silent);
      this->Said.Points = this->Contours.Points.size();
      this->Said.Levels = this->Contours.Levels.size();
      this->Said.Diagonal = this->Contours.Bounds().Diagonal();
      this->Given.Implicit ? this->MakeImplicit(start) : this->MakePolyhedral(start);
    }
    catch (const Error& error)
    {
      this->Said.Seconds = ProcessorSeconds() - start;
      this->Said.Kind = Verdict::Refused;
      this->Said.Reason = error.what();
    }
    return std::move(this->Said);
  }

private:
  void MakePolyhedral(double start)
  {
    const PolyhedralSurface surface =
      BuildPolyhedralSurface(this->Contours, this->Given.Options, this->Silent);
    this->Said.Seconds = ProcessorSeconds() - start;
    this->Said.Mesh = surface.Mesh;
    this->Blame(testing::BrokenPromises(surface, this->Contours, this->Given.Options));
    this->Certify(surface.Report);
  }

  void MakeImplicit(double start)
  {
    ImplicitSurfaceOptions options;
    options.Polygonizer.Detail =
      this->Given.Seed % 4 == 0 ? PolygonizerOptions::Medium : PolygonizerOptions::Coarse;
    options.Polygonizer.Threads = options.Function.Threads = 1;
    const ImplicitSurface surface = BuildImplicitSurface(this->Contours, options, this->Silent);
    this->Said.Seconds = ProcessorSeconds() - start;
    this->Said.Mesh = surface.Mesh.Mesh;
    this->Certify(surface.Report);
  }

  void Blame(const std::string& words)
  {
    if (!words.empty())
    {
      this->Said.Kind = Verdict::Unsound;
      this->Said.Reason += words + " ";
    }
  }

  void Certify(const std::vector<std::string>& report)
  {
    if (this->Said.Mesh.Triangles.empty())
    {
      this->Said.Kind = Verdict::Refused;
      this->Said.Reason = LineWith(report, "left out");
      this->Blame(this->Said.Reason.empty() ? "nothing, and no reason why" : "");
      return;
    }
    CertificateOptions options;
    options.Threads = 1;
    const SurfaceCertificate certificate =
      recon::Certify(this->Said.Mesh, &this->Contours, options, this->Silent);
    this->Said.Volume = certificate.Total.Mass.Volume.value_or(0);
    this->Said.Area = certificate.Total.Mass.Area;
    this->Said.Off = this->Given.Implicit
      ? 100 * (certificate.Distance ? certificate.Distance->MeanVertex : 0) / this->Said.Diagonal
      : certificate.TotalSectionPercent().value_or(100);
    this->Blame(certificate.Total.IsSound() ? "" : ToVerdict(certificate, false));
    if (!certificate.Welded.Manifold() && this->Said.Kind == Verdict::Sound)
    {
      const std::string line = LineWith(report, "no way apart was found");
      const bool isTold = line.find("no way apart was found") != std::string::npos;
      this->Said.Kind = isTold ? Verdict::Told : Verdict::Unsound;
      this->Said.Reason = isTold ? line : "no manifold by coordinates";
    }
  }

  const Case& Given;
  Monitor Silent;
  ContourSet Contours;
  Verdict Said;
};
}

Verdict Judge(const Case& given)
{
  return Judgement(given).Pass();
}

const char* NameOf(Verdict::KindType kind)
{
  switch (kind)
  {
    case Verdict::Sound:
      return "sound";
    case Verdict::Told:
      return "told";
    case Verdict::Refused:
      return "refused";
    default:
      return "unsound";
  }
}
}
