//! The cheapest way to part what has two sides: minimum cut by maximum flow (Dinic 1970, by levels and blocking flows).

/// Below this share of the largest capacity nothing is left of one.
const NOTHING: f64 = 1e-12;

/// Points with what they cost on the one side or the other, and links between the sides.
pub(super) struct Flow {
    /// For each point its links, as indices into `ends` and `left`; a link and its reverse lie beside one another.
    links: Vec<Vec<usize>>,
    ends: Vec<usize>,
    left: Vec<f64>,
    nothing: f64,
}

impl Flow {
    /// Points 0 (where flow begins), 1 (where it ends) and as many more.
    pub fn new(points: usize) -> Flow {
        Flow { links: vec![Vec::new(); points + 2], ends: Vec::new(), left: Vec::new(), nothing: 0.0 }
    }

    /// A link with its capacity.
    pub fn link(&mut self, from: usize, to: usize, capacity: f64) {
        for (from, to, capacity) in [(from, to, capacity), (to, from, 0.0)] {
            self.links[from].push(self.ends.len());
            self.ends.push(to);
            self.left.push(capacity);
        }
        self.nothing = self.nothing.max(NOTHING * capacity);
    }

    /// The points on the side of point 0 of the cheapest cut.
    pub fn cut(mut self) -> Vec<bool> {
        loop {
            let levels = self.levels();
            if levels[1] == usize::MAX {
                return levels.into_iter().map(|level| level != usize::MAX).collect();
            }
            let mut next = vec![0; self.links.len()];
            while self.push(&levels, &mut next) {}
        }
    }

    fn levels(&self) -> Vec<usize> {
        let mut levels = vec![usize::MAX; self.links.len()];
        levels[0] = 0;
        let mut queue = std::collections::VecDeque::from([0]);
        while let Some(at) = queue.pop_front() {
            for &link in &self.links[at] {
                let to = self.ends[link];
                if self.left[link] > self.nothing && levels[to] == usize::MAX {
                    levels[to] = levels[at] + 1;
                    queue.push_back(to);
                }
            }
        }
        levels
    }

    /// Pushes along one way, without recursion; nothing if there is none left by these levels.
    fn push(&mut self, levels: &[usize], next: &mut [usize]) -> bool {
        let mut way: Vec<usize> = Vec::new();
        let mut at = 0;
        while at != 1 {
            let goes = (next[at]..self.links[at].len()).find(|&k| {
                let link = self.links[at][k];
                let to = self.ends[link];
                self.left[link] > self.nothing && levels[to] != usize::MAX && levels[to] == levels[at] + 1
            });
            match goes {
                Some(k) => {
                    next[at] = k;
                    way.push(self.links[at][k]);
                    at = self.ends[self.links[at][k]];
                }
                None => {
                    next[at] = self.links[at].len();
                    let Some(back) = way.pop() else { return false };
                    at = self.ends[back ^ 1];
                    next[at] += 1;
                }
            }
        }
        let most = way.iter().map(|&link| self.left[link]).fold(f64::INFINITY, f64::min);
        for link in way {
            self.left[link] -= most;
            self.left[link ^ 1] += most;
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cheapest_of_all_cuts_is_found() {
        // Four points on one side, three on the other; all 2^7 choices are tried.
        let costs = [3.0, 1.0, 2.0, 5.0, 2.0, 4.0, 1.5];
        let links =
            [(0, 4, 1.0), (0, 5, 9.0), (1, 5, 2.0), (2, 6, 0.5), (3, 6, 9.0), (3, 4, 9.0), (2, 5, 3.0)];
        let price = |taken: &[bool]| -> f64 {
            let points: f64 = (0..7).filter(|&p| taken[p]).map(|p| costs[p]).sum();
            let open = links.iter().filter(|(a, b, _)| !taken[*a] && !taken[*b]);
            points + open.map(|(_, _, cost)| cost).sum::<f64>()
        };
        let all = (0..128).map(|bits| price(&(0..7).map(|p| bits >> p & 1 == 1).collect::<Vec<_>>()));
        let best = all.fold(f64::INFINITY, f64::min);
        let mut flow = Flow::new(7);
        (0..4).for_each(|p| flow.link(0, p + 2, costs[p]));
        (4..7).for_each(|p| flow.link(p + 2, 1, costs[p]));
        links.iter().for_each(|&(a, b, cost)| flow.link(a + 2, b + 2, cost));
        let near = flow.cut();
        let taken: Vec<bool> = (0..7).map(|p| if p < 4 { !near[p + 2] } else { near[p + 2] }).collect();
        assert!((price(&taken) - best).abs() < 1e-12, "{} {best}", price(&taken));
    }
}
