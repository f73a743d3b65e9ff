// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ImageJOutline.h
 * @brief One ROI of ImageJ as lines in its image.
 */
#ifndef recon_ImageJOutline_h
#define recon_ImageJOutline_h

#include "Base/Geometry.h"

#include <string>
#include <string_view>
#include <vector>

namespace recon
{
struct ImageJOutline
{
  struct Line
  {
    std::vector<Point2> Points;
    bool Closed = true;
  };
  std::vector<Line> Lines;
  std::string Name; ///< as it is in the file; empty where it has none
  int Slice = 0;    ///< from 1; 0 where it is on none in particular
  int Group = 0;    ///< 0: in none
  bool HasColor = false;
  unsigned int Color = 0; ///< 0xRRGGBB
};

/// @throws Error where it is no ROI, or not whole. name is for its sentence.
ImageJOutline ReadOutline(const std::string& name, std::string_view bytes);
}

#endif
