//! What the page holds, in its order. This is the one place that says so.

use crate::chapter::figure::{Chapter, Section};
use crate::histories::Recorded;
use crate::language::say;
use crate::source::Source;
use crate::{
    bolts, damage, energy, free_field, input, interfaces, section_forces, section_maps, spectra, stages,
};

/// A section in its place.
pub struct Placed {
    /// By which the page can be pointed into; once on a page.
    pub id: String,
    pub heading: String,
    pub content: Content,
}

/// What a section is made of.
pub enum Content {
    /// Figures, tables and texts.
    Section(Section),
    /// What the template sets under this id.
    Template,
}

/// The sections so far.
#[derive(Default)]
struct Contents(Vec<Placed>);

impl Contents {
    /// Sections that the code makes, none or several; further ones have a number behind the id.
    fn put(&mut self, id: &str, sections: impl IntoIterator<Item = Section>) {
        for (number, section) in sections.into_iter().enumerate() {
            let id = match number {
                0 => id.to_owned(),
                more => format!("{id}-{}", more + 1),
            };
            self.0.push(Placed { id, heading: section.heading().into(), content: Content::Section(section) });
        }
    }

    /// A chapter, which knows its id.
    fn tell(&mut self, chapter: Option<Chapter>) {
        if let Some(chapter) = chapter {
            self.put(chapter.id, [Section::Told(chapter)]);
        }
    }

    /// A section of the template, where there is something to set.
    fn set(&mut self, id: &str, heading: String, there: bool) {
        if there {
            self.0.push(Placed { id: id.into(), heading, content: Content::Template });
        }
    }
}

/// All sections of the page. `view` says whether the page holds the model in three dimensions.
pub fn sections(source: &Source, view: bool) -> Vec<Placed> {
    let (language, facts) = (source.language, source.facts());
    let shakes = source.shakes();
    let when =
        |shown: bool, section: fn(&Source) -> Option<Section>| if shown { section(source) } else { None };
    let recorded = shakes.then(|| Recorded::of(source));
    let (recorded, missing) = match recorded {
        Some(Ok(recorded)) => (Some(recorded), None),
        Some(Err(section)) => (None, Some(section)),
        None => (None, None),
    };
    let mut page = Contents::default();

    page.set("findings", say!(language, "What was found"), true);
    page.set("model-view", say!(language, "The model in three dimensions"), view);

    // The paper's figures: 2 and 3, 4, 5, 6, 7 and 8, 9.
    page.put("section-mesh", section_maps::mesh::section(source));
    page.set("shaking", say!(language, "Earthquake"), source.still().is_some());
    page.put("input", when(shakes, input::section));
    page.put("histories", missing);
    page.put("displacement", recorded.as_ref().map(Recorded::displacement));
    page.put("displacement-less-mean", recorded.as_ref().and_then(Recorded::beside_mean));
    page.put("relative", recorded.as_ref().map(Recorded::relative));
    page.put("stress", recorded.as_ref().map(Recorded::stress));
    page.put("stress-elastic", recorded.as_ref().and_then(Recorded::elastic_stress));
    page.put("damage-map", if shakes { damage::maps::sections(source) } else { Vec::new() });
    page.put("damage-history", when(shakes, damage::growth::section));
    page.put("interface-map", interfaces::map::section(source));
    page.put("interface-history", when(shakes, interfaces::history::section));
    page.put("interface-monitors", when(shakes, interfaces::monitors::section));
    page.put("section", if shakes { section_maps::sections(source) } else { Vec::new() });

    page.tell(section_forces::chapter(source));
    page.tell(stages::chapter(source));
    page.put("spectra", when(shakes, spectra::section));
    page.put("depth", when(shakes, free_field::depth::section));
    page.tell(bolts::chapter(source));
    page.put("free-field", when(shakes, free_field::section));
    page.put("velocity", recorded.as_ref().map(Recorded::velocity));
    page.put("acceleration", recorded.as_ref().map(Recorded::acceleration));
    page.put("further", recorded.iter().flat_map(Recorded::others));

    page.set("peaks", say!(language, "Peaks"), source.still().is_none());
    page.set("damage", say!(language, "Damage"), !damage::tables(language, &facts).is_empty());
    page.set("interfaces", say!(language, "Interfaces"), interfaces::table(source, &facts).is_some());
    page.put("energy", shakes.then(|| energy::section(source)));
    page.set("trust", say!(language, "Can these results be trusted?"), true);

    let model = match source.still() {
        Some(_) => say!(language, "Model"),
        None => say!(language, "Model and motion"),
    };
    page.set("model", model, true);
    page.set("materials", say!(language, "Materials"), !facts.computed.materials.is_empty());
    page.set("defaulted", say!(language, "Assumptions and defaults"), true);
    page.set("case", say!(language, "The case"), source.case.is_some());
    page.set("run", say!(language, "How it was run"), true);
    page.0
}
