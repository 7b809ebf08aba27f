#include "coupling/results/figures/departures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/units/constants.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling {
namespace {

using config::joined;
using config::percent;
using rockfall::RimPart;

constexpr std::string_view leaving = " % of the rocks leave the terrain";
constexpr std::array<std::string_view, rockfall::rim_sides> side_names{"north", "east", "south", "west"};

std::string part_in_words(const Departures& all, const Departure& one) {
    const std::string percent_of_rocks = departure_percent(all.share(one));
    if (!rockfall::is_hole(one.part)) {
        return joined(percent_of_rocks, " % over the ", name_of(one.part), " edge");
    }
    return joined(percent_of_rocks, " % into the hole at ", std::to_string(std::llround(one.hole_m.x())),
                  ", ", std::to_string(std::llround(one.hole_m.y())));
}

std::string parts_in_words(const Departures& departures) {
    std::string text;
    for (const Departure& one : named_parts(departures)) {
        text += joined(text.empty() ? "" : "; ", part_in_words(departures, one));
    }
    const std::uint64_t others = rocks_of_others(departures);
    if (others > 0) {
        const double share = static_cast<double>(others) / static_cast<double>(departures.rocks);
        text += joined("; ", departure_percent(share), " % elsewhere");
    }
    return text;
}

std::string share_in_words(const Departures& departures, const std::string& slope) {
    return joined(departure_percent(departures.share()), leaving, " ", slope, " (",
                  parts_in_words(departures), ")");
}

std::string remedy(const Departures& departures) {
    const auto over_hole = [](const Departure& one) { return rockfall::is_hole(one.part); };
    const bool holes = std::any_of(departures.parts.begin(), departures.parts.end(), over_hole);
    const bool sides = !std::all_of(departures.parts.begin(), departures.parts.end(), over_hole);
    return !holes  ? "give a terrain that reaches further on these sides"
           : sides ? "give a terrain that reaches further on these sides and fill the holes"
                   : "fill the holes";
}

}  // namespace

std::string departure_percent(double share) {
    const report::WritingLanguage english{config::Language::en};
    constexpr double least_of_pages = 1e-4;
    if (share < least_of_pages) {
        return report::three_digits(percent * share);
    }
    const std::string text = report::percent(share);  // as the page of the run shows it
    return text.substr(0, text.find("\u00a0"));
}

std::uint64_t Departures::left() const {
    return std::accumulate(parts.begin(), parts.end(), std::uint64_t{0},
                           [](std::uint64_t sum, const Departure& one) { return sum + one.rocks; });
}

double Departures::share() const {
    return rocks > 0 ? static_cast<double>(left()) / static_cast<double>(rocks) : 0.0;
}

double Departures::share(const Departure& departure) const {
    return rocks > 0 ? static_cast<double>(departure.rocks) / static_cast<double>(rocks) : 0.0;
}

Departures departures_of(std::uint64_t rocks, const std::map<RimPart, std::uint64_t>& left_over,
                         const rockfall::Terrain& terrain) {
    Departures departures;
    departures.rocks = rocks;
    const auto holes = terrain.rim().holes();
    for (const auto& [part, count] : left_over) {
        Departure one{part, Eigen::Vector2d::Zero(), count};
        if (rockfall::is_hole(part) && rockfall::hole_of(part) < holes.size()) {
            one.hole_m = terrain.origin_m() + holes[rockfall::hole_of(part)].centre_m;
        }
        departures.parts.push_back(one);
    }
    std::sort(departures.parts.begin(), departures.parts.end(), [](const Departure& a, const Departure& b) {
        if (a.rocks != b.rocks) {
            return a.rocks > b.rocks;
        }
        if (rockfall::is_hole(a.part) != rockfall::is_hole(b.part)) {
            return rockfall::is_hole(b.part);
        }
        return rockfall::is_hole(a.part)
                   ? std::pair{-a.hole_m.y(), a.hole_m.x()} < std::pair{-b.hole_m.y(), b.hole_m.x()}
                   : a.part < b.part;
    });
    return departures;
}

