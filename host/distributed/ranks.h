#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <type_traits>

namespace capcon {

/// The processes that an MPI launcher (mpirun, srun) started together, numbered from 0; without a launcher
/// one, number 0, and MPI is not even initialised. One object a process.
///
/// It is left in order when it is destroyed, which waits for the others; not where an exception is on its
/// way: then the launcher sees a failed process, and ends the rest.
class Ranks {
 public:
  /// Joins. Failure where a launcher started several and this program was built without MPI.
  Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
  ~Ranks();

  int rank() const { return rank_; }
  int size() const { return size_; }
  bool alone() const { return size_ == 1; }
  bool first() const { return rank_ == 0; }
  /// This one's number, from 0, among those on the same machine.
  int on_this_machine() const { return on_this_machine_; }
  /// How many there are on it.
  int size_of_machine() const { return size_of_machine_; }

  /// Sends to another rank, and waits until that has it.
  void send(int to, std::span<const std::byte> bytes) const;
  /// Waits for as many bytes of another rank; a waiting process takes no CPU time to speak of. With `lives`,
  /// which is asked now and then: false where it says that the other has died, and nothing came.
  bool receive(int from, std::span<std::byte> bytes, const std::function<bool()>& lives = {}) const;
  /// Everybody has rank 0's afterwards.
  void broadcast(std::span<std::byte> bytes) const;
  /// The values of all ranks added up, at rank 0, one rank after the other by their numbers: the same bits
  /// every time. Those of the others stay as they are.
  void add_up(std::span<double> values) const;
  /// Ends all processes at once; what is on disk stays. The exit code is the launcher's business.
  [[noreturn]] void end_all(int exit_code) const;

  /// The same for one plain value.
  template <class T>
  T broadcast_value(T value) const {
    static_assert(std::is_trivially_copyable_v<T>);
    broadcast(std::as_writable_bytes(std::span(&value, 1)));
    return value;
  }

 private:
  int rank_ = 0, size_ = 1, on_this_machine_ = 0, size_of_machine_ = 1;
};

/// Whether this program can work with several ranks.
bool built_with_mpi();

}  // namespace capcon
