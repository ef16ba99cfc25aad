"""Types of the Python module `fascia`; help(fascia) describes every name. Arrays are numpy arrays where numpy is installed, else memoryviews."""
from typing import Any, Callable, Optional, Sequence, Tuple

Vec3 = Tuple[float, float, float]
Array = Any  # numpy.ndarray or memoryview; as an argument also lists of lists

__version__: str

class Error(RuntimeError): ...
class ContextLost(Error): ...
class Interrupted(Error): ...

class Material:
    young_modulus: float  # E [Pa]
    poisson_ratio: float  # nu [-]
    density: float  # [kg/m^3]
    damping: float  # viscosity over stiffness [s]
    mooney_ratio: float  # C01 / (C10 + C01) of the model mooney_rivlin
    model: str  # one of material_models()
    def __init__(self, young_modulus: float = ..., poisson_ratio: float = ..., density: float = ..., damping: float = ..., model: str = ...,
                 mooney_ratio: float = ...) -> None: ...

class Settings:
    method: str
    acceleration: str
    integrator: str  # "implicit_euler", "bdf2" or "sdirk2"
    iterations: int  # per substep, at most
    tolerance: float  # relative residual at which iterations stop; 0: all iterations run
    time_step: float  # [s]
    substeps: int
    frame_budget: float  # [ms]; 0: no limit
    colors: int  # of gauss_seidel; 0: the mesh decides
    spectral_radius: float  # of chebyshev; 0: estimated
    window: int  # of anderson
    rest_speed: float  # [1/s]; 0: nothing falls asleep
    def __init__(self, **fields: Any) -> None: ...

class Mesh:
    def __init__(self, positions: Array, tets: Array, regions: Optional[Array] = ...) -> None: ...
    @property
    def positions(self) -> Array: ...  # [vertex_count, 3] [m], read only
    @property
    def tets(self) -> Array: ...  # [tet_count, 4], read only
    @property
    def regions(self) -> list[int]: ...  # [tet_count], or empty
    @property
    def region_names(self) -> dict[int, str]: ...
    @property
    def groups(self) -> dict[str, list[int]]: ...
    @property
    def vertex_count(self) -> int: ...
    @property
    def tet_count(self) -> int: ...

class Motion:
    def __init__(self, vertices: Array, translate: Vec3, start: float = ..., duration: float = ...) -> None: ...

class Body:
    def __init__(self, mesh: Mesh, material: Material = ..., name: str = ..., fixed: Array = ..., region_materials: dict[int, Material] = ...,
                 motions: Sequence[Motion] = ..., initial_velocity: Optional[Array] = ...,
                 elements: str = ...) -> None: ...

class Scene:
    def __init__(self, bodies: Sequence[Body], gravity: Vec3 = ..., settings: Settings = ..., title: str = ...) -> None: ...

class State:
    @property
    def time(self) -> float: ...  # [s]
    @property
    def displacements(self) -> Array: ...  # [vertex_count, 3] [m], read only
    @property
    def velocities(self) -> Array: ...  # [vertex_count, 3] [m/s], read only

class Diagnostics:
    @property
    def time(self) -> float: ...  # [s]
    @property
    def kinetic(self) -> float: ...  # [J]
    @property
    def elastic(self) -> float: ...  # [J]
    @property
    def gravitational(self) -> float: ...  # [J]
    @property
    def volume_ratio(self) -> float: ...
    @property
    def min_det_f(self) -> float: ...
    @property
    def max_det_f(self) -> float: ...
    @property
    def inverted(self) -> int: ...
    @property
    def max_strain(self) -> float: ...
    @property
    def max_von_mises(self) -> float: ...  # [Pa]
    @property
    def max_speed(self) -> float: ...  # [m/s]
    @property
    def momentum(self) -> list[float]: ...  # [kg m/s]
    @property
    def angular_momentum(self) -> list[float]: ...  # [kg m^2/s] about the origin
    @property
    def reaction(self) -> list[float]: ...  # of the supports on the tissue [N]
    @property
    def grab_force(self) -> list[float]: ...  # [N]
    @property
    def residual(self) -> float: ...
    @property
    def iterations(self) -> Optional[int]: ...

