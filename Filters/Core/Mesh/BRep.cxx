// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/BRep.h"

#include "Mesh/ContourEdges.h"
#include "Mesh/HalfEdges.h"

#include <algorithm>
#include <map>
#include <string>

namespace recon
{
namespace
{
//----- checking
//-------------------------------------------------------------------------------------
class ShellChecker
{
public:
  explicit ShellChecker(const BRepShell& shell) : Shell(shell) {}

  std::string Check()
  {
    const bool sound =
      this->CheckNumbers() && this->CheckFaces() && this->CheckPartners() && this->CheckContours();
    return sound ? std::string() : this->Sentence;
  }

private:
  bool Fail(const std::string& sentence)
  {
    this->Sentence = sentence;
    return false;
  }

  /// "half-edge 5 (2-0)"
  std::string Name(int h) const
  {
    const auto& ends = this->Shell.Edges[h];
    return "half-edge " + std::to_string(h) + " (" + std::to_string(ends[0]) + "-" +
      std::to_string(ends[1]) + ")";
  }

  bool IsHalfEdge(int h) const { return h >= 0 && h < static_cast<int>(this->Shell.Edges.size()); }

  std::string NoHalfEdge(int h) const
  {
    return "names half-edge " + std::to_string(h) + ", but the shell has " +
      std::to_string(this->Shell.Edges.size()) + ", counted from 0";
  }

  bool CheckNumbers()
  {
    const BRepShell& shell = this->Shell;
    if (shell.Edges.size() != 3 * shell.Faces.size() || shell.Partners.size() != shell.Edges.size())
    {
      return this->Fail("there are " + std::to_string(shell.Edges.size()) + " half-edges for " +
        std::to_string(shell.Faces.size()) + " faces, but it takes three a face");
    }
    const int vertices = static_cast<int>(shell.Vertices.size());
    for (std::size_t h = 0; h < shell.Edges.size(); ++h)
    {
      for (const int vertex : shell.Edges[h])
      {
        if (vertex < 0 || vertex >= vertices)
        {
          return this->Fail("half-edge " + std::to_string(h) + " names vertex " +
            std::to_string(vertex) + ", but the shell has " + std::to_string(vertices) +
            ", counted from 0");
        }
      }
      if (!this->IsHalfEdge(shell.Partners[h]))
      {
        return this->Fail("the partner of half-edge " + std::to_string(h) + " " +
          this->NoHalfEdge(shell.Partners[h]));
      }
    }
    return true;
  }

  bool CheckFaces()
  {
    std::vector<int> faceOf(this->Shell.Edges.size(), -1);
    for (std::size_t f = 0; f < this->Shell.Faces.size(); ++f)
    {
      const std::array<int, 3>& face = this->Shell.Faces[f];
      const std::string name = "face " + std::to_string(f) + " ";
      for (const int h : face)
      {
        if (!this->IsHalfEdge(h))
        {
          return this->Fail(name + this->NoHalfEdge(h));
        }
        if (faceOf[h] >= 0)
        {
          return this->Fail(
            this->Name(h) + " is in face " + std::to_string(faceOf[h]) + " and in " + name + "too");
        }
        faceOf[h] = static_cast<int>(f);
      }
      for (int i = 0; i < 3; ++i)
      {
        const int here = face[i];
        const int next = face[(i + 1) % 3];
        if (this->Shell.Edges[here][1] != this->Shell.Edges[next][0])
        {
          return this->Fail(
            name + "does not close: " + this->Name(here) + " is followed by " + this->Name(next));
        }
        if (this->Shell.Edges[here][0] == this->Shell.Edges[here][1])
        {
          return this->Fail(name + "has an edge without length: " + this->Name(here));
        }
      }
    }
    return true;
  }

  bool SamePosition(int a, int b) const
  {
    // By number first: a coordinate that is no number equals nothing, and is another defect.
    return a == b || this->Shell.Vertices[a] == this->Shell.Vertices[b];
  }

  bool ArePartners(int h, int g) const
  {
    return this->Shell.Partners[g] == h && this->Shell.Edges[g][0] == this->Shell.Edges[h][1] &&
      this->Shell.Edges[g][1] == this->Shell.Edges[h][0];
  }

