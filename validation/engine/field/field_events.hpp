#pragma once

#include <string>
#include <vector>

#include "coupling/inputs/observed/events.hpp"
#include "coupling/inputs/site.hpp"
#include "validation/engine/case/comparison.hpp"

namespace coupling::validation {

/// Passages and impacts under one motion model, beside observed ones.
struct ModelEvents {
    std::string model;
    std::vector<observed::EventComparison> events;
};

/// Names the figures of passages and impacts of a field case and what was observed of them.
/// "passage.speed_mps:road.mean", with the model before it ("" is the scenario's own).
void name_event_figures(const std::string& model, const Site& site, const std::string& simulated_by,
                        Comparison& comparison);

/// Enters the figures of simulated events under these names.
void take_event_values(const std::string& model, const std::vector<observed::EventComparison>& events,
                       Outcome& outcome);

/// Each quantity, observed and under each model.
PlainTable events_table(const std::vector<ModelEvents>& models);

}  // namespace coupling::validation
