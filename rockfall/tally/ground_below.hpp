#pragma once

#include <algorithm>
#include <span>

#include "config/units/constants.hpp"
#include "rockfall/laws/flight.hpp"

namespace rockfall {

/// A flight and the ground under it, which is a straight line in time over each stretch.
class GroundBelow {
public:
    GroundBelow(const Flight& flight, std::span<const Stretch> stretches, double ground_start_m)
        : stretch_{stretches.data()},
          last_{stretches.data() + stretches.size() - 1},
          start_m_{flight.start_m.z()},
          rising_mps_{flight.velocity_mps.z()},
          begin_m_{ground_start_m} {
        take_slope();
    }
    [[nodiscard]] double end_s() const { return stretch_->end_s; }
    [[nodiscard]] std::uint32_t triangle() const { return stretch_->triangle; }
    [[nodiscard]] bool last() const { return stretch_ == last_; }
    [[nodiscard]] double at(double time_s) const { return begin_m_ + rise_mps_ * (time_s - begin_s_); }

    /// Largest height of the flight above this stretch between two times: concave, so one candidate suffices.
    [[nodiscard]] double highest_m(double from_s, double to_s) const {
        const double time_s = std::min(std::max(apex_s_, from_s), to_s);
        const double above_m = above_m_ + time_s * (parting_mps_ - 0.5 * config::gravity_mps2 * time_s);
        return std::max(0.0, above_m);
    }
    void next() {
        begin_s_ = stretch_->end_s;
        begin_m_ = stretch_->ground_end_m;
        ++stretch_;
        take_slope();
    }

private:
    void take_slope() {
        const double duration_s = stretch_->end_s - begin_s_;
        rise_mps_ = duration_s > 0.0 ? (stretch_->ground_end_m - begin_m_) / duration_s : 0.0;
        above_m_ = start_m_ - begin_m_ + rise_mps_ * begin_s_;
        parting_mps_ = rising_mps_ - rise_mps_;
        apex_s_ = parting_mps_ * (1.0 / config::gravity_mps2);
    }
    const Stretch* stretch_;
    const Stretch* last_;
    double start_m_;
    double rising_mps_;
    double begin_s_ = 0.0;
    double begin_m_;
    // Over the stretch the height above ground is above + parting t - g t^2 / 2.
    double rise_mps_ = 0.0;
    double above_m_ = 0.0;
    double parting_mps_ = 0.0;
    double apex_s_ = 0.0;
};

}  // namespace rockfall
