#pragma once

#include <functional>
#include <string_view>
#include <utility>

namespace coupling {

/// Follows the writing of results, so that it can be shown and ended.
///
/// Writers call it before each file, and inside long ones again and again. What it calls may throw to end the
/// writing; what was written so far is worth nothing then.
class WriteWatch {
public:
    /// What is being written, and the share of it that is done [0, 1].
    using Report = std::function<void(std::string_view what, double share)>;

    WriteWatch() = default;  ///< nobody follows
    explicit WriteWatch(Report report) : report_{std::move(report)} {}

    void operator()(std::string_view what, double share = 0.0) const {
        if (report_) {
            report_(what, share);
        }
    }

private:
    Report report_;
};

}  // namespace coupling
