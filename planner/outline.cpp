#include "planner/outline.h"

#include <utility>

namespace headland {

Field simplified(const Field& field) {
  const PolygonSet whole{{PolygonPart{field.boundary, field.holes}}};
  PolygonPart part = std::move(simplified(whole, kOutlineTolerance_m).parts.front());
  Field result = field;
  result.boundary = std::move(part.outer);
  result.holes = std::move(part.holes);
  return result;
}

}  // namespace headland
