#pragma once

#include <cerrno>

namespace coupling {

/// Repeats a system call that a signal interrupted (EINTR): disks of a network may answer so, although the
/// handlers of this program restart calls. Not for `close`: Linux has closed the file all the same.
template <class Call>
auto repeated(const Call& call) {
    auto result = call();
    while (result == -1 && errno == EINTR) {
        result = call();
    }
    return result;
}

}  // namespace coupling