  bool CheckPartners()
  {
    std::vector<int> before(this->Shell.Edges.size(), -1); // along a border
    for (int h = 0; this->IsHalfEdge(h); ++h)
    {
      const int g = this->Shell.Partners[h];
      if (this->ArePartners(h, g))
      {
        continue;
      }
      const std::string pair = this->Name(h) + " has " + this->Name(g) + " as its partner, ";
      if (this->Shell.Edges[g][0] != this->Shell.Edges[h][1])
      {
        return this->Fail(pair +
          "which is neither the same edge the other way round nor the next one along a border");
      }
      if (this->ArePartners(g, this->Shell.Partners[g]))
      {
        return this->Fail(
          pair + "which has " + this->Name(this->Shell.Partners[g]) + " as its own");
      }
      if (before[g] >= 0)
      {
        return this->Fail(pair + "and so has " + this->Name(before[g]) +
          ": a border cannot be entered from two sides");
      }
      before[g] = h;
    }
    return true;
  }

  bool CheckContours()
  {
    for (std::size_t c = 0; c < this->Shell.Contours.size(); ++c)
    {
      const std::vector<int>& loop = this->Shell.Contours[c];
      const std::string name = "contour " + std::to_string(c) + " ";
      for (const int h : loop)
      {
        if (!this->IsHalfEdge(h))
        {
          return this->Fail(name + this->NoHalfEdge(h));
        }
      }
      for (std::size_t i = 0; i < loop.size(); ++i)
      {
        const int next = loop[(i + 1) % loop.size()];
        if (!this->SamePosition(this->Shell.Edges[loop[i]][1], this->Shell.Edges[next][0]))
        {
          return this->Fail(name + "is no closed loop: " + this->Name(loop[i]) +
            " is followed by " + this->Name(next));
        }
      }
    }
    return true;
  }

  const BRepShell& Shell;
  std::string Sentence;
};

//----- building
//-------------------------------------------------------------------------------------
class Builder
{
public:
  Builder(const TriangleMesh& mesh, const std::vector<int>& sets, Monitor& monitor)
    : Mesh(mesh),
      Sets(sets),
      Progress(monitor),
      Edges(mesh),
      Components(Edges.Components())
  {
  }

  BRep Build(const std::vector<SpaceLoop>& contours, std::vector<int>& missing)
  {
    this->Shells.resize(*std::max_element(this->Components.begin(), this->Components.end()) + 1);
    this->FillTriangles();
    this->FillPartners();
    this->FillContours(contours, missing);
    this->FillBorders();
    return this->GroupShells();
  }

private:
  BRepShell& ShellOf(int h) { return this->Shells[this->Components[h / 3]]; }

  void FillTriangles()
  {
    const int triangles = static_cast<int>(this->Mesh.Triangles.size());
    // Vertices first, in the order of the mesh's points: a point is one vertex in each of its
    // shells.
    std::vector<std::map<int, int>> vertexOf(this->Shells.size());
    for (int t = 0; t < triangles; ++t)
    {
      for (const int point : this->Mesh.Triangles[t])
      {
        vertexOf[this->Components[t]].emplace(point, -1);
      }
    }
    for (std::size_t s = 0; s < this->Shells.size(); ++s)
    {
      for (auto& [point, vertex] : vertexOf[s])
      {
        vertex = static_cast<int>(this->Shells[s].Vertices.size());
        this->Shells[s].Vertices.push_back(this->Mesh.Points[point]);
      }
    }
    this->Local.resize(this->Edges.Count());
    for (int t = 0; t < triangles; ++t)
    {
      this->Report(t, triangles, 0.0);
      BRepShell& shell = this->Shells[this->Components[t]];
      const std::map<int, int>& vertices = vertexOf[this->Components[t]];
      const int first = static_cast<int>(shell.Edges.size());
      shell.Faces.push_back({ first, first + 1, first + 2 });
      for (int i = 0; i < 3; ++i)
      {
        const int h = 3 * t + i;
        this->Local[h] = first + i;
        shell.Edges.push_back({ vertices.at(this->Edges.From(h)), vertices.at(this->Edges.To(h)) });
      }
    }
  }

  void FillPartners()
  {
    // Half-edges of a shell were made in the order of the mesh's.
    for (int h = 0; h < this->Edges.Count(); ++h)
    {
      this->ShellOf(h).Partners.push_back(this->Local[this->Edges.Partner(h)]);
    }
  }

