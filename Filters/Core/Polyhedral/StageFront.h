// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file StageFront.h
 * @brief How far a stage has come along the stack, and so how far the stages after it may follow.
 */
#ifndef recon_StageFront_h
#define recon_StageFront_h

#include <algorithm>
#include <cstddef>

namespace recon
{
/// Of a stage that does levels, or slabs, in their order.
struct StageFront
{
  std::size_t Count = 0; ///< all there are
  std::size_t Done = 0;  ///< the first so many

  /// How many of `count` levels or slabs may be done, where number i needs this stage's up to and with i + ahead, as
  /// far as there are such.
  std::size_t Allows(std::size_t count, std::size_t ahead) const
  {
    return this->Done == this->Count ? count
                                     : std::min(count, this->Done - std::min(this->Done, ahead));
  }
};

/// Of the stages that come again in every round in which points were added.
struct RoundFronts
{
  StageFront Joined;  ///< slabs
  StageFront Covered; ///< levels
  StageFront Located; ///< levels that were asked for the internal points of their neighbours
  StageFront Outside; ///< levels
  StageFront Lifted;  ///< slabs
  StageFront SkeletonLocated; ///< levels that were asked for the internal skeletons of theirs
  StageFront Ended;           ///< slabs
  StageFront Added;           ///< levels
};
}

#endif
