//! The view as the page holds it, decoded.

use std::collections::BTreeMap;
use std::fs;
use std::io::Read;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::read::ZlibDecoder;
use serde_json::Value;
use tremolite_report::write;
use tremolite_results::ResultFolder;

/// The page taken apart.
pub struct Page {
    pub manifest: Value,
    pub blocks: BTreeMap<usize, Vec<u8>>,
}

impl Page {
    pub fn of(folder: &ResultFolder) -> Option<Page> {
        Self::of_text(&fs::read_to_string(write(folder.root()).unwrap()).unwrap())
    }

    pub fn of_text(text: &str) -> Option<Page> {
        let (_, rest) = text.split_once(r#"<script type="application/json" id="view-data">"#)?;
        let (json, rest) = rest.split_once("</script>").unwrap();
        let mut blocks = BTreeMap::new();
        for block in rest.split(r#"<script type="text/plain" id="block-"#).skip(1) {
            let (number, rest) = block.split_once("\">").unwrap();
            let packed = STANDARD.decode(rest.split_once("</script>").unwrap().0).unwrap();
            let mut bytes = Vec::new();
            ZlibDecoder::new(&packed[..]).read_to_end(&mut bytes).unwrap();
            blocks.insert(number.parse().unwrap(), bytes);
        }
        Some(Page { manifest: serde_json::from_str(json).unwrap(), blocks })
    }

    pub fn bytes(&self, block: &Value) -> &[u8] {
        &self.blocks[&(block.as_u64().unwrap() as usize)]
    }

    /// Sums of differences, anew in each of `runs` equal pieces.
    pub fn u16s(&self, block: &Value, runs: usize) -> Vec<Vec<u16>> {
        let numbers: Vec<u16> =
            self.bytes(block).chunks_exact(2).map(|b| u16::from_le_bytes([b[0], b[1]])).collect();
        let sum = |run: &[u16]| {
            run.iter()
                .scan(0u16, |sum, d| {
                    *sum = sum.wrapping_add(*d);
                    Some(*sum)
                })
                .collect()
        };
        numbers.chunks_exact(numbers.len() / runs).map(sum).collect()
    }

    pub fn u32s(&self, block: &Value, runs: usize) -> Vec<Vec<u32>> {
        let numbers: Vec<u32> =
            self.bytes(block).chunks_exact(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect();
        let sum = |run: &[u32]| {
            run.iter()
                .scan(0u32, |sum, d| {
                    *sum = sum.wrapping_add(*d);
                    Some(*sum)
                })
                .collect()
        };
        numbers.chunks_exact(numbers.len() / runs).map(sum).collect()
    }

    pub fn parts(&self) -> &Vec<Value> {
        self.manifest["parts"].as_array().unwrap()
    }

    pub fn notes(&self) -> String {
        self.manifest["notes"].as_array().unwrap().iter().map(|n| n.as_str().unwrap()).collect()
    }

    pub fn three(&self, key: &str) -> [f64; 3] {
        [0, 1, 2].map(|i| self.manifest[key][i].as_f64().unwrap())
    }

    pub fn places(&self, part: &Value) -> Vec<[f64; 3]> {
        let (origin, step) = (self.three("origin"), self.three("step"));
        let planes = self.u16s(&part["points"]["block"], 3);
        assert_eq!(planes[0].len() as u64, part["points"]["count"].as_u64().unwrap());
        (0..planes[0].len())
            .map(|k| [0, 1, 2].map(|i| origin[i] + step[i] * f64::from(planes[i][k])))
            .collect()
    }

    /// The corners of each cell.
    pub fn cells(&self, part: &Value) -> Vec<Vec<u32>> {
        let per = part["cells"]["corners"].as_u64().unwrap() as usize;
        let corners = self.u32s(&part["cells"]["block"], per);
        assert_eq!(corners[0].len() as u64, part["cells"]["count"].as_u64().unwrap());
        (0..corners[0].len()).map(|cell| corners.iter().map(|run| run[cell]).collect()).collect()
    }

    pub fn elements(&self, part: &Value) -> Vec<u32> {
        self.u32s(&part["elements"], 1).remove(0)
    }

    /// Faces with their kinds.
    pub fn faces(&self, part: &Value) -> Vec<(u32, u8)> {
        let faces = self.u32s(&part["faces"]["block"], 1).remove(0);
        assert_eq!(faces.len() as u64, part["faces"]["count"].as_u64().unwrap());
        assert!(faces.windows(2).all(|pair| pair[0] < pair[1]));
        faces.into_iter().zip(self.bytes(&part["faces"]["kind"]).iter().copied()).collect()
    }

    pub fn displacement(&self, part: &Value, time: usize) -> Vec<[f64; 3]> {
        let step = self.manifest["displacementStep"].as_f64().unwrap();
        let planes = self.u16s(&part["displacement"][time], 3);
        (0..planes[0].len()).map(|k| [0, 1, 2].map(|i| step * f64::from(planes[i][k] as i16))).collect()
    }
}
