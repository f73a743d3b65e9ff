// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file PlaneByPlane.h
 * @brief What the two formats of curve networks have in common.
 */
#ifndef recon_PlaneByPlane_h
#define recon_PlaneByPlane_h

#include "Base/Monitor.h"
#include "Common/TextScanner.h"
#include "CurveNetwork/CurveNetwork.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace recon
{
/**
 * @class PlaneByPlane
 * @brief Reads planes one after another, each with vertices that its curves name by number.
 */
class PlaneByPlane
{
public:
  PlaneByPlane(const std::string& fileName, Monitor& monitor) : Scanner(fileName), Progress(monitor)
  {
  }

protected:
  virtual ~PlaneByPlane() = default;

  virtual void ReadPlane() = 0;

  /// Nothing may follow them.
  CurveNetwork ReadPlanes(int count);
  std::vector<Point3> ReadVertices(int count);
  /// The number of one of the plane's vertices.
  int ReadIndex(const char* what, int vertexCount);
  std::string PlaneName() const { return "Plane " + std::to_string(this->Plane + 1); }
  /// A line of the report about this plane.
  void Note(const std::string& sentence);
  /// Vertices that a material uses are its points, once each in a plane.
  void AddChain(
    int material, const std::vector<Point3>& vertices, const std::vector<int>& chain, bool closed);

  TextScanner Scanner;
  CurveNetwork Result;

private:
  Monitor& Progress;
  std::map<int, MaterialContours> Materials;
  std::map<int, std::vector<int>> Numbers; ///< of the plane's vertices in each material
  int Plane = 0;
};
}

#endif
