//! Blocks of numbers for the page's script: zlib, base64, little-endian, each in an element of its own.

use std::io::Write;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::ZlibEncoder;

/// The page's blocks, by their numbers.
#[derive(Default)]
pub struct Blocks {
    texts: Vec<String>,
}

impl Blocks {
    /// Adds a block; its number.
    pub fn add(&mut self, bytes: &[u8]) -> usize {
        let mut packed = ZlibEncoder::new(Vec::new(), Compression::best());
        // Writing to a Vec cannot fail.
        let packed = packed.write_all(bytes).and_then(|()| packed.finish()).unwrap_or_default();
        self.texts.push(STANDARD.encode(packed));
        self.texts.len() - 1
    }

    /// How much of the page all blocks take, in bytes.
    pub fn size(&self) -> usize {
        self.texts.iter().map(String::len).sum()
    }

    /// The elements `block-0`, `block-1` … that hold them.
    pub fn elements(&self) -> String {
        let element = |(k, text): (usize, &String)| {
            format!("<script type=\"text/plain\" id=\"block-{k}\">{text}</script>\n")
        };
        self.texts.iter().enumerate().map(element).collect()
    }
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
}
