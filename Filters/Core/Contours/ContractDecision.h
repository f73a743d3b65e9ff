// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ContractDecision.h
 * @brief What a contract on the number of pieces and handles decides between two adjacent levels.
 */
#ifndef recon_ContractDecision_h
#define recon_ContractDecision_h

namespace recon
{
struct ContractDecision
{
  enum KindType
  {
    Join,   ///< two solid regions that would not be joined
    Part,   ///< two solid regions that would be joined
    Tunnel, ///< what is not solid at two contours, through the solid between them
    Cut,    ///< the solid between two contours, at one place between their levels
    Fill    ///< a hole between two contours, at one place between their levels
  };

  KindType Kind = Join;
  int Slab = -1;
  int Lower =
    -1; ///< contour; of Join and Part the wall around the region; of Cut and Fill it may be -1
  int Upper = -1;
  /// What makes it dear: of Join and Tunnel how far apart the two are in projection, in slab
  /// thicknesses, or, negative, the share of the smaller region that they have in common; of Part that
  /// share; of Cut and Fill the area, in square units.
  double Cost = 0;
};
}

#endif
