// SPDX-License-Identifier: GPL-3.0-or-later
#include "SVG/SVGPath.h"

#include "Common/TextScanner.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>

namespace recon
{
namespace
{
constexpr double Flatness = 1e-3; // of a curve's size: farther no piece is from it
constexpr int MostPieces = 64;    // of one curve
constexpr int EllipsePieces = 72; // 5 degrees each: off by a thousandth of the radius
const double Pi = std::acos(-1.0);

double Distance(const Point2& a, const Point2& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

Point2 Between(const Point2& a, const Point2& b, double t)
{
  return { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]) };
}

/// Reads numbers, flags and letters of a path.
class Scanner
{
public:
  explicit Scanner(std::string_view text) : Text(text) {}

  void SkipSeparators()
  {
    while (this->At < this->Text.size() && std::strchr(" \t\r\n,", this->Text[this->At]))
    {
      ++this->At;
    }
  }

  bool AtEnd()
  {
    this->SkipSeparators();
    return this->At >= this->Text.size();
  }

  bool AtNumber()
  {
    return !this->AtEnd() && std::strchr("+-.0123456789", this->Text[this->At]) != nullptr;
  }

  char Letter() { return this->Text[this->At++]; }

  /// "1.5.5" are two numbers, "1-2" as well.
  bool Number(double& value)
  {
    if (!this->AtNumber())
    {
      return false;
    }
    const std::size_t begin = this->At;
    this->Sign();
    this->Digits();
    if (this->Is('.'))
    {
      ++this->At;
      this->Digits();
    }
    const std::size_t end = this->At;
    if (this->Is('e') || this->Is('E'))
    {
      ++this->At;
      this->Sign();
      const std::size_t digits = this->At;
      this->Digits();
      this->At = this->At == digits ? end : this->At;
    }
    return ParseNumber(this->Text.substr(begin, this->At - begin), value);
  }

  /// Flags of arcs may stand side by side without anything between them.
  bool Flag(bool& value)
  {
    if (this->AtEnd() || (this->Text[this->At] != '0' && this->Text[this->At] != '1'))
    {
      return false;
    }
    value = this->Text[this->At++] == '1';
    return true;
  }

private:
  bool Is(char c) const { return this->At < this->Text.size() && this->Text[this->At] == c; }
  void Sign() { this->At += this->Is('+') || this->Is('-'); }
  void Digits()
  {
    while (
      this->At < this->Text.size() && this->Text[this->At] >= '0' && this->Text[this->At] <= '9')
    {
      ++this->At;
    }
  }

  std::string_view Text;
  std::size_t At = 0;
};

class PathParser
{
public:
  explicit PathParser(const std::string& data) : Data(data) {}

  std::vector<SVGLine> Parse(bool& isWhole)
  {
    isWhole = true;
    char command = '\0';
    while (!this->Data.AtEnd() && isWhole)
    {
      if (!this->Data.AtNumber())
      {
        command = this->Data.Letter();
      }
      else if (command == 'M' || command == 'm')
      {
        command = command == 'M' ? 'L' : 'l'; // further points of a move are lines
      }
      else if (command == 'Z' || command == 'z')
      {
        isWhole = false; // which takes no numbers, so that it would never come to the end of these
        break;
      }
      isWhole = this->Piece(command);
    }
    this->Finish(false);
    return std::move(this->Lines);
  }

private:
  bool Piece(char command)
  {
    const bool isRelative = command >= 'a';
    const Point2 origin = isRelative ? this->Now : Point2{ 0, 0 };
    switch (isRelative ? static_cast<char>(command - 'a' + 'A') : command)
    {
      case 'M':
        return this->Move(origin);
      case 'L':
        return this->LineBy(origin, true, true);
      case 'H':
        return this->LineBy(origin, true, false);
      case 'V':
        return this->LineBy(origin, false, true);
      case 'C':
        return this->Curve(origin, 3, false);
      case 'S':
        return this->Curve(origin, 3, true);
      case 'Q':
        return this->Curve(origin, 2, false);
      case 'T':
        return this->Curve(origin, 2, true);
      case 'A':
        return this->Arc(origin);
      case 'Z':
        return this->Close();
      default:
        return false;
    }
  }

  bool Pair(const Point2& origin, Point2& point)
  {
    if (!this->Data.Number(point[0]) || !this->Data.Number(point[1]))
    {
      return false;
    }
    point = { point[0] + origin[0], point[1] + origin[1] };
    return true;
  }

  bool Move(const Point2& origin)
  {
    Point2 point{};
    if (!this->Pair(origin, point))
    {
      return false;
    }
    this->Finish(false);
    this->Now = this->Start = this->LastControl = point;
    this->HasStarted = true;
    return true;
  }

