// SPDX-License-Identifier: MIT
// One to three steps of random small worlds with everything, compared with a model written a second
// time from the documentation: plain doubles, no templates, every formula explicit. Numbers are on
// a grid of quarters, so that surfaces that just touch and velocities at the threshold occur often.
#include <engine.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace {

struct V {
    double x = 0, y = 0;
};
V operator+(V a, V b) { return {a.x + b.x, a.y + b.y}; }
V operator-(V a, V b) { return {a.x - b.x, a.y - b.y}; }
V operator*(V a, double s) { return {a.x * s, a.y * s}; }
double dot(V a, V b) { return a.x * b.x + a.y * b.y; }
double norm(V a) { return std::sqrt(dot(a, a)); }

constexpr int none = -1;

struct Particle {
    V x, v;
    double inverse_mass = 1, radius = 0, damping = 1;
    V force, moved;
};
struct Link {
    int a = 0, b = none;  // none: to the anchor
    V anchor;
    double length = 1, stiffness = 0, damping = 0, restitution = 0;
};
struct Drag {
    int a;
    double linear, quadratic;
};
struct Plane {
    V normal;
    double offset, restitution;
};
struct Row {
    int a, b;
    V normal;
    bool pushes_only;
    double target, restitution, penetration;
};
enum class Integrator {
    explicit_euler,
    semi_implicit,
    verlet,
    implicit_springs,
    direct_springs,
    implicit_midpoint
};
enum class Solver { gauss_seidel, worst_first };

struct Model {
    Integrator integrator;
    Solver solver;
    int iterations;
    double h = 0.25;
    V gravity;
    double restitution = 0, threshold = 0;
    std::vector<Particle> particles;
    std::vector<Link> springs, rods, ropes;  // anchored ones first
    std::vector<Drag> drags;
    std::vector<Plane> planes;
    std::vector<V> custom;

    std::vector<Row> rows;
    bool forces_known = false;
    int steps = 0;
    bool is_close = false;  // a comparison depended on rounding: not to be compared

    // Equal numbers distinguish < from <= where both sides have them without rounding: on the grid,
    // in the first step, unless it has moved already.
    bool less(double a, double b) {
        const bool is_exact = steps == 0 && integrator != Integrator::implicit_midpoint && a == b &&
                              std::floor(a * 1024) == a * 1024;
        if (std::abs(a - b) < 1e-9 && !is_exact) is_close = true;
        return a < b;
    }
    V position_of(int i, V anchor) const { return i == none ? anchor : particles[i].x; }
    V velocity_between(int a, int b) const {
        return b == none ? particles[a].v : particles[a].v - particles[b].v;
    }
    double inverse(int i) const { return i == none ? 0 : particles[i].inverse_mass; }
    // Changes a quantity of a relative to b along n, in proportion to inverse mass.
    void shift(int a, int b, V n, double change, V Particle::*quantity) {
        const double total = inverse(a) + inverse(b);
        if (total == 0) return;
        particles[a].*quantity = particles[a].*quantity + n * (change * inverse(a) / total);
        if (b != none)
            particles[b].*quantity = particles[b].*quantity - n * (change * inverse(b) / total);
    }

