#pragma once

#include <sys/resource.h>

namespace proskill::process {

/// Sets the soft and the hard limit of this process and its children.
inline void limitResource(__rlimit_resource resource, rlim_t most) {
  const rlimit both{most, most};
  setrlimit(resource, &both);
}

} // namespace proskill::process
