#include "coupling/assessments/profile/falls/profile_departures.hpp"

#include <array>
#include <utility>

#include "config/text/joined.hpp"
#include "config/units/constants.hpp"
#include "coupling/results/figures/departures.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::profile {
namespace {

using config::joined;

struct End {
    const char* name;     ///< in `summary.json`
    const char* words;    ///< on the screen
    const char* on_page;  ///< key of the page's text
    std::uint64_t rocks;
};

std::array<End, 2> ends_of(const ProfileTally& tally) {
    return {End{"lower_end", "lower end", "lower end", tally.left_lower},
            End{"upper_end", "upper end", "upper end", tally.left_upper}};
}

double share(std::uint64_t rocks, const ProfileTally& tally) {
    return share_of(rocks, tally.rocks).value;
}

std::uint64_t left(const ProfileTally& tally) {
    return tally.left_lower + tally.left_upper;
}

}  // namespace

std::string departures_in_words(const ProfileTally& tally) {
    if (left(tally) == 0) {
        return "no rock leaves the profile";
    }
    std::string ends;
    for (const End& end : ends_of(tally)) {
        if (end.rocks > 0) {
            ends += joined(ends.empty() ? "" : "; ", end.words, ": ",
                           departure_percent(share(end.rocks, tally)), " %");
        }
    }
    return joined(departure_percent(share(left(tally), tally)), " % of the rocks leave the profile (", ends,
                  ")");
}

std::string ends_on_page(const ProfileTally& tally) {
    std::vector<std::string> ends;
    for (const End& end : ends_of(tally)) {
        if (end.rocks > 0) {
            ends.push_back(
                report::page_text("{edge} {share}", {{"edge", report::page_text(end.on_page)},
                                                     {"share", report::percent(share(end.rocks, tally))}}));
        }
    }
    return report::join_with_semicolons(ends);
}

Json json_departures(const ProfileTally& tally) {
    Json edges = Json::array();
    for (const End& end : ends_of(tally)) {
        if (end.rocks > 0) {
            edges.push_back({{"edge", end.name},
                             {"rocks", end.rocks},
                             {"percent", json_number(config::percent * share(end.rocks, tally))}});
        }
    }
    return {{"rocks", left(tally)},
            {"percent", json_number(config::percent * share(left(tally), tally))},
            {"edges", std::move(edges)}};
}

rockfall::FallFigures fall_figures_of(const ProfileTally& tally) {
    return {tally.max_speed_mps.moments.most(), share(left(tally), tally)};
}

void warn_of_departures(const ProfileTally& tally, config::Warnings& warnings) {
    if (share(left(tally), tally) >= departures_to_warn_of) {
        warnings.add(joined(departures_in_words(tally), what_departures_do,
                            "give a profile that reaches further at these ends"),
                     config::Effect::answer);
    }
}

}  // namespace coupling::profile