    void find_forces() {
        for (std::size_t i = 0; i < particles.size(); ++i) particles[i].force = custom[i];
        if (integrator != Integrator::implicit_springs &&
            integrator != Integrator::direct_springs &&
            integrator != Integrator::implicit_midpoint) {
            for (const Link& s : springs) {
                const V d = particles[s.a].x - position_of(s.b, s.anchor);
                if (norm(d) == 0) continue;
                const V n = d * (1 / norm(d));
                const double tension = s.stiffness * (norm(d) - s.length) +
                                       s.damping * dot(velocity_between(s.a, s.b), n);
                particles[s.a].force = particles[s.a].force - n * tension;
                if (s.b != none) particles[s.b].force = particles[s.b].force + n * tension;
            }
        }
        for (const Drag& d : drags) {
            Particle& p = particles[d.a];
            p.force = p.force - p.v * (d.linear + d.quadratic * norm(p.v));
        }
    }
    void move_velocities(double by) {
        for (Particle& p : particles)
            if (p.inverse_mass > 0) p.v = p.v + (gravity + p.force * p.inverse_mass) * by;
    }
    void pull_implicitly() {
        for (const Link& s : springs) {
            const V d = particles[s.a].x - position_of(s.b, s.anchor);
            if (norm(d) == 0) continue;
            const V n = d * (1 / norm(d));
            const double i = inverse(s.a) + inverse(s.b);
            const double u = dot(velocity_between(s.a, s.b), n);
            const double x = norm(d) - s.length;
            const double after =
                (u - h * i * s.stiffness * x) / (1 + h * i * s.damping + h * h * i * s.stiffness);
            shift(s.a, s.b, n, after - u, &Particle::v);
        }
    }
    // The velocities of all particles after an implicit step of all springs, along the springs'
    // present directions: Gauss-Jordan elimination of all components. With w and w' before and
    // after it along a spring, the force is that at the extension e + h w' and the velocity w', or,
    // in the middle of the step, at e + h (w' - w) / 4 and (w + w') / 2.
    void pull_together(bool in_the_middle) {
        const std::size_t n = 2 * particles.size();
        std::vector<std::vector<double>> m(n, std::vector<double>(n + 1));
        for (std::size_t p = 0; p < particles.size(); ++p) {
            m[2 * p][2 * p] = m[2 * p + 1][2 * p + 1] = 1;
            m[2 * p][n] = particles[p].v.x;
            m[2 * p + 1][n] = particles[p].v.y;
        }
        for (const Link& s : springs) {
            const V d = particles[s.a].x - position_of(s.b, s.anchor);
            if (norm(d) == 0) continue;
            const double unit[] = {d.x / norm(d), d.y / norm(d)};
            const double w = dot(velocity_between(s.a, s.b), {unit[0], unit[1]});
            double force = s.stiffness * (norm(d) - s.length);
            double by_velocity = s.damping + h * s.stiffness;
            if (in_the_middle) {
                force += (s.damping / 2 - h * s.stiffness / 4) * w;
                by_velocity = s.damping / 2 + h * s.stiffness / 4;
            }
            for (const int p : {s.a, s.b}) {
                if (p == none) continue;
                const double of_p = h * inverse(p) * (p == s.a ? 1 : -1);
                for (int i = 0; i < 2; ++i) {
                    auto& row = m[2 * p + i];
                    row[n] -= of_p * unit[i] * force;
                    for (int j = 0; j < 2; ++j) {
                        const double slope = of_p * unit[i] * by_velocity * unit[j];
                        row[2 * s.a + j] += slope;
                        if (s.b != none) row[2 * s.b + j] -= slope;
                    }
                }
            }
        }
        for (std::size_t c = 0; c < n; ++c) {
            std::size_t pivot = c;
            for (std::size_t r = c; r < n; ++r)
                if (std::abs(m[r][c]) > std::abs(m[pivot][c])) pivot = r;
            std::swap(m[c], m[pivot]);
            for (std::size_t r = 0; r < n; ++r) {
                if (r == c) continue;
                const double factor = m[r][c] / m[c][c];
                for (std::size_t i = c; i <= n; ++i) m[r][i] -= factor * m[c][i];
            }
        }
        for (std::size_t p = 0; p < particles.size(); ++p)
            particles[p].v = {m[2 * p][n] / m[2 * p][2 * p],
                              m[2 * p + 1][n] / m[2 * p + 1][2 * p + 1]};
    }
    void move_positions() { move_positions(h); }
    void move_positions(double by) {
        for (Particle& p : particles)
            if (p.inverse_mass > 0) p.x = p.x + p.v * by;
    }
    void damp() {
        for (Particle& p : particles) p.v = p.v * p.damping;
    }

