// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file bench_constants.cxx
 * @brief What half and double of every tuned constant of the core make of shapes whose truth is known.
 *
 *   bench_constants FOLDER_OF_MESHES [--half first|second] [--scene TEXT] [--shapes N] [--only TEXT,TEXT,...]
 *     [--factors A,B,...] [--phase P]
 *
 * Phase says where in their slices the sections lie, 0.5 by default: in the middle, so that shapes end half a slice beyond.
 *
 * A scene is one way through the core on one shape; shapes are in two halves, so that what is chosen on the one can be
 * held against the other. Of each scene's constants (those that it is seen to read) each is scaled in turn,
 * all others being as they are; every run is a process of its own, so a value with which the core fails is a finding,
 * not the end. Prints a tab-separated line a run: scene, shape, half, constant, its value, factor, whether
 * the output is the same to the bit, CPU seconds, and figures as name=value; first the run with the constants as they are.
 */
#include "Shapes.h"
#include "Variable.h"

#include "Contours/ContourSetBuilder.h"
#include "Implicit/FastMultipole/FunctionEvaluator.h"
#include "Implicit/ImplicitSurface.h"
#include "Implicit/ZeroSet/ContourTracer.h"
#include "Mesh/Certificate.h"
#include "Polyhedral/PolyhedralSurface.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <map>
#include <random>
#include <set>

using namespace recon;

namespace
{
/// Runs that take longer than this many seconds are ended.
constexpr unsigned MostSeconds = 60;
/// A time that differs by less from the usual one is taken for the same; else it is measured again.
constexpr double SameTime = 0.2;

struct Shape
{
  const char* Name;
  int Axis;
  const char* Half;
  double Phase = 0.5; ///< of the sections in their slices
};

const std::vector<Shape> Shapes{ { "femur", 2, "first" }, { "knot2", 0, "first" },
  { "elephant", 1, "first" }, { "fertility", 2, "second" }, { "couplingdown", 0, "second" },
  { "bones", 1, "second" } };

struct Outcome
{
  std::uint64_t Digest = 14695981039346656037ull;
  std::vector<std::pair<std::string, double>> Figures;
  std::string Failure;
  double CPU = 0;

  void Say(const char* name, double value) { this->Figures.emplace_back(name, value); }

  void Digested(const void* data, std::size_t bytes)
  {
    const auto* at = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < bytes; ++i)
    {
      this->Digest = (this->Digest ^ at[i]) * 1099511628211ull;
    }
  }
  template <typename T>
  void Digested(const std::vector<T>& values)
  {
    this->Digested(values.data(), values.size() * sizeof(T));
  }
  void Digested(const std::vector<std::string>& lines)
  {
    for (const std::string& line : lines)
    {
      this->Digested(line.data(), line.size());
    }
  }
  void Digested(const TriangleMesh& mesh)
  {
    this->Digested(mesh.Points);
    this->Digested(mesh.Triangles);
  }
};

