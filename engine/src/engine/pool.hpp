// SPDX-License-Identifier: MIT
// Pool<T, capacity, Index>: up to `capacity` elements in place, no heap. Elements keep their index.
// A pool of capacity 0 is an empty class, and loops over it compile to nothing.
#pragma once

#include <stdint.h>

namespace engine {

template <class T, unsigned capacity, class Index>
class Pool {
  public:
    static constexpr Index size_limit = capacity;

    constexpr Index size() const { return size_; }
    constexpr bool full() const { return size_ == capacity; }
    constexpr void clear() { size_ = 0; }
    // Needs !full().
    constexpr T& append(const T& element) { return elements_[size_++] = element; }

    constexpr T& operator[](Index i) { return elements_[i]; }
    constexpr const T& operator[](Index i) const { return elements_[i]; }
    constexpr T* begin() { return elements_; }
    constexpr T* end() { return elements_ + size_; }
    constexpr const T* begin() const { return elements_; }
    constexpr const T* end() const { return elements_ + size_; }

    // Calls function(element) for each; not compiled where the capacity is 0.
    template <class Function>
    void for_each(Function function) const {
        for (const T& element : *this) function(element);
    }

  private:
    T elements_[capacity];
    Index size_ = 0;
};

template <class T, class Index>
class Pool<T, 0, Index> {
  public:
    static constexpr Index size_limit = 0;

    constexpr Index size() const { return 0; }
    constexpr bool full() const { return true; }
    constexpr void clear() {}
    constexpr T* begin() { return nullptr; }
    constexpr T* end() { return nullptr; }
    constexpr const T* begin() const { return nullptr; }
    constexpr const T* end() const { return nullptr; }
    template <class Function>
    void for_each(Function) const {}
};

}  // namespace engine
