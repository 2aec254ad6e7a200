#include "ltd_sim/outcome.hpp"

namespace ltd {

std::string toString(Outcome::Kind kind) {
  switch (kind) {
    case Outcome::Kind::kRunning:
      return "running";
    case Outcome::Kind::kFinished:
      return "finished";
    case Outcome::Kind::kStopped:
      return "stopped";
    case Outcome::Kind::kFailed:
      return "failed";
  }
  return "unknown";
}

}  // namespace ltd
