#include "sylph_core/execution/execution_event.hpp"

#include <utility>

namespace sylph {

ExecutionEvent::ExecutionEvent(std::uint32_t of_plan, What told)
    : plan_id(of_plan), what(std::move(told)) {}

}  // namespace sylph
