#pragma once

namespace capcon {

/// Whether an MPI launcher started this process, by what launchers put into the environment (Open MPI, PMIx
/// as of Slurm, MPICH and its kin), as one of several.
bool launched_together();

}  // namespace capcon
