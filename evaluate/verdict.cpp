#include "evaluate/verdict.h"

namespace headland {

std::string_view grade_name(Grade grade) {
  switch (grade) {
    case Grade::kPass:
      return "PASS";
    case Grade::kWarn:
      return "WARN";
    case Grade::kFail:
      return "FAIL";
  }
  return "";
}

}  // namespace headland