    void add_row(Row row, double correction) {
        if (solver == Solver::gauss_seidel) {
            if (inverse(row.a) + inverse(row.b) == 0) return;  // nothing can move
            shift(row.a, row.b, row.normal, correction, &Particle::x);
        }
        rows.push_back(row);
    }
    void contact(int a, int b, V n, double depth, double e) {
        double correction = depth, target = 0;
        const double closing = -dot(velocity_between(a, b), n);
        if (solver == Solver::gauss_seidel && less(threshold, closing)) {
            const double pulls = (inverse(a) > 0) - (inverse(b) > 0);
            correction = (1 + e) * depth;
            target = (1 + e) * pulls * dot(gravity, n) * (depth / closing + h / 2);
        }
        add_row({a, b, n, true, target, e, depth}, correction);
    }
    void collect() {
        rows.clear();
        for (const Link& r : rods) {
            const V d = particles[r.a].x - position_of(r.b, r.anchor);
            const V n = d * (1 / norm(d)), w = velocity_between(r.a, r.b);
            const double excess = norm(d) - r.length;
            if (solver == Solver::worst_first) {
                if (excess == 0) continue;
                rows.push_back({r.a, r.b, n, true, 0, 0, -excess});
                rows.push_back({r.a, r.b, n * -1, true, 0, 0, excess});
            } else {
                add_row({r.a, r.b, n, false, -h * dot(w, w) / (2 * r.length), 0, 0}, -excess);
            }
        }
        for (const Link& r : ropes) {
            const V d = particles[r.a].x - position_of(r.b, r.anchor);
            const V n = d * (-1 / norm(d)), w = velocity_between(r.a, r.b);
            const double slack = r.length - norm(d), apart = -dot(w, n) * h;
            if (less(1e-5, slack) && !less(slack, apart / 16)) continue;
            const double excess = std::max(0.0, -slack);
            add_row({r.a, r.b, n, true, h * dot(w, w) / (2 * r.length), r.restitution, excess},
                    excess);
        }
        for (const Plane& p : planes) {
            for (int i = 0; i < int(particles.size()); ++i) {
                const double height =
                    dot(p.normal, particles[i].x) - p.offset - particles[i].radius;
                if (inverse(i) > 0 && less(height, 0))
                    contact(i, none, p.normal, -height, p.restitution);
            }
        }
        for (int b = 1; b < int(particles.size()); ++b) {
            for (int a = 0; a < b; ++a) {
                const V d = particles[a].x - particles[b].x;
                const double reach = particles[a].radius + particles[b].radius;
                if (inverse(a) + inverse(b) == 0 || !less(norm(d), reach)) continue;
                contact(a, b, norm(d) == 0 ? V{1, 0} : d * (1 / norm(d)), reach - norm(d),
                        restitution);
            }
        }
    }

    void solve() {
        if (solver == Solver::worst_first) return solve_worst_first();
        // A single row is solved once.
        for (int i = 0; i < (rows.size() == 1 ? 1 : iterations); ++i) {
            for (const Row& row : rows) {
                const double v = dot(velocity_between(row.a, row.b), row.normal);
                double goal = row.target;
                if (row.pushes_only) {
                    if (!less(v, 0) && !less(v, goal)) continue;
                    if (less(threshold, -v)) {
                        goal += row.restitution * -v;
                    } else {
                        goal = std::max(goal, 0.0);
                    }
                }
                shift(row.a, row.b, row.normal, goal - v, &Particle::v);
            }
        }
    }
    void solve_worst_first() {
        for (Particle& p : particles) p.moved = {};
        for (int i = 0; i < iterations; ++i) {
            const Row* worst = nullptr;
            double worst_velocity = 0, worst_depth = 0;
            for (const Row& row : rows) {
                const double v = dot(velocity_between(row.a, row.b), row.normal);
                const V moved = row.b == none ? particles[row.a].moved
                                              : particles[row.a].moved - particles[row.b].moved;
                const double depth = row.penetration - dot(moved, row.normal);
                if (!less(v, -0.01) && !less(0.0001, depth)) continue;
                if (worst == nullptr || less(v, worst_velocity)) {
                    worst = &row;
                    worst_velocity = v;
                    worst_depth = depth;
                }
            }
            if (worst == nullptr) return;
            if (less(worst_velocity, 0)) {
                shift(worst->a, worst->b, worst->normal, -(1 + worst->restitution) * worst_velocity,
                      &Particle::v);
            }
            if (less(0, worst_depth)) {
                shift(worst->a, worst->b, worst->normal, worst_depth, &Particle::x);
                shift(worst->a, worst->b, worst->normal, worst_depth, &Particle::moved);
            }
        }
    }

    void step() {
        switch (integrator) {
            case Integrator::explicit_euler:
                find_forces();
                collect();
                solve();
                move_positions();
                move_velocities(h);
                damp();
                break;
            case Integrator::semi_implicit:
            case Integrator::implicit_springs:
            case Integrator::direct_springs:
                find_forces();
                move_velocities(h);
                if (integrator == Integrator::implicit_springs) pull_implicitly();
                if (integrator == Integrator::direct_springs) pull_together(false);
                damp();
                collect();
                solve();
                move_positions();
                break;
            case Integrator::implicit_midpoint:
                if (!forces_known) find_forces();
                forces_known = true;
                move_velocities(h / 2);
                move_positions(h / 2);
                pull_together(true);
                collect();
                solve();
                move_positions(h / 2);
                find_forces();
                move_velocities(h / 2);
                damp();
                break;
            case Integrator::verlet:
                if (!forces_known) find_forces();
                forces_known = true;
                move_velocities(h / 2);
                collect();
                solve();
                move_positions();
                find_forces();
                move_velocities(h / 2);
                damp();
                break;
        }
        ++steps;
    }
};

