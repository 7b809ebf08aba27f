#pragma once

#include <array>
#include <ostream>
#include <string>
#include <vector>

#include "coupling/inputs/formats/json_library.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/figures/figures.hpp"

namespace coupling {

struct Scenario;

// The seam over the JSON library: each kind of run builds its own summary from these parts.

/// What is not known becomes null. Nine digits: the rest is noise of the last bit.
Json json_number(double value);
Json json_interval(const Interval& i, double factor);
Json json_share(const Share& s);
Json json_distribution(const Distribution& d, bool with_interval);
/// Rocks with more than each counted energy, per 1000 released.
Json json_above_energies(const std::array<Share, rockfall::counted_energies_j.size()>& above);
Json json_map_frame(const config::GridFrame& frame);

/// Every setting of a scenario: key, value, unit, default, whether it was changed.
Json json_settings(const Scenario& scenario);

/// Adds the commit of the program, inputs, settings and files to a summary of any kind of run and writes it.
void write_json_summary(std::ostream& out, Json summary, const std::vector<InputFile>& input_files,
                        const Scenario& scenario, const std::vector<WrittenFile>& files);

/// The same without settings: of a command that has no scenario.
void write_json_summary(std::ostream& out, Json summary, const std::vector<InputFile>& input_files,
                        const std::vector<WrittenFile>& files);

}  // namespace coupling
