// SPDX-License-Identifier: GPL-3.0-or-later
#include "BRep/BRepFormatter.h"

#include "Common/TextFile.h"

#include <cmath>

namespace recon
{
namespace
{
class Formatter
{
public:
  Formatter(const BRep& brep, Monitor& monitor) : Whole(brep), Progress(monitor)
  {
    for (const BRepShellSet& set : brep.ShellSets)
    {
      for (const BRepShell& shell : set.Shells)
      {
        this->Things += shell.Vertices.size() + shell.Faces.size();
      }
    }
  }

  std::string Format()
  {
    if (this->Whole.ShellSets.empty())
    {
      throw Error("there is no shell set, and the format needs one at least.");
    }
    this->Line("NUM_SHELL_SETS", this->Whole.ShellSets.size());
    for (const BRepShellSet& set : this->Whole.ShellSets)
    {
      if (set.Shells.empty())
      {
        throw Error("a shell set has no shell, and the format needs one at least.");
      }
      this->Text += "BEGIN_SHELL_SET\n";
      this->Line("NUM_SHELLS", set.Shells.size());
      for (const BRepShell& shell : set.Shells)
      {
        this->AppendShell(shell);
      }
      this->Text += "END_SHELL_SET\n";
    }
    return std::move(this->Text);
  }

private:
  void AppendShell(const BRepShell& shell)
  {
    this->CheckShell(shell);
    this->Text += "BEGIN_SHELL # shell number " + std::to_string(this->ShellNumber) + "\n";
    this->Line("VERTICES", shell.Vertices.size());
    for (const Point3& p : shell.Vertices)
    {
      this->Report();
      for (int i = 0; i < 3; ++i)
      {
        AppendNumber(this->Text, p[i]);
        this->Text += i < 2 ? ' ' : '\n';
      }
    }
    this->AppendEdges(shell);
    this->AppendFaces(shell);
    this->AppendContours(shell);
    this->Text += "END_SHELL\n";
  }

  void CheckShell(const BRepShell& shell)
  {
    const std::string name = "shell " + std::to_string(++this->ShellNumber) + " ";
    if (shell.Vertices.empty() || shell.Faces.empty())
    {
      throw Error(name + "has no faces, and the format needs one at least.");
    }
    const std::string defect = FindShellDefect(shell);
    if (!defect.empty())
    {
      throw Error("in " + name + defect + ".");
    }
    for (std::size_t v = 0; v < shell.Vertices.size(); ++v)
    {
      const Point3& p = shell.Vertices[v];
      if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      {
        throw Error("in " + name + "vertex " + std::to_string(v) +
          " has a coordinate that is no finite number.");
      }
    }
  }

  void AppendEdges(const BRepShell& shell)
  {
    this->Line("EDGES", shell.Edges.size());
    for (std::size_t h = 0; h < shell.Edges.size(); ++h)
    {
      this->Text += std::to_string(shell.Edges[h][0]) + ' ' + std::to_string(shell.Edges[h][1]);
      this->Text += h % 3 == 2 ? "\n" : "  ";
    }
  }

  void AppendFaces(const BRepShell& shell)
  {
    this->Line("FACES", shell.Faces.size());
    for (const std::array<int, 3>& face : shell.Faces)
    {
      this->Report();
      for (int i = 0; i < 3; ++i)
      {
        this->Text += std::to_string(face[i]) + '(' + std::to_string(shell.Partners[face[i]]) + ')';
        this->Text += i < 2 ? ' ' : '\n';
      }
    }
  }

  void AppendContours(const BRepShell& shell)
  {
    this->Line("CONTOURS", shell.Contours.size());
    for (const std::vector<int>& contour : shell.Contours)
    {
      this->Text += '(' + std::to_string(contour.size()) + ')';
      for (const int h : contour)
      {
        this->Text += ' ' + std::to_string(h);
      }
      this->Text += '\n';
    }
  }

  void Line(const char* keyword, std::size_t count)
  {
    this->Text += std::string(keyword) + ' ' + std::to_string(count) + '\n';
  }

  void Report()
  {
    if (++this->Done % 1024 == 0)
    {
      this->Progress.Update(
        static_cast<double>(this->Done) / static_cast<double>(this->Things), "writing shells");
    }
  }

  const BRep& Whole;
  Monitor& Progress;
  std::string Text;
  int ShellNumber = 0;
  std::size_t Things = 0; ///< vertices and faces, for the progress
  std::size_t Done = 0;
};
}

void WriteBRep(const std::string& fileName, const BRep& brep, Monitor& monitor)
{
  std::string text;
  try
  {
    text = Formatter(brep, monitor).Format();
  }
  catch (const Error& error)
  {
    throw Error("Cannot write " + fileName + ": " + error.what());
  }
  WriteTextFile(fileName, text);
}
}
