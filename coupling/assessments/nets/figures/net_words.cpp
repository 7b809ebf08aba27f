#include "coupling/assessments/nets/figures/net_words.hpp"

#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/inputs/nets/net_classes.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling {
namespace {

using config::joined;

/// "; 95 % of energies below 312 kJ, of heights below 1.2 m", as far as they are known.
std::string percentiles_in_words(const NetFigures& figures) {
    if (std::isnan(figures.energy_kj.p95.value)) {
        return "";
    }
    return report::page_text(
        "; 95 % of energies below {energy_kj_p95} kJ, of heights of the centre below {height_m_p95} m",
        {{"energy_kj_p95", report::three_digits(figures.energy_kj.p95.value)},
         {"height_m_p95", report::three_digits(figures.height_m.p95.value)}});
}

}  // namespace

std::string need_in_words(const NetFigures& figures, double wanted_share) {
    if (figures.reached.part == 0) {
        return "–";
    }
    if (figures.needs.empty()) {
        return report::page_text(
            "too few rocks reach it for an estimate: {reached_part} of at least {rocks_to_tell_wanted_share}",
            {{"reached_part", report::grouped(figures.reached.part)},
             {"rocks_to_tell_wanted_share", report::grouped(rocks_to_tell(wanted_share))}});
    }
    const NetNeed& need = figures.needs[figures.recommended];
    const std::string level =
        std::isfinite(need.mel_kj)
            ? report::page_text("{need_mel_kj} kJ",
                                {{"need_mel_kj", report::grouped(static_cast<std::uint64_t>(need.mel_kj))}})
            : report::page_text("above 4 500 kJ: {energy_needed_kj} kJ",
                                {{"energy_needed_kj", report::three_digits(figures.energy_needed_kj)}});
    return report::page_text(
        "class {need_energy_class} ({level}), {part}{part_2}",
        {{"need_energy_class", need.energy_class},
         {"level", level},
         {"part", need.height_m ? report::page_text("{need_height_m} m high",
                                                    {{"need_height_m", report::fixed(*need.height_m, 1)}})
                                : report::page_text("at no height")},
         {"part_2",
          need.height_m && *need.height_m > highest_usual_net_m
              ? report::page_text("; no usual net is that high: they end at {highest_usual_net_m} m",
                                  {{"highest_usual_net_m", report::tick_text(highest_usual_net_m)}})
              : ""}});
}

std::string in_words(const NetRecord& net, const NetFigures& figures, double wanted_share) {
    std::string text = report::page_text(
        "{net_name}, {part}: {part_2}{reached_part} of {reached_whole} rocks reach it",
        {{"net_name", net.name},
         {"part", figures.cover == rockfall::Cover::forest ? report::page_text("with forest")
                                                           : report::page_text("bare slope")},
         {"part_2", figures.inexact > 0 ? report::page_text("at least ") : ""},
         {"reached_part", std::to_string(figures.reached.part)},
         {"reached_whole", std::to_string(figures.reached.whole)}});
    if (figures.inexact > 0) {
        text += report::page_text(
            " ({inexact} rocks that break through another net are not counted here: run the scenario to "
            "include them)",
            {{"inexact", std::to_string(figures.inexact)}});
    }
    if (figures.reached.part == 0) {
        return text;
    }
    return report::page_text(
        "{value}{part}{outcome}{percentiles_in_words}; to hold {wanted_share}: {need_in_words_wanted_share}",
        {{"value", text},
         {"part", figures.inexact > 0 ? report::page_text("; of those known it holds ")
                                      : report::page_text(", it holds ")},
         {"outcome", report::percent(figures.outcome[0].value)},
         {"percentiles_in_words", percentiles_in_words(figures)},
         {"wanted_share", report::percent(wanted_share)},
         {"need_in_words_wanted_share", need_in_words(figures, wanted_share)}});
}

}  // namespace coupling
