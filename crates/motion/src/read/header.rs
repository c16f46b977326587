//! What the headers of several formats say alike: which way a channel looks, and what it is called.

use crate::{Channel, Orientation};

/// The positive direction as a header states it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Direction {
    /// One that a channel can have.
    Along(Orientation),
    /// Vertical, downwards positive.
    Down,
    /// Not stated, or of no use: along a structure, radial.
    Unknown,
}

impl Direction {
    /// As [`Orientation::parse`], and `Down`.
    pub fn parse(label: &str) -> Direction {
        match label.trim().to_ascii_uppercase().as_str() {
            "DOWN" | "DN" | "DWN" => Direction::Down,
            other => Orientation::parse(other).map_or(Direction::Unknown, Direction::Along),
        }
    }

    /// Gives the direction to a channel; one that looks down is turned up.
    pub fn given_to(self, mut channel: Channel) -> Channel {
        channel.orientation = match self {
            Direction::Along(orientation) => Some(orientation),
            Direction::Down => Some(Orientation::Up),
            Direction::Unknown => None,
        };
        if self == Direction::Down {
            channel.acceleration.iter_mut().for_each(|a| *a = -*a);
            channel
                .remarks
                .push("The header says that down is positive; the sign was turned, so that up is.".into());
        }
        channel
    }
}

/// Numbers channels that their headers call the same, from the second on.
pub(super) fn named_apart(channels: &mut [Channel]) {
    let names: Vec<String> = channels.iter().map(|c| c.name.clone()).collect();
    for (i, channel) in channels.iter_mut().enumerate() {
        let before = names[..i].iter().filter(|name| **name == names[i]).count();
        if before > 0 {
            let number = format!(" ({})", before + 1);
            channel.name += &number;
            if !channel.label.is_empty() {
                channel.label += &number;
            }
        }
    }
}