  void Draw(const Point2& point)
  {
    if (this->Points.empty())
    {
      this->Points.push_back(this->Now);
    }
    this->Points.push_back(point);
    this->Now = point;
  }

  bool LineBy(const Point2& origin, bool hasX, bool hasY)
  {
    Point2 step{ 0, 0 };
    if (!this->HasStarted || (hasX && !this->Data.Number(step[0])) ||
      (hasY && !this->Data.Number(step[1])))
    {
      return false;
    }
    this->Draw(
      { hasX ? origin[0] + step[0] : this->Now[0], hasY ? origin[1] + step[1] : this->Now[1] });
    this->Order = 1;
    return true;
  }

  /// A Bezier curve of that order; its first control point may be the mirror of the last curve's.
  bool Curve(const Point2& origin, int order, bool isSmooth)
  {
    if (!this->HasStarted)
    {
      return false;
    }
    std::vector<Point2> control{ this->Now };
    if (isSmooth)
    {
      const bool hasLast = this->Order == order;
      control.push_back(hasLast ? Between(this->LastControl, this->Now, 2) : this->Now);
    }
    while (static_cast<int>(control.size()) <= order)
    {
      Point2 point{};
      if (!this->Pair(origin, point))
      {
        return false;
      }
      control.push_back(point);
    }
    this->Flatten(control);
    this->LastControl = control[control.size() - 2];
    this->Order = order;
    return true;
  }

  void Flatten(const std::vector<Point2>& control)
  {
    // The second differences bound how far a piece of a Bezier curve is from its chord.
    double bend = 0;
    double size = 0;
    for (std::size_t i = 1; i < control.size(); ++i)
    {
      size = std::max(size, Distance(control[0], control[i]));
      if (i + 1 < control.size())
      {
        bend =
          std::max(bend, 2 * Distance(Between(control[i - 1], control[i + 1], 0.5), control[i]));
      }
    }
    const auto order = static_cast<double>(control.size() - 1);
    const double wanted =
      size > 0 ? std::ceil(std::sqrt(order * (order - 1) * bend / (8 * Flatness * size))) : 1;
    const int pieces = static_cast<int>(std::clamp(wanted, 1.0, static_cast<double>(MostPieces)));
    for (int i = 1; i < pieces; ++i)
    {
      this->Draw(OnCurve(control, static_cast<double>(i) / pieces));
    }
    this->Draw(control.back());
  }

  /// De Casteljau's way to a point of a Bezier curve.
  static Point2 OnCurve(std::vector<Point2> corners, double t)
  {
    for (std::size_t left = corners.size() - 1; left > 0; --left)
    {
      for (std::size_t i = 0; i < left; ++i)
      {
        corners[i] = Between(corners[i], corners[i + 1], t);
      }
    }
    return corners.front();
  }

  /// An elliptical arc by its ends (SVG 1.1, appendix F.6.5, whose letters these are).
  bool Arc(const Point2& origin)
  {
    double rx = 0;
    double ry = 0;
    double phi = 0;
    bool isLarge = false;
    bool isSweep = false;
    Point2 end{};
    if (!this->HasStarted || !this->Data.Number(rx) || !this->Data.Number(ry) ||
      !this->Data.Number(phi) || !this->Data.Flag(isLarge) || !this->Data.Flag(isSweep) ||
      !this->Pair(origin, end))
    {
      return false;
    }
    this->Order = 1;
    rx = std::abs(rx);
    ry = std::abs(ry);
    if (rx == 0 || ry == 0 || end == this->Now)
    {
      this->Draw(end);
      return true;
    }
    const double c = std::cos(phi * Pi / 180);
    const double s = std::sin(phi * Pi / 180);
    const Point2 half{ (this->Now[0] - end[0]) / 2, (this->Now[1] - end[1]) / 2 };
    const Point2 p{ c * half[0] + s * half[1], c * half[1] - s * half[0] };
    const double tooSmall = (p[0] * p[0]) / (rx * rx) + (p[1] * p[1]) / (ry * ry);
    const double stretch = std::sqrt(std::max(1.0, tooSmall));
    rx *= stretch;
    ry *= stretch;
    const double below = rx * rx * p[1] * p[1] + ry * ry * p[0] * p[0];
    const double root =
      std::sqrt(std::max(0.0, (rx * rx * ry * ry - below) / below)) * (isLarge == isSweep ? -1 : 1);
    const Point2 centre{ root * rx * p[1] / ry, -root * ry * p[0] / rx };
    const double from = std::atan2((p[1] - centre[1]) / ry, (p[0] - centre[0]) / rx);
    double turn = std::atan2((-p[1] - centre[1]) / ry, (-p[0] - centre[0]) / rx) - from;
    turn += isSweep && turn < 0 ? 2 * Pi : !isSweep && turn > 0 ? -2 * Pi : 0;
    const Point2 middle = Between(this->Now, end, 0.5);
    const int pieces =
      std::max(1, static_cast<int>(std::ceil(EllipsePieces * std::abs(turn) / (2 * Pi))));
    for (int i = 1; i < pieces; ++i)
    {
      const double angle = from + turn * i / pieces;
      const double x = centre[0] + rx * std::cos(angle);
      const double y = centre[1] + ry * std::sin(angle);
      this->Draw({ middle[0] + c * x - s * y, middle[1] + s * x + c * y });
    }
    this->Draw(end);
    return true;
  }

