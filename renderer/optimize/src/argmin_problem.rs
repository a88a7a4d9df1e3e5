//! An objective as `argmin` wants it.

use std::cell::{Cell, RefCell};
use std::rc::Rc;

use argmin::core::{CostFunction, Error, Gradient};

use super::{Coordinates, Evaluation, Objective};

/// An [`Objective`] over [`Coordinates`] without bounds, for every solver of `argmin` that asks
/// for a cost function and its gradient. Whatever the solver tries, the objective is evaluated
/// within the bounds.
///
/// ```
/// use argmin::core::{Executor, State};
/// use argmin::solver::linesearch::MoreThuenteLineSearch;
/// use argmin::solver::quasinewton::LBFGS;
/// use renderer::optimize::{ArgminProblem, Coordinates, Evaluation, Variable};
///
/// let variables = [Variable::new("x", vec![1.0], 0.1).bounded(0.0, 2.5)];
/// let mut objective = |x: &[f64]| Evaluation {
///     loss: (x[0] - 3.0).powi(2),
///     gradient: vec![2.0 * (x[0] - 3.0)],
/// };
/// let coordinates = Coordinates::new(&variables)?;
/// let start = coordinates.from_bounded(&variables[0].initial);
/// let problem = ArgminProblem::new(&mut objective, &coordinates);
/// let solver = LBFGS::new(MoreThuenteLineSearch::new(), 5);
/// let result = Executor::new(problem, solver)
///     .configure(|state| state.param(start).max_iters(20))
///     .run()
///     .unwrap();
/// let found = coordinates.to_bounded(result.state().get_best_param().unwrap());
/// assert!((found[0] - 2.5).abs() < 1e-3);
/// # Ok::<(), renderer::Error>(())
/// ```
pub struct ArgminProblem<'a> {
    objective: RefCell<&'a mut dyn Objective>,
    coordinates: &'a Coordinates,
    /// What losses and gradients are multiplied by.
    scale: f64,
    most_evaluations: u32,
    evaluations: Cell<u32>,
    /// Why it was not evaluated, if it was not.
    refusal: Rc<RefCell<Option<String>>>,
    /// The latest evaluation and its coordinates: solvers ask for cost and gradient one by one.
    latest: RefCell<Option<(Vec<f64>, Evaluation)>>,
}

impl<'a> ArgminProblem<'a> {
    /// The problem of minimising `objective`.
    pub fn new(objective: &'a mut dyn Objective, coordinates: &'a Coordinates) -> Self {
        Self {
            objective: RefCell::new(objective),
            coordinates,
            scale: 1.0,
            most_evaluations: u32::MAX,
            evaluations: Cell::new(0),
            refusal: Rc::default(),
            latest: RefCell::new(None),
        }
    }

    /// This problem with losses and gradients multiplied by `scale`: solvers take a first step as long
    /// as the gradient.
    pub fn scaled(self, scale: f64) -> Self {
        Self { scale, ..self }
    }

    /// This problem, where more evaluations than `most` are an error: line searches may not end by
    /// themselves.
    pub fn limited(self, most: u32) -> Self {
        Self { most_evaluations: most, ..self }
    }

    /// Why it was not evaluated, if it was not: solvers keep the problem where they fail, and put their own words
    /// around it.
    pub(super) fn refusal(&self) -> Rc<RefCell<Option<String>>> {
        self.refusal.clone()
    }

    fn evaluate<T>(&self, u: &[f64], make: impl Fn(&Evaluation) -> T) -> Result<T, Error> {
        self.try_to_evaluate(u, make).map_err(|why| {
            *self.refusal.borrow_mut() = Some(why.clone());
            Error::msg(why)
        })
    }

    /// Loss and gradient at `u`, by the elements and not scaled, and whatever is made of them.
    fn try_to_evaluate<T>(&self, u: &[f64], make: impl Fn(&Evaluation) -> T) -> Result<T, String> {
        let mut latest = self.latest.borrow_mut();
        if let Some((at, evaluation)) = &*latest
            && at == u
        {
            return Ok(make(evaluation));
        }
        if self.evaluations.get() >= self.most_evaluations {
            let most = self.most_evaluations;
            return Err(format!(
                "the line search did not end within {most} evaluations, as at a minimum or where the loss jumps"
            ));
        }
        self.evaluations.set(self.evaluations.get() + 1);
        let x = self.coordinates.to_bounded(u);
        if !x.iter().all(|x| x.is_finite()) {
            return Err("it left the finite numbers".to_owned());
        }
        let evaluation = self.objective.borrow_mut().evaluate(&x);
        if !evaluation.loss.is_finite() {
            return Err(format!("the line search met the loss {}", evaluation.loss));
        }
        if !evaluation.gradient.iter().all(|g| g.is_finite()) {
            return Err("the line search met a gradient that is not finite".to_owned());
        }
        let made = make(&evaluation);
        *latest = Some((u.to_vec(), evaluation));
        Ok(made)
    }

    /// Loss and gradient at `u`, by the elements and not scaled.
    ///
    /// # Errors
    ///
    /// If one of them is not finite, or the limit of evaluations is reached.
    pub fn evaluation(&self, u: &[f64]) -> Result<Evaluation, Error> {
        self.evaluate(u, Evaluation::clone)
    }
}

impl CostFunction for ArgminProblem<'_> {
    type Param = Vec<f64>;
    type Output = f64;

    fn cost(&self, u: &Vec<f64>) -> Result<f64, Error> {
        self.evaluate(u, |evaluation| self.scale * evaluation.loss)
    }
}

impl Gradient for ArgminProblem<'_> {
    type Param = Vec<f64>;
    type Gradient = Vec<f64>;

    fn gradient(&self, u: &Vec<f64>) -> Result<Vec<f64>, Error> {
        self.evaluate(u, |evaluation| {
            let mut gradient = self.coordinates.pull_back(u, &evaluation.gradient);
            gradient.iter_mut().for_each(|g| *g *= self.scale);
            gradient
        })
    }
}
