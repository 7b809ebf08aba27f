#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "rockfall/laws/flight.hpp"
#include "rockfall/laws/rolling.hpp"
#include "rockfall/obstacles/log_index.hpp"
#include "rockfall/obstacles/nets/net_index.hpp"
#include "rockfall/obstacles/stem_index.hpp"
#include "rockfall/obstacles/touched.hpp"

namespace rockfall {

/// What stands and lies in the way. `gone` marks stems that no longer stand, `logs_gone` logs that no longer
/// lie there (empty: none is gone).
struct Obstacles {
    const StemIndex* stems = nullptr;  ///< nullptr: no stems
    std::span<std::uint8_t> gone{};
    const LogIndex* logs = nullptr;  ///< nullptr: no logs
    std::span<std::uint8_t> logs_gone{};
    const NetIndex* nets = nullptr;  ///< nullptr: no nets

    [[nodiscard]] bool none() const { return stems == nullptr && logs == nullptr && nets == nullptr; }
};

/// What a rock meets next: a stem or a log.
struct Encounter {
    double time_s;
    std::optional<StemHit> stem;
    std::optional<LogHit> log;
};

/// What one rock has touched, and what it meets next.
class Encounters {
public:
    Encounters(const Obstacles& obstacles, double rock_radius_m)
        : obstacles_{obstacles}, radius_m_{rock_radius_m} {}

    void remember(const StemHit& hit) { stems_.remember(hit.stem); }
    void remember(const LogHit& hit) { logs_.remember(hit.log); }

    /// The first obstacle on a flight before `until_s`. It counts again a centimetre after the rock left it.
    std::optional<Encounter> next(const Flight& flight, double until_s) {
        return first_of(flight.start_m, until_s,
                        [&](const auto& index, double before_s, const Touched& touched,
                            std::span<const std::uint8_t> gone) {
                            return index.first_hit(flight, before_s, radius_m_, touched.numbers(), gone);
                        });
    }

    /// The same on a piece of rolling, taken as straight and even in time.
    std::optional<Encounter> next(const RollingPiece& piece) {
        const Eigen::Vector3d end_m = piece.position_m(piece.duration_s);
        // What the rock touches it may leave or forget on any way.
        if (obstacles_.logs == nullptr && obstacles_.stems != nullptr && stems_.numbers().empty() &&
            is_clear(piece.start_m, end_m)) {
            return std::nullopt;
        }
        const Eigen::Vector3d mean_mps = (end_m - piece.start_m) / piece.duration_s;
        return first_of(piece.start_m, piece.duration_s,
                        [&](const auto& index, double before_s, const Touched& touched,
                            std::span<const std::uint8_t> gone) {
                            return index.first_hit_rolling(piece.start_m, mean_mps, before_s, radius_m_,
                                                           touched.numbers(), gone);
                        });
    }

private:
    /// Whether a straight way surely meets no stem. Most ways on the ground are short and stay in a place
    /// that is known to be clear.
    [[nodiscard]] bool is_clear(const Eigen::Vector3d& start_m, const Eigen::Vector3d& end_m) {
        const auto holds = [&] {
            return clear_.has(start_m.x(), start_m.y()) && clear_.has(end_m.x(), end_m.y());
        };
        if (holds()) {
            return true;
        }
        clear_ = obstacles_.stems->clear_place(start_m.head<2>(), radius_m_);
        return holds();
    }

    template <class FirstHit>
    std::optional<Encounter> first_of(const Eigen::Vector3d& start_m, double until_s, FirstHit first_hit) {
        std::optional<Encounter> found;
        if (obstacles_.stems != nullptr) {
            stems_.forget_if(
                [&](std::uint32_t stem) { return obstacles_.stems->is_left(stem, start_m, radius_m_); });
            if (const auto hit = first_hit(*obstacles_.stems, until_s, stems_, obstacles_.gone)) {
                found = {hit->time_s, hit, std::nullopt};
            }
        }
        if (obstacles_.logs != nullptr) {
            logs_.forget_if(
                [&](std::uint32_t log) { return obstacles_.logs->is_left(log, start_m, radius_m_); });
            const double before_s = found ? found->time_s : until_s;
            if (const auto hit = first_hit(*obstacles_.logs, before_s, logs_, obstacles_.logs_gone)) {
                found = {hit->time_s, std::nullopt, hit};
            }
        }
        return found;
    }

    const Obstacles& obstacles_;
    double radius_m_;
    Touched stems_;
    Touched logs_;
    ClearPlace clear_;
};

}  // namespace rockfall
