#pragma once

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "coupling/page_scripts/page_scripts.hpp"

namespace coupling::report {

/// What stands around the content of a page.
struct PageFrame {
    std::string title;                          ///< HTML
    std::string version;                        ///< of the program, plain
    std::vector<page_scripts::Script> scripts;  ///< at the end of the page, and the only ones it may run
    std::string style;                          ///< CSS of this kind of page, beside what all pages share
    std::string before_main;                    ///< HTML: definitions that the content refers to
};

/// All of a page before its content: policy, title, style.
void begin_page(std::ostream& out, const PageFrame& frame);

/// All of it after its content.
void end_page(std::ostream& out, const PageFrame& frame);

}  // namespace coupling::report
