#include "coupling/nets/net_words.hpp"

#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/inputs/nets/net_classes.hpp"
#include "coupling/results/report/markup.hpp"

namespace coupling {
namespace {

using config::joined;

/// "; 95 % of energies below 312 kJ, of heights below 1.2 m", as far as they are known.
std::string percentiles_in_words(const NetFigures& figures) {
    if (std::isnan(figures.energy_kj.p95.value)) {
        return "";
    }
    return joined("; 95 % of energies below ", report::three_digits(figures.energy_kj.p95.value),
                  " kJ, of heights of the centre below ", report::three_digits(figures.height_m.p95.value),
                  " m");
}

}  // namespace

std::string need_in_words(const NetFigures& figures, double wanted_share) {
    if (figures.reached.part == 0) {
        return "–";
    }
    if (figures.needs.empty()) {
        return joined("too few rocks reach it to tell: ", report::grouped(figures.reached.part),
                      " of at least ", report::grouped(rocks_to_tell(wanted_share)));
    }
    const NetNeed& need = figures.needs[figures.recommended];
    const std::string level =
        std::isfinite(need.mel_kj)
            ? joined(report::grouped(static_cast<std::uint64_t>(need.mel_kj)), " kJ")
            : joined("above 4 500 kJ: ", report::three_digits(figures.energy_needed_kj), " kJ");
    return joined("class ", need.energy_class, " (", level, "), ",
                  need.height_m ? joined(report::fixed(*need.height_m, 1), " m high") : "at no height",
                  need.height_m && *need.height_m > highest_usual_net_m
                      ? joined("; no usual net is that high: they end at ",
                               report::tick_text(highest_usual_net_m), " m")
                      : "");
}

std::string in_words(const NetRecord& net, const NetFigures& figures, double wanted_share) {
    std::string text =
        joined(net.name, ", ", figures.cover == rockfall::Cover::forest ? "with forest" : "bare slope", ": ",
               figures.inexact > 0 ? "at least " : "", std::to_string(figures.reached.part), " of ",
               std::to_string(figures.reached.whole), " rocks reach it");
    if (figures.inexact > 0) {
        text += joined(" (not known of ", std::to_string(figures.inexact),
                       " that break through another net and would reach it where none stands)");
    }
    if (figures.reached.part == 0) {
        return text;
    }
    return joined(text, figures.inexact > 0 ? "; of those known it holds " : ", it holds ",
                  report::percent(figures.outcome[0].value), percentiles_in_words(figures), "; to hold ",
                  report::percent(wanted_share), ": ", need_in_words(figures, wanted_share));
}

}  // namespace coupling
