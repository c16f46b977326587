//! Waves at angles, in words.

use tremolite_results::{MotionFacts, Wave, WavePart};

use crate::language::{Language, say};
use crate::quantities::scale::{figures, quantity, trimmed};

/// What a wave is times which components of the record: one after the other.
fn parts(language: Language, wave: &Wave) -> String {
    let part = |part: &WavePart| {
        let component = match part.component.as_str() {
            "east" => say!(language, "east"),
            "north" => say!(language, "north"),
            _ => say!(language, "up"),
        };
        let factor = trimmed(&figures(part.factor, 3));
        match part.phase == 0.0 {
            true => say!(language, "{factor} × {component}", factor = factor, component = component),
            false => say!(
                language,
                "{factor} × {component}, turned by {phase}° in phase",
                factor = factor,
                component = component,
                phase = trimmed(&figures(part.phase.to_degrees(), 3))
            ),
        }
    };
    wave.parts.iter().map(part).collect::<Vec<_>>().join(" + ")
}

/// Of each wave what it is, its way, and what of the record it carries with how fast its field goes along the ground.
pub fn lines(language: Language, motion: &MotionFacts) -> Vec<[String; 3]> {
    let of = |wave: &Wave| {
        let degrees = |angle: f64| trimmed(&format!("{:.2}", angle.to_degrees()));
        let value = say!(
            language,
            "{angle}° from the vertical towards {azimuth}°",
            angle = degrees(wave.angle),
            azimuth = degrees(wave.azimuth)
        );
        let mut note = parts(language, wave);
        if wave.apparent_velocity.is_finite() {
            note.push_str(&say!(
                language,
                "; its field goes along the ground with {velocity}",
                velocity = quantity("m/s", wave.apparent_velocity)
            ));
        }
        if !wave.arrives {
            note.push_str(&say!(
                language,
                "; beyond a critical angle, or turned in phase: the field fades in before the wave comes"
            ));
        }
        [say!(language, "{kind} wave", kind = wave.kind), value, note]
    };
    motion.waves.iter().map(of).collect()
}

/// How the waves come in, behind a figure of the record: whole sentences.
pub fn words(language: Language, motion: &MotionFacts) -> String {
    say!(
        language,
        "It is carried by plane waves at angles ({waves}), which come {lead} later than in the record so that nothing moves before.",
        waves = motion
            .waves
            .iter()
            .map(|wave| format!("{} {}°", wave.kind, trimmed(&format!("{:.2}", wave.angle.to_degrees()))))
            .collect::<Vec<_>>()
            .join(", "),
        lead = quantity("s", motion.lead)
    )
}
