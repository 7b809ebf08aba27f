#include "config/options/options.hpp"
#include "rockfall/motion/pir3d/model.hpp"

namespace rockfall::pir3d {

void Model::declare(config::Options& options, Law& law, Written&) {
    options.choice("pir3d.spread", law.spread, {{"uniform", Spread::uniform}, {"normal", Spread::normal}},
                   {.meaning = "distribution of k, R_N, R_T and the angles; normal is cut at 3 deviations",
                    .source = "Cottaz et al. 2010, 2.4"});
    options.choice(
        "pir3d.uncertainty", law.uncertainty,
        {{"off", Uncertainty::off}, {"constant", Uncertainty::constant}, {"by_speed", Uncertainty::by_speed}},
        {.meaning = "their widths: none, those at rest, or falling with speed",
         .source = "Cottaz et al. 2010, Eqs. 6-9"});
    options.number("pir3d.position_tolerance_m", law.position_tolerance_m,
                   {.unit = "m",
                    .low = 1e-9,
                    .high = 1.0,
                    .meaning = "largest error of a step of sliding; larger ones are made again, shorter",
                    .source = "Cottaz et al. 2010, 2.3.1.2"});
    options.number("pir3d.least_hop", law.least_hop,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 10.0,
                    .meaning = "hops shorter than this times the rock's radius are sliding",
                    .source = "choice"});
}

void Model::take_over(const Written&, const SharedSettings& shared, Law& law, const config::Options&,
                      config::Problems&) {
    law.losses = shared.losses;
    law.most_impacts = static_cast<std::uint32_t>(shared.most_impacts);
}

void Model::stay_in_plane(Law& law, Written&) {
    law.turns_sideways = false;
}

}  // namespace rockfall::pir3d