double ProcessSeconds()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t)
  { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// What every surface is judged by. The time of this is not counted.
void Judge(const TriangleMesh& mesh, const TriangleMesh& truth, Outcome& outcome)
{
  Monitor monitor;
  outcome.CPU = ProcessSeconds();
  outcome.Digested(mesh);
  const shapes::Deviation deviation = shapes::Compare(mesh, truth);
  CertificateOptions options;
  options.Threads = 1;
  const SurfaceCertificate certificate = Certify(mesh, nullptr, options, monitor);
  const double volume = shapes::VolumeOf(truth);
  outcome.Say("mean", deviation.Mean);
  outcome.Say("largest", deviation.Largest);
  outcome.Say("volume%", 100 * (shapes::VolumeOf(mesh) / volume - 1));
  outcome.Say("Euler", certificate.Total.Topology.Euler);
  outcome.Say("truth", shapes::EulerOf(truth));
  outcome.Say("crossing",
    static_cast<double>(certificate.Total.Pairs.Crossing + certificate.Total.Pairs.Overlapping));
  outcome.Say("angle", certificate.Total.Mass.SmallestAngle);
  outcome.Say("triangles", static_cast<double>(mesh.Triangles.size()));
}

ContourSet ContoursOf(const TriangleMesh& truth, const Shape& shape, int slices, bool parallel)
{
  Monitor monitor;
  ContourSetOptions options;
  options.Parallel = parallel;
  return BuildContourSet(shapes::Cut(truth, shape.Axis, slices, shape.Phase), options, monitor);
}

/// Polyhedral Surface as its node does it.
void Polyhedral(const TriangleMesh& truth, const Shape& shape, Outcome& outcome)
{
  Monitor monitor;
  PolyhedralOptions options;
  options.Mapping = PolyhedralOptions::Overlap;
  options.EndCaps = PolyhedralOptions::Tapered;
  options.IsolatedContours = PolyhedralOptions::Extrude;
  options.AlignLevels = LevelAlignmentMode::Automatic;
  options.PinchGap = 1e-3;
  options.Threads = 1;
  const PolyhedralSurface made =
    BuildPolyhedralSurface(ContoursOf(truth, shape, 24, true), options, monitor);
  outcome.Digested(made.Report);
  Judge(made.Mesh, truth, outcome);
}

ImplicitSurfaceOptions ImplicitOptions()
{
  ImplicitSurfaceOptions options;
  options.Function.Threads = 1;
  options.Polygonizer.Threads = 1;
  return options;
}

/// Implicit Surface as its node does it, on few slices, and its contours on planes between them.
void Implicit(const TriangleMesh& truth, const Shape& shape, Outcome& outcome)
{
  Monitor monitor;
  const ContourSet contours = ContoursOf(truth, shape, 10, false);
  ImplicitSurfaceOptions options = ImplicitOptions();
  // As coarse as tells one value from another, so that a sweep does not take a day.
  options.Polygonizer.CellSize = DiagonalOf(BoundsOf(SeedsOf(contours))) / 50;
  const ImplicitSurface made = BuildImplicitSurface(contours, options, monitor);
  TracerOptions tracing;
  tracing.CellSize = options.Polygonizer.CellSize;
  tracing.Box = ChooseBoundsOf(contours);
  tracing.Threads = 1;
  const ContourSet traced = TraceContours(
    made.Fit.Function, SeedsOf(made.Fit.Contours), PlanesOf(contours), tracing, monitor);
  outcome.Digested(traced.Points);
  outcome.Digested(made.Report);
  outcome.Say("misfit", made.Fit.Function.Residual);
  Judge(made.Mesh.Mesh, truth, outcome);
}

/// Implicit Surface as a coarse preview.
void Preview(const TriangleMesh& truth, const Shape& shape, Outcome& outcome)
{
  Monitor monitor;
  ImplicitSurfaceOptions options = ImplicitOptions();
  options.Polygonizer.Detail = PolygonizerOptions::Coarse;
  const ImplicitSurface made =
    BuildImplicitSurface(ContoursOf(truth, shape, 24, false), options, monitor);
  outcome.Digested(made.Report);
  Judge(made.Mesh.Mesh, truth, outcome);
}

/// Points of a box, evenly: Halton's sequence.
std::vector<Point3> Places(const std::vector<Point3>& around, int count)
{
  const Bounds box = BoundsOf(around);
  const std::array<int, 3> bases{ 2, 3, 5 };
  std::vector<Point3> places(count);
  for (int i = 0; i < count; ++i)
  {
    for (int a = 0; a < 3; ++a)
    {
      double part = 1, place = 0;
      for (int k = i + 1; k > 0; k /= bases[a])
      {
        part /= bases[a];
        place += part * (k % bases[a]);
      }
      places[i][a] = box[2 * a] + (box[2 * a + 1] - box[2 * a]) * place;
    }
  }
  return places;
}

/// The iterative solver and the fast sums, on constraints enough for these.
void Iterative(const TriangleMesh& truth, const Shape& shape, Outcome& outcome)
{
  Monitor monitor;
  ConstraintOptions constraining;
  constraining.ThinOut = false;
  const ConstraintSet constraints =
    BuildInPlaneConstraints(ContoursOf(truth, shape, 24, false), constraining, monitor);
  FunctionOptions options;
  options.Solver = FunctionOptions::Iterative;
  options.Threads = 1;
  const double begun = ProcessSeconds();
  const ImplicitFunction function =
    FitImplicitFunction(constraints.Points, constraints.Values, options, monitor);
  const double fitted = ProcessSeconds();
  const std::vector<Point3> places = Places(function.Centres, 30000);
  const FunctionEvaluator evaluator(function, 1);
  const std::vector<double> values = evaluator.Values(places, monitor);
  outcome.CPU = ProcessSeconds();
  outcome.Digested(function.Weights);
  outcome.Digested(values);
  const std::vector<Point3> some(places.begin(), places.begin() + 300);
  const std::vector<double> exact = function.Evaluate(some, 1);
  double error = 0;
  for (std::size_t i = 0; i < some.size(); ++i)
  {
    error = std::max(error, std::abs(exact[i] - values[i]));
  }
  outcome.Say("constraints", static_cast<double>(constraints.Points.size()));
  outcome.Say("misfit/range", function.Residual / constraints.MarginDistance);
  outcome.Say("steps", function.Iterations);
  outcome.Say("error/range", error / constraints.MarginDistance);
  outcome.Say("fit", fitted - begun);
  outcome.Say("evaluation", outcome.CPU - fitted);
}

/// Fewer centres than constraints.
void Reduced(const TriangleMesh& truth, const Shape& shape, Outcome& outcome)
{
  Monitor monitor;
  ImplicitSurfaceOptions options = ImplicitOptions();
  options.Constraints.Normals = ConstraintOptions::InPlane;
  options.Constraints.FollowDrawnPlanes = false;
  const ContourSet contours = ContoursOf(truth, shape, 10, false);
  options.Function.CentreReduction = 0.1 * ChooseMarginDistance(contours, options.Constraints);
  const ContourFit fit = FitContours(contours, options.Constraints, options.Function, monitor);
  outcome.CPU = ProcessSeconds();
  outcome.Digested(fit.Function.Weights);
  outcome.Say("centres", static_cast<double>(fit.Function.Centres.size()));
  outcome.Say("constraints", static_cast<double>(fit.Constraints.Points.size()));
}

/// Turned out of the axes, rounded, drawn twice in part, and with pieces missing.
LoopSoup Untidied(LoopSoup soup, double diagonal)
{
  const PlanarFrame frame = PlanarFrame::About((1 / std::sqrt(1.1)) * Vector3{ 0.3, 0.1, 1 });
  const double grain = std::pow(10, std::floor(std::log10(diagonal)) - 3);
  for (Point3& p : soup.Points)
  {
    const Point3 turned = p[0] * frame.U + (p[1] * frame.V + p[2] * frame.Normal);
    for (int a = 0; a < 3; ++a)
    {
      p[a] = std::round(turned[a] / grain) * grain;
    }
  }
  std::mt19937_64 random(2);
  std::vector<LoopSoup::Chain> kept;
  for (const LoopSoup::Chain& chain : soup.Chains)
  {
    if (random() % 200 != 0)
    {
      kept.push_back(chain);
    }
    if (random() % 300 == 0)
    {
      kept.push_back(chain);
    }
  }
  soup.Chains = std::move(kept);
  return soup;
}

/// What is made of contours that are not tidy.
void Untidy(const TriangleMesh& truth, const Shape& shape, Outcome& outcome)
{
  Monitor monitor;
  Box3 box;
  for (const Point3& p : truth.Points)
  {
    box.Add(p);
  }
  const LoopSoup soup =
    Untidied(shapes::Cut(truth, shape.Axis, 24, shape.Phase), Norm(box.High - box.Low));
  ContourSetOptions options;
  options.OpenLines = OpenLineRule::Chord;
  const ContourSet contours = BuildContourSet(soup, options, monitor);
  outcome.CPU = ProcessSeconds();
  outcome.Digested(contours.Points);
  outcome.Digested(contours.Report);
  double area = 0;
  for (const Contour& contour : contours.Contours)
  {
    area += std::abs(contour.SignedArea);
  }
  outcome.Say("contours", static_cast<double>(contours.Contours.size()));
  outcome.Say("levels", static_cast<double>(contours.Levels.size()));
  outcome.Say("points", static_cast<double>(contours.Points.size()));
  outcome.Say("area", area);
  outcome.Say("lines", static_cast<double>(contours.Report.size()));
}

struct Scene
{
  const char* Name;
  void (*Run)(const TriangleMesh& truth, const Shape& shape, Outcome& outcome);
  std::size_t ShapesAHalf; ///< the first of each half
};
const std::vector<Scene> Scenes{ { "polyhedral", Polyhedral, 3 }, { "implicit", Implicit, 2 },
  { "preview", Preview, 2 }, { "iterative", Iterative, 1 }, { "reduced", Reduced, 1 },
  { "untidy", Untidy, 2 } };

/// A run in a process of its own; what it reads is in `read` where that is given.
Outcome RunApart(const Scene& scene, const Shape& shape, const TriangleMesh& truth,
  variables::Variable* variable, double factor, std::set<std::string>* read)
{
  int ends[2];
  if (pipe(ends) != 0)
  {
    throw std::runtime_error("There is no pipe.");
  }
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0)
  {
    alarm(MostSeconds);
    Outcome outcome;
    if (variable != nullptr)
    {
      variables::Scale(*variable, factor);
    }
    if (read != nullptr)
    {
      variables::Watch();
    }
    const double begun = ProcessSeconds();
    try
    {
      scene.Run(truth, shape, outcome);
    }
    catch (const std::exception& error)
    {
      outcome.Failure = error.what();
    }
    FILE* out = fdopen(ends[1], "w");
    std::fprintf(out, "digest %llu\ncpu %.9g\n", static_cast<unsigned long long>(outcome.Digest),
      outcome.CPU - begun);
    for (const auto& [name, value] : outcome.Figures)
    {
      std::fprintf(out, "figure %s %.9g\n", name.c_str(), value);
    }
    if (!outcome.Failure.empty())
    {
      std::fprintf(out, "failure %s\n", outcome.Failure.c_str());
    }
    for (const variables::Variable* of : variables::All())
    {
      if (of->Read)
      {
        std::fprintf(out, "read %s\n", of->Name.c_str());
      }
    }
    std::fclose(out);
    std::_Exit(0);
  }
  close(ends[1]);
  Outcome outcome;
  FILE* in = fdopen(ends[0], "r");
  char line[4096];
  while (std::fgets(line, sizeof line, in) != nullptr)
  {
    std::string said = line;
    said.pop_back();
    const std::string what = said.substr(0, said.find(' '));
    const std::string rest = said.substr(what.size() + 1);
    if (what == "digest")
    {
      outcome.Digest = std::strtoull(rest.c_str(), nullptr, 10);
    }
    else if (what == "cpu")
    {
      outcome.CPU = std::atof(rest.c_str());
    }
    else if (what == "figure")
    {
      const std::size_t space = rest.find(' ');
      outcome.Figures.emplace_back(rest.substr(0, space), std::atof(rest.c_str() + space));
    }
    else if (what == "failure")
    {
      outcome.Failure = rest;
    }
    else if (read != nullptr)
    {
      read->insert(rest);
    }
  }
  std::fclose(in);
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSIGNALED(status))
  {
    outcome.Failure = WTERMSIG(status) == SIGALRM
      ? "takes more than a minute"
      : "ends by signal " + std::to_string(WTERMSIG(status));
  }
  return outcome;
}

