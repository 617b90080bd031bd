#include "multiply_rows_kernel.hpp"

namespace sylph::policy_kernels {

void multiplyRowsAvx2(const Multiplication& task) {
  Kernel<8, 6>::multiply(task);
}

}  // namespace sylph::policy_kernels
