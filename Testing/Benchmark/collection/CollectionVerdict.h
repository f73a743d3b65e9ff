// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file CollectionVerdict.h
 * @brief The surface of one case of the collection, and what is to be said of it.
 */
#ifndef recon_CollectionVerdict_h
#define recon_CollectionVerdict_h

#include "CollectionCases.h"
#include "Mesh/TriangleMesh.h"

#include <string>

namespace recon::collection
{
struct Verdict
{
  enum KindType
  {
    Sound,   ///< by the certificate, by index and by coordinates, contours on it
    Told,    ///< sound by index; by coordinates sheets touch in places that Report counts
    Refused, ///< no surface, and a sentence why
    Unsound
  };
  KindType Kind = Sound;
  std::string Reason;     ///< of Refused and Told the sentence, of Unsound what is wrong
  std::size_t Points = 0; ///< of the contours
  std::size_t Levels = 0;
  double Seconds = 0; ///< of a processor, from contours as they arrive to the surface
  double Volume = 0;
  double Area = 0;
  double Diagonal = 0; ///< of the box around the contours
  /// Of the polyhedral method the sections' difference from the contours in percent, of the implicit one the mean
  /// distance of the contours' points from the surface, in percent of the diagonal.
  double Off = 0;
  TriangleMesh Mesh;
};

Verdict Judge(const Case& given);

/// The word for it.
const char* NameOf(Verdict::KindType kind);
}

#endif
