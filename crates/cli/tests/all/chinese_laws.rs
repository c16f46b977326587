//! What the page's tables say of laws has a Chinese text, and no Chinese text is of a law that is gone.

use crate::every_law::samples::samples;
use std::collections::BTreeSet;
use tremolite_kernels::laws;
use tremolite_laws::band::Band;
use tremolite_laws::interfaces::INTERFACES;
use tremolite_laws::materials::MATERIALS;
use tremolite_report::chinese::materials::LAWS;

/// As the page shows it: what follows a semicolon is for who writes the case.
fn shown(text: &str) -> String {
    text.split("; ").next().unwrap_or_default().to_owned()
}

/// What laws and parameters are, and what laws make of the parameters of all samples.
fn texts() -> BTreeSet<String> {
    let infos = || MATERIALS.iter().chain(INTERFACES);
    let mut texts: BTreeSet<String> = infos().map(|info| shown(info.summary)).collect();
    texts.extend(infos().flat_map(|info| info.parameters).map(|parameter| shown(parameter.doc)));
    let band = Band::fit(0.02, [0.5, 10.0], 2.0).unwrap();
    for law in laws() {
        for sample in samples(law.info.name) {
            let values = sample.values();
            for built in [(law.build)(&values), (law.build_banded)(&values, band)] {
                texts.extend(built.unwrap().derived([0.2, 1.0]).iter().map(|derived| shown(derived.doc)));
            }
        }
    }
    texts
}

#[test]
fn every_law_and_every_value_of_one_has_a_chinese_text_and_no_other_has() {
    let (texts, chinese) = (texts(), LAWS.iter().map(|(english, _)| (*english).to_owned()).collect());
    let missing: Vec<_> = texts.difference(&chinese).collect();
    assert!(missing.is_empty(), "no Chinese for {missing:#?}");
    let gone: Vec<_> = chinese.difference(&texts).collect();
    assert!(gone.is_empty(), "no law says {gone:#?}");
}
