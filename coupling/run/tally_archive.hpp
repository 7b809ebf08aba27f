#pragma once

#include "coupling/results/disk/byte_archive.hpp"
#include "rockfall/tally/ensemble_tally.hpp"

namespace coupling {

// Tallies in part files. What is read replaces a tally that is empty so far.

void write(ByteWriter& out, const rockfall::ArrivalTally& t);
void read(ByteReader& in, rockfall::ArrivalTally& t);
void write(ByteWriter& out, const rockfall::RunTally& t);
void read(ByteReader& in, rockfall::RunTally& t);
void write(ByteWriter& out, const rockfall::TargetTally& t);
void read(ByteReader& in, rockfall::TargetTally& t);
void write(ByteWriter& out, const rockfall::StratumTally& t);
void read(ByteReader& in, rockfall::StratumTally& t);

}  // namespace coupling
