// SPDX-License-Identifier: GPL-3.0-or-later
// Contours of a NUAGES file (.cnt) in, the closed surface through them out (.stl).
#include "Contours/ContourSetBuilder.h"
#include "Mesh/CertificateText.h"
#include "NUAGES/NUAGESParser.h"
#include "Polyhedral/PolyhedralSurface.h"

#include <cstdio>
#include <fstream>

namespace
{
void WriteSTL(const recon::TriangleMesh& mesh, const char* fileName)
{
  std::ofstream file(fileName);
  file.precision(9);
  file << "solid contours\n";
  for (const auto& corners : mesh.Triangles)
  {
    // Programs that read STL compute the normal from the corners where it is zero.
    file << "facet normal 0 0 0\nouter loop\n";
    for (const int i : corners)
    {
      const recon::Point3& p = mesh.Points[i];
      file << "vertex " << p[0] << " " << p[1] << " " << p[2] << "\n";
    }
    file << "endloop\nendfacet\n";
  }
  file << "endsolid contours\n";
  if (!file.flush())
  {
    throw recon::Error(std::string("Cannot write ") + fileName + ".");
  }
}

void Reconstruct(const char* contourFile, const char* surfaceFile)
{
  recon::Monitor monitor; // derive from it to show progress and to stop
  const recon::ContourFile file = recon::ReadNUAGES(contourFile, monitor);
  const recon::ContourSet contours = recon::BuildContourSet(file.Soup, {}, monitor);

  recon::PolyhedralOptions options;
  options.Mapping = recon::PolyhedralOptions::Overlap;
  options.EndCaps = recon::PolyhedralOptions::Tapered;
  options.IsolatedContours = recon::PolyhedralOptions::Extrude;
  const auto surface = recon::BuildPolyhedralSurface(contours, options, monitor);
  for (const std::string& line : surface.Report)
  {
    std::printf("%s\n", line.c_str());
  }

  const auto certificate = recon::Certify(surface.Mesh, &contours, {}, monitor);
  for (const std::string& line : recon::ToShortText(certificate))
  {
    std::printf("%s\n", line.c_str());
  }
  WriteSTL(surface.Mesh, surfaceFile);
}
}

int main(int argc, char** argv)
{
  if (argc != 3)
  {
    std::fprintf(stderr, "Usage: brain-surface CONTOURS.cnt SURFACE.stl\n");
    return 2;
  }
  try
  {
    Reconstruct(argv[1], argv[2]);
    return 0;
  }
  catch (const recon::Error& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
