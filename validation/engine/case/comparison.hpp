#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "validation/engine/case/plot.hpp"

namespace coupling::validation {

/// A figure that a case computes.
struct Figure {
    std::string name;   ///< as criteria.csv has it
    std::string label;  ///< for people
    std::string unit;
    bool listed = true;   ///< in the tables too where nothing but its reference is known
    std::string model{};  ///< motion model that it is of; "" where it is no figure of rocks with its defaults
    std::string measures{};  ///< the figure that it is made of where its name does not say it, as of a trend
};

/// What the reference says of a figure.
struct Reference {
    double value = 0.0;
    std::string source;
};

/// How a case is worked through; none of it changes the outcome.
struct Work {
    int threads = 1;
    std::function<void(std::uint64_t)> done;  ///< called with pieces as they come; one at a time
    std::optional<std::size_t> draw{};        ///< rocks fall by this draw of what is not known
    bool deviations = false;                  ///< whether Outcome::deviations are wanted
};

/// What a comparison has found.
struct Outcome {
    std::map<std::string, double> values;  ///< by the name of their figure
    /// Of figures of rocks: standard deviation between parts as large as what was observed.
    std::map<std::string, double> deviations;
    /// Where values are means over seeds: standard deviation between these.
    std::map<std::string, double> seed_deviations{};
    std::vector<PlotGroup> plots;
    std::vector<PlainTable> tables;
    std::vector<std::string> details;  ///< lines for the screen: what was compared, where it differs most
};

/// A part of the model held against a reference: everything read and checked, nothing computed yet.
struct Comparison {
    std::string extent;           ///< what is compared, such as "333 trees on 3 slopes"
    std::vector<Figure> figures;  ///< all that run() gives
    std::map<std::string, Reference> references;
    /// Figures that the kind has and this case cannot give, with the reason.
    std::map<std::string, std::string> unknown;
    std::vector<std::string> notes;     ///< what was assumed or filled in
    std::vector<std::string> warnings;  ///< what the user should look at in the files
    std::uint64_t pieces = 0;           ///< of work that Work::done will be called with
    std::function<Outcome(const Work&)> run;

    /// Empty for a name that there is not.
    [[nodiscard]] Figure figure(const std::string& name) const;
};

}  // namespace coupling::validation