  void FillContours(const std::vector<SpaceLoop>& contours, std::vector<int>& missing)
  {
    this->InContour.assign(this->Edges.Count(), false);
    if (contours.empty())
    {
      return;
    }
    const ContourEdges finder(this->Mesh, this->Edges, this->Components);
    for (std::size_t c = 0; c < contours.size(); ++c)
    {
      this->Report(static_cast<int>(c), static_cast<int>(contours.size()), 0.5);
      std::vector<int> loop = finder.Find(contours[c]);
      if (loop.empty())
      {
        loop = finder.Find(SpaceLoop(contours[c].rbegin(), contours[c].rend()));
      }
      if (loop.empty())
      {
        missing.push_back(static_cast<int>(c));
        continue;
      }
      this->AddContour(loop);
    }
  }

  /// Borders that no contour runs along.
  void FillBorders()
  {
    for (int h = 0; h < this->Edges.Count(); ++h)
    {
      if (this->Edges.Opposite(h) >= 0 || this->InContour[h])
      {
        continue;
      }
      std::vector<int> loop;
      for (int g = h; loop.empty() || g != h; g = this->Edges.Partner(g))
      {
        loop.push_back(g);
      }
      this->AddContour(loop);
    }
  }

  void AddContour(const std::vector<int>& loop)
  {
    std::vector<int> contour;
    for (const int h : loop)
    {
      contour.push_back(this->Local[h]);
      this->InContour[h] = true;
    }
    this->ShellOf(loop.front()).Contours.push_back(std::move(contour));
  }

  BRep GroupShells()
  {
    BRep brep;
    std::vector<int> setOfShell(this->Shells.size(), -1);
    std::map<int, std::size_t> place; // of a set's number among the sets, by first triangle
    for (std::size_t t = 0; t < this->Components.size(); ++t)
    {
      const int set = this->Sets.empty() ? 0 : this->Sets[t];
      const int shell = this->Components[t];
      const int at = static_cast<int>(place.emplace(set, place.size()).first->second);
      if (setOfShell[shell] < 0)
      {
        setOfShell[shell] = at;
        brep.ShellSets.resize(place.size());
        brep.ShellSets[at].Shells.push_back(std::move(this->Shells[shell]));
      }
      if (setOfShell[shell] != at)
      {
        throw Error("Triangle " + std::to_string(t) +
          " is in another shell set than triangles that it is joined to; a shell set holds whole "
          "components.");
      }
    }
    return brep;
  }

  void Report(int done, int all, double start)
  {
    if (done % 1024 == 0)
    {
      this->Progress.Update(start + 0.5 * done / all, "joining half-edges");
    }
  }

  const TriangleMesh& Mesh;
  const std::vector<int>& Sets;
  Monitor& Progress;
  HalfEdges Edges;
  std::vector<int> Components;
  std::vector<BRepShell> Shells; ///< by component
  std::vector<int> Local;        ///< a half-edge of the mesh: its number in its shell
  std::vector<bool> InContour;   ///< a half-edge of the mesh
};
}

std::string FindShellDefect(const BRepShell& shell)
{
  return ShellChecker(shell).Check();
}

ShelledMesh MakeMesh(const BRep& brep)
{
  ShelledMesh result;
  int number = 0;
  for (std::size_t set = 0; set < brep.ShellSets.size(); ++set)
  {
    for (const BRepShell& shell : brep.ShellSets[set].Shells)
    {
      const int first = static_cast<int>(result.Mesh.Points.size());
      result.Mesh.Points.insert(
        result.Mesh.Points.end(), shell.Vertices.begin(), shell.Vertices.end());
      for (const std::array<int, 3>& face : shell.Faces)
      {
        result.Mesh.Triangles.push_back({ first + shell.Edges[face[0]][0],
          first + shell.Edges[face[1]][0], first + shell.Edges[face[2]][0] });
        result.ShellOfTriangle.push_back(number);
        result.ShellSetOfTriangle.push_back(static_cast<int>(set));
      }
      for (const std::vector<int>& contour : shell.Contours)
      {
        std::vector<int> loop;
        for (const int h : contour)
        {
          loop.push_back(first + shell.Edges[h][0]);
        }
        result.Contours.push_back(std::move(loop));
        result.ShellOfContour.push_back(number);
        result.ShellSetOfContour.push_back(static_cast<int>(set));
      }
      ++number;
    }
  }
  return result;
}

BRep MakeBRep(const TriangleMesh& mesh, const std::vector<int>& shellSetOfTriangle,
  const std::vector<SpaceLoop>& contours, std::vector<int>& missing, Monitor& monitor)
{
  missing.clear();
  if (mesh.Triangles.empty())
  {
    throw Error("There are no triangles, and a boundary representation needs at least one.");
  }
  return Builder(mesh, shellSetOfTriangle, monitor).Build(contours, missing);
}
}
