// The table of methods, and finding one by its name. Fifth of the headers to read.
#pragma once

#include <span>
#include <string_view>

#include "tyg/method.h"

namespace tyg {

/// Every method, in the order in which people meet them.
std::span<const Method> methods();
/// Their names, in the same order.
std::span<const std::string_view> methodNames();
/// The method of that name. Throws InputError that lists the names; `key` is what asked for it.
const Method& findMethod(std::string_view name, std::string_view key = "integrator");

/// Some methods refuse some scenes: throws InputError that says why.
void refuseUnfit(const Method& method, const Scene& scene);
/// Whether the method takes the scene.
bool takes(const Method& method, const Scene& scene);

}  // namespace tyg
