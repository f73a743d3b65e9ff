// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a soup of triangles: its certificate adds up, and what it calls sound is a boundary representation that
// can be written and read.
#include "FuzzTarget.h"
#include "InputBytes.h"

#include "Mesh/BRep.h"
#include "Mesh/Certificate.h"
#include "Mesh/CertificateText.h"

namespace
{
recon::TriangleMesh DrawMesh(fuzz::InputBytes& bytes)
{
  recon::TriangleMesh mesh;
  const int style = bytes.Below(4);
  const int points = bytes.Between(1, 40);
  const auto coordinate = [&]() -> double
  {
    const int byte = bytes.Byte();
    return style == 0 ? byte % 3
      : style == 1    ? byte / 16 * 0.1 + byte % 16 * 0.1
      : style == 2    ? (byte - 128) * 1e6
      : byte < 16     ? bytes.Real()
                      : byte;
  };
  for (int i = 0; i < points; ++i)
  {
    const double x = coordinate();
    const double y = coordinate();
    mesh.Points.push_back({ x, y, coordinate() });
  }
  // Sometimes a point that is not there.
  const auto corner = [&]
  {
    const int byte = bytes.Byte();
    return byte == 255 ? -1 : byte == 254 ? points : byte % points;
  };
  for (int i = 0; i < 200 && !bytes.AtEnd(); ++i)
  {
    const int a = corner();
    const int b = corner();
    mesh.Triangles.push_back({ a, b, corner() });
  }
  return mesh;
}
}

void fuzz::Try(const std::string& bytes)
{
  InputBytes input(bytes);
  recon::CertificateOptions options;
  options.Weld = input.Flag();
  options.Threads = 1;
  const recon::TriangleMesh mesh = DrawMesh(input);
  recon::Monitor monitor;
  const recon::SurfaceCertificate certificate = recon::Certify(mesh, nullptr, options, monitor);
  const recon::TopologyFigures& total = certificate.Total.Topology;
  Require(total.Triangles == static_cast<int>(mesh.Triangles.size()), "triangles got lost");
  Require(total.Components == static_cast<int>(certificate.Components.size()), "components");
  int open = 0;
  for (const recon::ComponentCertificate& component : certificate.Components)
  {
    open += component.Topology.OpenEdges;
  }
  Require(open == total.OpenEdges, "the components have another number of open edges");
  Require(!recon::ToJson(certificate).empty() && !recon::ToShortText(certificate).empty(), "words");
  if (!certificate.Total.IsSound() || options.Weld || total.DegenerateTriangles > 0)
  {
    return;
  }
  std::vector<int> missing;
  const recon::BRep brep = recon::MakeBRep(mesh, {}, {}, missing, monitor);
  for (const recon::BRepShell& shell : brep.ShellSets.at(0).Shells)
  {
    RequireNone(recon::FindShellDefect(shell));
  }
  Require(recon::MakeMesh(brep).Mesh.Triangles.size() == mesh.Triangles.size(), "another mesh");
}
