//! Exact gradients of ordinary Rust functions, written at compile time.
//!
//! ```
//! use ad::differentiable;
//!
//! #[differentiable]
//! fn spring(stiffness: f64, stretch: f64) -> f64 {
//!     0.5 * stiffness * stretch * stretch
//! }
//!
//! let (energy, (by_stiffness, by_stretch)) = spring::value_and_grad(3.0, 0.5);
//! assert_eq!((energy, by_stiffness, by_stretch), (0.375, 0.125, 1.5));
//! ```
//!
//! The function stays as it is. Beside it stands a type of the same name with four functions
//! (types and functions have separate name spaces, and `use` imports both):
//!
//! | | |
//! |---|---|
//! | `f::vjp(x, y)` | the value, and the *pullback*: a closure from the cotangent of the value to those of the parameters |
//! | `f::value_and_grad(x, y)` | the value and the gradient, for a scalar result |
//! | `f::grad(x, y)` | the gradient alone |
//! | `f::jvp(x, y, x_dot, y_dot)` | the value, and its derivative along a direction ([forward mode](#forward-mode)) |
//!
//! With one parameter the gradient is bare, with several it is a tuple in their order. In an `impl`
//! block under `#[differentiable]` each method `m` gets the siblings `m_vjp`, `m_value_and_grad`,
//! `m_grad` and `m_jvp`; the receiver is the first parameter.
//!
//! # What can be differentiated
//!
//! Functions and inherent methods on `f32`, `f64`, glam's float vectors, matrices and quaternions,
//! tuples, arrays, slices, `Vec`, `Box`, `Option`, `Result`, references to these, and structs and
//! enums with `#[derive(Differentiable)]`; generic ones too. In a body: `let` with patterns,
//! variables that get their value later, arithmetic, assignment to local variables and parts of
//! them, to several at once, too, `let (a, b) = &mut pair` and `ref mut` in a `let`, `if`, `match`,
//! `if let` and chains of it, `let else`, `for` over ranges and over elements, `while`, `while
//! let`, `loop`, labels, `break`, `continue` and `return` from anywhere, `?`, constants and other
//! items, calls of differentiable functions and of the methods listed in [`rules`].
//!
//! Iterators: `iter`, `iter_mut`, `into_iter`, `windows`, `chunks`, `chunks_exact`, `chunks_mut` and
//! `chunks_exact_mut`, under
//! `enumerate`, `zip`, `chain`, `rev`, `skip`, `take`, `step_by`, `cycle`, `copied`, `map`,
//! `filter`, `filter_map`, `flat_map`, `flatten`, `take_while` and `map_while`; in a `for` loop or
//! used up by `sum`, `product`, `fold`, `reduce`, `last`, `for_each`, `collect` into a `Vec`,
//! `extend`, `min_by` or `max_by`, and without derivative by `count`, `any`, `all` or `position`;
//! `array::from_fn`, `map` of arrays. Options, results and truth values: `map`, `and_then`, `or_else`,
//! `map_or`, `map_or_else`, `map_err`, `ok`, `ok_or`, `ok_or_else`, `unwrap`, `expect`, `unwrap_or`,
//! `unwrap_or_else`, `unwrap_or_default`, `then`, `then_some`, and of options `as_ref`, `take`, `replace`,
//! `or`, `xor`, `zip`, `filter`, `flatten`. (`or_else` is taken for that of options, unless a type written
//! down or what was called before tells a result.) Slices: `first`, `last`, `get`,
//! `split_at`, `split_first`, `split_last`, in a `let` also `split_at_mut`, `split_first_mut` and
//! `split_last_mut`, `sort_by`, `swap`, `reverse`, `rotate_left`, `rotate_right`, `fill`. `Vec`: `push`,
//! `pop`, `insert`, `remove`, `swap_remove`, `truncate`, `resize`, `split_off`, `append`, `clear`,
//! `extend_from_slice`. Integers: their arithmetic, `min`, `max`, `clamp`, `pow`, `abs`,
//! `saturating_sub` and the like. Closures can be bound to a variable and called, and may change what they
//! capture, or be passed to [functions of functions](#functions-of-functions). Macros: `assert!`
//! and its kin, `panic!`, `unreachable!`, `vec!`, `matches!`, `dbg!`, `println!` and its kin,
//! `format!`.
//!
//! The gradient by a slice or a `Vec` is a `Vec` of the same length. Reading or writing an element
//! costs the reverse sweep a constant time, as it does the function, and so does a call that passes a
//! slice, a `Vec` or a struct on, or is made on one as `&self`. By the length of what is passed are
//! charged: methods of traits, functions that take functions, closures that are passed, rules written
//! by hand, and `checkpoint` on a function, which keeps copies of its arguments. There a function that
//! looks at a few elements of many is best given `&xs[a..b]`. What is passed as `&mut` is lent, at no
//! cost.
//!
//! ```
//! use ad::differentiable;
//!
//! /// The energy of a chain of springs.
//! #[differentiable]
//! fn chain(xs: &[f64], stiffness: f64) -> f64 {
//!     let mut energy = 0.0;
//!     for i in 1..xs.len() {
//!         let stretch = xs[i] - xs[i - 1];
//!         energy += 0.5 * stiffness * stretch * stretch;
//!     }
//!     energy
//! }
//!
//! let (by_xs, by_stiffness) = chain::grad(&[0.0, 1.0, 3.0], 2.0);
//! assert_eq!(by_xs, [-2.0, -2.0, 4.0]);
//! assert_eq!(by_stiffness, 2.5);
//! ```
//!
//! ```
//! use ad::{Differentiable, differentiable};
//! use glam::DVec3;
//!
//! #[derive(Clone, Copy, Differentiable)]
//! struct Ray {
//!     origin: DVec3,
//!     direction: DVec3,
//! }
//!
//! #[differentiable]
//! impl Ray {
//!     fn at(&self, t: f64) -> DVec3 {
//!         self.origin + self.direction * t
//!     }
//! }
//!
//! /// The nearest distance at which the ray meets the unit sphere, squared.
//! #[differentiable]
//! fn hit(ray: Ray) -> Option<f64> {
//!     let b = ray.origin.dot(ray.direction);
//!     let discriminant = b * b - ray.origin.length_squared() + 1.0;
//!     if discriminant < 0.0 {
//!         return None;
//!     }
//!     let point = ray.at(-b - discriminant.sqrt());
//!     Some(point.distance_squared(ray.origin))
//! }
//!
//! let ray = Ray { origin: DVec3::new(0.0, 0.5, -3.0), direction: DVec3::Z };
//! let (distance, pullback) = hit::vjp(ray);
//! assert!(distance.is_some());
//! // The cotangent of a struct is a struct of the same fields: here a `RayTangent`.
//! assert!(pullback(1.0).origin.z < 0.0);
//! ```
//!
//! Everything else is refused, where it stands, with what to write instead: a gradient that compiles
//! is right. [What is refused](#what-is-refused-and-what-is-trusted) has a chapter of its own.
//!
//! At points without a derivative (`|x|` at 0, a vector of length 0) the rules return a finite
//! subgradient: see the [table](rules#singular-points).
//!
//! # What is refused, and what is trusted
//!
//! - A function that is called needs a derivative. If it has none, the compiler says that the
//!   function *is not a crate or module*, or that there is no method `.._vjp`. Three ways out: put
//!   `#[differentiable]` on it, write a [rule](#rules-written-by-hand) for it, or say that nothing
//!   is to flow through it: [`no_diff`]`(|| f(x))`.
//! - Integers, booleans and comparisons carry no derivative. A cast from a float to an integer would
//!   cut one off, so it has to be said: `stop_gradient(x) as usize`.
//! - A number that goes through a text or through its bits and comes back (`x.to_string()`, then
//!   `parse()`) would lose its derivative on the way, and so would one that a condition or [`no_diff`]
//!   puts into a `Cell`, a `RefCell` or a `Mutex`. Both need `stop_gradient(x)`.
//! - A `#[constant]` field takes nothing that has a derivative: it is written `stop_gradient(x)`. What
//!   another such field held goes in as it is.
//! - A condition, an index, a bound and a `let` with an integer type may call what changes something.
//!   A call is differentiated there where it shows the change: by `&mut`, by the name of a `&mut`
//!   parameter, by a method like `pop`, or by a `&mut self` method that stands in the same `impl` block.
//!   Any other method that changes a place, `if balls[i].bounce()`, gets a line of its own before:
//!   `let bounced = balls[i].bounce();`.
//! - A derivative within a differentiable function (`g::grad(x)` in the body of another) is refused:
//!   second derivatives are [taken from outside](#second-derivatives-and-jacobians).
//! - A field that carries no derivative is marked `#[constant]`, and so is a type that carries none.
//!   So is a parameter by which no derivative is asked for, `fn f(#[constant] table: &Table, x: f64)`:
//!   its place in the gradient holds `()`, and its type needs no tangent. As `#[constant] rng: &mut Rng`
//!   it is advanced exactly as the function advances it.
//! - A variable that changes and carries no derivative needs no mark while only its own methods change
//!   it: `let mut rng = Rng::new(1); let u = rng.uniform();`. To be passed on as `&mut rng` it is
//!   declared by `#[constant] let mut rng = ..;`, if its type has no tangent. What has a derivative
//!   cannot be stored in it.
//! - Operators of your own types have a derivative where their `impl` carries the attribute: see
//!   [below](#operators-of-your-own-types).
//! - A variant of an enum is told from a struct by the name of the enum (`Shape::Disc(r)`,
//!   `Self::Disc(r)`). Behind `use Shape::*` it is told by the other variants that the same `match`
//!   asks for, or by what is done where it is none (`let Disc(r) = shape else ..`); where nothing
//!   tells it, name the enum.
//! - `sums[f()] += g()` evaluates `g()` first for numbers, and `f()` first for every other type. Where
//!   the type is not a number of the language, one of the calls gets a name before.
//! - A type that has lifetimes names them in a signature: `View<'_>`, not `View`.
//! - `vec!`, `dbg!`, `mem::swap`, `array::from_fn`, `Box::new`, [`stop_gradient`] and [`no_diff`] have to
//!   be those of the standard library and of this crate. Your own function or macro of such a name is
//!   refused where it would be taken for one of these.
//!
//! A derivative cannot show everything that a function does. The following is trusted, and a debug
//! build panics where it finds one of the first three broken:
//!
//! - A [checkpointed](#memory) loop or function does the same when it runs the second time: it draws no
//!   random numbers, and it reads nothing that somebody else changes.
//! - `g(x)` and `g::vjp(x)` are looked up in two name spaces. A plain `g` that hides a differentiable one
//!   of another module does not hide its derivative.
//! - A function that is passed by its name is found in the same two name spaces.
//! - `Clone` gives an equal value. Closures that are passed, checkpoints, and operators of values keep
//!   clones.
//! - An inherent method that hides a method of a trait carries the attribute if that does.
//! - A function that is called in a condition, or for an integer or a text, keeps nothing of what it is
//!   given in a `static`, in a `thread_local!` or in a cell of its own.
//! - A closure before `zip` does not count how often it is called: the standard library calls it once
//!   more where the other side is shorter.
//! - A temporary of a constant argument is dropped with the argument, not with the whole statement.
//!
//! # Methods, traits, recursion
//!
//! On an `impl` block the attribute differentiates every method. On a method it differentiates that one,
//! in a block without type parameters; of a function without `self` it sees that it stands in a block
//! by a `Self` in the signature. On a trait it adds `m_vjp` and `m_jvp` to each
//! method `m`, and has to stand on each `impl` of the trait, too; an `impl` without it does not
//! compile. Generic code asks for `T: Trait + Differentiable`.
//!
//! ```
//! use ad::{Differentiable, differentiable};
//!
//! #[differentiable]
//! trait Potential {
//!     fn energy(&self, x: f64) -> f64;
//! }
//!
//! #[derive(Differentiable)]
//! struct Spring {
//!     stiffness: f64,
//! }
//!
//! #[differentiable]
//! impl Potential for Spring {
//!     fn energy(&self, x: f64) -> f64 {
//!         0.5 * self.stiffness * x * x
//!     }
//! }
//!
//! #[differentiable]
//! fn total<P: Potential + Differentiable>(potential: &P, xs: &[f64]) -> f64 {
//!     let mut sum = 0.0;
//!     for x in xs {
//!         sum += potential.energy(*x);
//!     }
//!     sum
//! }
//!
//! let (by_spring, by_xs) = total::grad(&Spring { stiffness: 3.0 }, &[1.0, 2.0]);
//! assert_eq!((by_spring.stiffness, by_xs), (2.5, vec![3.0, 6.0]));
//! ```
//!
//! A function that calls itself has its pullback boxed, since its type would hold itself: one
//! allocation for each call. Where functions call each other in a circle, or a method calls itself
//! on something else than `self`, one of them says so with `#[differentiable(boxed)]`; else the
//! compiler speaks of a *recursive opaque type*.
//!
//! # Operators of your own types
//!
//! `#[differentiable]` on the `impl` of an operator (`+`, `-`, `*`, `/`, `%`, the negative, and their
//! assigning forms) differentiates it wherever it is written, in both modes.
//!
//! ```
//! use std::ops::{Add, Mul};
//!
//! use ad::{Differentiable, differentiable};
//!
//! #[derive(Clone, Copy, Differentiable)]
//! struct Complex {
//!     re: f64,
//!     im: f64,
//! }
//!
//! #[differentiable]
//! impl Add for Complex {
//!     type Output = Self;
//!
//!     fn add(self, other: Self) -> Self {
//!         Self { re: self.re + other.re, im: self.im + other.im }
//!     }
//! }
//!
//! #[differentiable]
//! impl Mul for Complex {
//!     type Output = Self;
//!
//!     fn mul(self, other: Self) -> Self {
//!         Self {
//!             re: self.re * other.re - self.im * other.im,
//!             im: self.re * other.im + self.im * other.re,
//!         }
//!     }
//! }
//!
//! #[differentiable]
//! fn step(z: Complex, c: Complex) -> f64 {
//!     (z * z + c).re
//! }
//!
//! let z = Complex { re: 1.0, im: 2.0 };
//! let (by_z, by_c) = step::grad(z, z);
//! assert_eq!((by_z.re, by_z.im, by_c.re), (2.0, -4.0, 1.0));
//! ```
//!
//! `a += b` is differentiated as the `AddAssign` that it calls. Of the forms of an operator, those of
//! values and of references, one carries the attribute, and all that are written are differentiated as
//! that one. `sum()` and `product()` need the attribute on `impl Sum`, whose body is
//! `iter.fold(start, |sum, x| sum + x)`; what they add up is `Copy`. The pullback of an operator of
//! values starts from its operands, of which it keeps copies; that of an operator of references holds
//! what that of a function does.
//!
//! ```
//! use std::ops::{AddAssign, Mul};
//!
//! use ad::{Differentiable, differentiable};
//!
//! #[derive(Clone, Differentiable)]
//! struct Polynomial(Vec<f64>);
//!
//! #[differentiable]
//! impl Mul<&Polynomial> for &Polynomial {
//!     type Output = Polynomial;
//!
//!     fn mul(self, other: &Polynomial) -> Polynomial {
//!         let mut product = vec![0.0; self.0.len() + other.0.len() - 1];
//!         for (i, a) in self.0.iter().enumerate() {
//!             for (k, b) in other.0.iter().enumerate() {
//!                 product[i + k] += a * b;
//!             }
//!         }
//!         Polynomial(product)
//!     }
//! }
//!
//! #[differentiable]
//! impl AddAssign<f64> for Polynomial {
//!     fn add_assign(&mut self, constant: f64) {
//!         self.0[0] += constant;
//!     }
//! }
//!
//! #[differentiable]
//! fn middle(p: &Polynomial, x: f64) -> f64 {
//!     let mut square = p * p;
//!     square += x;
//!     let fourth = &square * &square;
//!     fourth.0[2]
//! }
//!
//! let (by_p, by_x) = middle::grad(&Polynomial(vec![1.0, 2.0]), 3.0);
//! assert_eq!((by_p.0, by_x), (vec![48.0, 48.0], 8.0));
//! ```
//!
//! Of a type that is not `Copy` the attribute has to see that an operand is: by `&`, by a type that is
//! declared (`let mut m: Matrix = f(x)`, a parameter), a constructor (`Matrix::new(..)`), `clone()` or
//! another operator of it. Where it does not, the compiler says that `a` in `a *= b` or `a * b` *is moved*,
//! or cannot be: write the type of `a`, or `&a * &b`. A field that an operator changes, `self.m *= x`, is
//! given a name first: `let m: &mut Matrix = &mut self.m;`.
//!
//! Elements of your own types have one where they are told by a tuple, `m[(i, j)]`: the attribute stands
//! on `impl Index<(usize, usize)>` and, for elements that are assigned to, on `impl IndexMut`. What is
//! indexed stands at the end of `index` as a reference, and is `Copy`.
//!
//! ```
//! use std::ops::{Index, IndexMut};
//!
//! use ad::{Differentiable, differentiable};
//!
//! #[derive(Clone, Differentiable)]
//! struct Matrix {
//!     columns: usize,
//!     data: Vec<f64>,
//! }
//!
//! #[differentiable]
//! impl Index<(usize, usize)> for Matrix {
//!     type Output = f64;
//!
//!     fn index(&self, (i, j): (usize, usize)) -> &f64 {
//!         &self.data[i * self.columns + j]
//!     }
//! }
//!
//! #[differentiable]
//! impl IndexMut<(usize, usize)> for Matrix {
//!     fn index_mut(&mut self, (i, j): (usize, usize)) -> &mut f64 {
//!         &mut self.data[i * self.columns + j]
//!     }
//! }
//!
//! #[differentiable]
//! fn eliminated(matrix: &Matrix) -> f64 {
//!     let mut m = matrix.clone();
//!     let factor = m[(1, 0)] / m[(0, 0)];
//!     m[(1, 1)] -= factor * m[(0, 1)];
//!     m[(0, 0)] * m[(1, 1)]
//! }
//!
//! // The derivatives of a determinant are the cofactors.
//! let by_matrix = eliminated::grad(&Matrix { columns: 2, data: vec![2.0, 3.0, 5.0, 7.0] });
//! assert_eq!(by_matrix.data, [7.0, -5.0, -3.0, 2.0]);
//! ```
//!
//! # Functions of functions
//!
//! A parameter may be a function of up to four arguments, by its bound `F: Fn(..) -> ..` or as
//! `impl Fn(..) -> ..`. What is passed is a closure, which is differentiated by what it captures,
//! too, or the name of a differentiable function: `integrate(square, a, b)`, `integrate(f64::sin,
//! a, b)`; to a function that takes it by value, also a reference to it, `integrate(&f, a, b)`. A
//! function or a method tells a closure the types of its parameters; to an associated function, or
//! where they are types for which the function is generic, it is passed with types, `|x: f64| ..`.
//! In forward mode `()` stands at the place of a function's tangent: an object holds those of what
//! it captures.
//!
//! ```
//! use ad::differentiable;
//!
//! /// Newton's method.
//! #[differentiable]
//! fn root<F: Fn(f64) -> f64, G: Fn(f64) -> f64>(f: F, slope: G, start: f64) -> f64 {
//!     let mut x = start;
//!     while f(x).abs() > 1e-12 {
//!         x -= f(x) / slope(x);
//!     }
//!     x
//! }
//!
//! #[differentiable]
//! fn square_root(a: f64) -> f64 {
//!     root(|x| x * x - a, |x| 2.0 * x, 1.0)
//! }
//!
//! assert!((square_root::grad(2.0) - 0.5 / 2.0_f64.sqrt()).abs() < 1e-9);
//! ```
//!
//! A closure that changes what it captures can be called where it was written, but not passed; see
//! [`function`] for how this works and what it costs.
//!
//! # Rules written by hand
//!
//! `#[differentiable(vjp = rule)]` takes the derivative from a function that returns the value and
//! the pullback. Forward mode then goes by way of the pullback where the result is one number, and the
//! parameters are numbers, vectors and sequences of them; else it needs a rule of its own, `jvp = rule`,
//! where it is used. On the `use` of a function it gives a derivative to what another crate computes:
//!
//! ```
//! use ad::differentiable;
//!
//! mod special {
//!     pub fn softplus(x: f64) -> f64 {
//!         x.exp().ln_1p()
//!     }
//! }
//!
//! #[differentiable(vjp = softplus_vjp)]
//! use special::softplus;
//!
//! fn softplus_vjp(x: f64) -> (f64, impl FnOnce(f64) -> f64) {
//!     (special::softplus(x), move |cotangent| cotangent / (1.0 + (-x).exp()))
//! }
//!
//! #[differentiable(vjp = cube_root_vjp)]
//! fn cube_root(x: f64) -> f64 {
//!     x.powf(1.0 / 3.0)
//! }
//!
//! fn cube_root_vjp(x: f64) -> (f64, impl FnOnce(f64) -> f64) {
//!     let root = cube_root(x);
//!     (root, move |cotangent| cotangent / (3.0 * root * root))
//! }
//!
//! #[differentiable(reverse)]
//! fn f(x: f64) -> f64 {
//!     softplus(x) * cube_root(x)
//! }
//!
//! fn main() {
//!     assert!((f::grad(1.0) - 1.1688).abs() < 1e-4);
//! }
//! ```
//!
//! One call of [`check::assert_rule`] holds a rule against finite differences, one of
//! [`check::assert_forward`] a rule for forward mode.
//!
//! The attribute sees nothing of an imported function but its name, so forward mode of what calls it
//! needs a rule for it, `#[differentiable(vjp = softplus_vjp, jvp = softplus_jvp)]` with
//! `fn softplus_jvp(x: f64, x_dot: f64) -> (f64, f64)`, or else is left out by
//! `#[differentiable(reverse)]`, as below.
//!
//! A rule for a function of references returns `impl FnOnce(..) -> .. + use<>`: its pullback holds
//! copies. An imported function gets its rule in a module, not within a function. One for a method
//! `m` of another crate's type is a method `m_vjp` of a trait of yours.
//!
//! # Options, results and enums
//!
//! The cotangent of an `Option` is that of its content, zero for `None`. That of a
//! `Result<T, E>` is the pair of those of `T` and of `E`, of which an error without data has `()`;
//! nothing flows through `?` on the side of the error. The tangent of an enum has a field for each
//! variant with data; those of the variants that the value is not stay zero.
//!
//! ```
//! use ad::{Differentiable, differentiable};
//!
//! #[derive(Clone, Copy, Differentiable)]
//! enum Shape {
//!     Disc(f64),
//!     Box { width: f64, height: f64 },
//!     Point,
//! }
//!
//! #[differentiable]
//! fn area(shape: &Shape) -> f64 {
//!     match shape {
//!         Shape::Disc(radius) => std::f64::consts::PI * radius * radius,
//!         Shape::Box { width, height } => width * height,
//!         Shape::Point => 0.0,
//!     }
//! }
//!
//! let by_shape = area::grad(&Shape::Box { width: 2.0, height: 3.0 });
//! assert_eq!((by_shape.Box.width, by_shape.Box.height), (3.0, 2.0));
//! assert_eq!(by_shape.Disc.0, 0.0);
//! ```
//!
//! The tangent of a `Box` is a [`Boxed`] one, made when something flows to it, so that types may
//! hold themselves in boxes: trees of formulas, of bodies, of scenes.
//!
//! # Changing things in place
//!
//! A `&mut` parameter goes both ways, and so does its cotangent: the pullback takes, after that of
//! the value, the cotangent of what each `&mut` parameter holds afterwards, and returns, at the
//! place of the parameter, that of what it held before. `grad` and `value_and_grad` differentiate
//! the value alone: what is left behind counts for nothing.
//!
//! ```
//! use ad::differentiable;
//!
//! #[differentiable]
//! fn advance(x: &mut f64, v: &mut f64, dt: f64) {
//!     *v -= *x * dt;
//!     *x += *v * dt;
//! }
//!
//! #[differentiable]
//! fn oscillator(start: f64, steps: usize) -> f64 {
//!     let (mut x, mut v) = (start, 0.0);
//!     for _ in 0..steps {
//!         advance(&mut x, &mut v, 0.01);
//!     }
//!     x
//! }
//!
//! let (x, (by_start, ())) = oscillator::value_and_grad(2.0, 100);
//! assert!((by_start - x / 2.0).abs() < 1e-12);
//!
//! let (mut x, mut v) = (1.0, 0.0);
//! let ((), pullback) = advance::vjp(&mut x, &mut v, 0.5);
//! // By how much does the new position change with the old position, the old velocity, the step?
//! let (by_x, by_v, by_dt) = pullback((), 1.0, 0.0);
//! assert_eq!((by_x, by_v, by_dt), (0.75, 0.5, -1.0));
//! ```
//!
//! By value, the cotangents of parts of one array can be lent to a call at the same time, and a
//! `Vec` is handed over without copying it; a pullback that wrote into its caller's cotangents
//! instead would need them all borrowed at once.
//!
//! # How the generated code reads
//!
//! For `fn f(x: f64, y: f64) -> f64 { let p = x * y; p.sin() + p }` the attribute writes, but for
//! full paths,
//!
//! ```ignore
//! pub fn vjp(x: f64, y: f64) -> (f64, impl FnOnce(f64) -> (f64, f64)) {
//!     let p = x * y;
//!     let (sin, sin_pullback) = p.sin_vjp();
//!     let sum = sin + p;
//!     (sum, move |sum_bar| {
//!         let (sin_bar, mut p_bar) = add_pullback(sum_bar);
//!         p_bar += sin_pullback(sin_bar);
//!         let (x_bar, y_bar) = mul_pullback(x, y, p_bar);
//!         (x_bar, y_bar)
//!     })
//! }
//! ```
//!
//! What the closure names, it captures: the compiler decides what is saved. There is no tape and no
//! allocation, except for loops that do not have a small literal for their length: these have one
//! tape each, made once where the number of iterations is known before the first. Calls are inlined
//! like any others, and cotangents that a caller drops are not computed.
//!
//! A call that is passed `&xs`, or a struct by reference, goes to `vjp_onto` in place of `vjp`, whose
//! pullback takes the cotangent of `xs` so far and returns it with its own part added: a loop of n
//! calls with a slice of n elements costs n, not n². Methods that take `&self` have such a function, too.
//! (Methods of traits, and functions that take functions, return a cotangent of their own for each call.)
//!
//! # Forward mode
//!
//! `f::jvp` (Jacobian-vector product) takes the arguments, then a *tangent* for each in the same
//! order: how fast the argument moves. It returns the value and how fast that moves.
//!
//! ```
//! use ad::differentiable;
//!
//! #[differentiable]
//! fn range(speed: f64, angle: f64, wind: &[f64]) -> f64 {
//!     let mut distance = speed * speed * (2.0 * angle).sin() / 9.81;
//!     for gust in wind {
//!         distance += gust * distance.sqrt();
//!     }
//!     distance
//! }
//!
//! // By how much does the range grow with the speed?
//! let wind = [0.1, -0.2];
//! let (distance, by_speed) = range::jvp(20.0, 0.7, &wind, 1.0, 0.0, &[0.0, 0.0]);
//! let (value, gradient) = range::value_and_grad(20.0, 0.7, &wind);
//! assert_eq!(distance, value);
//! assert!((by_speed - gradient.0).abs() < 1e-12);
//! ```
//!
//! | parameter | its tangent |
//! |---|---|
//! | `T` | [`Tangent<T>`](Tangent), `()` for integers |
//! | `&T`, `&[T]` | `&Tangent<T>`, `&[Tangent<T>]` |
//! | `&mut T`, `&mut [T]` | `&mut Tangent<T>`, `&mut [Tangent<T>]`: it comes in and goes out |
//!
//! A tangent has as many elements as its value has. The tangents of options, results, structs and
//! enums are those that reverse mode has for cotangents; so are the derivatives at singular points.
//!
//! Generated code is the function with a tangent beside each variable. There is no tape, no closure
//! and no allocation but the function's own; recursion needs no `boxed`, and `checkpoint` changes
//! nothing:
//!
//! ```ignore
//! pub fn jvp(x: f64, y: f64, x_dot: f64, y_dot: f64) -> (f64, f64) {
//!     let (p, p_dot) = mul_jvp(x, y, x_dot, y_dot);
//!     let (sin, sin_dot) = p.sin_jvp(p_dot);
//!     let (sum, sum_dot) = add_jvp(sin, p, sin_dot, p_dot);
//!     (sum, sum_dot)
//! }
//! ```
//!
//! Which mode? A `jvp` costs 1.3 to 2.7 times the function (measured, bench `ad`) and gives one
//! *column* of the Jacobian; a pullback costs as much or little more, and gives a *row*, the whole
//! gradient of a result. So for one direction, and for functions of one parameter to many results,
//! take `jvp`; for the gradient by two numbers or more, `grad`. Forward mode needs no memory for
//! what reverse mode would save, which decides where a loop is long and its gradient is wanted by
//! few numbers.
//!
//! Every function gets its forward mode, for it has to be there in all that a function calls. It
//! adds less than a tenth to what the attribute costs at compile time; code that is not called is
//! not generated. `#[differentiable(reverse)]` leaves it out. Turned down: forward mode on
//! request, which each function called would have to be asked for, too.
//!
//! # Second derivatives and Jacobians
//!
//! [`hvp`] gives the Hessian times a vector, exactly, by dual numbers through the gradient of a
//! function that is [generic over its scalar](#generic-scalars); [`hessian`] all of a small Hessian.
//! [`jacobian_forward`] and [`jacobian_reverse`] give Jacobians by columns and by rows. For functions
//! that are generic over their scalar, [`jacobian`] and [`hessian`] follow four columns at once
//! ([`dual::Directions`]), which share what the values cost: a third to two thirds of one by one (bench
//! `ad`).
//!
//! # Memory
//!
//! By default the value and what the pullback needs are computed in one go, and the pullback holds
//! what it needs until it is called: a loop holds that of each iteration. Two forms of
//! `#[differentiable(checkpoint)]` store less and compute again:
//!
//! | on | holds | time |
//! |---|---|---|
//! | a function, or a method of an `impl` block | its arguments | its value is computed twice |
//! | a loop of n iterations in a differentiable function | about √n times the variables that the loop changes (up to 2√n, where n is not known before), and in the reverse sweep what √n iterations need | its body is computed twice |
//!
//! What runs twice has to do the same twice: random numbers are drawn before, and passed in.
//! A `for` loop so marked that is left early does nothing in the iterations that are left. What it uses of
//! `self`, and of what is borrowed as `&mut`, is copied before the loop and written back after it, so
//! that has to be `Clone`. Checkpoints of loops within checkpointed functions multiply:
//! each level computes its part once more.
//!
//! ```
//! use ad::differentiable;
//!
//! /// A logistic map, which the gradient follows for a million steps with a thousand states.
//! #[differentiable]
//! fn logistic(growth: f64, start: f64) -> f64 {
//!     let mut x = start;
//!     #[differentiable(checkpoint)]
//!     for _ in 0..1_000_000 {
//!         x = growth * x * (1.0 - x);
//!     }
//!     x
//! }
//!
//! let (by_growth, by_start) = logistic::grad(2.5, 0.3);
//! assert!((by_growth - 1.0 / 2.5_f64.powi(2)).abs() < 1e-12 && by_start.abs() < 1e-12);
//! ```
//!
//! # Generic scalars
//!
//! A function generic over `S:` [`Real`] runs at `f32`, at `f64` and on [`Dual`] numbers. That gives
//! forward mode, an independent check of the adjoint, and, with dual numbers under the adjoint,
//! second derivatives:
//!
//! ```
//! use ad::{Dual, Real, differentiable};
//!
//! #[differentiable]
//! fn rosenbrock<S: Real>(x: S, y: S) -> S {
//!     let a = S::ONE - x;
//!     let b = y - x * x;
//!     a * a + S::from_f64(100.0) * b * b
//! }
//!
//! // The Hessian times the direction (1, 0), at (1, 1): what `ad::hvp` does.
//! let (by_x, by_y) = rosenbrock::grad(Dual::new(1.0, 1.0), Dual::constant(1.0));
//! assert_eq!((by_x.derivative, by_y.derivative), (802.0, -400.0));
//! ```
//!
//! Two things differ from plain code. [`Vec3<S>`](Vec3) does not tell the compiler what `S` is, so
//! calls name it: `shade::<S>(..)`. And a comparison is a [`Mask`], with which
//! [`select`](fn@select) chooses, so that the scalar may also be several numbers side by side.
//!
//! The same functions run on the variables of a [`tape`] that is recorded at run time: for a
//! gradient without the attribute, and to compare with.
//!
//! # Beside other ways to derivatives
//!
//! | | time for a gradient by n inputs | what it asks of the code | what it gives |
//! |---|---|---|---|
//! | `#[differentiable]` | value and gradient 1.4 to 3.3 times the value (measured, by the benches) | the attribute on what is called; stable Rust | exact; first order, and second by dual numbers under the adjoint |
//! | [`tape`], recorded at run time | 6 to 88 times the value (measured) | functions generic over the scalar | exact; any control flow, also through foreign generic code |
//! | [`Dual`] numbers | n runs at about the cost of the value and one tangent each | functions generic over the scalar | exact; the better choice for one or two inputs |
//! | [finite differences](check::gradient) | 2n values, and more with step control | nothing | half of the digits, fewer near kinks and in single precision; a check of the others |
//! | Enzyme, by nightly's `std::autodiff` | value and gradient 3.6 to 19 times the value (on four of the benches' programs, on another machine) | a nightly compiler with its plugin and fat LTO; no generic functions | exact; works on what the optimiser leaves, so it also sees into code without attributes |
//!
//! Four of ADBench's objectives, written as ordinary Rust, agree with its published derivatives to 12
//! digits: `cargo run --release -p ad --example adbench -- FOLDER` compares them.
//!
//! # Checking a gradient
//!
//! [`check::gradient`] differentiates numerically, with step control, and shares no code with the
//! rules. [`check::assert_rule`] compares a pullback with it, of any function, and
//! [`check::assert_forward`] a forward mode; [`check::worst`] and [`check::worst_forward`] tell the
//! component with the greatest error.

