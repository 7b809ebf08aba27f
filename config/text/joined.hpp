#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace config {

/// Texts one after the other: one allocation however many there are.
std::string joined_texts(std::initializer_list<std::string_view> texts);

// `joined("2 of ", all, " rocks")`: functions of views. A template would be compiled anew for each length of
// each literal.
inline std::string joined(std::string_view t0) {
    return joined_texts({t0});
}
inline std::string joined(std::string_view t0, std::string_view t1) {
    return joined_texts({t0, t1});
}
inline std::string joined(std::string_view t0, std::string_view t1, std::string_view t2) {
    return joined_texts({t0, t1, t2});
}
inline std::string joined(std::string_view t0, std::string_view t1, std::string_view t2,
                          std::string_view t3) {
    return joined_texts({t0, t1, t2, t3});
}
inline std::string joined(std::string_view t0, std::string_view t1, std::string_view t2, std::string_view t3,
                          std::string_view t4) {
    return joined_texts({t0, t1, t2, t3, t4});
}
inline std::string joined(std::string_view t0, std::string_view t1, std::string_view t2, std::string_view t3,
                          std::string_view t4, std::string_view t5) {
    return joined_texts({t0, t1, t2, t3, t4, t5});
}
inline std::string joined(std::string_view t0, std::string_view t1, std::string_view t2, std::string_view t3,
                          std::string_view t4, std::string_view t5, std::string_view t6) {
    return joined_texts({t0, t1, t2, t3, t4, t5, t6});
}
inline std::string joined(std::string_view t0, std::string_view t1, std::string_view t2, std::string_view t3,
                          std::string_view t4, std::string_view t5, std::string_view t6,
                          std::string_view t7) {
    return joined_texts({t0, t1, t2, t3, t4, t5, t6, t7});
}
inline std::string joined(std::string_view t0, std::string_view t1, std::string_view t2, std::string_view t3,
                          std::string_view t4, std::string_view t5, std::string_view t6, std::string_view t7,
                          std::string_view t8) {
    return joined_texts({t0, t1, t2, t3, t4, t5, t6, t7, t8});
}
inline std::string joined(std::string_view t0, std::string_view t1, std::string_view t2, std::string_view t3,
                          std::string_view t4, std::string_view t5, std::string_view t6, std::string_view t7,
                          std::string_view t8, std::string_view t9) {
    return joined_texts({t0, t1, t2, t3, t4, t5, t6, t7, t8, t9});
}
inline std::string joined(std::string_view t0, std::string_view t1, std::string_view t2, std::string_view t3,
                          std::string_view t4, std::string_view t5, std::string_view t6, std::string_view t7,
                          std::string_view t8, std::string_view t9, std::string_view t10) {
    return joined_texts({t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10});
}
inline std::string joined(std::string_view t0, std::string_view t1, std::string_view t2, std::string_view t3,
                          std::string_view t4, std::string_view t5, std::string_view t6, std::string_view t7,
                          std::string_view t8, std::string_view t9, std::string_view t10,
                          std::string_view t11) {
    return joined_texts({t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11});
}
inline std::string joined(std::string_view t0, std::string_view t1, std::string_view t2, std::string_view t3,
                          std::string_view t4, std::string_view t5, std::string_view t6, std::string_view t7,
                          std::string_view t8, std::string_view t9, std::string_view t10,
                          std::string_view t11, std::string_view t12) {
    return joined_texts({t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, t12});
}
inline std::string joined(std::string_view t0, std::string_view t1, std::string_view t2, std::string_view t3,
                          std::string_view t4, std::string_view t5, std::string_view t6, std::string_view t7,
                          std::string_view t8, std::string_view t9, std::string_view t10,
                          std::string_view t11, std::string_view t12, std::string_view t13) {
    return joined_texts({t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, t12, t13});
}
inline std::string joined(std::string_view t0, std::string_view t1, std::string_view t2, std::string_view t3,
                          std::string_view t4, std::string_view t5, std::string_view t6, std::string_view t7,
                          std::string_view t8, std::string_view t9, std::string_view t10,
                          std::string_view t11, std::string_view t12, std::string_view t13,
                          std::string_view t14) {
    return joined_texts({t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, t12, t13, t14});
}
inline std::string joined(std::string_view t0, std::string_view t1, std::string_view t2, std::string_view t3,
                          std::string_view t4, std::string_view t5, std::string_view t6, std::string_view t7,
                          std::string_view t8, std::string_view t9, std::string_view t10,
                          std::string_view t11, std::string_view t12, std::string_view t13,
                          std::string_view t14, std::string_view t15) {
    return joined_texts({t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, t12, t13, t14, t15});
}

}  // namespace config
