// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file StaircaseStep.h
 * @brief How high the steps of contours are that follow pixels.
 */
#ifndef recon_StaircaseStep_h
#define recon_StaircaseStep_h

#include "Contours/ContourSet.h"

namespace recon
{
/**
 * The usual length of the short edges between a turn to the left and one to the right, where so many
 * corners are of that kind that the contours follow pixels; 0 where they were drawn.
 */
double StaircaseStep(const ContourSet& contours);
}

#endif