void Print(const Scene& scene, const Shape& shape, const std::string& constant, double value,
  double factor, const Outcome& outcome, const Outcome& usual)
{
  std::printf("%s\t%s %c\t%s\t%s\t%.9g\t%g\t%s\t%.4g", scene.Name, shape.Name, "xyz"[shape.Axis],
    shape.Half, constant.c_str(), value, factor,
    !outcome.Failure.empty()           ? outcome.Failure.c_str()
      : outcome.Digest == usual.Digest ? "same"
                                       : "other",
    outcome.CPU);
  for (const auto& [name, figure] : outcome.Figures)
  {
    std::printf("\t%s=%.6g", name.c_str(), figure);
  }
  std::printf("\n");
  std::fflush(stdout);
}

/// The least time of runs that are otherwise alike.
void TimeAgain(Outcome& outcome, const std::function<Outcome()>& run, int times)
{
  for (int i = 0; i < times; ++i)
  {
    const Outcome again = run();
    if (again.CPU < outcome.CPU)
    {
      outcome.CPU = again.CPU;
      outcome.Figures = again.Figures;
    }
  }
}

struct Settings
{
  std::string Folder, Half, SceneName, Only;
  std::size_t ShapesAHalf = 3; ///< no more of each half than this
  std::vector<double> Factors{ 0.5, 2 };
  double Phase = 0.5;
};

