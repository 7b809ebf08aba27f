#pragma once

#include <proj.h>

#include <memory>

namespace coupling::formats {

struct CloseProj {
    void operator()(PJ_CONTEXT* context) const { proj_context_destroy(context); }
    void operator()(PJ* system) const { proj_destroy(system); }
};

using ProjContext = std::unique_ptr<PJ_CONTEXT, CloseProj>;
using ProjSystem = std::unique_ptr<PJ, CloseProj>;

/// A context that writes nothing to the terminal.
inline ProjContext silent_context() {
    ProjContext context{proj_context_create()};
    proj_log_level(context.get(), PJ_LOG_NONE);
    return context;
}

}  // namespace coupling::formats
