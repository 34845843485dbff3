#include "atom_mapping/surface/marching_cubes.h"

#include <vtkCellArray.h>
#include <vtkContourGrid.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

namespace atom_map {
namespace {

// Only nodes of the cells come in: a contour filter looks at all that there are.
vtkNew<vtkUnstructuredGrid> toGrid(const Lattice& lattice, const std::vector<LatticeCell>& cells,
                                   const std::vector<float>& values) {
  constexpr vtkIdType kUnused = -1;
  std::vector<vtkIdType> ids(lattice.size(), kUnused);
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> scalars;
  vtkNew<vtkUnstructuredGrid> grid;
  grid->Allocate(static_cast<vtkIdType>(cells.size()));
  for (const LatticeCell& cell : cells) {
    std::array<vtkIdType, 8> corners{};
    for (std::size_t i = 0; i < corners.size(); ++i) {
      vtkIdType& id = ids[cell.corners[i]];
      if (id == kUnused) {
        id = points->InsertNextPoint(lattice.position(cell.corners[i]).data());
        scalars->InsertNextValue(values[cell.corners[i]]);
      }
      corners[i] = id;
    }
    grid->InsertNextCell(VTK_HEXAHEDRON, 8, corners.data());
  }
  grid->SetPoints(points);
  grid->GetPointData()->SetScalars(scalars);
  return grid;
}

SurfaceMesh fromPolyData(vtkPolyData& contour) {
  SurfaceMesh mesh;
  for (vtkIdType i = 0; i < contour.GetNumberOfPoints(); ++i) {
    mesh.vertices.emplace_back(Eigen::Map<const Eigen::Vector3d>(contour.GetPoint(i)).cast<float>());
  }
  vtkNew<vtkIdList> corners;
  contour.GetPolys()->InitTraversal();
  while (contour.GetPolys()->GetNextCell(corners) != 0) {
    const auto corner = [&](vtkIdType i) { return static_cast<std::uint32_t>(corners->GetId(i)); };
    mesh.triangles.push_back({corner(0), corner(2), corner(1)});  // VTK's face the negative side
  }
  return mesh;
}

}  // namespace

SurfaceMesh marchingCubes(const Lattice& lattice, const std::vector<LatticeCell>& cells,
                          const std::vector<float>& values) {
  if (cells.empty()) return {};
  const vtkNew<vtkUnstructuredGrid> grid = toGrid(lattice, cells, values);
  vtkNew<vtkContourGrid> contour;
  contour->SetInputData(grid);
  contour->SetValue(0, 0.0);
  contour->ComputeScalarsOff();
  contour->Update();
  return fromPolyData(*contour->GetOutput());
}

}  // namespace atom_map
