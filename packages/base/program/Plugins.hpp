#pragma once

#include <functional>
#include <string>
#include <vector>

namespace asperity
{
// Loads shared libraries, which register their laws and outputs while they are loaded, and keeps
// them until the program ends. `registrations` names everything that is registered, as "friction
// law 'Truncated'", and names twice what is registered twice. InputError if a library cannot be
// loaded, registers nothing, or registers a name that is taken. Call it on every rank, before
// anything is made from what is registered.
void loadPlugins(std::vector<std::string> const& files,
                 std::function<std::vector<std::string>()> const& registrations);

// Checksums of the content of these libraries, in an order that does not depend on that of the
// files: the text differs where a library has been changed or exchanged.
std::string contentOfPlugins(std::vector<std::string> const& files);
} // namespace asperity
