#include "rockfall/motion/fall_doubts.hpp"

#include "rockfall/motion/classical/fall_doubts.hpp"
#include "rockfall/motion/pir3d/fall_doubts.hpp"

namespace rockfall {

std::vector<std::string> doubts_of_falls(const MotionLaws& laws, const FallFigures& falls) {
    return with_model(laws, [&]<class Model>(std::type_identity<Model>, const auto& law) {
        if constexpr (requires { doubts_after(falls, law); }) {
            return doubts_after(falls, law);
        } else {
            return std::vector<std::string>{};
        }
    });
}

}  // namespace rockfall
