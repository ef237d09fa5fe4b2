// SPDX-License-Identifier: GPL-3.0-or-later
// The virtual side of the haptic lever, as the scene of the engine: the forces of the user on its
// end in N, 1024 times a second. Result: how high the end is, in m.
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
