// Box2D, in metres and seconds.
#include <box2d/box2d.h>

#include "engines.h"

namespace talus::beside {
namespace {

// Box2D is made for boxes of 0.1 to 10 m, and for what a frame of gravity adds to be below the slowest speed
// that bounces, 1 m/s.
constexpr double kPxPerMetre = 16;

struct Settings {
  int substeps, velocity_iterations, position_iterations;
  bool is_continuous;  // also between boxes; and slow impacts bounce, too
};
constexpr Settings kUsual{1, 8, 3, false};
constexpr Settings kBest{kBestSubsteps, 40, 20, true};

b2Vec2 metres(Vec2 px) {
  return {static_cast<float>(px.x / kPxPerMetre), static_cast<float>(px.y / kPxPerMetre)};
}

// Box2D keeps shapes apart by a skin around each of them, but for circles. The shapes are smaller by it, so
// that the skins meet where the boxes of the other engines meet.
void set_box(b2PolygonShape& shape, double width, double height) {
  const b2Vec2 half = metres({width / 2, height / 2});
  shape.SetAsBox(half.x - shape.m_radius, half.y - shape.m_radius);
}

class Box2dEngine : public Engine {
 public:
  Box2dEngine(const World& world, const Settings& settings)
      : settings_(settings),
        world_(metres({0, world.gravity * kFramesPerSecond * kFramesPerSecond})),
        material_(world.material) {
    for (const Rect& wall : world.walls) add_wall(wall);
    for (const Incline& incline : world.inclines) add_incline(incline);
    for (const HalfCircle& half : world.half_circles) add_half_circle(half);
    for (const Body& body : world.bodies) add_body(body);
  }
  void step() override {
    for (int i = 0; i < settings_.substeps; ++i)
      world_.Step(static_cast<float>(seconds()), settings_.velocity_iterations,
                  settings_.position_iterations);
  }
  Rect box(std::size_t index) const override {
    const b2Vec2 center = bodies_[index]->GetPosition();
    const Vec2 size = sizes_[index];
    return {center.x * kPxPerMetre - size.x / 2, center.y * kPxPerMetre - size.y / 2, size.x, size.y};
  }
  Vec2 velocity(std::size_t index) const override {
    const b2Vec2 v = bodies_[index]->GetLinearVelocity();
    return Vec2{v.x, v.y} * (kPxPerMetre / kFramesPerSecond);
  }
  double spin(std::size_t index) const override {
    return bodies_[index]->GetAngularVelocity() * sizes_[index].x / 2 / kFramesPerSecond;
  }

 private:
  double seconds() const { return 1 / (kFramesPerSecond * settings_.substeps); }  // of a sub-step
  void add_shape(b2Body& body, const b2Shape& shape) {
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.density = 1;
    fixture.friction = static_cast<float>(material_.friction);
    fixture.restitution = static_cast<float>(material_.bounce);
    // What two steps of gravity add is rest, and no impact.
    if (settings_.is_continuous)
      fixture.restitutionThreshold = 2 * world_.GetGravity().y * static_cast<float>(seconds());
    body.CreateFixture(&fixture);
  }
  void add_wall(const Rect& wall) {
    b2BodyDef def;
    def.position = metres(wall.center());
    b2PolygonShape shape;
    set_box(shape, wall.w, wall.h);
    add_shape(*world_.CreateBody(&def), shape);
  }
  void add_incline(const Incline& incline) {
    const Vec2 along = incline.to - incline.from;
    b2Vec2 below = metres({-along.y, along.x});
    below.Normalize();
    b2EdgeShape shape;
    const b2Vec2 skin = shape.m_radius * below;
    shape.SetTwoSided(metres(incline.from) + skin, metres(incline.to) + skin);
    const b2BodyDef def;
    add_shape(*world_.CreateBody(&def), shape);
  }
  void add_half_circle(HalfCircle half) {
    b2ChainShape shape;
    half.radius += (half.is_hill ? -1 : 1) * shape.m_radius * kPxPerMetre;  // the skin
    std::vector<b2Vec2> points;
    for (const Vec2 point : points_of(half)) points.push_back(metres(point));
    const b2Vec2 on{0, half.is_hill ? 1.0F : -1.0F};  // where the circle would go on beyond its ends
    shape.CreateChain(points.data(), static_cast<int>(points.size()), points.front() + on,
                      points.back() + on);
    const b2BodyDef def;
    add_shape(*world_.CreateBody(&def), shape);
  }
  void add_body(const Body& start) {
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.fixedRotation = !start.is_round;
    def.bullet = settings_.is_continuous;
    def.position = metres(start.at.center());
    def.linearVelocity = metres(start.velocity * kFramesPerSecond);
    b2Body* body = world_.CreateBody(&def);
    const b2Vec2 size = metres({start.at.w, start.at.h});
    const float radius = size.x / 2;
    if (start.is_round) {
      b2CircleShape shape;
      shape.m_radius = radius;
      add_shape(*body, shape);
    } else {
      b2PolygonShape shape;
      set_box(shape, start.at.w, start.at.h);
      add_shape(*body, shape);
    }
    // The mass of the whole box, not that of the smaller shape.
    const float mass = size.x * size.y;
    const b2MassData data{mass, {0, 0}, mass * radius * radius / 2};
    body->SetMassData(&data);
    bodies_.push_back(body);
    sizes_.push_back({start.at.w, start.at.h});
  }

  Settings settings_;
  b2World world_;
  Material material_;
  std::vector<b2Body*> bodies_;
  std::vector<Vec2> sizes_;  // px
};

Contestant contestant(std::string name, const Settings& settings) {
  return {std::move(name),
          [settings](const World& world) { return std::make_unique<Box2dEngine>(world, settings); }};
}

}  // namespace

std::vector<Contestant> box2d_engines() {
  return {contestant("Box2D usual", kUsual), contestant("Box2D best", kBest)};
}

}  // namespace talus::beside
