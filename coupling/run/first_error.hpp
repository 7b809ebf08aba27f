#pragma once

#include <atomic>
#include <exception>
#include <mutex>

namespace coupling {

/// The first exception of any thread; once there is one, the others have nothing to do.
class FirstError {
public:
    template <class Work>
    void guard(const Work& work) {
        if (failed_) {
            return;
        }
        try {
            work();
        } catch (...) {
            const std::lock_guard lock{mutex_};
            if (!error_) {
                error_ = std::current_exception();
            }
            failed_ = true;
        }
    }
    [[nodiscard]] bool any() const { return failed_; }
    void rethrow() const {
        if (error_) {
            std::rethrow_exception(error_);
        }
    }

private:
    std::atomic<bool> failed_ = false;
    std::mutex mutex_;
    std::exception_ptr error_;
};

}  // namespace coupling
