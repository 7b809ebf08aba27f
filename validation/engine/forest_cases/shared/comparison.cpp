#include "validation/engine/forest_cases/shared/comparison.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

namespace coupling::validation::forest_cases {

namespace {

using config::joined;

}  // namespace

std::vector<int> rising(const std::string& key, const std::vector<double>& values) {
    std::vector<int> whole;
    for (const double value : values) {
        const int next = static_cast<int>(std::lround(value));
        if (next != value || (!whole.empty() && next <= whole.back())) {
            config::fail(config::ExitCode::settings, {}, joined(key, " ", config::to_text(value)),
                         "whole numbers, each above the one before");
        }
        whole.push_back(next);
    }
    if (whole.empty()) {
        config::fail(config::ExitCode::settings, {}, joined("no ", key), "one number or more");
    }
    return whole;
}

void declare(config::Options& options, Settings& settings, CaseKind kind) {
    if (kind == CaseKind::forest_yield || kind == CaseKind::forest_remeasured) {
        forest::declare(options, settings.forest);
    }
    if (kind == CaseKind::forest_remeasured) {
        RemeasuredSettings& remeasured = settings.remeasured;
        options.numbers("remeasured.classes_cm", remeasured.classes_cm,
                        {.unit = "cm",
                         .low = 1.0,
                         .high = 300.0,
                         .meaning = "lower ends of classes of diameter at the first measurement; thinner "
                                    "trees count among all alone"});
        options.count("remeasured.replicates", remeasured.replicates,
                      {.low = 1.0, .high = 10'000.0, .meaning = "simulations of the plot"});
        options.count("remeasured.seed", remeasured.seed,
                      {.low = 0.0, .high = 9007199254740992.0, .meaning = "key of all random numbers"});
    }
    if (kind == CaseKind::forest_light) {
        options.count("light.first_month", settings.light.first_month,
                      {.low = 1.0, .high = 12.0, .meaning = "first month that light is a mean of"});
        options.count("light.last_month", settings.light.last_month,
                      {.low = 1.0, .high = 12.0, .meaning = "last month that light is a mean of"});
        options.number("light.least_angle_deg", settings.light.least_angle_deg,
                       {.unit = "deg",
                        .low = 0.0,
                        .high = 60.0,
                        .meaning = "light flatter than this to the ground does not count"});
    }
    if (kind == CaseKind::forest_yield) {
        options.whole_numbers("yield.ages_years", settings.yield.ages_years,
                              {.unit = "years",
                               .low = 13.0,
                               .high = 300.0,
                               .meaning = "rising ages at which stands are compared; tables must have them"});
        options.whole_numbers("yield.drawn_ages_years", settings.yield.drawn_ages_years,
                              {.unit = "years",
                               .low = 2.0,
                               .high = 1000.0,
                               .meaning = "those of them that tables of the page show; none: the last"});
        options.flag("yield.twins", settings.yield.twins,
                     {.meaning = "each stand also grows without thinning, in two kinds of light"});
    }
}

Comparison read(CaseKind kind, const CaseFiles& files, const Settings& settings) {
    switch (kind) {
        case CaseKind::forest_production:
            return read_production(files);
        case CaseKind::forest_light:
            return read_light(files, settings.light);
        case CaseKind::forest_yield:
            return read_yield(files, settings.yield, settings.forest);
        case CaseKind::forest_remeasured:
            return read_remeasured(files, settings.remeasured, settings.forest);
        case CaseKind::slope:
        case CaseKind::profile:
        case CaseKind::factors:
        case CaseKind::field:
        case CaseKind::collapse:
        case CaseKind::forest_years:
            break;
    }
    throw std::logic_error{"no kind of the forest"};
}

std::string code_in_figures(const forest::Species& species) {
    std::string code = species.code;
    std::transform(code.begin(), code.end(), code.begin(), [](unsigned char c) { return std::tolower(c); });
    return code;
}

forest::SpeciesTable species_of(const CaseFiles& files) {
    constexpr const char* own = "species.csv";
    return files.has(own) ? forest::SpeciesTable::read(table_of(files, own))
                          : forest::SpeciesTable::shipped();
}

config::Table table_of(const CaseFiles& files, const std::string& name) {
    const auto text = files.texts.find(name);
    if (text == files.texts.end()) {
        std::vector<std::string> present;
        for (const auto& [file, bytes] : files.texts) {
            present.push_back(file);
        }
        const std::string nearest = config::nearest_word(name, present);
        config::fail(config::ExitCode::file, {files.shown(name)}, "no such file", "a table of the case",
                     nearest.empty() ? "" : joined("if it is ", config::in_quotes(nearest), ", rename it"));
    }
    std::istringstream in{text->second};
    return config::Table::read(in, files.shown(name));
}

}  // namespace coupling::validation::forest_cases
