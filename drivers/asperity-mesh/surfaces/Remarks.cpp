#include "surfaces/Remarks.hpp"

#include "GmshSession.hpp"

namespace asperity::geometry
{
void printRemark(std::string const& sentence) { warn(sentence); }
} // namespace asperity::geometry
