#include "coupling/results/report/departures_line.hpp"

#include <algorithm>

#include "config/text/joined.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {
namespace {

using config::joined;
using rockfall::RimPart;

std::string edge_in_words(const Departure& one) {
    switch (one.part) {
        case RimPart::north:
            return page_text("departures.north");
        case RimPart::east:
            return page_text("departures.east");
        case RimPart::south:
            return page_text("departures.south");
        case RimPart::west:
            return page_text("departures.west");
        default:
            return page_text("departures.hole_at",
                             {{"x", fixed(one.hole_m.x(), 0)}, {"y", fixed(one.hole_m.y(), 0)}});
    }
}

/// "8.3 % (south edge 6.0 %; hole at 100 / 200 2.3 %)" or "none".
std::string share_by_edge(const Departures& departures) {
    if (departures.parts.empty()) {
        return page_text("departures.none");
    }
    std::string edges;
    for (const Departure& one : named_parts(departures)) {
        edges += joined(edges.empty() ? "" : page_text("departures.separator"),
                        page_text("departures.edge",
                                  {{"edge", edge_in_words(one)}, {"share", percent(departures.share(one))}}));
    }
    if (const std::uint64_t others = rocks_of_others(departures); others > 0) {
        const double share = static_cast<double>(others) / static_cast<double>(departures.rocks);
        edges += joined(page_text("departures.separator"),
                        page_text("departures.edge",
                                  {{"edge", page_text("departures.elsewhere")}, {"share", percent(share)}}));
    }
    return joined("<b>", percent(departures.share()), "</b> (", edges, ")");
}

}  // namespace

std::string departures_line(const std::vector<DeparturesOfSlope>& slopes) {
    if (std::all_of(slopes.begin(), slopes.end(),
                    [](const DeparturesOfSlope& slope) { return slope.departures.parts.empty(); })) {
        return joined("<p class=\"departures\">", page_text("departures.no_rock"), "</p>\n");
    }
    std::string text;
    for (const DeparturesOfSlope& slope : slopes) {
        text += joined(text.empty() ? "" : page_text("departures.separator"),
                       page_text("departures.slope_and_share",
                                 {{"slope", slope.slope}, {"share", share_by_edge(slope.departures)}}));
    }
    return joined("<p class=\"departures\"><b>", page_text("departures.heading"), "</b> ", text, ". ",
                  page_text("departures.what_it_means"), "</p>\n");
}

std::string of_those_that_stop(double stopped, const std::string& bound_m) {
    return stopped == 1.0 ? page_text("departures.all_stopped")
                          : page_text("departures.stopped_on_the_terrain",
                                      {{"stopped", percent(stopped)}, {"bound", bound_m}});
}

}  // namespace coupling::report
