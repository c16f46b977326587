//! What the page's tables say of laws has a Chinese text, and no Chinese text is of a law that is gone.

use crate::chinese::lacking;
use crate::every_law::samples::samples;
use std::collections::BTreeSet;
use tremolite_kernels::laws;
use tremolite_laws::band::Band;
use tremolite_laws::interfaces::INTERFACES;
use tremolite_laws::materials::MATERIALS;
use tremolite_laws::{Kind, Parameter, Value, Values};
use tremolite_report::chinese::materials::LAWS;

/// As the page shows it: what follows a semicolon is for who writes the case.
fn shown(text: &str) -> String {
    text.split("; ").next().unwrap_or_default().to_owned()
}

/// A sample as it is, with each word of each of its parameters, and these with a fracture energy as well.
fn variants(parameters: &[Parameter], sample: Values) -> Vec<Values> {
    let mut all = vec![sample.clone()];
    for parameter in parameters {
        let Kind::Word(words) = parameter.kind else { continue };
        all.extend(words.iter().map(|word| {
            let mut values = sample.clone();
            values.0.insert(parameter.name.to_owned(), Value::Word((*word).to_owned()));
            values
        }));
    }
    let with_energy = |values: &Values| {
        let mut values = values.clone().with("fracture_energy", 130.0);
        values.0.remove("ultimate_strain_ratio");
        values
    };
    let more: Vec<Values> = all.iter().map(with_energy).collect();
    all.extend(more);
    all
}

/// What laws and parameters are, what laws make of the parameters of all samples, and what water adds to these.
fn texts() -> BTreeSet<String> {
    let infos = || MATERIALS.iter().chain(INTERFACES);
    let mut texts: BTreeSet<String> = infos().map(|info| shown(info.summary)).collect();
    texts.extend(infos().flat_map(|info| info.parameters).map(|parameter| shown(parameter.doc)));
    let band = Band::fit(0.02, [0.5, 10.0], 2.0).unwrap();
    for law in laws() {
        for values in
            samples(law.info.name).iter().flat_map(|sample| variants(law.info.parameters, sample.values()))
        {
            // Not every law takes every word with every number.
            let built = [(law.build)(&values), (law.build_banded)(&values, band)].into_iter().flatten();
            texts.extend(built.flat_map(|law| law.derived([0.2, 1.0])).map(|derived| shown(derived.doc)));
        }
    }
    texts.extend(tremolite::setup::MEANINGS_OF_WATER.map(str::to_owned));
    texts
}

#[test]
fn every_law_and_every_value_of_one_has_a_chinese_text_and_no_other_has() {
    let (texts, chinese) = (texts(), LAWS.iter().map(|(english, _)| (*english).to_owned()).collect());
    let missing = texts.difference(&chinese).map(|text| format!("a law: no Chinese for \"{text}\""));
    lacking(&missing.collect::<Vec<_>>());
    let gone: Vec<_> = chinese.difference(&texts).collect();
    assert!(gone.is_empty(), "no law says {gone:#?}");
}
