//! Arrays in zarr, version 3, of the kind that results need: chunks of whole rows, not compressed (noise does not
//! shrink), each with a CRC-32C at its end.
//!
//! Source: Zarr core specification 3.0; codecs `bytes`, `vlen-utf8` and `crc32c` of its registry.

use serde_json::{Value, json};

/// Bytes of the checksum at the end of a chunk.
const CHECKSUM: usize = 4;

/// What an element of an array is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DataType {
    /// A number, missing where NaN.
    Float64,
    /// A complex number, missing where both parts are NaN.
    Complex128,
    /// A whole number.
    Int64,
    /// True where it is not zero.
    Bool,
    /// A text, missing where empty.
    String,
}

/// An array in chunks of whole rows. A row is what belongs to one index of the first dimension.
#[derive(Debug, Clone, PartialEq)]
pub struct Array {
    /// The name of its folder.
    pub name: String,
    /// What an element is.
    pub data_type: DataType,
    /// Elements along each dimension; the first counts the rows.
    pub shape: Vec<u64>,
    /// Rows of each chunk. The last chunk is filled up.
    pub rows_per_chunk: u64,
    /// Names of the dimensions.
    pub dimensions: Vec<&'static str>,
    /// What else is to be known of it, an object.
    pub attributes: Value,
}

/// Elements of an array in order, the last dimension fastest.
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    /// Numbers, complex ones as pairs.
    Numbers(Vec<f64>),
    /// Texts.
    Texts(Vec<String>),
}

impl Array {
    /// The coordinate of a dimension, or one more of it: numbers in one chunk.
    pub fn axis(name: &str, dimension: &'static str, length: u64, unit: &str, description: &str) -> Self {
        Self {
            name: name.to_owned(),
            data_type: DataType::Float64,
            shape: vec![length],
            rows_per_chunk: length,
            dimensions: vec![dimension],
            attributes: json!({ "units": unit, "long_name": description }),
        }
    }

    /// The document `zarr.json`.
    pub fn metadata(&self) -> Value {
        let (data_type, fill_value, codec) = match self.data_type {
            DataType::Float64 => ("float64", json!("NaN"), little_endian()),
            DataType::Complex128 => ("complex128", json!(["NaN", "NaN"]), little_endian()),
            DataType::Int64 => ("int64", json!(0), little_endian()),
            DataType::Bool => ("bool", json!(false), json!({ "name": "bytes" })),
            DataType::String => ("string", json!(""), json!({ "name": "vlen-utf8" })),
        };
        let mut chunk_shape = self.shape.clone();
        chunk_shape[0] = self.rows_per_chunk;
        json!({
            "zarr_format": 3,
            "node_type": "array",
            "shape": self.shape,
            "data_type": data_type,
            "chunk_grid": { "name": "regular", "configuration": { "chunk_shape": chunk_shape } },
            "chunk_key_encoding": { "name": "default", "configuration": { "separator": "/" } },
            "fill_value": fill_value,
            "codecs": [codec, { "name": "crc32c" }],
            "attributes": self.attributes,
            "dimension_names": self.dimensions,
        })
    }

    /// The file of a chunk, below the folder of the group.
    pub fn file(&self, chunk: u64) -> String {
        let zeros = "/0".repeat(self.shape.len() - 1);
        format!("{}/c/{chunk}{zeros}", self.name)
    }

    /// Numbers or texts of a row.
    fn width(&self) -> usize {
        let elements: u64 = self.shape[1..].iter().product();
        match self.data_type {
            DataType::Complex128 => 2 * elements as usize,
            _ => elements as usize,
        }
    }

    /// Numbers or texts of a chunk.
    fn length(&self) -> usize {
        self.rows_per_chunk as usize * self.width()
    }

    /// The bytes of a chunk, filled up where there are fewer rows. Texts must be of an array of texts.
    pub fn encode(&self, values: &Values) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(8 * self.length() + CHECKSUM);
        match values {
            Values::Numbers(numbers) => {
                let missing = self.length().saturating_sub(numbers.len());
                let nothing = match self.data_type {
                    DataType::Int64 | DataType::Bool => 0.0,
                    _ => f64::NAN,
                };
                let missing = std::iter::repeat_n(&nothing, missing);
                for number in numbers.iter().chain(missing) {
                    match self.data_type {
                        DataType::Int64 => bytes.extend((*number as i64).to_le_bytes()),
                        DataType::Bool => bytes.push(u8::from(*number != 0.0)),
                        _ => bytes.extend(number.to_le_bytes()),
                    }
                }
            }
            Values::Texts(texts) => {
                // At most a million texts of a line each.
                bytes.extend((self.length() as u32).to_le_bytes());
                for text in texts {
                    bytes.extend((text.len() as u32).to_le_bytes());
                    bytes.extend(text.as_bytes());
                }
                let missing = self.length().saturating_sub(texts.len());
                bytes.resize(bytes.len() + 4 * missing, 0);
            }
        }
        bytes.extend(crc32c::crc32c(&bytes).to_le_bytes());
        bytes
    }

    /// The first rows of a chunk by its bytes.
    ///
    /// # Errors
    /// Why they are not those of a chunk.
    pub fn decode(&self, bytes: &[u8], rows: u64) -> Result<Values, &'static str> {
        let cut = "a chunk is cut short";
        let (bytes, checksum) = bytes.split_last_chunk::<CHECKSUM>().ok_or(cut)?;
        if crc32c::crc32c(bytes) != u32::from_le_bytes(*checksum) {
            return Err("a chunk has another checksum");
        }
        let length = (rows as usize * self.width()).min(self.length());
        if self.data_type == DataType::Bool {
            let truths = bytes.get(..length).ok_or(cut)?.iter();
            return Ok(Values::Numbers(truths.map(|truth| f64::from(*truth)).collect()));
        }
        if self.data_type != DataType::String {
            let (numbers, []) = bytes.as_chunks::<8>() else {
                return Err(cut);
            };
            let numbers = numbers.get(..length).ok_or(cut)?.iter();
            let numbers = numbers.map(|bytes| match self.data_type {
                DataType::Int64 => i64::from_le_bytes(*bytes) as f64,
                _ => f64::from_le_bytes(*bytes),
            });
            return Ok(Values::Numbers(numbers.collect()));
        }
        let (_count, mut rest) = bytes.split_first_chunk::<4>().ok_or(cut)?;
        let mut texts = Vec::new();
        for _ in 0..length {
            let (size, after) = rest.split_first_chunk::<4>().ok_or(cut)?;
            let size = u32::from_le_bytes(*size) as usize;
            let (text, after) = after.split_at_checked(size).ok_or(cut)?;
            let text = str::from_utf8(text).map_err(|_| "a text is not UTF-8")?;
            texts.push(text.to_owned());
            rest = after;
        }
        Ok(Values::Texts(texts))
    }
}

