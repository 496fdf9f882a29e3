// Entries of lists by whole numbers.
#pragma once

#include <cstddef>

namespace headland {

// list[index] for an index >= 0. Nodes and places are ints, for which -1 stands for none; the
// containers count in another type.
template <typename List>
decltype(auto) at(List& list, int index) {
  return list[static_cast<std::size_t>(index)];
}

}  // namespace headland
