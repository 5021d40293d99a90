//! Balls of light, found among many.
//!
//! In: balls. Out: the first that a ray meets. Up to a few are looked at one by one; more are kept in boxes in boxes, so that ten thousand
//! cost a ray little more than ten.

use crate::surface::{Ray, Shape};
use glam::DVec3;

/// So many balls are looked at one by one.
const FEW: usize = 4;

/// A point whose squared distance is this near to the squared radius, as a part of it, is on the sphere: what a ray that leaves it starts
/// from.
const ON_BALL: f64 = 1e-12;

/// A ball with what it stands for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    /// Which emitter it is.
    pub emitter: usize,
    /// Its middle.
    pub center: DVec3,
    /// Its radius.
    pub radius: f64,
}

/// Balls in boxes.
#[derive(Clone, Debug, Default)]
pub struct Balls {
    list: Vec<Ball>,
    boxes: Vec<Node>,
}

/// A box, and what is in it: its first child follows it, or it holds balls.
#[derive(Clone, Debug)]
struct Node {
    shape: Shape,
    /// Where among all boxes its second child is.
    second: usize,
    balls: std::ops::Range<usize>,
}

impl Balls {
    /// Puts balls into boxes.
    pub fn new(list: Vec<Ball>) -> Self {
        let mut balls = Balls { list, boxes: Vec::new() };
        if !balls.list.is_empty() {
            balls.part(0, balls.list.len());
        }
        balls
    }

    /// The box of balls `start..end`, halved across its longest side while there are more than a few.
    fn part(&mut self, start: usize, end: usize) {
        let balls = &self.list[start..end];
        let min = balls.iter().map(|ball| ball.center - ball.radius).reduce(DVec3::min).unwrap_or_default();
        let max = balls.iter().map(|ball| ball.center + ball.radius).reduce(DVec3::max).unwrap_or_default();
        let here = self.boxes.len();
        self.boxes.push(Node { shape: Shape::Box { min, max }, second: 0, balls: start..end });
        if end - start <= FEW {
            return;
        }
        let axis = (0..3).max_by(|&a, &b| (max - min)[a].total_cmp(&(max - min)[b])).unwrap_or(0);
        let by_axis = |a: &Ball, b: &Ball| a.center[axis].total_cmp(&b.center[axis]).then(a.emitter.cmp(&b.emitter));
        self.list[start..end].sort_by(by_axis);
        let middle = (start + end) / 2;
        self.part(start, middle);
        self.boxes[here].second = self.boxes.len();
        self.boxes[here].balls = 0..0;
        self.part(middle, end);
    }

    /// The first ball that a ray meets before `end`: the distance and the emitter.
    pub fn first(&self, ray: &Ray, end: f64) -> Option<(f64, usize)> {
        let (mut end, mut first) = (end, None);
        let mut open = [0; 64];
        let mut count = usize::from(!self.boxes.is_empty());
        while count > 0 {
            count -= 1;
            let at = open[count];
            let node = &self.boxes[at];
            if self.boxes.len() > 1 && node.shape.span(ray).is_none_or(|(near, _)| near > end) {
                continue;
            }
            if node.balls.is_empty() {
                // Halving makes no more than 64 levels of anything that fits in memory.
                (open[count], open[count + 1]) = (node.second, at + 1);
                count += 2;
            }
            for ball in &self.list[node.balls.clone()] {
                if let Some(t) = meet(ray, ball.center, ball.radius)
                    && t < end
                {
                    (end, first) = (t, Some((t, ball.emitter)));
                }
            }
        }
        first
    }
}

/// The first distance > 0 at which a ray is on a sphere.
pub fn meet(ray: &Ray, center: DVec3, radius: f64) -> Option<f64> {
    let to = center - ray.origin;
    let middle = to.dot(ray.direction);
    let off = to - ray.direction * middle;
    let squared = radius * radius;
    let half = squared - off.length_squared();
    if half < 0.0 {
        return None;
    }
    let half = half.sqrt();
    // From the sphere itself a ray goes out or in, and does not meet it where it starts.
    if (to.length_squared() / squared - 1.0).abs() < ON_BALL {
        return Some(2.0 * middle).filter(|&t| t > radius * ON_BALL);
    }
    [middle - half, middle + half].into_iter().find(|&t| t > 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::transport::sobol::numbers;
    use crate::render::transport::warp::on_sphere;

    #[test]
    fn boxes_find_what_looking_at_all_finds() {
        for count in [0u64, 1, 4, 5, 9, 300] {
            let ball = |k: u64| {
                let ([x, y], [z, r]) = (numbers(k, 0, 0, 0), numbers(k, 0, 1, 0));
                Ball { emitter: k as usize, center: DVec3::new(x, y, z) * 10.0, radius: 0.05 + 0.3 * r }
            };
            let list: Vec<Ball> = (0..count).map(ball).collect();
            let balls = Balls::new(list.clone());
            for k in 0..500 {
                let [x, y] = numbers(k, 1, 2, 0);
                let ray = Ray::new(DVec3::new(x * 10.0, y * 10.0, 5.0), on_sphere(numbers(k, 1, 3, 0)));
                let each = list.iter().filter_map(|ball| Some((meet(&ray, ball.center, ball.radius)?, ball.emitter)));
                let expected = each.filter(|met| met.0 < 7.0).min_by(|a, b| a.0.total_cmp(&b.0));
                assert_eq!(balls.first(&ray, 7.0), expected, "{count} {k}");
            }
        }
    }
}
