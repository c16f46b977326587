//! Nodes that move as one: periodic sides, the reference column, later slabs.

/// Sets of tied nodes, as a forest whose roots are the smallest nodes.
#[derive(Clone, Debug)]
pub struct Ties {
    parent: Vec<u32>,
}

impl Ties {
    /// `nodes` nodes, none tied.
    pub fn new(nodes: usize) -> Self {
        Ties { parent: (0..nodes as u32).collect() }
    }

    fn root(&mut self, mut node: u32) -> u32 {
        while self.parent[node as usize] != node {
            let above = self.parent[self.parent[node as usize] as usize];
            self.parent[node as usize] = above;
            node = above;
        }
        node
    }

    /// Ties two nodes, and with them all that are tied to either.
    pub fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        self.parent[a.max(b) as usize] = a.min(b);
    }

    /// Of every node, the smallest of its set.
    pub fn roots(mut self) -> Vec<u32> {
        (0..self.parent.len() as u32).map(|node| self.root(node)).collect()
    }

    /// Master of every engine node: the first engine node of its set.
    pub fn masters(mut self, mesh_node: &[u32], engine_node: &[u32]) -> Vec<u32> {
        let mut first = vec![u32::MAX; engine_node.len()];
        mesh_node
            .iter()
            .enumerate()
            .map(|(engine, &node)| {
                let root = self.root(node) as usize;
                if first[root] == u32::MAX {
                    first[root] = engine as u32;
                }
                first[root]
            })
            .collect()
    }
}