class Support:
    @property
    def body(self) -> int: ...
    @property
    def motion(self) -> Optional[int]: ...
    @property
    def force(self) -> list[float]: ...  # on the tissue [N]

class RecoveredStress:
    @property
    def cauchy(self) -> Array: ...  # [vertex_count, 6] [Pa] xx, yy, zz, yz, xz, xy; a copy
    @property
    def von_mises(self) -> Array: ...  # [vertex_count] [Pa]; a copy
    @property
    def max_von_mises(self) -> float: ...  # [Pa]
    @property
    def p99_von_mises(self) -> float: ...  # [Pa] that 1 % of the volume exceeds

class StaticReport:
    @property
    def iterations(self) -> int: ...
    @property
    def newton_iterations(self) -> int: ...
    @property
    def relative_residual(self) -> float: ...
    @property
    def converged(self) -> bool: ...

class Grab:
    target: Vec3  # [m]; assign it to move the grab
    @property
    def force(self) -> list[float]: ...  # on the tissue [N]
    @property
    def stiffness(self) -> float: ...  # [N/m]
    def release(self) -> None: ...

class Context:
    @staticmethod
    def own(kind: str = ...) -> Context: ...
    @staticmethod
    def current() -> Context: ...
    @staticmethod
    def none() -> Context: ...
    @property
    def kind(self) -> str: ...
    @property
    def renderer(self) -> str: ...
    @property
    def software(self) -> bool: ...

class Simulation:
    positions: Array  # [vertex_count, 3] [m]; a copy
    velocities: Array  # [vertex_count, 3] [m/s]; a copy
    settings: Settings  # a copy; assign settings to change them
    gravity: Vec3  # [m/s^2]
    def __init__(self, scene: Scene, context: Optional[Context] = ..., reference: bool = ...) -> None: ...
    @staticmethod
    def open(path: str, context: Optional[Context] = ..., set: Sequence[str] = ..., reference: bool = ...,
             progress: Optional[Callable[[float, str], None]] = ...) -> Simulation: ...
    @property
    def context(self) -> Context: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def vertex_count(self) -> int: ...
    @property
    def tet_count(self) -> int: ...
    @property
    def rest_positions(self) -> Array: ...  # [vertex_count, 3] [m], read only
    @property
    def tets(self) -> Array: ...  # [tet_count, 4], read only
    @property
    def surface_triangles(self) -> Array: ...  # [triangle_count, 3], read only
    @property
    def fixed(self) -> Array: ...  # [fixed_count], read only
    @property
    def masses(self) -> Array: ...  # lumped, [vertex_count] [kg]
    @property
    def bodies(self) -> list[dict[str, Any]]: ...
    def step(self, count: int = ...) -> None: ...
    def solve_static(self) -> StaticReport: ...
    def reset(self) -> None: ...
    @property
    def time(self) -> float: ...  # [s]
    @property
    def asleep(self) -> bool: ...
    def diverged_vertex(self) -> Optional[int]: ...
    def restore_valid(self) -> None: ...
    def save(self) -> State: ...
    def restore(self, state: State) -> None: ...
    def write(self, path: str) -> None: ...
    @property
    def material_names(self) -> list[str]: ...
    def material(self, index: int = ...) -> Material: ...
    def set_material(self, index: int, material: Material) -> None: ...
    def grab(self, vertices: Array, stiffness: float = ...) -> Grab: ...
    def grab_patch(self, point: Vec3, radius: float, stiffness: float = ...) -> Grab: ...
    def diagnostics(self) -> Diagnostics: ...
    def supports(self) -> list[Support]: ...
    def von_mises(self) -> Array: ...  # [tet_count] [Pa]
    def recovered_stress(self) -> RecoveredStress: ...
    def green_strain(self) -> Array: ...  # [tet_count, 6] xx, yy, zz, yz, xz, xy
    def det_f(self) -> Array: ...  # [tet_count]

def make_box(nx: int, ny: int, nz: int, size: Vec3) -> Mesh: ...
def read_mesh(path: str) -> Mesh: ...
def tissue(name: str) -> Material: ...
def tissues() -> list[str]: ...
def material_models() -> list[str]: ...
def solver_pairs() -> list[tuple[str, str]]: ...
def data_dir() -> str: ...
def set_data_dir(folder: str) -> None: ...
