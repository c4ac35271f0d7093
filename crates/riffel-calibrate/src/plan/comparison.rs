//! What a plan says of other models, and of what is left out to compare them.

use riffel_case::settings;
use riffel_keys::{CaseError, Message, say};
use toml::{Table, Value};

use super::{OF_OTHERS, Plan, name_of};
use crate::data::{Group, Held};
use crate::file::{CompareFile, HoldOutFile};
use crate::model::{Role, VehicleKey};

impl Plan {
    /// Plan without what no draw follows from.
    fn again(&self, change: impl FnOnce(&mut Table)) -> Result<Self, CaseError> {
        let mut source = self.source.clone();
        OF_OTHERS.iter().for_each(|key| source.remove(key));
        let mut table = source.table().clone();
        change(&mut table);
        ["set", "parameter", "data"]
            .into_iter()
            .filter_map(|key| Some((key, table.remove(key)?)))
            .for_each(|(key, value)| source.put(key, value));
        Self::of(&self.inputs[0], self.text.clone(), source)
    }

    /// The plan without some of its data.
    pub(crate) fn without(&self, block: usize, held: Held) -> Result<Self, CaseError> {
        let mut plan = self.again(|_| ())?;
        let blocks = &mut plan.posterior.blocks;
        plan.left_out = Some(format!("{block} {held:?}"));
        match blocks[block].block.without(held) {
            Some(rest) => blocks[block].block = rest,
            None => drop(blocks.remove(block)),
        }
        Ok(plan)
    }

    /// The plan with another model.
    pub(super) fn compared(&self, index: usize, written: &CompareFile) -> Result<Self, CaseError> {
        let key = |key: &str| format!("compare[{index}].{key}");
        let wrong = |at: &str, rule: Message, help: Message| self.source.invalid(&key(at), rule, help);
        let others = &self.file.compare[..index];
        if others.iter().any(|other| other.title == written.title) {
            let rule = say!(is_a_second_time, text = &written.title);
            return Err(wrong("title", rule, say!(give_each_its_title)));
        }
        if written.set.is_empty() && written.without.is_empty() {
            let help = say!(say_what_differs);
            return Err(self.source.missing(&key("set"), help));
        }
        let uncertain = &self.posterior.parameters()[..self.file.parameter.len()];
        let mut left_out = Vec::new();
        for name in &written.without {
            let place = uncertain.iter().position(|it| it.name == *name);
            left_out.push(place.ok_or_else(|| {
                let names: Vec<&str> = uncertain.iter().map(|it| &*it.name).collect();
                let rule = say!(names_no_parameter, name, names = names.join(", "));
                wrong("without", rule, Message::verbatim(""))
            })?);
        }
        let set = settings(&written.set);
        for (changed, _) in &set {
            let is_changed = |(place, key): (usize, &str)| {
                !left_out.contains(&place) && (key == changed || key.starts_with(&format!("{changed}.")))
            };
            let keys = uncertain.iter().enumerate();
            let mut keys = keys.filter_map(|(place, it)| match &it.role {
                Role::Key(key) | Role::Vehicle(_, VehicleKey::OfCase(key, _)) => Some((place, &**key)),
                _ => None,
            });
            if let Some((place, _)) = keys.find(|it| is_changed(*it)) {
                let message =
                    say!(changes_what_is_uncertain, place = key("set"), key = changed, name = &uncertain[place].name,);
                return Err(self.source.refuse(&key("set"), message));
            }
        }
        let differs = |table: &mut Table, adds: bool| {
            let own = table.get("set").and_then(Value::as_table);
            let own = settings(own.unwrap_or(&Table::new())).into_iter();
            let kept = own.filter(|(key, _)| !set.iter().any(|(changed, _)| changed == key));
            let added = set.iter().filter(|_| adds).cloned();
            table.insert("set".to_owned(), kept.chain(added).collect::<Table>().into());
        };
        let plan = self.again(|table| {
            differs(table, true);
            let list = |table: &mut Table, key: &str, change: &dyn Fn(&mut Vec<Value>)| {
                if let Some(list) = table.get_mut(key).and_then(Value::as_array_mut) {
                    change(list);
                }
            };
            list(table, "data", &|data| {
                let data = data.iter_mut().filter_map(Value::as_table_mut);
                data.for_each(|data| differs(data, false));
            });
            list(table, "parameter", &|parameters| {
                let mut place = 0..;
                parameters.retain(|_| place.next().is_none_or(|it| !left_out.contains(&it)));
            });
        });
        plan.map_err(|error| {
            let message = say!(model_of_the_plan_says, title = &written.title, error = error.message());
            self.source.refuse(&format!("compare[{index}]"), message)
        })
    }

