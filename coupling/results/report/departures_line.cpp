#include "coupling/results/report/departures_line.hpp"

#include <algorithm>

#include "config/text/joined.hpp"
#include "coupling/results/templates/page_template.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {
namespace {

using config::joined;
using rockfall::RimPart;

std::string edge_in_words(const Departure& one) {
    switch (one.part) {
        case RimPart::north:
            return page_text("north edge");
        case RimPart::east:
            return page_text("east edge");
        case RimPart::south:
            return page_text("south edge");
        case RimPart::west:
            return page_text("west edge");
        default:
            return page_text("hole at {x} / {y}",
                             {{"x", fixed(one.hole_m.x(), 0)}, {"y", fixed(one.hole_m.y(), 0)}});
    }
}

/// "8.3 % (south edge 6.0 %; hole at 100 / 200 2.3 %)" or "none".
std::string share_by_edge(const Departures& departures) {
    if (departures.parts.empty()) {
        return page_text("none");
    }
    std::vector<std::string> edges;
    const auto add = [&](const std::string& edge, double share) {
        edges.push_back(page_text("{edge} {share}", {{"edge", edge}, {"share", percent(share)}}));
    };
    for (const Departure& one : named_parts(departures)) {
        add(edge_in_words(one), departures.share(one));
    }
    if (const std::uint64_t others = rocks_of_others(departures); others > 0) {
        add(page_text("elsewhere"), static_cast<double>(others) / static_cast<double>(departures.rocks));
    }
    return joined(element("b", {}, percent(departures.share())), " (", join_with_semicolons(edges), ")");
}

}  // namespace

std::string departures_line(const std::vector<DeparturesOfSlope>& slopes) {
    const bool none = std::all_of(slopes.begin(), slopes.end(), [](const DeparturesOfSlope& slope) {
        return slope.departures.parts.empty();
    });
    std::vector<std::string> texts;
    for (const DeparturesOfSlope& slope : slopes) {
        texts.push_back(page_text("{slope} {share}",
                                  {{"slope", slope.slope}, {"share", share_by_edge(slope.departures)}}));
    }
    return filled_template("departures_line.html", {{"none", none}, {"shares", join_with_semicolons(texts)}});
}

std::string of_those_that_stop(double stopped, const std::string& bound_m) {
    return stopped == 1.0 ? page_text("of all rocks")
                          : page_text(
                                "of the {stopped} of the rocks that stop on the terrain; of all rocks at "
                                "least {bound} m",
                                {{"stopped", percent(stopped)}, {"bound", bound_m}});
}

}  // namespace coupling::report
