#include "coupling/inputs/formats/system_text.hpp"

#include <proj.h>

#include <memory>

namespace coupling::formats {

std::string esri_text_of(const std::string& definition) {
    struct Close {
        void operator()(PJ_CONTEXT* context) const { proj_context_destroy(context); }
        void operator()(PJ* system) const { proj_destroy(system); }
    };
    const std::unique_ptr<PJ_CONTEXT, Close> context{proj_context_create()};
    proj_log_level(context.get(), PJ_LOG_NONE);
    const std::unique_ptr<PJ, Close> system{proj_create(context.get(), definition.c_str())};
    if (!system || proj_is_crs(system.get()) == 0) {
        return {};
    }
    // Of plan and heights the plan.
    std::unique_ptr<PJ, Close> plan;
    if (proj_get_type(system.get()) == PJ_TYPE_COMPOUND_CRS) {
        plan.reset(proj_crs_get_sub_crs(context.get(), system.get(), 0));
    }
    PJ* const shown = plan ? plan.get() : system.get();
    const char* const one_line[] = {"MULTILINE=NO", nullptr};
    const char* text = proj_as_wkt(context.get(), shown, PJ_WKT1_ESRI, one_line);
    if (text == nullptr) {
        text = proj_as_wkt(context.get(), shown, PJ_WKT2_2019, one_line);
    }
    return text == nullptr ? std::string{} : std::string{text};
}

}  // namespace coupling::formats
