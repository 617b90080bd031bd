#include "sylph_training/run/threads.hpp"

#include <dlfcn.h>
#include <torch/torch.h>

namespace sylph_training {

void useThreads(int count) {
  torch::set_num_threads(count);
  using Setter = void (*)(int);
  if (void* const setter = dlsym(RTLD_DEFAULT, "openblas_set_num_threads")) {
    reinterpret_cast<Setter>(setter)(count);
  }
}

}  // namespace sylph_training
