#include "multiply_rows_kernel.hpp"

namespace sylph::policy_kernels {

void multiplyRowsPortable(const Multiplication& task) {
  Kernel<4, 4>::multiply(task);
}

}  // namespace sylph::policy_kernels
