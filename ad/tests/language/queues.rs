//! `VecDeque`s of numbers.

use std::collections::VecDeque;

use ad::{Differentiable, differentiable};

use crate::oracle::{assert_close, check, check_list};

#[derive(Clone, Debug, Differentiable)]
struct Average {
    window: VecDeque<f64>,
    sum: f64,
}

#[differentiable]
impl Average {
    fn add(&mut self, x: f64, #[constant] size: usize) -> f64 {
        self.window.push_back(x);
        self.sum += x;
        if self.window.len() > size {
            self.sum -= self.window.pop_front().unwrap();
        }
        self.sum / self.window.len() as f64
    }
}

#[differentiable]
fn moving_average(x: &[f64]) -> f64 {
    let mut average = Average { window: VecDeque::new(), sum: 0.0 };
    let mut total = 0.0;
    for (i, x) in x.iter().enumerate() {
        total += average.add(x * x, 3) * (i + 1) as f64;
    }
    let kept = average.window.clone();
    total * kept[1] + average.window.iter().map(|x| x.sin()).sum::<f64>()
}

#[differentiable]
fn both_ends(x: f64, y: f64) -> f64 {
    let mut queue = VecDeque::new();
    let mut total = queue.pop_back().unwrap_or(x);
    for i in 0..6 {
        if i % 2 == 0 {
            queue.push_front(x * i as f64 + y);
        } else {
            queue.push_back(total * y);
        }
        if queue.len() > 3 {
            let (first, last) = (queue.pop_front(), queue.pop_back());
            total += first.unwrap() * last.unwrap();
        }
    }
    while let Some(next) = queue.pop_front() {
        total += next * next;
        if total > 40.0 {
            queue.clear();
        }
    }
    total
}

/// Nothing flows to the elements at the end.
#[differentiable]
fn first_ones(x: f64, y: f64) -> f64 {
    let mut queue = VecDeque::new();
    for i in 0..5 {
        queue.push_back(x * i as f64 + y);
    }
    let mut shorter = queue.clone();
    let last = shorter.pop_back().unwrap() * shorter[0];
    let mut turned = queue.clone();
    turned.rotate_left(1);
    let mut swapped = queue.clone();
    swapped.swap(0, 4);
    queue.push_back(x);
    queue[1] * last * turned[0] + swapped[0] * y
}

#[differentiable]
fn turn(queue: &mut VecDeque<f64>, by: f64) {
    queue[0] *= by;
    queue.rotate_left(2);
    queue.swap(0, 1);
    for x in queue.iter_mut() {
        *x += by;
    }
    queue.push_back(by);
    queue.rotate_right(1);
    queue.truncate(4);
}

#[differentiable]
fn weighted(queue: &VecDeque<f64>, y: f64) -> f64 {
    let mut total = 0.0;
    for (i, x) in queue.iter().enumerate() {
        total += x * y * (i + 1) as f64;
    }
    total * queue[queue.len() - 1]
}

#[differentiable]
fn turned(x: f64, y: f64) -> f64 {
    let mut queue = VecDeque::new();
    for i in 0..5 {
        queue.push_back(x * y + i as f64 * x);
    }
    turn(&mut queue, y);
    weighted(&queue, x)
}

#[differentiable]
fn breadth_first(x: f64, y: f64) -> f64 {
    let mut rows: VecDeque<Vec<f64>> = VecDeque::new();
    rows.push_back(vec![x, y]);
    let mut total = 1.0;
    while let Some(row) = rows.pop_front() {
        total += total * row[0] * row[1];
        if row.len() < 4 {
            let mut longer = row.clone();
            longer.push(row[0] * row[1]);
            rows.push_back(longer);
            rows.push_front(vec![row[1], total, x, y]);
        }
    }
    total
}

#[test]
fn queues() {
    check_list!(moving_average at [0.5, -0.9, 1.3, 0.7, 1.4]);
    check!(both_ends(x, y) at [0.5, 0.7], [-1.1, 0.4], [1.7, -0.6]);
    check!(first_ones(x, y) at [0.5, 0.7], [-1.1, 0.4], [1.7, -0.6]);
    check!(turned(x, y) at [0.5, 0.7], [-1.1, 0.4], [1.7, -0.6]);
    check!(breadth_first(x, y) at [0.5, 0.7], [-1.1, 0.4], [1.7, -0.6]);
    // The gradient has the size of the queue.
    let queue = VecDeque::from([0.5, 2.0, 1.5]);
    let (by_queue, by_y) = weighted::grad(&queue, 2.0);
    assert_eq!(by_queue, [3.0, 6.0, 9.0 + 18.0]);
    assert_close("y", by_y, 9.0 * 1.5, 1e-12);
}
