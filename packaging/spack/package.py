try:  # Spack 1.0 and newer; before, spack.package has these classes
    from spack_repo.builtin.build_systems.cmake import CMakePackage
    from spack_repo.builtin.build_systems.cuda import CudaPackage
except ImportError:
    pass

from spack.package import *


class Asperity(CMakePackage, CudaPackage):
    """Earthquakes with inertia and rate-and-state friction in two and three dimensions, by implicit
    time steps that a nonlinear multigrid method (TNNMG) solves."""

    license("BSD-3-Clause")

    # The release's archive has no public address: give the source tree by `spack develop`.
    version("0.2.0")

    variant("openmp", default=False, description="Threads on each rank, by Kokkos")
    variant("gmsh", default=True, description="asperity-mesh, which uses Gmsh and CGAL (GPL)")
    variant("python", default=True, description="Figures, reports, status and studies")
    variant("tests", default=False, description="The tests, run by `spack install --test=root`")
    variant("shared", default=True, description="Shared libraries, which plugins need")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.20:", type="build")
    depends_on("cmake@3.24:", type="build", when="~shared")
    generator("ninja")

    depends_on("mpi")
    depends_on(
        "trilinos@13.2:+mpi+tpetra+belos+muelu+ifpack2+amesos2+kokkos"
        "+explicit_template_instantiation gotype=long_long"
    )
    depends_on("trilinos~openmp", when="~openmp")
    depends_on("trilinos+openmp", when="+openmp")
    depends_on("trilinos~cuda", when="~cuda")
    # MueLu's matrices are built on the host, and Trilinos compiles for CUDA through its wrapper.
    depends_on("trilinos+cuda+wrapper", when="+cuda")
    for _arch in CudaPackage.cuda_arch_values:
        depends_on(f"trilinos cuda_arch={_arch}", when=f"+cuda cuda_arch={_arch}")
    conflicts("+openmp", when="+cuda", msg="Kokkos takes one of both as its default")
    conflicts("cuda_arch=none", when="+cuda", msg="say cuda_arch=90, for example")

    depends_on("hdf5@1.10:+mpi")
    depends_on("metis@5:")
    depends_on("muparser@2.3.3:")
    depends_on("cli11")
    depends_on("eigen@3.3:")
    depends_on("gmsh", when="+gmsh")
    depends_on("proj@7:", when="+gmsh")
    depends_on("cgal@5.5:", when="+gmsh")

    with when("+python"):
        depends_on("python@3.9:", type=("build", "run"))
        depends_on("py-h5py", type=("build", "run"))
        depends_on("py-numpy", type=("build", "run"))
        depends_on("py-matplotlib", type=("build", "run"))
    with when("+tests"):
        depends_on("googletest")
        conflicts("~python", msg="many tests are written in Python")

    def cmake_args(self):
        backend = "Serial"
        if self.spec.satisfies("+cuda"):
            backend = "Cuda"
        elif self.spec.satisfies("+openmp"):
            backend = "OpenMP"
        arguments = [
            self.define("ASPERITY_BACKEND", backend),
            self.define_from_variant("ASPERITY_ENABLE_MESH_TOOL", "gmsh"),
            self.define_from_variant("ASPERITY_ENABLE_TESTS", "tests"),
            self.define_from_variant("BUILD_SHARED_LIBS", "shared"),
        ]
        if self.spec.satisfies("+python"):
            arguments.append(self.define("ASPERITY_PYTHON", self.spec["python"].command.path))
        return arguments

    def check(self):
        if self.spec.satisfies("+tests"):
            with working_dir(self.build_directory):
                ctest("-L", "short", "--output-on-failure")
