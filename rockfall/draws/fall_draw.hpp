#pragma once

#include <span>
#include <vector>

#include "rockfall/laws/fall_factors.hpp"
#include "rockfall/motion/fall.hpp"
#include "rockfall/slope/slope.hpp"

namespace rockfall {

/// Laws and ground types of one draw of what is not known about falls.
struct FallDraw {
    FallLaw law;
    std::vector<SurfaceType> types;  ///< as those of the slope, in their order
    double block_size = 1.0;         ///< factor on diameters: see FallFactors
};

/// A ground type with factors on its losses, friction and stopping, for all motion models. Rigid blocks lose
/// by rolling resistance, drag and the softness of the ground.
SurfaceType with_factors(const SurfaceType& type, const FallFactors& factors);

/// Laws with the factors on what ground types do not say.
FallLaw with_factors(const FallLaw& law, const FallFactors& factors);

/// `own_losses`: a further factor on the losses of each ground type. Factors of 1 change no bit.
FallDraw draw_of(const FallLaw& law, std::span<const SurfaceType> types, const FallFactors& factors,
                 std::span<const double> own_losses);

}  // namespace rockfall
