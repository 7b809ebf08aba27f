#include "coupling/inputs/formats/system_text.hpp"

#include "coupling/inputs/formats/proj_handles.hpp"

namespace coupling::formats {

std::string esri_text_of(const std::string& definition) {
    const ProjContext context = silent_context();
    const ProjSystem system{proj_create(context.get(), definition.c_str())};
    if (!system || proj_is_crs(system.get()) == 0) {
        return {};
    }
    // Of plan and heights the plan.
    ProjSystem plan;
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

std::string first_element(const std::string& text) {
    int depth = 0;
    bool quoted = false;
    for (std::size_t at = 0; at < text.size(); ++at) {
        quoted = quoted != (text[at] == '"');
        depth += !quoted && text[at] == '[' ? 1 : 0;
        if (!quoted && text[at] == ']' && --depth == 0) {
            return text.substr(0, at + 1);
        }
    }
    return text;
}

}  // namespace coupling::formats