template <class World>
struct CustomForces {
    typename World::Vector force[World::capacity];
    void apply(World& world) const {
        for (unsigned char i = 0; i < world.particles().size(); ++i)
            world.particles()[i].force += force[i];
    }
};

template <class IntegratorType, class SolverType>
struct Everything : engine::Uses {
    static constexpr unsigned particles = 4, springs = 1, anchored_springs = 1, drags = 1, rods = 1,
                              anchored_rods = 1, ropes = 1, anchored_ropes = 1, planes = 1,
                              contacts = 10;
    static constexpr bool gravity = true, damping = true, radii = true, collisions = true,
                          custom_force = true;
    template <class World>
    using CustomForce = CustomForces<World>;
    using Integrator = IntegratorType;
    using Solver = SolverType;
};

struct Random {
    std::mt19937 engine;
    int below(int n) { return int(engine() % unsigned(n)); }
    bool one_in(int n) { return below(n) == 0; }
    double quarters(int low, int high) { return (low + below(high - low + 1)) / 4.0; }
    V vector(int most) { return {quarters(-most, most), quarters(-most, most)}; }
};

Link random_link(Random& random, const Model& model, bool anchored) {
    Link link;
    const int count = int(model.particles.size());
    link.a = random.below(count);
    if (!anchored) link.b = (link.a + 1 + random.below(count - 1)) % count;
    link.anchor = random.vector(8);
    const double distance =
        norm(model.particles[link.a].x - model.position_of(link.b, link.anchor));
    link.length = random.one_in(3) && distance > 0 ? distance : random.quarters(1, 12);
    link.stiffness = random.quarters(0, 20);
    link.damping = random.one_in(2) ? 0 : random.quarters(1, 8);
    link.restitution = random.quarters(0, 4);
    return link;
}

Model random_model(Random& random) {
    Model m;
    const double inverse_masses[] = {0, 0.25, 1, 2, 3};
    for (int count = 2 + random.below(3); count > 0; --count) {
        Particle p;
        p.x = random.vector(6);
        p.v = random.vector(12);
        p.inverse_mass = inverse_masses[random.below(5)];
        p.radius = random.one_in(3) ? 0 : random.quarters(1, 4);
        p.damping = random.one_in(2) ? 1 : random.quarters(1, 4);
        m.particles.push_back(p);
        m.custom.push_back(random.one_in(2) ? V{} : random.vector(8));
    }
    m.gravity = random.one_in(3) ? V{} : random.vector(16);
    m.restitution = random.quarters(0, 4);
    m.threshold = random.one_in(2) ? 0 : random.quarters(1, 12);
    const bool has_links = random.one_in(2), has_springs = random.one_in(2);
    for (const bool anchored : {true, false}) {
        if (has_springs) m.springs.push_back(random_link(random, m, anchored));
        if (has_links && random.one_in(2)) m.rods.push_back(random_link(random, m, anchored));
        if (has_links && random.one_in(2)) m.ropes.push_back(random_link(random, m, anchored));
    }
    if (random.one_in(2))
        m.drags.push_back({random.below(int(m.particles.size())), random.quarters(0, 4),
                           random.one_in(2) ? 0 : random.quarters(1, 2)});
    const V normals[] = {{0, 1}, {1, 0}, {0, -1}, {-1, 0}, {0.6, 0.8}};
    if (random.one_in(2))
        m.planes.push_back(
            {normals[random.below(5)], random.quarters(-8, 2), random.quarters(0, 4)});
    return m;
}

template <class World>
typename World::Vector vector(V v) {
    return {v.x, v.y};
}

template <class World>
void build(World& world, const Model& m) {
    world.gravity = vector<World>(m.gravity);
    world.set_restitution(m.restitution);
    world.set_restitution_threshold(m.threshold);
    std::vector<typename World::Handle> handles;
    for (const Particle& p : m.particles) {
        typename World::Body body;
        body.position = vector<World>(p.x);
        body.velocity = vector<World>(p.v);
        body.inverse_mass = p.inverse_mass;
        body.radius = p.radius;
        body.damping = p.damping;
        world.custom_force().force[handles.size()] = vector<World>(m.custom[handles.size()]);
        handles.push_back(world.add_particle(body));
    }
    for (const Link& s : m.springs) {
        if (s.b == none) {
            world.add_anchored_spring(handles[s.a], vector<World>(s.anchor), s.stiffness, s.damping,
                                      s.length);
        } else {
            world.add_spring(handles[s.a], handles[s.b], s.stiffness, s.damping, s.length);
        }
    }
    for (const Link& r : m.rods) {
        if (r.b == none) {
            world.add_anchored_rod(handles[r.a], vector<World>(r.anchor), r.length);
        } else {
            world.add_rod(handles[r.a], handles[r.b], r.length);
        }
    }
    for (const Link& r : m.ropes) {
        if (r.b == none) {
            world.add_anchored_rope(handles[r.a], vector<World>(r.anchor), r.length, r.restitution);
        } else {
            world.add_rope(handles[r.a], handles[r.b], r.length, r.restitution);
        }
    }
    for (const Drag& d : m.drags) world.add_drag(handles[d.a], d.linear, d.quadratic);
    for (const Plane& p : m.planes)
        world.add_plane(vector<World>(p.normal), p.offset, p.restitution);
}

