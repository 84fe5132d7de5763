#include "layoutbox/base/result.h"

namespace layoutbox {

std::string_view error_code_name(ErrorCode code) {
  switch (code) {
    case ErrorCode::kUsage: return "usage";
    case ErrorCode::kParse: return "parse";
    case ErrorCode::kSchema: return "schema";
    case ErrorCode::kReference: return "reference";
    case ErrorCode::kGeometry: return "geometry";
    case ErrorCode::kEmpty: return "empty";
    case ErrorCode::kTooLarge: return "tooLarge";
    case ErrorCode::kInfeasible: return "infeasible";
    case ErrorCode::kNotFound: return "notFound";
    case ErrorCode::kCheckFailed: return "checkFailed";
    case ErrorCode::kNoBlender: return "noBlender";
    case ErrorCode::kRenderFailed: return "renderFailed";
    case ErrorCode::kNoSolver: return "noSolver";
    case ErrorCode::kIo: return "io";
    case ErrorCode::kNetwork: return "network";
    case ErrorCode::kInterrupted: return "interrupted";
    case ErrorCode::kInternal: return "internal";
  }
  return "internal";
}

}  // namespace layoutbox
