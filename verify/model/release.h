#pragma once

namespace proskill::verify {

/// Gives back the memory of a container. Assigning `{}` to one would only remove its elements.
template <class Container> void release(Container& all) { Container().swap(all); }

} // namespace proskill::verify
