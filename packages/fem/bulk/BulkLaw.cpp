#include "fem/bulk/BulkLaw.hpp"

namespace asperity::fem
{
BulkLawRegistry const& bulkLaws() { return BulkLawRegistry::instance(); }
} // namespace asperity::fem
