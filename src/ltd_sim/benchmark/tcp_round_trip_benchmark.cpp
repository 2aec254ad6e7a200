// A raw TCP round trip between two processes on this machine, as a measure for the lock's: 200 bytes there, 150 back,
// about the length of LocoForce and LocoTraction.

#include <arpa/inet.h>
#include <benchmark/benchmark.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace {

constexpr std::size_t kThere = 200, kBack = 150;

bool transfer(int socket, char* buffer, std::size_t length, bool out) {
  for (std::size_t done = 0; done < length;) {
    const ssize_t n = out ? write(socket, buffer + done, length - done) : read(socket, buffer + done, length - done);
    if (n <= 0) return false;
    done += static_cast<std::size_t>(n);
  }
  return true;
}

[[noreturn]] void echo(int listener) {
  const int socket = accept(listener, nullptr, nullptr);
  const int on = 1;
  setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  char buffer[kThere] = {};
  while (transfer(socket, buffer, kThere, false) && transfer(socket, buffer, kBack, true)) {
  }
  _exit(0);
}

void BM_RawTcpRoundTrip(benchmark::State& state) {
  const int listener = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t length = sizeof address;
  auto* generic = reinterpret_cast<sockaddr*>(&address);
  if (bind(listener, generic, length) != 0 || listen(listener, 1) != 0 ||
      getsockname(listener, generic, &length) != 0) {
    state.SkipWithError("no port on the loopback");
    return;
  }
  const pid_t child = fork();
  if (child == 0) echo(listener);
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  const int on = 1;
  setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  if (connect(socket, generic, length) != 0) state.SkipWithError("cannot connect");
  char buffer[kThere] = {};
  for (auto _ : state) {
    if (!transfer(socket, buffer, kThere, true) || !transfer(socket, buffer, kBack, false)) {
      state.SkipWithError("connection lost");
      break;
    }
  }
  close(socket);
  close(listener);
  waitpid(child, nullptr, 0);
}
BENCHMARK(BM_RawTcpRoundTrip)->UseRealTime()->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
