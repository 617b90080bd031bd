#include "multiply_rows_kernel.hpp"

namespace sylph::policy_kernels {

void multiplyRowsAvx512(const Multiplication& task) {
  Kernel<16, 8>::multiply(task);
}

}  // namespace sylph::policy_kernels
