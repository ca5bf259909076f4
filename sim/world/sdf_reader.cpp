#include "sim/world/sdf_reader.h"

#include <filesystem>
#include <optional>

#include <sdf/sdf.hh>

#include "sim/world/mesh_builder.h"
#include "sim/world/mesh_reader.h"
#include "sim/world/primitives.h"

namespace citrine::sim {
namespace {

namespace fs = std::filesystem;

constexpr double kSheetMargin_m =
    10;  ///< what a plane without a size of its own reaches beyond everything else

Eigen::Affine3d ToAffine(const ignition::math::Pose3d& pose) {
  const auto& p = pose.Pos();
  const auto& q = pose.Rot();
  return Eigen::Translation3d(p.X(), p.Y(), p.Z()) *
         Eigen::Quaterniond(q.W(), q.X(), q.Y(), q.Z()).normalized();
}

Eigen::Vector3d ToEigen(const ignition::math::Vector3d& v) { return {v.X(), v.Y(), v.Z()}; }

bool NamesGround(const std::string& model) {
  constexpr std::string_view kGround = "ground";
  return model.size() >= kGround.size() &&
         std::equal(kGround.begin(), kGround.end(), model.begin(),
                    [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
}

class Reader {
 public:
  Reader(const std::string& path, const std::vector<std::string>& search) : path_(path), search_(search) {}

  World Read() {
    sdf::ParserConfig config;
    config.SetFindCallback([this](const std::string& uri) { return Find(uri, {}).value_or(""); });
    config.SetWarningsPolicy(sdf::EnforcementPolicy::LOG);
    config.SetUnrecognizedElementsPolicy(sdf::EnforcementPolicy::LOG);
    sdf::Console::Instance()->SetQuiet(true);
    sdf::Root root;
    const sdf::Errors errors = root.Load(path_, config);
    if (!errors.empty()) throw WorldError(path_ + ": " + errors.front().Message());
    if (const sdf::World* world = root.WorldByIndex(0)) {
      world_.name = world->Name();
      for (std::uint64_t i = 0; i < world->ModelCount(); ++i) {
        const sdf::Model& model = *world->ModelByIndex(i);
        ReadModel(model, Eigen::Affine3d::Identity(), "", NamesGround(model.Name()));
      }
    } else if (const sdf::Model* model = root.Model()) {
      world_.name = model->Name();
      ReadModel(*model, Eigen::Affine3d::Identity(), "", NamesGround(model->Name()));
    } else {
      throw WorldError(path_ + ": holds neither a world nor a model");
    }
    AddPlanes();
    return std::move(world_);
  }

 private:
  struct PlaneShape {
    Part part;
    Eigen::Affine3d X_WS;                   ///< z along the normal
    std::optional<Eigen::Vector2d> size_m;  ///< as the file says
  };

  template <class Posed>
  Eigen::Affine3d PoseOf(const Posed& posed, const std::string& name) const {
    ignition::math::Pose3d pose;
    const sdf::Errors errors = posed.SemanticPose().Resolve(pose);
    if (!errors.empty())
      throw WorldError(path_ + ": " + name + ": its pose cannot be resolved: " + errors.front().Message());
    return ToAffine(pose);
  }

  void ReadModel(const sdf::Model& model, const Eigen::Affine3d& X_WP, const std::string& prefix,
                 bool ground) {
    const std::string name = prefix + model.Name();
    const Eigen::Affine3d X_WM = X_WP * PoseOf(model, name);
    for (std::uint64_t i = 0; i < model.LinkCount(); ++i) ReadLink(*model.LinkByIndex(i), X_WM, name, ground);
    for (std::uint64_t i = 0; i < model.ModelCount(); ++i) {
      const sdf::Model& nested = *model.ModelByIndex(i);
      ReadModel(nested, X_WM, name + "/", ground || NamesGround(nested.Name()));
    }
  }

  void ReadLink(const sdf::Link& link, const Eigen::Affine3d& X_WM, const std::string& model, bool ground) {
    const std::string name = model + "/" + link.Name();
    const Eigen::Affine3d X_WL = X_WM * PoseOf(link, name);
    const auto read = [&](const auto& shape) {
      Part part;
      part.name = name + "/" + shape.Name();
      part.ground = ground;
      ReadGeometry(*shape.Geom(), X_WL * PoseOf(shape, part.name), part);
    };
    for (std::uint64_t i = 0; i < link.CollisionCount(); ++i) read(*link.CollisionByIndex(i));
    if (link.CollisionCount() > 0) return;
    for (std::uint64_t i = 0; i < link.VisualCount(); ++i) read(*link.VisualByIndex(i));
  }

  void ReadGeometry(const sdf::Geometry& geometry, const Eigen::Affine3d& X_WS, const Part& part) {
    const auto add = [&](const TriMesh& mesh) { AddPart(mesh, X_WS, part, world_); };
    switch (geometry.Type()) {
      case sdf::GeometryType::BOX:
        return add(BoxMesh(ToEigen(geometry.BoxShape()->Size())));
      case sdf::GeometryType::SPHERE:
        return add(EllipsoidMesh(Eigen::Vector3d::Constant(geometry.SphereShape()->Radius())));
      case sdf::GeometryType::ELLIPSOID:
        return add(EllipsoidMesh(ToEigen(geometry.EllipsoidShape()->Radii())));
      case sdf::GeometryType::CYLINDER:
        return add(CylinderMesh(geometry.CylinderShape()->Radius(), geometry.CylinderShape()->Length()));
      case sdf::GeometryType::CAPSULE:
        return add(CapsuleMesh(geometry.CapsuleShape()->Radius(), geometry.CapsuleShape()->Length()));
      case sdf::GeometryType::PLANE:
        return KeepPlane(*geometry.PlaneShape(), X_WS, part);
      case sdf::GeometryType::MESH:
        return ReadMesh(*geometry.MeshShape(), X_WS, part);
      case sdf::GeometryType::EMPTY:
        return;
      default:
        throw WorldError(path_ + ": " + part.name +
                         ": only box, sphere, cylinder, capsule, ellipsoid, plane and mesh are read");
    }
  }

  void ReadMesh(const sdf::Mesh& mesh, const Eigen::Affine3d& X_WS, const Part& part) {
    const std::optional<std::string> file = Find(mesh.Uri(), mesh.FilePath());
    if (!file)
      throw WorldError(path_ + ": " + part.name + ": its mesh " + mesh.Uri() + " is not found in" +
                       Searched());
    std::vector<NamedMesh> pieces = ReadMeshFile(*file);
    Eigen::Affine3d X_WM = X_WS * Eigen::Scaling(ToEigen(mesh.Scale()));
    if (!mesh.Submesh().empty()) {
      std::erase_if(pieces, [&](const NamedMesh& piece) {
        return piece.name != mesh.Submesh() &&
               std::ranges::find(piece.nodes, mesh.Submesh()) == piece.nodes.end();
      });
      if (pieces.empty())
        throw WorldError(path_ + ": " + part.name + ": " + *file + " has no submesh " + mesh.Submesh());
      if (mesh.CenterSubmesh()) X_WM = X_WM * Eigen::Translation3d(-Centre(pieces));
    }
    for (const NamedMesh& piece : pieces) {
      Part named = part;
      if (pieces.size() > 1) named.name += "/" + (piece.name.empty() ? piece.nodes.back() : piece.name);
      AddPart(piece.mesh, X_WM, named, world_);
    }
  }

  static Eigen::Vector3d Centre(const std::vector<NamedMesh>& pieces) {
    Eigen::AlignedBox3f box;
    for (const NamedMesh& piece : pieces)
      for (const Eigen::Vector3f& v : piece.mesh.vertices_W) box.extend(v);
    return box.center().cast<double>();
  }

  void KeepPlane(const sdf::Plane& plane, const Eigen::Affine3d& X_WS, const Part& part) {
    PlaneShape kept{part, X_WS, {}};
    kept.part.half_space = true;
    kept.X_WS.rotate(
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), ToEigen(plane.Normal()).normalized()));
    const bool sized = plane.Element() && plane.Element()->HasElement("size") &&
                       plane.Element()->GetElement("size")->GetExplicitlySetInFile();
    if (sized) kept.size_m = Eigen::Vector2d(plane.Size().X(), plane.Size().Y());
    planes_.push_back(kept);
  }

  /// A plane has no end: it becomes a sheet under everything else, and no larger than the file says.
  void AddPlanes() {
    const TriMesh others = world_.mesh;
    for (const PlaneShape& plane : planes_) {
      const Eigen::Vector2d half = plane.size_m.value_or(Eigen::Vector2d::Constant(1e4)) / 2;
      Eigen::AlignedBox2d sheet(-half, half);
      Eigen::AlignedBox2d around;
      const Eigen::Affine3d X_SW = plane.X_WS.inverse();
      for (const Eigen::Vector3f& v_W : others.vertices_W)
        around.extend((X_SW * v_W.cast<double>()).head<2>().eval());
      if (!around.isEmpty())
        sheet = sheet.intersection(
            {around.min().array() - kSheetMargin_m, around.max().array() + kSheetMargin_m});
      else if (!plane.size_m)
        sheet = {Eigen::Vector2d::Constant(-kSheetMargin_m), Eigen::Vector2d::Constant(kSheetMargin_m)};
      if (!sheet.isEmpty()) AddPart(SheetMesh(sheet.min(), sheet.max()), plane.X_WS, plane.part, world_);
    }
  }

  /// Where a URI leads. @param beside  the file that says it, for a relative one
  std::optional<std::string> Find(const std::string& uri, const std::string& beside) const {
    for (const std::string_view scheme : {"model://", "package://", "file://"})
      if (uri.starts_with(scheme)) return FindIn(search_, uri.substr(scheme.size()));
    std::vector<std::string> folders = search_;
    if (!beside.empty()) folders.insert(folders.begin(), fs::path(beside).parent_path().string());
    return FindIn(folders, uri);
  }

  static std::optional<std::string> FindIn(const std::vector<std::string>& folders, const std::string& name) {
    std::error_code ignored;
    if (fs::path(name).is_absolute()) return fs::exists(name, ignored) ? std::optional(name) : std::nullopt;
    for (const std::string& folder : folders)
      if (const fs::path found = fs::path(folder) / name; fs::exists(found, ignored)) return found.string();
    return std::nullopt;
  }

  std::string Searched() const {
    std::string text;
    for (const std::string& folder : search_) text += " " + folder;
    return text;
  }

  std::string path_;
  std::vector<std::string> search_;
  std::vector<PlaneShape> planes_;
  World world_;
};

}  // namespace

World ReadSdf(const std::string& path, const std::vector<std::string>& search) {
  return Reader(path, search).Read();
}

}  // namespace citrine::sim
