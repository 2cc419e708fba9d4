#ifdef CAPCON_MPI
#define OMPI_SKIP_MPICXX
#define MPICH_SKIP_MPICXX
#include <mpi.h>

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <limits>
#include <thread>
#include <vector>

#include "distributed/launcher.h"
#include "distributed/ranks.h"

namespace capcon {
namespace {

constexpr auto kShortest = std::chrono::microseconds(50), kLongest = std::chrono::microseconds(5000);
constexpr auto kAsk = std::chrono::seconds(1);  // how often it is asked whether the other lives

/// MPI's own waiting keeps a core busy, which is somebody else's. False where `lives` said no.
bool wait_for(MPI_Request& request, const std::function<bool()>& lives = {}) {
  auto pause = kShortest;
  auto asked = std::chrono::steady_clock::now();
  for (;;) {
    int done = 0;
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done) return true;
    if (lives && std::chrono::steady_clock::now() - asked > kAsk) {
      if (!lives()) {
        // What was sent before the other died may still have come.
        MPI_Test(&request, &done, MPI_STATUS_IGNORE);
        if (!done) MPI_Cancel(&request);
        return done != 0;
      }
      asked = std::chrono::steady_clock::now();
    }
    std::this_thread::sleep_for(pause);
    pause = std::min(kLongest, 2 * pause);
  }
}

int length(std::size_t bytes) {
  assert(bytes <= std::size_t(std::numeric_limits<int>::max()));
  return static_cast<int>(bytes);
}

}  // namespace

bool built_with_mpi() {
  return true;
}

Ranks::Ranks() {
  if (!launched_together()) return;
  MPI_Init(nullptr, nullptr);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
  MPI_Comm here;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &here);
  MPI_Comm_rank(here, &on_this_machine_);
  MPI_Comm_size(here, &size_of_machine_);
  MPI_Comm_free(&here);
}

Ranks::~Ranks() {
  if (size_ > 1 && std::uncaught_exceptions() == 0) MPI_Finalize();
}

void Ranks::send(int to, std::span<const std::byte> bytes) const {
  MPI_Request request;
  MPI_Isend(bytes.data(), length(bytes.size()), MPI_BYTE, to, 0, MPI_COMM_WORLD, &request);
  wait_for(request);
}

bool Ranks::receive(int from, std::span<std::byte> bytes, const std::function<bool()>& lives) const {
  MPI_Request request;
  MPI_Irecv(bytes.data(), length(bytes.size()), MPI_BYTE, from, 0, MPI_COMM_WORLD, &request);
  return wait_for(request, lives);
}

void Ranks::broadcast(std::span<std::byte> bytes) const {
  if (alone()) return;
  MPI_Request request;
  MPI_Ibcast(bytes.data(), length(bytes.size()), MPI_BYTE, 0, MPI_COMM_WORLD, &request);
  wait_for(request);
}

void Ranks::add_up(std::span<double> values) const {
  if (!first()) return send(0, std::as_bytes(values));
  std::vector<double> others(alone() ? 0 : values.size());
  for (int from = 1; from < size_; ++from) {
    receive(from, std::as_writable_bytes(std::span(others)));
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += others[i];
  }
}

void Ranks::end_all(int exit_code) const {
  if (size_ > 1) MPI_Abort(MPI_COMM_WORLD, exit_code);
  std::_Exit(exit_code);
}

}  // namespace capcon
#endif
