// SPDX-License-Identifier: MIT
// Pool<T, capacity, Index>: up to `capacity` elements in place, no heap. Elements keep their index.
// A pool of capacity 0 is an empty class, and loops over it compile to nothing.
#pragma once

#include <stdint.h>

#include <engine/inline.hpp>

namespace engine {

template <class T, unsigned capacity, class Index>
class Pool {
  public:
    static constexpr Index size_limit = capacity;

    constexpr Index size() const { return size_; }
    constexpr bool full() const { return size_ == capacity; }
    constexpr void clear() { size_ = 0; }
    // Needs !full(). The new element is still what it was made as, or what it was before clear().
    constexpr T& append() { return (*this)[size_++]; }
    constexpr T& append(const T& element) { return append() = element; }

    // Where there is room for one only, it needs no look-up.
    constexpr T& operator[](Index i) { return elements_[capacity == 1 ? 0 : i]; }
    constexpr const T& operator[](Index i) const { return elements_[capacity == 1 ? 0 : i]; }
    constexpr T* begin() { return elements_; }
    constexpr T* end() { return elements_ + size_; }
    constexpr const T* begin() const { return elements_; }
    constexpr const T* end() const { return elements_ + size_; }

    // Calls function(element) for each; not compiled where the capacity is 0, no loop where it
    // is 1.
    template <class Function>
    ENGINE_INLINE void for_each(Function function) {
        visit(*this, function);
    }
    template <class Function>
    ENGINE_INLINE void for_each(Function function) const {
        visit(*this, function);
    }

  private:
    template <class Pool, class Function>
    ENGINE_INLINE static void visit(Pool& pool, Function& function) {
        if (capacity == 1) {
            if (pool.size_ != 0) function(pool.elements_[0]);
        } else {
            for (auto& element : pool) function(element);
        }
    }

    T elements_[capacity]{};
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