// Whether a rod has no direction, which is an error of the world and not part of the model.
bool has_direction(const Model& m) {
    for (const Link& r : m.rods)
        if (norm(m.particles[r.a].x - m.position_of(r.b, r.anchor)) == 0) return false;
    for (const Link& r : m.ropes)
        if (norm(m.particles[r.a].x - m.position_of(r.b, r.anchor)) == 0) return false;
    return true;
}

template <class IntegratorType, class SolverType>
void expect_model(Integrator integrator, Solver solver, int iterations) {
    using World = engine::World<double, Everything<IntegratorType, SolverType>>;
    int compared = 0;
    for (unsigned seed = 0; seed < 3000; ++seed) {
        Random random{std::mt19937(seed)};
        Model model = random_model(random);
        model.integrator = integrator;
        model.solver = solver;
        model.iterations = iterations;
        World world;
        build(world, model);
        ASSERT_EQ(world.error(), engine::Error::none) << engine::describe(world.error());
        for (int step = 0; step < 3 && has_direction(model); ++step) {
            model.step();
            if (model.is_close) break;
            if (step == 1) {
                world.step(0.25);
            } else {
                world.step(engine::BinaryStep<2>());
            }
            ASSERT_EQ(world.error(), engine::Error::none) << "seed " << seed;
            ASSERT_EQ(unsigned(world.rows().size()), model.rows.size())
                << "seed " << seed << ", step " << step;
            for (std::size_t i = 0; i < model.particles.size(); ++i) {
                const auto& is = const_cast<const World&>(world).particles()[i];
                const Particle& shall = model.particles[i];
                const double scale = 1 + norm(shall.x) + norm(shall.v);
                ASSERT_NEAR(is.position[0], shall.x.x, 1e-10 * scale) << seed << ", " << step;
                ASSERT_NEAR(is.position[1], shall.x.y, 1e-10 * scale) << seed << ", " << step;
                ASSERT_NEAR(is.velocity[0], shall.v.x, 1e-10 * scale) << seed << ", " << step;
                ASSERT_NEAR(is.velocity[1], shall.v.y, 1e-10 * scale) << seed << ", " << step;
            }
            ++compared;
        }
    }
    EXPECT_GT(compared, 4000);
}

}  // namespace

TEST(Model, SemiImplicitEuler) {
    expect_model<engine::SemiImplicitEuler, engine::ProjectedGaussSeidel<3>>(
        Integrator::semi_implicit, Solver::gauss_seidel, 3);
}
TEST(Model, VelocityVerletInOneIteration) {
    expect_model<engine::VelocityVerlet, engine::ProjectedGaussSeidel<1>>(Integrator::verlet,
                                                                          Solver::gauss_seidel, 1);
}
TEST(Model, ImplicitSprings) {
    expect_model<engine::ImplicitSprings, engine::ProjectedGaussSeidel<2>>(
        Integrator::implicit_springs, Solver::gauss_seidel, 2);
}
TEST(Model, DirectSprings) {
    expect_model<engine::DirectSprings, engine::ProjectedGaussSeidel<2>>(Integrator::direct_springs,
                                                                         Solver::gauss_seidel, 2);
}
TEST(Model, ImplicitMidpoint) {
    expect_model<engine::ImplicitMidpoint, engine::ProjectedGaussSeidel<2>>(
        Integrator::implicit_midpoint, Solver::gauss_seidel, 2);
}
TEST(Model, ExplicitEulerAndTheWorstContacts) {
    expect_model<engine::ExplicitEuler, engine::WorstFirst<4>>(Integrator::explicit_euler,
                                                               Solver::worst_first, 4);
}
TEST(Model, TheWorstContactAlone) {
    expect_model<engine::SemiImplicitEuler, engine::WorstFirst<1>>(Integrator::semi_implicit,
                                                                   Solver::worst_first, 1);
}
