// SPDX-License-Identifier: GPL-3.0-or-later
// The virtual side of the haptic lever, as in the engine's scene. Input: the user's forces on its
// end in N, 1024 times a second. Result: the height of the end in m.
#include <scenes/lever.hpp>

template <class Number>
class Program {
  public:
    Program() { scenes::build<scenes::Lever>(world_); }

    Number step(Number force_x, Number force_y) {
        world_.custom_force().force = {force_x, force_y};
        world_.step(engine::BinaryStep<10>());
        return world_.particles()[0].position[1];
    }

  private:
    engine::World<Number, scenes::Lever::Uses<scenes::SemiImplicit>> world_;
};
