#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace sylph {

/// Calls work(0) to work(count - 1) in `jobs` threads, this one among them, and after each of them
/// finished(index, how many are done), one at a time.
/// @throws whatever a call throws first, once the calls under way have ended; no further one begins
template <typename Work, typename Finished>
void parallelFor(std::size_t count, int jobs, const Work& work, const Finished& finished) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;  // of what follows
  std::size_t done = 0;
  std::exception_ptr failure;
  const auto workOn = [&] {
    for (std::size_t index = next++; index < count; index = next++) {
      try {
        work(index);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(mutex);
        failure = failure ? failure : std::current_exception();
        next = count;
        return;
      }
      const std::lock_guard<std::mutex> lock(mutex);
      finished(index, ++done);
    }
  };
  std::vector<std::thread> threads;
  for (int job = 1; job < jobs; ++job) {
    threads.emplace_back(workOn);
  }
  workOn();
  for (std::thread& thread : threads) {
    thread.join();
  }
  if (failure) {
    std::rethrow_exception(failure);
  }
}

}  // namespace sylph
