"""The program as the functions that a solver calls, with derivatives put together from those of one sample.

The variables reach a sample as y_k = [x_k; u_k], and what it yields, c_k, reaches the rows; both ways are constant:

    dg/dx = dg/dx|c + (dg/dc) blockdiag(dc_k/dy_k) (dy/dx),   Hessian = f_xx + (dy/dx)' blockdiag(H_k) (dy/dx)

CasADi, left alone, would find both by many sweeps through the whole horizon, at several times the price.
"""

import casadi as ca

from swerve.control.nonlinear.formulation import Formulation
from swerve.control.nonlinear.stage import N_BOTH, Stage


def functions(program: Formulation, stage: Stage, solver: str) -> tuple[ca.Function, ...]:
    """What CasADi's interface to a solver looks for in a library, under the names by which it looks for it."""
    x, p = program.x, ca.vertcat(*program.p)
    n_samples = program.c.size2()
    y = ca.vertcat(program.starts, program.inputs)
    y_x, g_c = ca.jacobian(ca.vec(y), x), ca.jacobian(program.rows, program.c)
    indices = ca.DM(range(n_samples)).T
    arguments = [program.starts, program.inputs, indices, ca.repmat(program.p.data, 1, n_samples)]
    weight_f, weights_g = ca.MX.sym("lam_f"), ca.MX.sym("lam_g", program.rows.numel())

    def rows(c: ca.MX) -> ca.MX:
        return ca.graph_substitute([program.rows], [program.c], [c])[0]

    f, g = program.cost, rows(stage.value.map(n_samples)(*arguments))
    c, blocks = stage.jacobian.map(n_samples)(*arguments)
    g_x = ca.jacobian(program.rows, x) + _product(g_c, blocks, y_x)
    on_c = ca.reshape(g_c.T @ weights_g, *program.c.shape)
    hessians, gradients = stage.hessian.map(n_samples)(*arguments, on_c)
    f_x, f_xx = ca.gradient(f, x), ca.hessian(f, x)[0]
    gamma_x = weight_f * f_x + ca.jacobian(program.rows, x).T @ weights_g + y_x.T @ ca.vec(gradients)
    gamma_xx = weight_f * f_xx + _product(y_x.T, hessians, y_x)

    point = {"x": x, "p": p}
    weighted = point | {"lam_f": weight_f, "lam_g": weights_g}
    never_asked = ca.MX(ca.DM.nan(p.numel()))
    if solver == "fatrop":
        gradient = {"grad_f_x": f_x}
        hessian = {"grad_gamma_x": gamma_x, "hess_gamma_x_x": gamma_xx}
    else:
        gradient = {"f": f, "grad_f_x": f_x}
        hessian = {"triu_hess_gamma_x_x": ca.triu(gamma_xx)}
    return (
        _function("nlp", point, {"f": f, "g": g}),
        _function("nlp_f", point, {"f": f}),
        _function("nlp_g", point, {"g": g}),
        _function("nlp_grad_f", point, gradient),
        _function("nlp_jac_g", point, {"g": rows(c), "jac_g_x": g_x}),
        _function("nlp_hess_l", weighted, hessian),
        _function("nlp_grad", weighted, {"f": f, "g": g, "grad_gamma_x": gamma_x, "grad_gamma_p": never_asked}),
    )


def _function(name: str, inputs: dict[str, ca.MX], outputs: dict[str, ca.MX]) -> ca.Function:
    return ca.Function(name, list(inputs.values()), list(outputs.values()), list(inputs), list(outputs))


def _product(left: ca.MX, blocks: ca.MX, right: ca.MX) -> ca.MX:
    """The product left blockdiag(blocks) right, of constants left and right: its non-zeros are linear in the blocks'.

    Args:
        left: constant.
        blocks: (n, N_BOTH Np), dense, side by side.
        right: constant.
    """
    symbols = ca.SX.sym("blocks", *blocks.shape)
    product = ca.evalf(left) @ ca.diagcat(*ca.horzsplit(symbols, N_BOTH)) @ ca.evalf(right)
    how = ca.DM(ca.jacobian(product.nz[:], symbols))
    return ca.MX(product.sparsity(), how @ ca.vec(blocks))
