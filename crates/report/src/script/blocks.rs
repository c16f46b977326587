//! Blocks of numbers for the page's script: zlib, base64, little-endian, each in an element of its own.

use std::collections::HashMap;
use std::io::Write;
use std::rc::Rc;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::ZlibEncoder;

/// The page's blocks, by their numbers. Equal ones are held once.
#[derive(Default)]
pub struct Blocks {
    texts: Vec<Rc<str>>,
    known: HashMap<Rc<str>, usize>,
}

impl Blocks {
    /// Adds a block; its number, which is that of an equal one where there is one.
    pub fn add(&mut self, bytes: &[u8]) -> usize {
        self.hold(packed(bytes).into())
    }

    /// As [`Blocks::add`], where the block takes at most `room` bytes of the page.
    pub fn add_within(&mut self, bytes: &[u8], room: usize) -> Option<usize> {
        let text = packed(bytes);
        (text.len() <= room).then(|| self.hold(text.into()))
    }

    /// Takes over a block of others; its number here.
    pub fn take(&mut self, others: &Blocks, number: usize) -> usize {
        self.hold(others.texts[number].clone())
    }

    fn hold(&mut self, text: Rc<str>) -> usize {
        if let Some(&number) = self.known.get(&text) {
            return number;
        }
        self.texts.push(text.clone());
        self.known.insert(text, self.texts.len() - 1);
        self.texts.len() - 1
    }

    /// How much of the page a block takes, in bytes.
    pub fn size(&self, number: usize) -> usize {
        self.texts[number].len()
    }

    /// The elements `block-0`, `block-1` … that hold them.
    pub fn elements(&self) -> String {
        let element = |(k, text): (usize, &Rc<str>)| {
            format!("<script type=\"text/plain\" id=\"block-{k}\">{text}</script>\n")
        };
        self.texts.iter().enumerate().map(element).collect()
    }
}

fn packed(bytes: &[u8]) -> String {
    let mut packed = ZlibEncoder::new(Vec::new(), Compression::best());
    // Writing to a Vec cannot fail.
    let packed = packed.write_all(bytes).and_then(|()| packed.finish()).unwrap_or_default();
    STANDARD.encode(packed)
}

/// A JSON text as it may stand in a `<script>`: no name can end the element.
pub fn json_element(id: &str, json: &str) -> String {
    let safe = json.replace('<', "\\u003c").replace('\u{2028}', "\\u2028").replace('\u{2029}', "\\u2029");
    format!("<script type=\"application/json\" id=\"{id}\">{safe}</script>\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_cannot_end_the_element() {
        let text = json_element("view-data", r#"{"name":"</script><script>"}"#);
        assert_eq!(text.matches("</script>").count(), 1);
        assert!(text.contains(r"\u003c/script>\u003cscript>"));
    }

    #[test]
    fn equal_blocks_are_held_once() {
        let mut blocks = Blocks::default();
        assert_eq!([blocks.add(&[1, 2]), blocks.add(&[3]), blocks.add(&[1, 2])], [0, 1, 0]);
        let mut others = Blocks::default();
        assert_eq!((others.take(&blocks, 1), others.add(&[3])), (0, 0));
        assert_eq!(others.elements().matches("<script").count(), 1);
    }
}
