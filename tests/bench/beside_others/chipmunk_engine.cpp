// Chipmunk, in px and seconds.
#include <chipmunk/chipmunk.h>

#include <cmath>

#include "engines.h"

namespace talus::beside {
namespace {

struct Settings {
  int substeps, iterations;
  double slop;  // px that bodies may overlap
};
constexpr Settings kUsual{1, 10, 0.1};
constexpr Settings kBest{kBestSubsteps, 50, 0.001};

constexpr double kSecondsToSleep = 0.5;  // as Box2D has it; Chipmunk itself lets nothing sleep

class ChipmunkEngine : public Engine {
 public:
  ChipmunkEngine(const World& world, const Settings& settings)
      : substeps_(settings.substeps), space_(cpSpaceNew()), material_(world.material) {
    cpSpaceSetGravity(space_, {0, world.gravity * kFramesPerSecond * kFramesPerSecond});
    cpSpaceSetIterations(space_, settings.iterations);
    cpSpaceSetCollisionSlop(space_, settings.slop);
    cpSpaceSetSleepTimeThreshold(space_, kSecondsToSleep);
    cpBody* ground = cpSpaceGetStaticBody(space_);
    for (const Rect& wall : world.walls)
      add_shape(cpBoxShapeNew2(ground, {wall.x, wall.y, wall.right(), wall.bottom()}, 0));
    for (const Incline& line : world.inclines)
      add_shape(cpSegmentShapeNew(ground, {line.from.x, line.from.y}, {line.to.x, line.to.y}, 0));
    for (const HalfCircle& half : world.half_circles) add_half_circle(half);
    for (const Body& body : world.bodies) add_body(body);
  }
  ~ChipmunkEngine() override {
    for (cpShape* shape : shapes_) {
      cpSpaceRemoveShape(space_, shape);
      cpShapeFree(shape);
    }
    for (cpBody* body : bodies_) {
      cpSpaceRemoveBody(space_, body);
      cpBodyFree(body);
    }
    cpSpaceFree(space_);
  }
  ChipmunkEngine(const ChipmunkEngine&) = delete;
  ChipmunkEngine& operator=(const ChipmunkEngine&) = delete;

  void step() override {
    for (int i = 0; i < substeps_; ++i) cpSpaceStep(space_, 1 / (kFramesPerSecond * substeps_));
  }
  Rect box(std::size_t index) const override {
    const cpVect center = cpBodyGetPosition(bodies_[index]);
    const Vec2 size = sizes_[index];
    return {center.x - size.x / 2, center.y - size.y / 2, size.x, size.y};
  }
  Vec2 velocity(std::size_t index) const override {
    const cpVect v = cpBodyGetVelocity(bodies_[index]);
    return Vec2{v.x, v.y} * (1 / kFramesPerSecond);
  }
  double spin(std::size_t index) const override {
    return cpBodyGetAngularVelocity(bodies_[index]) * sizes_[index].x / 2 / kFramesPerSecond;
  }

 private:
  // Chipmunk multiplies the numbers of the two that meet.
  void add_shape(cpShape* shape) {
    cpShapeSetFriction(shape, std::sqrt(material_.friction));
    cpShapeSetElasticity(shape, std::sqrt(material_.bounce));
    shapes_.push_back(cpSpaceAddShape(space_, shape));
  }
  void add_half_circle(const HalfCircle& half) {
    const std::vector<Vec2> points = points_of(half);
    const auto at = [&](std::size_t i) { return cpv(points[i].x, points[i].y); };
    const std::size_t last = points.size() - 1;
    for (std::size_t i = 0; i < last; ++i) {
      cpShape* segment = cpSegmentShapeNew(cpSpaceGetStaticBody(space_), at(i), at(i + 1), 0);
      if (i > 0 && i + 1 < last) cpSegmentShapeSetNeighbors(segment, at(i - 1), at(i + 2));
      add_shape(segment);
    }
  }
  void add_body(const Body& start) {
    const double mass = start.at.w * start.at.h / (kCell * kCell), radius = start.at.w / 2;
    cpBody* body = cpBodyNew(mass, start.is_round ? mass * radius * radius / 2 : INFINITY);
    cpSpaceAddBody(space_, body);
    const Vec2 center = start.at.center(), velocity = start.velocity * kFramesPerSecond;
    cpBodySetPosition(body, {center.x, center.y});
    cpBodySetVelocity(body, {velocity.x, velocity.y});
    add_shape(start.is_round ? cpCircleShapeNew(body, radius, cpvzero)
                             : cpBoxShapeNew(body, start.at.w, start.at.h, 0));
    bodies_.push_back(body);
    sizes_.push_back({start.at.w, start.at.h});
  }

  int substeps_;
  cpSpace* space_;
  Material material_;
  std::vector<cpShape*> shapes_;
  std::vector<cpBody*> bodies_;
  std::vector<Vec2> sizes_;  // px
};

Contestant contestant(std::string name, const Settings& settings) {
  return {std::move(name),
          [settings](const World& world) { return std::make_unique<ChipmunkEngine>(world, settings); }};
}

}  // namespace

std::vector<Contestant> chipmunk_engines() {
  return {contestant("Chipmunk usual", kUsual), contestant("Chipmunk best", kBest)};
}

}  // namespace talus::beside
