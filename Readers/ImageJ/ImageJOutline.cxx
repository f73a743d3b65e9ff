// SPDX-License-Identifier: GPL-3.0-or-later
#include "ImageJ/ImageJOutline.h"

#include "Base/Monitor.h"
#include "Common/BinaryScanner.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace recon
{
namespace
{
// Places in the header, as in ImageJ's class RoiDecoder.
constexpr std::size_t TypeAt = 6;
constexpr std::size_t BoxAt = 8;
constexpr std::size_t CountAt = 16;
constexpr std::size_t LineAt = 18; // also the box in single precision
constexpr std::size_t ShapeSizeAt = 36;
constexpr std::size_t StrokeColorAt = 40;
constexpr std::size_t OptionsAt = 50;
constexpr std::size_t PositionAt = 56;
constexpr std::size_t SecondHeaderAt = 60;
constexpr std::size_t CoordinatesAt = 64;
// Within the second header.
constexpr std::size_t SliceAt = 8;
constexpr std::size_t NameAt = 16;
constexpr std::size_t GroupAt = 30;
constexpr std::size_t SecondHeaderSize = 32;
constexpr unsigned int InSubpixels = 128; // option: coordinates in single precision
constexpr int CornersOfOval = 72;         // five degrees each
constexpr int CurvePieces = 8;            // of a curve of a composite outline

enum class Type
{
  Polygon,
  Rectangle,
  Oval,
  Line,
  FreeLine,
  PolyLine,
  None,
  FreeHand,
  Traced,
  Angle,
  Point
};

class Decoder
{
public:
  Decoder(const std::string& name, std::string_view bytes) : Scanner(name, bytes), Bytes(bytes) {}

  ImageJOutline Read()
  {
    if (this->Bytes.substr(0, 4) != "Iout" || this->Bytes.size() < CoordinatesAt)
    {
      this->Scanner.Fail(
        "expected an ROI of ImageJ, which begins with Iout and 64 bytes of header.");
    }
    this->ReadHeader();
    this->ReadLines();
    this->ReadSecondHeader();
    return std::move(this->Outline);
  }

private:
  void At(std::size_t position) { this->Scanner.MoveTo(position, "a part of the ROI"); }

  std::uint32_t UInt32At(std::size_t position)
  {
    this->At(position);
    return this->Scanner.UInt32("a number");
  }

  std::uint16_t UInt16At(std::size_t position)
  {
    this->At(position);
    return this->Scanner.UInt16("a number");
  }

  void ReadHeader()
  {
    this->At(TypeAt);
    const unsigned int type = this->Scanner.Byte("the type");
    if (type > static_cast<unsigned int>(Type::Point))
    {
      this->Scanner.Fail("type " + std::to_string(type) + " of an ROI is not known here.");
    }
    this->Kind = static_cast<Type>(type);
    this->Outline.Slice = static_cast<int>(std::min(this->UInt32At(PositionAt), 1u << 30));
    const std::uint32_t color = this->UInt32At(StrokeColorAt);
    this->Outline.HasColor = color >> 24 != 0; // not transparent
    this->Outline.Color = color & 0xffffff;
    this->IsSubpixel = this->UInt16At(OptionsAt) & InSubpixels;
  }

  void ReadLines()
  {
    if (this->Kind == Type::Rectangle && this->UInt32At(ShapeSizeAt) > 0)
    {
      this->ReadShape(this->UInt32At(ShapeSizeAt));
      return;
    }
    switch (this->Kind)
    {
      case Type::Rectangle:
        this->ReadRectangle();
        break;
      case Type::Oval:
        this->ReadOval();
        break;
      case Type::Line:
        this->ReadSegment();
        break;
      case Type::None:
        break;
      default:
        this->ReadCoordinates();
    }
  }

  void ReadRectangle()
  {
    double x = 0;
    double y = 0;
    double width = 0;
    double height = 0;
    this->ReadBoxSize(x, y, width, height);
    this->Outline.Lines.push_back(
      { { { x, y }, { x + width, y }, { x + width, y + height }, { x, y + height } }, true });
  }

  void ReadOval()
  {
    const double step = 2 * std::acos(-1.0) / CornersOfOval;
    double x = 0;
    double y = 0;
    double width = 0;
    double height = 0;
    this->ReadBoxSize(x, y, width, height);
    ImageJOutline::Line line;
    for (int i = 0; i < CornersOfOval; ++i)
    {
      line.Points.push_back({ x + 0.5 * width * (1 + std::cos(step * i)),
        y + 0.5 * height * (1 + std::sin(step * i)) });
    }
    this->Outline.Lines.push_back(std::move(line));
  }

  void ReadBoxSize(double& x, double& y, double& width, double& height)
  {
    this->At(BoxAt);
    const int top = this->Scanner.Int16("the box");
    const int left = this->Scanner.Int16("the box");
    const int bottom = this->Scanner.Int16("the box");
    const int right = this->Scanner.Int16("the box");
    x = left;
    y = top;
    width = right - left;
    height = bottom - top;
    if (this->IsSubpixel)
    {
      this->At(LineAt);
      x = this->Scanner.Float("the box");
      y = this->Scanner.Float("the box");
      width = this->Scanner.Float("the box");
      height = this->Scanner.Float("the box");
    }
  }

  void ReadSegment()
  {
    this->At(LineAt);
    ImageJOutline::Line line;
    line.Closed = false;
    for (int i = 0; i < 2; ++i)
    {
      const double x = this->Scanner.Float("the line");
      line.Points.push_back({ x, this->Scanner.Float("the line") });
    }
    this->Outline.Lines.push_back(std::move(line));
  }

  /// All x, then all y; as whole pixels from the box's corner, and again in single precision.
  void ReadCoordinates()
  {
    // Where 16 bits are not enough, the count is where a line has its ends.
    const std::size_t shortCount = this->UInt16At(CountAt);
    const std::size_t count = shortCount > 0 ? shortCount : this->UInt32At(LineAt);
    this->At(BoxAt);
    const double top = this->Scanner.Int16("the box");
    const double left = this->Scanner.Int16("the box");
    const std::size_t each = this->IsSubpixel ? 4 : 2;
    this->At(CoordinatesAt);
    if (count > this->Scanner.BytesLeft() / 4)
    {
      this->Scanner.Fail("the ROI announces " + std::to_string(count) +
        " points, more than the rest of it can hold; it is truncated or the count is wrong.");
    }
    const std::size_t xAt = CoordinatesAt + (this->IsSubpixel ? 4 * count : 0);
    std::vector<Point2> points(count);
    this->ReadAxis(xAt, 0, left, points);
    this->ReadAxis(xAt + each * count, 1, top, points);
    this->AddPoints(std::move(points));
  }

  void ReadAxis(std::size_t at, std::size_t axis, double origin, std::vector<Point2>& points)
  {
    this->At(at);
    for (Point2& point : points)
    {
      point[axis] = this->IsSubpixel ? this->Scanner.Float("the coordinates")
                                     : origin + this->Scanner.Int16("the coordinates");
    }
  }

  void AddPoints(std::vector<Point2> points)
  {
    if (this->Kind == Type::Point)
    {
      for (const Point2& point : points)
      {
        this->Outline.Lines.push_back({ { point }, false });
      }
      return;
    }
    const bool isClosed =
      this->Kind == Type::Polygon || this->Kind == Type::FreeHand || this->Kind == Type::Traced;
    this->Outline.Lines.push_back({ std::move(points), isClosed });
  }

  /// A composite outline: numbers of moves (0), lines (1), curves (2, 3) and ends (4), each with its
  /// points.
  void ReadShape(std::size_t numbers)
  {
    this->At(CoordinatesAt);
    if (numbers > this->Scanner.BytesLeft() / 4)
    {
      this->Scanner.Fail("the composite outline is truncated.");
    }
    const std::size_t end = CoordinatesAt + 4 * numbers;
    ImageJOutline::Line line;
    while (this->Scanner.GetPosition() < end)
    {
      const float kind = this->Scanner.Float("a piece of a composite outline");
      if (kind == 0 || kind == 4)
      {
        this->Finish(line);
      }
      if (!(kind >= 0 && kind <= 4 && kind == std::floor(kind)))
      {
        this->Scanner.Fail("a piece of the composite outline is of no known kind.");
      }
      this->AppendPiece(static_cast<std::size_t>(kind), line.Points);
    }
    this->Finish(line);
  }

  void Finish(ImageJOutline::Line& line)
  {
    if (line.Points.size() > 1)
    {
      this->Outline.Lines.push_back(line);
    }
    line.Points.clear();
  }

  void AppendPiece(std::size_t kind, std::vector<Point2>& points)
  {
    const std::size_t given = kind == 4 ? 0 : kind == 0 ? 1 : kind;
    std::vector<Point2> corners;
    for (std::size_t i = 0; i < given; ++i)
    {
      const double x = this->Scanner.Float("a piece of a composite outline");
      corners.push_back({ x, this->Scanner.Float("a piece of a composite outline") });
    }
    if (given > 1 && !points.empty())
    {
      corners.insert(corners.begin(), points.back());
      for (int i = 1; i <= CurvePieces; ++i)
      {
        points.push_back(OnCurve(corners, static_cast<double>(i) / CurvePieces));
      }
      return;
    }
    points.insert(points.end(), corners.begin(), corners.end());
  }

  /// De Casteljau's way to a point of a Bezier curve.
  static Point2 OnCurve(std::vector<Point2> corners, double t)
  {
    for (std::size_t left = corners.size() - 1; left > 0; --left)
    {
      for (std::size_t i = 0; i < left; ++i)
      {
        corners[i] = { corners[i][0] + t * (corners[i + 1][0] - corners[i][0]),
          corners[i][1] + t * (corners[i + 1][1] - corners[i][1]) };
      }
    }
    return corners.front();
  }

  void ReadSecondHeader()
  {
    const std::size_t header = this->UInt32At(SecondHeaderAt);
    if (header < CoordinatesAt || header > this->Bytes.size() ||
      this->Bytes.size() - header < SecondHeaderSize)
    {
      return; // files of old versions have none
    }
    const auto slice = static_cast<std::int32_t>(this->UInt32At(header + SliceAt));
    this->Outline.Slice = slice > 0 ? slice : this->Outline.Slice;
    const std::size_t at = this->UInt32At(header + NameAt);
    const std::size_t length = this->Scanner.UInt32("the name's length");
    if (at >= CoordinatesAt && at <= this->Bytes.size() && length <= (this->Bytes.size() - at) / 2)
    {
      this->At(at);
      for (std::size_t i = 0; i < length; ++i)
      {
        this->AppendLetter(this->Scanner.UInt16("the name"));
      }
    }
    this->At(header + GroupAt);
    this->Outline.Group = this->Scanner.Byte("the group");
  }

  /// UTF-16 to UTF-8; halves of pairs become question marks, as names only have to tell things apart.
  void AppendLetter(unsigned int code)
  {
    std::string& name = this->Outline.Name;
    const bool isHalf = code >= 0xd800 && code < 0xe000;
    if (code < 0x80 || isHalf)
    {
      name += isHalf ? '?' : static_cast<char>(code);
      return;
    }
    if (code < 0x800)
    {
      name += static_cast<char>(0xc0 | (code >> 6));
    }
    else
    {
      name += static_cast<char>(0xe0 | (code >> 12));
      name += static_cast<char>(0x80 | ((code >> 6) & 0x3f));
    }
    name += static_cast<char>(0x80 | (code & 0x3f));
  }

  BinaryScanner Scanner;
  std::string_view Bytes;
  Type Kind = Type::None;
  bool IsSubpixel = false;
  ImageJOutline Outline;
};
}

ImageJOutline ReadOutline(const std::string& name, std::string_view bytes)
{
  return Decoder(name, bytes).Read();
}
}