/// Whether a name has one of the texts in it, which commas part.
bool IsMeant(const std::string& name, const std::string& texts)
{
  std::size_t from = 0;
  while (from <= texts.size())
  {
    const std::size_t to = std::min(texts.find(',', from), texts.size());
    if (name.find(texts.substr(from, to - from)) != std::string::npos)
    {
      return true;
    }
    from = to + 1;
  }
  return false;
}

/// Function-local constants are registered in the child alone where they are first met: so one run here first.
void Sweep(
  const Scene& scene, const Shape& shape, const TriangleMesh& truth, const Settings& settings)
{
  {
    Outcome warm;
    try
    {
      scene.Run(truth, shape, warm);
    }
    catch (const std::exception&)
    {
    }
  }
  std::set<std::string> read;
  RunApart(scene, shape, truth, nullptr, 1, &read);
  const auto asIs = [&]() { return RunApart(scene, shape, truth, nullptr, 1, nullptr); };
  Outcome usual = asIs();
  TimeAgain(usual, asIs, 1);
  Print(scene, shape, "as they are", 1, 1, usual, usual);
  for (variables::Variable* variable : variables::All())
  {
    if (read.count(variable->Name) == 0 || !IsMeant(variable->Name, settings.Only))
    {
      continue;
    }
    for (const double factor : settings.Factors)
    {
      const auto run = [&]() { return RunApart(scene, shape, truth, variable, factor, nullptr); };
      Outcome outcome = run();
      if (outcome.Failure.empty() && std::abs(outcome.CPU / usual.CPU - 1) > SameTime)
      {
        TimeAgain(outcome, run, 1);
      }
      Print(scene, shape, variable->Name, variable->Value, factor, outcome, usual);
    }
  }
}

