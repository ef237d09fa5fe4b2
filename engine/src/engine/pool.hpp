// SPDX-License-Identifier: MIT
/// \file
/// Pool<T, capacity>: up to `capacity` elements in place, without a heap. Elements keep their
/// index. A pool of capacity 0 is an empty class, and loops over it compile to nothing.
#pragma once

#include <stdint.h>

#include <engine/choice.hpp>
#include <engine/inline.hpp>
#include <fixedpoint/constexpr.hpp>

namespace engine {

/// \cond internal
// The smallest type that counts to `capacity`.
template <unsigned capacity>
struct CountTo {
    static_assert(capacity <= 65535,
                  "A pool holds at most 65535 elements: Uses states a larger capacity.");
    using Type = typename Either<(capacity < 256), uint8_t, uint16_t>::Type;
};
/// \endcond

/// The elements of a pool, which can be read and changed, but neither added nor removed. An index
/// must be less than size().
template <class T, unsigned capacity>
class Elements {
  public:
    /// The type of an index: one byte for a capacity of up to 255, else two.
    using Index = typename CountTo<capacity>::Type;

    /// The number of elements.
    constexpr Index size() const { return size_; }

    /// The element of that index. With a capacity of 1 every index means the one element.
    FIXEDPOINT_CONSTEXPR T& operator[](Index i) { return elements_[capacity == 1 ? 0 : i]; }
    /// The element of that index.
    constexpr const T& operator[](Index i) const { return elements_[capacity == 1 ? 0 : i]; }
    /// For range-based loops, in the order in which the elements were added.
    /// @{
    FIXEDPOINT_CONSTEXPR T* begin() { return elements_; }
    FIXEDPOINT_CONSTEXPR T* end() { return elements_ + size_; }
    constexpr const T* begin() const { return elements_; }
    constexpr const T* end() const { return elements_ + size_; }
    /// @}

    /// Calls function(element) for each element. With a capacity of 0 nothing is compiled, with 1
    /// no loop.
    template <class Function>
    ENGINE_INLINE void for_each(Function function) {
        visit(*this, function);
    }
    /// Calls function(element) for each element.
    template <class Function>
    ENGINE_INLINE void for_each(Function function) const {
        visit(*this, function);
    }

  private:
    template <class Self, class Function>
    ENGINE_INLINE static void visit(Self& self, Function& function) {
        if (capacity == 1) {
            if (self.size_ != 0) function(self.elements_[0]);
        } else {
            for (auto& element : self) function(element);
        }
    }

    T elements_[capacity]{};

  protected:
    Index size_ = 0;  ///< the number of elements
};

/// \cond internal
template <class T>
class Elements<T, 0> {
  public:
    using Index = uint8_t;

    constexpr Index size() const { return 0; }
    FIXEDPOINT_CONSTEXPR T* begin() { return nullptr; }
    FIXEDPOINT_CONSTEXPR T* end() { return nullptr; }
    constexpr const T* begin() const { return nullptr; }
    constexpr const T* end() const { return nullptr; }
    template <class Function>
    void for_each(Function) const {}
};
/// \endcond

/// Elements that are added one by one and removed together.
template <class T, unsigned capacity>
class Pool : public Elements<T, capacity> {
  public:
    /// Whether there is no room for another element.
    constexpr bool full() const { return this->size_ == capacity; }
    /// Removes all elements.
    FIXEDPOINT_CONSTEXPR void clear() { this->size_ = 0; }
    /// Adds an element and returns it. The pool must not be full. The element has its default
    /// value, or the value it had before clear().
    FIXEDPOINT_CONSTEXPR T& append() { return (*this)[this->size_++]; }
    /// Adds a copy of the element and returns it. The pool must not be full.
    FIXEDPOINT_CONSTEXPR T& append(const T& element) { return append() = element; }
};

/// \cond internal
template <class T>
class Pool<T, 0> : public Elements<T, 0> {
  public:
    constexpr bool full() const { return true; }
    FIXEDPOINT_CONSTEXPR void clear() {}
};
/// \endcond

}  // namespace engine
