#include "coupling/results/report/map/map_key.hpp"

#include "coupling/results/templates/page_template.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {

OnMaps drawn_of(const Site& site) {
    return {.sources = !site.sources.empty(),
            .targets = !site.targets.empty(),
            .nets = !site.nets.empty(),
            .works = !site.works.empty()};
}

std::string lines_in_words(const OnMaps& drawn, WordsOfLines words) {
    const auto when = [](bool is_drawn, const std::string& text) { return is_drawn ? text : std::string{}; };
    const std::string& sources =
        words.of_longest_period ? page_text("Thin outlines: release sources of the longest return period.")
                                : page_text("Thin outlines: release sources.");
    const std::string& targets = words.distances_along_lines
                                     ? page_text("Thick lines: targets, with distances in m along lines.")
                                     : page_text("Thick lines: targets.");
    return join_sentences(
        {when(drawn.sources, sources), when(drawn.targets, targets),
         when(drawn.nets, page_text("Blue broken lines: nets.")),
         when(drawn.works, page_text("Blue unbroken lines: dams, ditches, walls and galleries."))});
}

std::string map_key(const OnMaps& drawn) {
    return filled_template("map_key.html", {{"shows_sources", drawn.sources},
                                            {"shows_targets", drawn.targets},
                                            {"shows_nets", drawn.nets},
                                            {"shows_works", drawn.works}});
}

}  // namespace coupling::report
