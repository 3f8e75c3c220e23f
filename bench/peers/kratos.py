"""Kratos Multiphysics: four-node thick shells, springs at the nodes switched on and off in a loop of our own.

    python bench/peers/kratos.py 25000 amgcl        # multigrid and conjugate gradients
    python bench/peers/kratos.py 25000 sparse_lu    # Eigen's sparse LU

Kratos has no springs that only push for shells; its elements can be switched, and that is what the loop does, each step
being Kratos' own linear analysis. In-plane displacements and the drilling rotation are held at all nodes, and taken out
of the equations. Its wheels have neither MKL nor CHOLMOD, so that LU is the only direct solver that scales. The wheels
of 10.4.4 write beyond an array in this element and crash; those of 10.3.0 do not.
"""

from __future__ import annotations

import importlib.metadata

import KratosMultiphysics as Km
import KratosMultiphysics.StructuralMechanicsApplication as Sm
import numpy as np
from first_plate import LIMIT, NU, E, Job, K, Q, T, divisions, mesh_nodes, run
from KratosMultiphysics import python_linear_solver_factory

SOLVERS = {
    "amgcl": {
        "solver_type": "amgcl",
        "smoother_type": "ilu0",
        "krylov_type": "cg",
        "coarsening_type": "smoothed_aggregation",
        "tolerance": 1e-10,
        "max_iteration": 2000,
        "block_size": 1,
        "use_block_matrices_if_possible": False,
        "scaling": False,
    },
    "sparse_lu": {"solver_type": "LinearSolversApplication.sparse_lu"},
}

NAMES = {"amgcl": "AMGCL, multigrid and conjugate gradients", "sparse_lu": "Eigen, sparse LU"}


def main(unknowns: int, name: str = "amgcl") -> None:
    """Solve the plate and print the figures."""
    if name == "sparse_lu":
        import KratosMultiphysics.LinearSolversApplication  # noqa: F401  # the clock starts after all imports
    job = Job()
    Km.Logger.GetDefaultOutput().SetSeverity(Km.Logger.Severity.WARNING)
    with job.phase("mesh"):
        part, springs = build(*divisions(unknowns, 1))
    with job.phase("solution"):
        parameters = Km.Parameters("{}")
        for key, value in SOLVERS[name].items():
            parameters.AddEmptyValue(key)
            {str: parameters[key].SetString, float: parameters[key].SetDouble, int: parameters[key].SetInt,
             bool: parameters[key].SetBool}[type(value)](value)  # fmt: skip
        builder = Km.ResidualBasedEliminationBuilderAndSolver(python_linear_solver_factory.ConstructSolver(parameters))
        scheme = Km.ResidualBasedIncrementalUpdateStaticScheme()
        # reactions no, new pattern in each step no, norm of the increment no, moving mesh no
        strategy = Km.ResidualBasedLinearStrategy(part, scheme, builder, False, False, False, False)
        strategy.SetEchoLevel(0)
        strategy.Initialize()
    pushing = np.ones(len(springs), dtype=bool)
    steps, settled = 0, False
    while not settled:
        steps += 1
        with job.phase("solution"):
            strategy.Solve()
        with job.phase("contact"):
            w = -np.array([node.GetSolutionStepValue(Km.DISPLACEMENT_Z) for node in part.Nodes])
            changed = (w > 0) != pushing
            pushing = w > 0
            for i in np.flatnonzero(changed).tolist():
                springs[i].Set(Km.ACTIVE, bool(pushing[i]))
        settled = not changed.any()
        if steps > LIMIT:
            raise SystemExit("the springs do not come to rest")
    job.report(
        program="Kratos",
        version=importlib.metadata.version("KratosMultiphysics"),
        element="ShellThickElement3D4N",
        solver=NAMES[name],
        unknowns=builder.GetEquationSystemSize(),
        iterations=steps,
        centre=float(w[0]),
        corner=float(w[-1]),
    )


def build(nx: int, ny: int) -> tuple[Km.ModelPart, list[Km.Element]]:
    """Return the model and the springs, one for each node in the nodes' order."""
    global model  # Kratos frees a model that no name holds
    model = Km.Model()
    part = model.CreateModelPart("plate")
    of_motion = (Km.DISPLACEMENT, Km.ROTATION, Km.REACTION, Km.REACTION_MOMENT, Km.VOLUME_ACCELERATION)
    for variable in (*of_motion, Sm.POINT_LOAD):
        part.AddNodalSolutionStepVariable(variable)
    part.SetBufferSize(1)
    part.ProcessInfo[Km.DOMAIN_SIZE] = 3
    plate, ground = part.CreateNewProperties(1), part.CreateNewProperties(2)
    for variable, value in ((Km.YOUNG_MODULUS, E), (Km.POISSON_RATIO, NU), (Km.THICKNESS, T), (Km.DENSITY, 0.0)):
        plate.SetValue(variable, value)
    plate.SetValue(Km.CONSTITUTIVE_LAW, Sm.LinearElasticPlaneStress2DLaw())

    x, y, cell, around, loaded = mesh_nodes(nx, ny)
    tag = 0
    for Y in y.tolist():
        for X in x.tolist():
            tag += 1
            part.CreateNewNode(tag, X, Y, 0.0)
    tools = Km.VariableUtils()
    for field in ("DISPLACEMENT", "ROTATION"):
        for axis in "XYZ":
            against = {"DISPLACEMENT": "REACTION", "ROTATION": "REACTION_MOMENT"}[field]
            tools.AddDof(_variable(f"{field}_{axis}"), _variable(f"{against}_{axis}"), part)
    for variable in (Km.DISPLACEMENT_X, Km.DISPLACEMENT_Y, Km.ROTATION_Z):
        tools.ApplyFixity(variable, True, part.Nodes)
    springs, tag = [], nx * ny
    for node, n, q in zip(part.Nodes, around.ravel().tolist(), loaded.ravel().tolist(), strict=True):
        tag += 1
        spring = part.CreateNewElement("NodalConcentratedElement3D1N", tag, [node.Id], ground)
        spring.SetValue(Sm.NODAL_DISPLACEMENT_STIFFNESS, Km.Array3([0.0, 0.0, K * n * cell / 4]))
        springs.append(spring)
        if q:
            node.SetSolutionStepValue(Sm.POINT_LOAD, Km.Array3([0.0, 0.0, -Q * q * cell / 4]))
            part.CreateNewCondition("PointLoadCondition3D1N", node.Id, [node.Id], ground)
        if node.X0 == 0.0:
            node.Fix(Km.ROTATION_Y)
        if node.Y0 == 0.0:
            node.Fix(Km.ROTATION_X)
    tag = 0
    for j in range(ny):
        for i in range(nx):
            tag += 1
            first = 1 + i + j * (nx + 1)
            corners = [first, first + 1, first + nx + 2, first + nx + 1]
            part.CreateNewElement("ShellThickElement3D4N", tag, corners, plate)
    return part, springs


def _variable(name: str) -> Km.DoubleVariable:
    return Km.KratosGlobals.GetVariable(name)


if __name__ == "__main__":
    run(main)