//!
//! # Coming from JAX, Zygote, Enzyme, `std::autodiff`
//!
//! | there | here |
//! |---|---|
//! | `jax.grad(f)`, `Zygote.gradient(f, x...)` | [`f::grad(x, ..)`](crate): by all parameters; `#[constant]` leaves one out |
//! | `jax.value_and_grad(f)` | `f::value_and_grad(x, ..)` |
//! | `jax.vjp(f, x)`, `Zygote.pullback(f, x)` | `f::vjp(x)`: value and pullback, which is called once |
//! | `jax.jvp(f, x, t)`, Enzyme's `Forward` | `f::jvp(x, t)`; tangents stand behind all arguments |
//! | `jax.jacfwd`, `jax.jacrev`, `jax.hessian` | [`jacobian_forward`], [`jacobian_reverse`], [`hessian`]; [`hvp`] for products |
//! | `jax.lax.stop_gradient(x)`, `Zygote.ignore(f)` | [`stop_gradient`]`(x)`, [`no_diff`]`(\|\| f(x))` |
//! | `@jax.custom_vjp`, `@adjoint`, `rrule` | [`#[differentiable(vjp = rule)]`](#rules-written-by-hand) |
//! | `jax.checkpoint`, `Zygote.checkpointed` | [`#[differentiable(checkpoint)]`](#memory), on functions and loops |
//! | pytrees, structural tangents | the tangent of a struct is a struct: [`Differentiable`] |
//! | `jax.vmap` | none; [`Real`] runs a function on SIMD lanes |
//! | `#[autodiff_reverse(df, Active, Const, Duplicated)]` | `#[differentiable]`; activity follows from types and `#[constant]` |
//!
//! **JAX** traces: it sees the operations of one run, so Python's `if` on a value needs `lax.cond`, arrays
//! are not changed in place, and random keys are passed by hand. Here the source is transformed: `if`,
//! `while`, `return` and `x[i] = ..` are what they are, and a generator is a [`#[constant] rng: &mut
//! Rng`](#what-is-refused-and-what-is-trusted). A function that is not differentiable is a compile error, not
//! an error of a run. There is no compiler for accelerators behind it.
//!
//! **Zygote** is the same idea, pullbacks as closures. Differences: changing in place is differentiated, and
//! what a loop needs lies on one tape instead of in a closure for each iteration; a gradient by nothing is
//! zero, never `nothing`; and the derivative of a callee has to be there when the caller is compiled, by
//! the attribute on it or by a rule.
//!
//! **Enzyme** and **`std::autodiff`** transform what the optimiser leaves. They see into code without
//! attributes, and need a compiler with their plugin. Here each function that is called carries the
//! attribute, on stable Rust; functions may be generic; and a `&mut` parameter needs no shadow from the
//! caller: [its cotangent goes in and comes out](#changing-things-in-place) as a value.
//!
//! A cotangent is a value of its own type, made by the pullback, where Enzyme adds to shadows that the
//! caller has made. To sum gradients over many samples, write the sum into the function, or add the results.

extern crate self as ad;

mod assigning;
mod boxed;
pub mod check;
mod containers;
mod differentiable;
pub mod dual;
pub mod fields;
pub mod function;
mod jacobian;
#[cfg(feature = "lanes")]
pub mod lanes;
mod real;
#[doc(hidden)]
pub mod rt;
pub mod rules;
mod second_order;
pub mod tape;
pub mod vector;

pub use ad_macros::{Differentiable, Fields, differentiable};
pub use boxed::Boxed;
pub use differentiable::{Additive, Differentiable, NoDerivative, NoTangent, Shape, Tangent};
pub use dual::Dual;
pub use fields::{Field, Fields};
pub use function::{DifferentiableFn, ForwardFn};
pub use jacobian::{Pushforward, jacobian, jacobian_forward, jacobian_reverse};
pub use real::{Mask, Real, Scalar, Select};
pub use rules::{no_diff, select, stop_gradient};
pub use second_order::{hessian, hvp};

/// The first gradient of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

/// The vector of three scalars `S`.
pub type Vec3<S> = <S as Real>::Vec3;
