#include "benchmark/cpu_pinning.hpp"

#include <algorithm>

namespace sylph {

CpuPool::CpuPool() {
  cpu_set_t allowed{};
  if (sched_getaffinity(0, sizeof(allowed), &allowed) == 0) {
    for (int number = 0; number < CPU_SETSIZE; ++number) {
      if (CPU_ISSET(static_cast<std::size_t>(number), &allowed)) {
        cpus_.push_back({number, 0});
      }
    }
  }
}

int CpuPool::take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto cpu = std::min_element(cpus_.begin(), cpus_.end(),
                                    [](const Cpu& a, const Cpu& b) { return a.runs < b.runs; });
  if (cpu == cpus_.end()) {
    return -1;
  }
  ++cpu->runs;
  return cpu->number;
}

void CpuPool::giveBack(int cpu) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (Cpu& candidate : cpus_) {
    candidate.runs -= candidate.number == cpu ? 1 : 0;
  }
}

PinnedToCpu::PinnedToCpu(CpuPool& pool) : pool_(&pool), cpu_(pool.take()) {
  if (cpu_ >= 0 && sched_getaffinity(0, sizeof(before_), &before_) == 0) {
    cpu_set_t one{};
    CPU_SET(static_cast<std::size_t>(cpu_), &one);
    sched_setaffinity(0, sizeof(one), &one);
  }
}

PinnedToCpu::~PinnedToCpu() {
  if (cpu_ >= 0) {
    sched_setaffinity(0, sizeof(before_), &before_);
    pool_->giveBack(cpu_);
  }
}

}  // namespace sylph
