#include "planner/plan.h"

namespace headland {

std::string_view pass_kind_name(PassKind kind) {
  return kind == PassKind::kSwath ? "swath" : "headland pass";
}

}  // namespace headland
