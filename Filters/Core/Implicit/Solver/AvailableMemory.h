// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file AvailableMemory.h
 * @brief How much memory may be taken before the machine has to swap or to kill.
 */
#ifndef recon_AvailableMemory_h
#define recon_AvailableMemory_h

namespace recon
{
/// What the kernel says is available, and what the control group that the process lives in leaves
/// (a container, a batch job), whichever is less; in gigabytes. Where the system tells neither: 8.
double AvailableGigabytes();
}

#endif
