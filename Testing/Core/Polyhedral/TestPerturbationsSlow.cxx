// SPDX-License-Identifier: GPL-3.0-or-later
// Contours as other programs leave them, a thousand times; CONTOUR_PERTURBATION_SEED begins elsewhere.
#include "Perturbations.h"

using namespace recon::testing;

using PerturbationsSlow = SharedData;

TEST_F(PerturbationsSlow, HardlyChangeTheSurface)
{
  PerturbSets(1000);
}