Settings Parse(int argc, char** argv)
{
  Settings settings;
  settings.Folder = argc > 1 ? argv[1] : ".";
  for (int i = 2; i + 1 < argc; i += 2)
  {
    const std::string option = argv[i];
    const std::map<std::string, std::string*> texts{ { "--half", &settings.Half },
      { "--scene", &settings.SceneName }, { "--only", &settings.Only } };
    if (const auto text = texts.find(option); text != texts.end())
    {
      *text->second = argv[i + 1];
    }
    else if (option == "--shapes")
    {
      settings.ShapesAHalf = std::strtoul(argv[i + 1], nullptr, 10);
    }
    else if (option == "--phase")
    {
      settings.Phase = std::strtod(argv[i + 1], nullptr);
    }
    else if (option == "--factors")
    {
      settings.Factors.clear();
      for (char* at = argv[i + 1]; *at != 0; at += *at == ',' ? 1 : 0)
      {
        settings.Factors.push_back(std::strtod(at, &at));
      }
    }
    else
    {
      throw std::runtime_error("There is no option " + option + ".");
    }
  }
  return settings;
}

void Run(const Settings& settings)
{
  for (const Scene& scene : Scenes)
  {
    std::map<std::string, std::size_t> done;
    for (const Shape& shape : Shapes)
    {
      if (std::string(scene.Name).find(settings.SceneName) == std::string::npos ||
        std::string(shape.Half).find(settings.Half) == std::string::npos ||
        done[shape.Half]++ >= std::min(scene.ShapesAHalf, settings.ShapesAHalf))
      {
        continue;
      }
      Shape cut = shape;
      cut.Phase = settings.Phase;
      Sweep(scene, cut, shapes::ReadOFF(settings.Folder + "/" + shape.Name + ".off"), settings);
    }
  }
}
}

int main(int argc, char** argv)
{
  try
  {
    Run(Parse(argc, argv));
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "bench_constants: %s\n", error.what());
    return 1;
  }
  return 0;
}
