// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SliceStack.h
 * @brief Where slices lie, for formats of drawings that do not tell it.
 */
#ifndef recon_SliceStack_h
#define recon_SliceStack_h

namespace recon
{
/// Coordinates are the file's times PixelSize, and slice n lies at z = n * Spacing.
struct SliceStack
{
  double Spacing = 1;   ///< in the unit of the output; negative: slices follow towards -z
  double PixelSize = 1; ///< what one unit of the drawing is in the unit of the output
};
}

#endif
