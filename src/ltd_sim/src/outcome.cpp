#include "ltd_sim/outcome.hpp"

namespace ltd {

int Outcome::exitStatus() const {
  switch (kind) {
    case Kind::kFinished:
      return 0;
    case Kind::kRefused:
      return 2;
    case Kind::kStopped:
      return 3;
    default:
      return 1;
  }
}

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
    case Outcome::Kind::kRefused:
      return "refused";
  }
  return "unknown";
}

}  // namespace ltd
