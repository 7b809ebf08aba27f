#include "tests/fuzz/watch.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>
#include <ctime>
#include <fstream>

#if defined(__SANITIZE_ADDRESS__)
#include <sanitizer/common_interface_defs.h>
// Memory that was freed is kept for a while to catch late uses; of each input little is enough.
extern "C" const char* __asan_default_options() {
    return "quarantine_size_mb=16:max_allocation_size_mb=8192:allocator_may_return_null=0";
}
#endif

namespace fuzz {
namespace {

std::array<char, 1024> last_words{};
std::size_t last_size = 0;

/// Safe in a signal handler.
void say_last_words() {
    constexpr std::string_view before = "\nThis input ended the process or took too long: ";
    [[maybe_unused]] auto written = write(STDERR_FILENO, before.data(), before.size());
    written = write(STDERR_FILENO, last_words.data(), last_size);
    written = write(STDERR_FILENO, "\n", 1);
}

[[maybe_unused]] void end_at_signal(int) {
    say_last_words();
    _exit(1);
}

void set_timers(int cpu_s, int wait_s) {
    const itimerval cpu{{0, 0}, {cpu_s, 0}};
    setitimer(ITIMER_PROF, &cpu, nullptr);
    alarm(static_cast<unsigned>(wait_s));
}

double cpu_now_s() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// A line of /proc/self/status in bytes, 0 where there is none.
std::size_t status_bytes(const std::string& name) {
    std::ifstream status{"/proc/self/status"};
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with(name)) {
            return std::stoul(line.substr(name.size() + 1)) * 1024U;
        }
    }
    return 0;
}

/// Lets the largest use of memory begin at the present one.
void forget_peak() {
    std::ofstream{"/proc/self/clear_refs"} << '5';
}

}  // namespace

Watch::Watch() {
    for (const int number : {SIGPROF, SIGALRM}) {
        std::signal(number, end_at_signal);
    }
#if defined(__SANITIZE_ADDRESS__)
    __sanitizer_set_death_callback(say_last_words);
    std::signal(SIGABRT, end_at_signal);
#else
    for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
        std::signal(number, end_at_signal);
    }
#endif
}

void Watch::begin(const std::string& how_to_repeat) {
    last_size = std::min(how_to_repeat.size(), last_words.size());
    std::memcpy(last_words.data(), how_to_repeat.data(), last_size);
    forget_peak();
    begun_bytes_ = status_bytes("VmRSS:");
    begun_s_ = cpu_now_s();
    set_timers(longest_cpu_seconds, longest_wait_seconds);
}

void Watch::end() {
    set_timers(0, 0);
    cpu_seconds_ = cpu_now_s() - begun_s_;
    const std::size_t peak = status_bytes("VmHWM:");
    grown_bytes_ = peak - std::min(peak, begun_bytes_);
}

}  // namespace fuzz
