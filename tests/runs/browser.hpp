#pragma once

#include <cstdlib>
#include <string>

#include "tests/runs/program.hpp"

namespace coupling {

inline bool has_browser() {
    return std::system("command -v chromium > /dev/null 2>&1") == 0;  // NOLINT: a test
}

/// Calls the browser without network in the folder of a project. One browser at a time: two that draw in
/// software beside each other now and then spend their virtual time before a slope is drawn.
inline Outcome call_browser(const SampleProject& project, const std::string& arguments) {
    return shell(
        project,
        "rm -rf browser; mkdir browser; flock \"${TMPDIR:-/tmp}/bannwald-browser-$(id -u).lock\" "
        // A short folder of its own: paths of sockets have at most 108 bytes.
        "env TMPDIR=/tmp chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run "
        "--disable-background-networking --disable-component-update --disable-sync "
        "--user-data-dir=\"$PWD/browser\" " +
            arguments + "\n");
}

}  // namespace coupling
