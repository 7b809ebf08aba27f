#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "rockfall/ensemble.hpp"

namespace coupling::calibrate {

/// What rocks of one parameter set leave that can be seen in the field. Places in coordinates of the terrain.
struct SetRocks {
    struct End {
        Eigen::Vector2d start_m;
        Eigen::Vector2d end_m;
        std::uint32_t zone = 0;
        float diameter_m = 0.0F;
        bool left_terrain = false;  ///< then nobody sees where it rests
    };
    struct Hit {
        Eigen::Vector2d stem_m;
        float height_m = 0.0F;  ///< of the rock's centre above the ground at the stem
        float dbh_cm = 0.0F;
    };
    struct Passage {
        std::uint32_t target = 0;
        rockfall::Arrival arrival;
    };
    std::vector<End> ends;
    std::vector<Hit> hits;
    struct Jump {
        float length_m = 0.0F;  ///< in plan, from impact to impact
        int ground = 0;         ///< code of the ground type on which it begins
    };
    std::vector<Passage> passages;
    std::vector<Jump> jumps;  ///< where wanted
};

/// Waves of a search have numbers below this.
inline constexpr std::uint16_t most_waves = 64;
/// How often a set may let one and the same rock fall.
inline constexpr std::uint64_t most_repeats = 65'536 / most_waves;

/// Whose rocks: they are keyed by it, so that nothing depends on threads or on what else falls.
struct SetKey {
    std::uint64_t seed = 0;
    std::uint16_t wave = 0;    ///< below most_waves
    std::uint32_t number = 0;  ///< of the set in its wave
};

/// Lets rocks of single parameter sets fall through the forest of a site, or over its bare slope if it has
/// none. One of them per thread.
class SetFalls {
public:
    /// `rocks`: of each set, spread over those that the sources release; at most `most_repeats` times as
    /// many. `with_jumps`: keeps jumps, for which each rock falls once more.
    SetFalls(const rockfall::Assessment& assessment, std::uint64_t rocks, bool with_jumps = false);
    ~SetFalls();
    SetFalls(SetFalls&&) noexcept;
    SetFalls& operator=(SetFalls&&) = delete;

    /// Stems and logs stand again for each rock.
    void fall(const rockfall::FallDraw& draw, const SetKey& key, SetRocks& out);

private:
    struct Instruments;
    const rockfall::Assessment* assessment_;
    std::uint64_t rocks_;
    bool with_jumps_;
    std::unique_ptr<Instruments> instruments_;
};

}  // namespace coupling::calibrate