    /// What is left out, with the block of data that it is of: what the plan says, or one after the other all there is.
    pub(crate) fn groups(&self) -> Result<Vec<(usize, Group)>, CaseError> {
        let blocks = self.posterior.blocks.iter().enumerate();
        let all = blocks.flat_map(|(place, named)| {
            let groups = named.block.groups().into_iter();
            groups.map(move |group| (place, group))
        });
        let all: Vec<(usize, Group)> = all.collect();
        let Some(written) = &self.file.hold_out else {
            return match all.len() {
                1 => Err(self.source.refuse("compare", say!(data_cannot_be_parted))),
                _ => Ok(all),
            };
        };
        Ok(vec![self.held_out(written, &all)?])
    }

    /// What is left out, with the names of the data of each block.
    ///
    /// # Errors
    /// [`CaseError`] where nothing can be left out.
    pub fn left_out_of_data(&self) -> Result<Vec<(String, Held)>, CaseError> {
        let groups = self.groups()?.into_iter();
        let named = |block: usize| self.posterior.blocks[block].names.join(" + ");
        Ok(groups.map(|(block, group)| (named(block), group.held)).collect())
    }

    fn held_out(&self, written: &HoldOutFile, all: &[(usize, Group)]) -> Result<(usize, Group), CaseError> {
        let wrong = |key: &str, rule: Message| self.source.invalid(&format!("hold_out.{key}"), rule, "");
        let among = |numbers: Vec<f64>| numbers.into_iter().collect::<riffel_keys::Value>();
        let of_kind = |wanted: fn(Held) -> Option<f64>| -> Vec<f64> {
            all.iter().filter_map(|(_, group)| wanted(group.held)).collect()
        };
        let found = |held: Held| {
            let group = all.iter().find(|(_, group)| group.held == held);
            group.cloned()
        };
        match (&written.date, &written.position, &written.data) {
            (Some(date), None, None) => {
                let dates = of_kind(|held| match held {
                    Held::Date(date) => Some(date),
                    _ => None,
                });
                let Some(last) = dates.last() else {
                    return Err(wrong("date", say!(is_date_of_too_few, date = date.to_string())));
                };
                let passages = match date {
                    Value::String(text) if text == "last" => Some(*last),
                    Value::String(text) if text == "first" => Some(dates[0]),
                    Value::Integer(passages) => Some(*passages as f64),
                    Value::Float(passages) => Some(*passages),
                    _ => None,
                };
                let group = passages.and_then(|passages| found(Held::Date(passages)));
                group.ok_or_else(|| {
                    let rule = say!(date_that_is_there, dates = among(dates));
                    wrong("date", say!(is_but_must_be, value = date.to_string(), rule))
                })
            }
            (None, Some(position), None) => found(Held::Place(position.si())).ok_or_else(|| {
                let places = of_kind(|held| match held {
                    Held::Place(place) => Some(place),
                    _ => None,
                });
                let shown = position.to_string();
                let rule = match &places[..] {
                    [] => say!(is_place_of_too_few, place = shown),
                    _ => {
                        let rule = say!(place_of_the_hammer, places = among(places));
                        say!(is_but_must_be, value = shown, rule)
                    }
                };
                wrong("position", rule)
            }),
            (None, None, Some(name)) => {
                let mut blocks = self.posterior.blocks.iter();
                let block = blocks.position(|named| named.names == [name.clone()]);
                let block = block.ok_or_else(|| {
                    let names = self.file.data.iter().map(name_of);
                    let is_run = names.clone().any(|own| own == name);
                    let rule = match is_run {
                        true => say!(is_left_out_by_date, name),
                        false => {
                            let names = names.collect::<riffel_keys::Value>();
                            say!(is_name_of_none_of_the_data, name, names)
                        }
                    };
                    wrong("data", rule)
                })?;
                if self.posterior.blocks.len() == 1 {
                    return Err(wrong("data", say!(is_the_only_data, name)));
                }
                let count = self.posterior.blocks[block].block.observed().len();
                Ok((block, Group::all(count)))
            }
            _ => Err(self.source.refuse("hold_out", say!(hold_out_names_one))),
        }
    }
}
