//! The header of a VTU file without its data: where these stand in the file takes their place.

use std::io::{BufRead, BufReader, SeekFrom};

use crate::input::Source;

/// Longest tag; a longer one is no XML that a program writes.
const LONGEST: u64 = 1 << 20;

/// A file's header and where its data are.
pub(super) struct Outline {
    /// Well-formed XML if the file is. The data of a `DataArray` are replaced by [`Place`]s.
    pub xml: String,
    pub appended: Option<Appended>,
}

/// The appended data of a file.
#[derive(Clone, Copy)]
pub(super) struct Appended {
    /// First byte after the mark `_`.
    pub start: u64,
    pub base64: bool,
}

/// A run of text in the file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place {
    pub start: u64,
    pub length: u64,
}

impl Place {
    /// The place that stands in an outline's XML; none if it is blank.
    pub(super) fn named(text: &str) -> Option<Self> {
        let (start, length) = text.trim().split_once('+')?;
        Some(Place { start: start.parse().ok()?, length: length.parse().ok()? })
    }
}

/// Reads on to the appended data, or to the end.
pub(super) fn outline(source: &mut dyn Source) -> Result<Outline, String> {
    source
        .seek(SeekFrom::Start(0))
        .map_err(|e| format!("it is no file but a stream ({e}); save it first"))?;
    let mut scan = Scan { from: BufReader::with_capacity(1 << 16, source), at: 0 };
    let mut xml = Vec::new();
    // How deep in a DataArray; 0 outside.
    let mut depth = 0_u32;
    loop {
        let start = scan.at;
        if depth == 1 {
            let data = scan.until(b'<', None, u64::MAX)?;
            if data {
                xml.extend(format!("{start}+{} ", scan.at - start).bytes());
            }
        } else {
            scan.until(b'<', Some(&mut xml), u64::MAX)?;
        }
        let mut tag = Vec::new();
        if !scan.tag(&mut tag)? {
            break;
        }
        if tag.starts_with(b"<!--") {
            continue;
        }
        if tag.starts_with(b"<!") {
            return Err("the header has a document type or CDATA, which VTK does not write".into());
        }
        let closing = tag.starts_with(b"</");
        let empty = tag.ends_with(b"/>");
        let name = tag[if closing { 2 } else { 1 }..]
            .split(|b| b.is_ascii_whitespace() || matches!(b, b'>' | b'/'))
            .next();
        match name {
            Some(b"AppendedData") if !closing => {
                let base64 = tag.windows(8).any(|w| w == b"\"base64\"");
                scan.until(b'_', None, u64::MAX)?;
                if scan.byte()? != Some(b'_') {
                    return Err("the appended data have no start mark `_`".into());
                }
                // Closed here the XML proper is well formed.
                xml.extend(b"</VTKFile>");
                let appended = Some(Appended { start: scan.at, base64 });
                return Ok(Outline { xml: text(xml)?, appended });
            }
            Some(b"DataArray") if depth == 0 && !empty && !closing => depth = 1,
            _ if depth > 0 && closing => depth -= 1,
            _ if depth > 0 && !empty && !tag.starts_with(b"<?") => depth += 1,
            _ => {}
        }
        xml.append(&mut tag);
    }
    Ok(Outline { xml: text(xml)?, appended: None })
}

fn text(xml: Vec<u8>) -> Result<String, String> {
    String::from_utf8(xml).map_err(|_| "the header is not UTF-8".into())
}

/// A file read byte by byte from its start.
struct Scan<'a> {
    from: BufReader<&'a mut dyn Source>,
    /// Bytes read.
    at: u64,
}

impl Scan<'_> {
    /// Reads up to a byte, which is left, or to the end; whether there was anything but blanks.
    fn until(&mut self, stop: u8, mut into: Option<&mut Vec<u8>>, most: u64) -> Result<bool, String> {
        let (mut any, end) = (false, self.at.saturating_add(most));
        loop {
            let piece = self.from.fill_buf().map_err(|e| format!("it cannot be read: {e}"))?;
            let found = piece.iter().position(|&b| b == stop);
            let length = found.unwrap_or(piece.len());
            any |= !piece[..length].trim_ascii().is_empty();
            if let Some(into) = &mut into {
                into.extend_from_slice(&piece[..length]);
            }
            let ended = piece.is_empty();
            self.from.consume(length);
            self.at += length as u64;
            if found.is_some() || ended {
                return Ok(any);
            }
            if self.at > end {
                return Err("the header has a tag without an end".into());
            }
        }
    }

    fn byte(&mut self) -> Result<Option<u8>, String> {
        let piece = self.from.fill_buf().map_err(|e| format!("it cannot be read: {e}"))?;
        let byte = piece.first().copied();
        if byte.is_some() {
            self.from.consume(1);
            self.at += 1;
        }
        Ok(byte)
    }

    /// Reads a tag or a comment, from its `<` on; false at the end of the file.
    fn tag(&mut self, tag: &mut Vec<u8>) -> Result<bool, String> {
        let mut quote = None;
        while let Some(byte) = self.byte()? {
            tag.push(byte);
            if tag.len() as u64 > LONGEST {
                return Err("the header has a tag without an end".into());
            }
            let comment = tag.starts_with(b"<!--");
            match (byte, quote) {
                _ if comment && tag.len() >= 7 && tag.ends_with(b"-->") => return Ok(true),
                _ if comment => {}
                (b'"' | b'\'', None) => quote = Some(byte),
                (_, Some(q)) if q == byte => quote = None,
                (b'>', None) => return Ok(true),
                _ => {}
            }
        }
        // What is left of a broken tag makes the XML malformed, which is told.
        Ok(false)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Cursor;

    fn of(text: &str) -> Result<Outline, String> {
        outline(&mut Cursor::new(text.as_bytes()))
    }

    #[test]
    fn data_are_replaced_by_their_places_and_all_else_stays() {
        let file = "<?xml?><V n='a>b'><!-- <DataArray> --><DataArray>12 <K>m</K> 34\n</DataArray><E/> t</V>";
        let outline = of(file).unwrap();
        let at = |data: &str| file.find(data).unwrap();
        let (first, second) = (at("12"), at(" 34"));
        let places = format!("<DataArray>{first}+3 <K>m</K>{second}+4 </DataArray>");
        assert_eq!(outline.xml, format!("<?xml?><V n='a>b'>{places}<E/> t</V>"));
        assert_eq!(Place::named(" 4+9 "), Some(Place { start: 4, length: 9 }));
        assert_eq!((Place::named(""), Place::named("4+"), Place::named("x")), (None, None, None));
    }

    #[test]
    fn appended_data_are_found_by_their_mark() {
        let file = "<VTKFile><DataArray/>\n<AppendedData encoding=\"base64\">\n  _<raw>";
        let outline = of(file).unwrap();
        assert_eq!(outline.xml, "<VTKFile><DataArray/>\n</VTKFile>");
        let appended = outline.appended.unwrap();
        assert!(appended.base64 && &file[appended.start as usize..] == "<raw>");
        assert!(of("<V><AppendedData>no mark").is_err());
        assert!(of("<V><![CDATA[1]]></V>").is_err() && of(&format!("<{}", "x".repeat(2 << 20))).is_err());
        assert!(of("").unwrap().xml.is_empty() && of("<V").unwrap().xml.is_empty());
    }
}