Departures departures_of(const RunResults& results, Cover cover) {
    const rockfall::RunTally& tally = results.tally.runs[index_of(cover)];
    return departures_of(tally.rocks, tally.left_over, results.site.slope.terrain);
}

const char* name_of(RimPart part) {
    return rockfall::is_hole(part) ? "hole" : side_names[static_cast<std::size_t>(part)].data();
}

Json json_departures(const Departures& departures) {
    Json parts = Json::array();
    for (const Departure& one : departures.parts) {
        Json part{{"edge", name_of(one.part)},
                  {"rocks", one.rocks},
                  {"percent", json_number(percent * departures.share(one))}};
        if (rockfall::is_hole(one.part)) {
            part["x_m"] = json_number(one.hole_m.x());
            part["y_m"] = json_number(one.hole_m.y());
        }
        parts.push_back(std::move(part));
    }
    return {{"rocks", departures.left()},
            {"percent", json_number(percent * departures.share())},
            {"edges", std::move(parts)}};
}

Departures read_departures(std::string_view summary, Cover cover, const std::string& file) {
    try {
        Departures departures;
        const Json slopes = Json::parse(summary).at("slopes");
        if (!slopes.contains(name_of(cover))) {
            return departures;
        }
        const Json& slope = slopes.at(name_of(cover));
        departures.rocks = slope.at("rocks").get<std::uint64_t>();
        for (const Json& edge : slope.at("left_terrain").at("edges")) {
            Departure one{.rocks = edge.at("rocks").get<std::uint64_t>()};
            const auto name = edge.at("edge").get<std::string>();
            const auto* side = std::find(side_names.begin(), side_names.end(), name);
            if (side != side_names.end()) {
                one.part = static_cast<RimPart>(side - side_names.begin());
            } else {
                // Which hole it was, its place says.
                one.part = RimPart::first_hole;
                one.hole_m = {edge.at("x_m").get<double>(), edge.at("y_m").get<double>()};
            }
            departures.parts.push_back(one);
        }
        return departures;
    } catch (const Json::exception&) {
        config::fail(config::ExitCode::data, {file}, "no summary of a run of today",
                     "summary.json as `bannwald run` writes it");
    }
}

std::vector<Departure> named_parts(const Departures& departures) {
    const std::size_t named = departures.parts.size() == most_parts_named + 1
                                  ? departures.parts.size()
                                  : std::min(most_parts_named, departures.parts.size());
    return {departures.parts.begin(), departures.parts.begin() + static_cast<std::ptrdiff_t>(named)};
}

std::uint64_t rocks_of_others(const Departures& departures) {
    std::uint64_t rocks = departures.left();
    for (const Departure& one : named_parts(departures)) {
        rocks -= one.rocks;
    }
    return rocks;
}

std::string in_words(const Departures& departures, const std::string& slope) {
    return departures.parts.empty() ? joined("no rock leaves the terrain ", slope)
                                    : share_in_words(departures, slope);
}

std::optional<std::string> warning_of(const Departures& departures, const std::string& slope) {
    if (departures.share() < departures_to_warn_of) {
        return std::nullopt;
    }
    return joined(share_in_words(departures, slope), what_departures_do, remedy(departures));
}

void warn_of_departures(const Departures& bare, const Departures& forest, config::Warnings& warnings) {
    const bool by_forest = forest.share() > bare.share();
    if (auto sentence =
            by_forest ? warning_of(forest, "with forest") : warning_of(bare, "over the bare slope")) {
        const std::vector<std::string>& known = warnings.warnings();
        if (std::find(known.begin(), known.end(), *sentence) == known.end()) {
            warnings.add(std::move(*sentence), config::Effect::answer);
        }
    }
}

std::optional<DepartingShare> departing_share(std::string_view warning) {
    const std::string_view before = warning.substr(0, warning.find(leaving));
    if (before.size() == warning.size()) {
        return std::nullopt;
    }
    const std::size_t figure = before.rfind(' ') + 1;  // 0 where nothing stands before it
    const std::optional<double> number = config::parse_number(before.substr(figure));
    return number ? std::optional{DepartingShare{before.substr(0, figure), *number}} : std::nullopt;
}

}  // namespace coupling