fn little_endian() -> Value {
    json!({ "name": "bytes", "configuration": { "endian": "little" } })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn array(data_type: DataType) -> Array {
        Array {
            name: "a".to_owned(),
            data_type,
            shape: vec![5, 2],
            rows_per_chunk: 3,
            dimensions: vec!["sample", "band"],
            attributes: json!({}),
        }
    }

    /// Bytes by the specification; the CRC-32C of 32 bytes of zero is that of RFC 3720, B.4.
    #[test]
    fn chunks_are_laid_out_as_specified() {
        let two_rows = Array { rows_per_chunk: 2, ..array(DataType::Float64) };
        let bytes = two_rows.encode(&Values::Numbers(vec![0.0; 4]));
        assert_eq!(bytes[..32], [0; 32]);
        assert_eq!(bytes[32..], [0xaa, 0x36, 0x91, 0x8a]);

        let texts = Values::Texts(vec!["é".to_owned(), "ab".to_owned()]);
        let bytes = array(DataType::String).encode(&texts);
        let expected = [6, 0, 0, 0, 2, 0, 0, 0, 0xc3, 0xa9, 2, 0, 0, 0, b'a', b'b'];
        assert_eq!(bytes[..16], expected);
        assert_eq!(bytes[16..bytes.len() - CHECKSUM], [0; 16]);
    }

    #[test]
    fn a_chunk_is_filled_up_and_read_back() {
        let numbers = Values::Numbers(vec![1.5, -0.0, f64::MAX, 4.0]);
        let (one, two) = (array(DataType::Float64), array(DataType::Complex128));
        assert_eq!(one.encode(&numbers).len(), 8 * 6 + CHECKSUM);
        assert_eq!(one.decode(&one.encode(&numbers), 2).unwrap(), numbers);
        assert_eq!(two.encode(&numbers).len(), 16 * 6 + CHECKSUM);
        assert_eq!(two.decode(&two.encode(&numbers), 1).unwrap(), numbers);
        let Values::Numbers(all) = one.decode(&one.encode(&numbers), 3).unwrap() else {
            panic!("numbers are read as texts");
        };
        assert!(all.len() == 6 && all[4..].iter().all(|number| number.is_nan()));

        let whole = Values::Numbers(vec![0.0, 1.0, 1.0, 0.0]);
        for (kind, size) in [(DataType::Int64, 8), (DataType::Bool, 1)] {
            let bytes = array(kind).encode(&whole);
            assert_eq!(bytes.len(), size * 6 + CHECKSUM);
            assert_eq!(bytes[size], 1);
            assert_eq!(array(kind).decode(&bytes, 2).unwrap(), whole);
        }

        let texts = Values::Texts(["", "a sentence", "Ŵ₁", "b"].map(str::to_owned).into());
        let array = array(DataType::String);
        assert_eq!(array.decode(&array.encode(&texts), 2).unwrap(), texts);
    }

    #[test]
    fn bytes_that_are_no_chunk_are_refused() {
        let sealed = |bytes: &[u8]| [bytes, &crc32c::crc32c(bytes).to_le_bytes()].concat();
        let numbers = array(DataType::Float64);
        let texts = array(DataType::String);
        let mut damaged = numbers.encode(&Values::Numbers(vec![1.0; 6]));
        damaged[7] ^= 1;
        assert!(numbers.decode(&damaged, 3).is_err());
        assert!(numbers.decode(&[0; 3], 3).is_err());
        assert!(numbers.decode(&sealed(&[0; 47]), 3).is_err());
        assert!(numbers.decode(&sealed(&[0; 40]), 3).is_err());
        assert!(texts.decode(&sealed(&[1, 0, 0, 0]), 1).is_err());
        let too_long = [1, 0, 0, 0, 255, 255, 255, 255, b'a'];
        assert!(texts.decode(&sealed(&too_long), 1).is_err());
        let no_text = [6, 0, 0, 0, 1, 0, 0, 0, 0xff, 0, 0, 0, 0];
        assert!(texts.decode(&sealed(&no_text), 1).is_err());
    }
}
