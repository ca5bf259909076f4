#include "sim/dynamics/rigid_bodies.h"

#include <algorithm>
#include <array>

#include <ode/ode.h>
#include <Eigen/Geometry>

#include "core/vehicle/airframe.h"

namespace citrine::sim {

namespace {

constexpr int kContactsMax = 8;
constexpr double kFriction = 0.5;
constexpr double kBounce = 0.2;

void StartEngine() {
  static const bool started = dInitODE2(0) != 0 && dAllocateODEDataForThread(dAllocateMaskAll) != 0;
  static_cast<void>(started);
}

Eigen::Vector3d ToEigen(const dReal* x) { return {x[0], x[1], x[2]}; }

/// Every triangle that has an area, and once more seen from behind: the engine's triangles are solid from one
/// side only.
std::vector<std::array<int, 3>> TwoSided(const TriMesh& mesh) {
  std::vector<std::array<int, 3>> triangles;
  triangles.reserve(2 * mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3f& corner = mesh.vertices_W[a];
    const float area = (mesh.vertices_W[b] - corner).cross(mesh.vertices_W[c] - corner).norm() / 2;
    if (!(area > 1e-9f)) continue;
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, b});
  }
  return triangles;
}

}  // namespace

struct RigidBodies::Impl {
  dWorldID world = nullptr;
  dSpaceID space = nullptr;
  dJointGroupID contacts = nullptr;
  dTriMeshDataID mesh_data = nullptr;
  std::vector<Eigen::Vector3f> vertices_W;  ///< the engine keeps pointers into these two
  std::vector<std::array<int, 3>> triangles;
  std::vector<dBodyID> bodies;
  std::vector<Touch> touches;
  std::uint64_t seed = 0, steps = 0;

  /// Number of a geometry's body; kWorld for the mesh.
  int NumberOf(dGeomID geometry) const {
    const auto found = std::find(bodies.begin(), bodies.end(), dGeomGetBody(geometry));
    return found == bodies.end() ? Touch::kWorld : static_cast<int>(found - bodies.begin());
  }

  void AddMesh(const TriMesh& mesh) {
    vertices_W = mesh.vertices_W;
    triangles = TwoSided(mesh);
    if (triangles.empty()) return;
    mesh_data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildSingle(mesh_data, vertices_W.data(), sizeof(Eigen::Vector3f),
                                static_cast<int>(vertices_W.size()), triangles.data(),
                                static_cast<int>(3 * triangles.size()), sizeof(triangles.front()));
    dCreateTriMesh(space, mesh_data, nullptr, nullptr, nullptr);
  }

  void AddBody(const QuadrotorModel& model, const Eigen::Vector3d& p_W) {
    const Eigen::Vector3d& J = model.inertia_kgm2;
    dMass mass;
    dMassSetParameters(&mass, model.mass_kg, 0, 0, 0, J.x(), J.y(), J.z(), 0, 0, 0);
    const dBodyID body = dBodyCreate(world);
    dBodySetMass(body, &mass);
    dBodySetPosition(body, p_W.x(), p_W.y(), p_W.z());
    dBodySetAutoDisableFlag(body, 0);
    dGeomSetBody(dCreateSphere(space, kAirframeRadius_m), body);
    bodies.push_back(body);
  }

  void Collide(dGeomID a, dGeomID b) {
    std::array<dContact, kContactsMax> found{};
    const int n = dCollide(a, b, kContactsMax, &found[0].geom, sizeof(dContact));
    if (n == 0) return;
    for (int i = 0; i < n; ++i) {
      found[i].surface.mode = dContactBounce | dContactApprox1;
      found[i].surface.mu = kFriction;
      found[i].surface.bounce = kBounce;
      found[i].surface.bounce_vel = 0.1;
      dJointAttach(dJointCreateContact(world, contacts, &found[i]), dGeomGetBody(a), dGeomGetBody(b));
    }
    const auto [low, high] = std::minmax({NumberOf(a), NumberOf(b)});
    touches.push_back(low == Touch::kWorld ? Touch{high, low} : Touch{low, high});
  }
};

RigidBodies::RigidBodies(const TriMesh& world, const QuadrotorModel& model,
                         const std::vector<Eigen::Vector3d>& p_W, std::uint64_t seed)
    : impl_(std::make_unique<Impl>()) {
  StartEngine();
  impl_->seed = seed;
  impl_->world = dWorldCreate();
  impl_->space = dSimpleSpaceCreate(nullptr);
  impl_->contacts = dJointGroupCreate(0);
  dWorldSetGravity(impl_->world, 0, 0, -kGravity_mps2);
  impl_->AddMesh(world);
  for (const Eigen::Vector3d& p : p_W) impl_->AddBody(model, p);
}

RigidBodies::~RigidBodies() {
  dJointGroupDestroy(impl_->contacts);
  dSpaceDestroy(impl_->space);
  dWorldDestroy(impl_->world);
  if (impl_->mesh_data != nullptr) dGeomTriMeshDataDestroy(impl_->mesh_data);
}

void RigidBodies::Exert(int body, const Wrench& wrench_B, const Eigen::Vector3d& force_W) {
  const dBodyID id = impl_->bodies[static_cast<std::size_t>(body)];
  const Eigen::Vector3d& torque = wrench_B.torque_B;
  dBodyAddRelForce(id, 0, 0, wrench_B.thrust_N);
  dBodyAddRelTorque(id, torque.x(), torque.y(), torque.z());
  dBodyAddForce(id, force_W.x(), force_W.y(), force_W.z());
}

std::vector<Touch> RigidBodies::Step(double dt_s) {
  // The engine has one random state a process; with several simulations in it each brings its own to every
  // step.
  dRandSetSeed(static_cast<unsigned long>((impl_->seed * 1000003 + impl_->steps++) & 0xffffffff));
  impl_->touches.clear();
  dSpaceCollide(impl_->space, impl_.get(),
                [](void* impl, dGeomID a, dGeomID b) { static_cast<Impl*>(impl)->Collide(a, b); });
  dWorldStep(impl_->world, dt_s);
  dJointGroupEmpty(impl_->contacts);
  return impl_->touches;
}

UavState RigidBodies::state(int body) const {
  const dBodyID id = impl_->bodies[static_cast<std::size_t>(body)];
  const dReal* q = dBodyGetQuaternion(id);
  UavState state;
  state.X_WB = {ToEigen(dBodyGetPosition(id)), Eigen::Quaterniond(q[0], q[1], q[2], q[3])};
  state.v_W = ToEigen(dBodyGetLinearVel(id));
  state.omega_B = state.X_WB.q.conjugate() * ToEigen(dBodyGetAngularVel(id));
  return state;
}

void RigidBodies::Place(int body, const Pose& X_WB, const Eigen::Vector3d& v_W) {
  const dBodyID id = impl_->bodies[static_cast<std::size_t>(body)];
  const dQuaternion q = {X_WB.q.w(), X_WB.q.x(), X_WB.q.y(), X_WB.q.z()};
  dBodySetPosition(id, X_WB.p.x(), X_WB.p.y(), X_WB.p.z());
  dBodySetQuaternion(id, q);
  dBodySetLinearVel(id, v_W.x(), v_W.y(), v_W.z());
}

}  // namespace citrine::sim
