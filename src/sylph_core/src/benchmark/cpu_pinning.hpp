#pragma once

#include <sched.h>

#include <mutex>
#include <vector>

namespace sylph {

/// Shares the CPUs that this process may use among its runs.
class CpuPool {
 public:
  /// Of those that the calling thread may use.
  CpuPool();

  /// One of those with the fewest runs, the first of them.
  /// @return -1 if it is not known which there are
  int take();
  /// Ends a run on a CPU that take() gave.
  void giveBack(int cpu);

 private:
  struct Cpu {
    int number = 0;
    int runs = 0;
  };

  std::mutex mutex_;
  std::vector<Cpu> cpus_;  // guarded by mutex_
};

/// Keeps the calling thread, and what it starts meanwhile, on one CPU.
class PinnedToCpu {
 public:
  explicit PinnedToCpu(CpuPool& pool);
  PinnedToCpu(const PinnedToCpu&) = delete;
  PinnedToCpu& operator=(const PinnedToCpu&) = delete;
  ~PinnedToCpu();

 private:
  CpuPool* pool_;
  int cpu_;
  cpu_set_t before_{};
};

}  // namespace sylph