  bool Close()
  {
    this->Finish(true);
    this->Now = this->LastControl = this->Start;
    this->Order = 1;
    return this->HasStarted;
  }

  void Finish(bool isClosed)
  {
    if (!this->Points.empty())
    {
      this->Lines.push_back({ std::move(this->Points), isClosed });
    }
    this->Points.clear();
  }

  Scanner Data;
  std::vector<SVGLine> Lines;
  std::vector<Point2> Points; // of the subpath that is drawn
  Point2 Now{ 0, 0 };
  Point2 Start{ 0, 0 };
  Point2 LastControl{ 0, 0 };
  int Order = 1; // of the last piece
  bool HasStarted = false;
};

/// One of the transforms that SVG knows, by its name and its numbers.
bool NamedTransform(const std::string& name, const std::vector<double>& n, SVGMatrix& matrix)
{
  const auto at = [&n](std::size_t i, double otherwise) { return i < n.size() ? n[i] : otherwise; };
  const double angle = at(0, 0) * Pi / 180;
  if (n.empty() || n.size() > 6)
  {
    return false;
  }
  if (name == "matrix" && n.size() == 6)
  {
    matrix = { n[0], n[1], n[2], n[3], n[4], n[5] };
  }
  else if (name == "translate")
  {
    matrix = { 1, 0, 0, 1, n[0], at(1, 0) };
  }
  else if (name == "scale")
  {
    matrix = { n[0], 0, 0, at(1, n[0]), 0, 0 };
  }
  else if (name == "rotate" && n.size() != 2)
  {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const Point2 about{ at(1, 0), at(2, 0) };
    matrix = { c, s, -s, c, about[0] - c * about[0] + s * about[1],
      about[1] - s * about[0] - c * about[1] };
  }
  else if (name == "skewX" || name == "skewY")
  {
    const double t = std::tan(angle);
    matrix = name == "skewX" ? SVGMatrix{ 1, 0, t, 1, 0, 0 } : SVGMatrix{ 1, t, 0, 1, 0, 0 };
  }
  else
  {
    return false;
  }
  return true;
}
}

std::vector<SVGLine> ParsePath(const std::string& data, bool& isWhole)
{
  return PathParser(data).Parse(isWhole);
}

std::vector<double> ParseNumbers(const std::string& text)
{
  Scanner scanner(text);
  std::vector<double> numbers;
  double value = 0;
  while (scanner.Number(value))
  {
    numbers.push_back(value);
  }
  return numbers;
}

bool ParseTransform(const std::string& text, SVGMatrix& matrix)
{
  matrix = SVGIdentity;
  std::size_t at = 0;
  while ((at = text.find_first_not_of(" \t\r\n,", at)) != std::string::npos)
  {
    const std::size_t open = text.find('(', at);
    const std::size_t close = text.find(')', at);
    if (open == std::string::npos || close == std::string::npos || close < open)
    {
      return false;
    }
    std::string name = text.substr(at, open - at);
    name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
    SVGMatrix next{};
    if (!NamedTransform(name, ParseNumbers(text.substr(open + 1, close - open - 1)), next))
    {
      return false;
    }
    matrix = Compose(matrix, next);
    at = close + 1;
  }
  return true;
}

SVGMatrix Compose(const SVGMatrix& o, const SVGMatrix& i)
{
  return { o[0] * i[0] + o[2] * i[1], o[1] * i[0] + o[3] * i[1], o[0] * i[2] + o[2] * i[3],
    o[1] * i[2] + o[3] * i[3], o[0] * i[4] + o[2] * i[5] + o[4], o[1] * i[4] + o[3] * i[5] + o[5] };
}

Point2 Apply(const SVGMatrix& m, const Point2& p)
{
  return { m[0] * p[0] + m[2] * p[1] + m[4], m[1] * p[0] + m[3] * p[1] + m[5] };
}

SVGLine EllipseOutline(const Point2& centre, double radiusX, double radiusY)
{
  SVGLine line;
  line.Closed = true;
  for (int i = 0; i < EllipsePieces; ++i)
  {
    const double angle = 2 * Pi * i / EllipsePieces;
    line.Points.push_back(
      { centre[0] + radiusX * std::cos(angle), centre[1] + radiusY * std::sin(angle) });
  }
  return line;
}
}
