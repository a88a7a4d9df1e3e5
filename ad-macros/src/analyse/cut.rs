//! The fewest values that have to be stored so that all that are needed can be computed again.

use std::collections::VecDeque;

/// A graph of values, in an order in which each comes after those it is made of.
#[derive(Default)]
pub struct Graph {
    nodes: Vec<Node>,
}

struct Node {
    /// The values it can be computed from; `None` if it can only be stored.
    parents: Option<Vec<usize>>,
    needed: bool,
}

/// Half an edge of the flow network: its target, what it can still carry, and the index of the
/// other half among the edges of the target.
struct Edge {
    to: usize,
    capacity: usize,
    twin: usize,
}

/// Larger graphs are not cut, which takes time in proportion to their size times that of the cut.
const LARGEST: usize = 2000;

impl Graph {
    /// Adds a value and returns its index.
    pub fn add(&mut self, parents: Option<Vec<usize>>, needed: bool) -> usize {
        self.nodes.push(Node { parents, needed });
        self.nodes.len() - 1
    }

    /// For each value whether it is to be stored.
    ///
    /// This is a minimum vertex cut between what can only be stored and what is needed, found as a
    /// maximum flow (Edmonds & Karp 1972). Of several, it is the one nearest to what is needed,
    /// which leaves the least to be computed.
    pub fn stored(&self) -> Vec<bool> {
        if self.nodes.len() > LARGEST {
            return self.nodes.iter().map(|node| node.needed).collect();
        }
        let (source, sink) = (2 * self.nodes.len(), 2 * self.nodes.len() + 1);
        let mut network: Vec<Vec<Edge>> = (0..sink + 1).map(|_| Vec::new()).collect();
        let mut connect = |from: usize, to: usize, capacity: usize| {
            let (forth, back) = (network[from].len(), network[to].len());
            network[from].push(Edge { to, capacity, twin: back });
            network[to].push(Edge { to: from, capacity: 0, twin: forth });
        };
        // A value is an edge from 2i to 2i + 1, which is cut where the value is stored.
        const UNBOUNDED: usize = usize::MAX / 2;
        for (i, node) in self.nodes.iter().enumerate() {
            connect(2 * i, 2 * i + 1, 1);
            match &node.parents {
                Some(parents) => {
                    parents.iter().for_each(|p| connect(2 * p + 1, 2 * i, UNBOUNDED));
                }
                None => connect(source, 2 * i, UNBOUNDED),
            }
            if node.needed {
                connect(2 * i + 1, sink, UNBOUNDED);
            }
        }
        while augment(&mut network, source, sink) {}
        let reaches = reaching(&network, sink);
        (0..self.nodes.len()).map(|i| !reaches[2 * i] && reaches[2 * i + 1]).collect()
    }
}

/// Sends one unit along a shortest path, if there is one.
fn augment(network: &mut [Vec<Edge>], source: usize, sink: usize) -> bool {
    let mut arrived_by: Vec<Option<(usize, usize)>> = network.iter().map(|_| None).collect();
    let mut queue = VecDeque::from([source]);
    while let Some(from) = queue.pop_front() {
        for (index, edge) in network[from].iter().enumerate() {
            if edge.capacity > 0 && edge.to != source && arrived_by[edge.to].is_none() {
                arrived_by[edge.to] = Some((from, index));
                queue.push_back(edge.to);
            }
        }
    }
    let mut at = sink;
    while let Some((from, index)) = arrived_by[at] {
        let twin = network[from][index].twin;
        network[from][index].capacity -= 1;
        network[at][twin].capacity += 1;
        at = from;
    }
    at == source
}

/// From where the sink can still be reached.
fn reaching(network: &[Vec<Edge>], sink: usize) -> Vec<bool> {
    let mut reaches = vec![false; network.len()];
    reaches[sink] = true;
    let mut queue = VecDeque::from([sink]);
    while let Some(to) = queue.pop_front() {
        for edge in &network[to] {
            let from = edge.to;
            if !reaches[from] && network[from][edge.twin].capacity > 0 {
                reaches[from] = true;
                queue.push_back(from);
            }
        }
    }
    reaches
}

#[cfg(test)]
mod tests {
    use super::Graph;

    /// The indices of the stored values of a graph given by the parents of each.
    fn stored(nodes: &[(Option<&[usize]>, bool)]) -> Vec<usize> {
        let mut graph = Graph::default();
        for (parents, needed) in nodes {
            graph.add(parents.map(<[usize]>::to_vec), *needed);
        }
        let stored = graph.stored().into_iter().enumerate();
        stored.filter_map(|(i, stored)| stored.then_some(i)).collect()
    }

    #[test]
    fn what_needs_nothing_is_not_stored() {
        assert_eq!(stored(&[(Some(&[]), true), (Some(&[0]), true)]), []);
    }

    #[test]
    fn one_source_of_many_values_is_stored_alone() {
        let nodes: [(Option<&[usize]>, bool); 4] =
            [(None, false), (Some(&[0]), true), (Some(&[0]), true), (Some(&[1, 2]), true)];
        assert_eq!(stored(&nodes), [0]);
    }

    #[test]
    fn a_sum_of_sources_is_stored_itself() {
        assert_eq!(stored(&[(None, false), (None, false), (Some(&[0, 1]), true)]), [2]);
    }

    #[test]
    fn of_equals_the_later_is_stored() {
        assert_eq!(stored(&[(None, false), (Some(&[0]), true)]), [1]);
    }

    #[test]
    fn a_needed_source_is_stored_and_serves_others() {
        assert_eq!(stored(&[(None, true), (Some(&[0]), true)]), [0]);
    }
}
