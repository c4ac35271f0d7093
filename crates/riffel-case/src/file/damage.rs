//! The keys of the laws of damage.

use riffel_keys::quantity::{
    Angle, Area, Force, Length, LengthPerForce, Modulus, Moment, Quantity, Ratio, RelativeSlope,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What damages the rail beside wear; left out, wear alone.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Damage {
    /// The laws whose rates add, each with its table.
    pub laws: Vec<DamageLawName>,
    /// Grade of the rail, for the yield of its surface.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub grade: Option<RailGrade>,
    /// Shear yield k of the surface of the rail, hardened as it is; left out, that of the grade, or 300 MPa.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shear_yield: Option<Quantity<Modulus>>,
    /// Limit of the pressure over utilised friction, against which the demand is measured.
    pub limit: LimitName,
    /// Standard deviation of the demand over the wheels of traffic; 0, the law is sharp.
    pub spread: Quantity<Ratio>,
    /// Flow to the sides of the rail.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub flow: Option<Flow>,
    /// Flow along the rail.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub flow_along: Option<FlowAlong>,
    /// Flow by load without a threshold.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub load: Option<Load>,
    /// Bending of the rail beyond yield.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bending: Option<Bending>,
    /// Contact fatigue by Tγ.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fatigue: Option<Fatigue>,
}

impl Damage {
    /// Shear yield \[Pa\] where nothing is said.
    pub const SHEAR_YIELD: f64 = 300e6;

    /// Shear yield k \[Pa\]: as written, or that of the grade.
    pub fn yield_in_shear(&self) -> f64 {
        let of_grade = self.grade.map_or(Self::SHEAR_YIELD, RailGrade::shear_yield);
        self.shear_yield.map_or(of_grade, |shear| shear.si())
    }
}

impl Default for Damage {
    fn default() -> Self {
        Self {
            laws: vec![DamageLawName::Wear],
            grade: None,
            shear_yield: None,
            limit: LimitName::default(),
            spread: Quantity::new(0.0),
            flow: None,
            flow_along: None,
            load: None,
            bending: None,
            fatigue: None,
        }
    }
}

/// A law of damage.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum DamageLawName {
    /// Wear, by `[wear]`.
    Wear,
    /// Depth in proportion to the load.
    Load,
    /// Plastic flow to the sides, where the demand is above the limit.
    Flow,
    /// Plastic flow along the rail in the direction of the force on it.
    FlowAlong,
    /// Bending of the rail beyond its plastic moment.
    Bending,
    /// Contact fatigue by Tγ.
    Fatigue,
}

impl DamageLawName {
    /// Name in a case file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Wear => "wear",
            Self::Load => "load",
            Self::Flow => "flow",
            Self::FlowAlong => "flow-along",
            Self::Bending => "bending",
            Self::Fatigue => "fatigue",
        }
    }
}

/// A limit of the pressure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum LimitName {
    /// First yield by von Mises under the ellipse in full slip.
    Elastic,
    /// Shakedown of line contact, below the surface or at it.
    #[default]
    Line,
    /// That of the surface, P/Q.
    Surface,
    /// That below the surface of the ellipse without friction.
    Subsurface,
}

/// A grade of rail steel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum RailGrade {
    /// R200, 200 to 240 HBW.
    R200,
    /// R260, 260 to 300 HBW.
    R260,
    /// R350HT, head hardened, 350 to 390 HBW.
    R350HT,
}

impl RailGrade {
    /// Shear yield k \[Pa\]: the least tensile strength of the grade in EN 13674-1 (recalled, not looked up), of which rail steel as
    /// rolled yields at 0.59 (recalled), over √3 by von Mises: 230, 300 and 400 MPa. A surface that traffic has hardened has 1.3 to
    /// 2 times that.
    pub fn shear_yield(self) -> f64 {
        const YIELD_RATIO: f64 = 0.59;
        let strength = match self {
            Self::R200 => 680e6,
            Self::R260 => 880e6,
            Self::R350HT => 1175e6,
        };
        // To ten MPa, no better than what is recalled.
        (YIELD_RATIO * strength / 3f64.sqrt() / 1e7).round() * 1e7
    }
}

/// h = H ⟨u − 1⟩^m of the demand u.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Flow {
    /// Depth H per passage at a demand of two.
    pub depth: Quantity<Length>,
    /// Exponent m; left out, 1.
    #[serde(default = "one")]
    pub exponent: Quantity<Ratio>,
    /// Outflow D_h by which hardening uses up a demand of one; left out, flow goes on.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hardening_depth: Option<Quantity<Length>>,
}

/// J = J_r ⟨u − 1⟩^m of the demand u.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FlowAlong {
    /// Volume J_r that moves along per passage and width at a demand of two.
    pub area: Quantity<Area>,
    /// Exponent m; left out, 1.
    #[serde(default = "one")]
    pub exponent: Quantity<Ratio>,
}

/// h = βP.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Load {
    /// Depth β per passage and force.
    pub depth_per_force: Quantity<LengthPerForce>,
}

/// κ = B ⟨M/M_lim − 1⟩^m.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Bending {
    /// Limit M_lim of the bending moment: the plastic moment of the rail.
    pub limit: Quantity<Moment>,
    /// Curvature B kept per passage at twice the limit.
    pub curvature: Quantity<RelativeSlope>,
    /// Exponent m; left out, 1.
    #[serde(default = "one")]
    pub exponent: Quantity<Ratio>,
}

/// D(Tγ) of straight pieces, cracks beside wear, and what spalls.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Fatigue {
    /// Tγ at which damage begins, is highest, and is none again.
    pub thresholds: Vec<Quantity<Force>>,
    /// Highest damage per axle.
    pub peak: Quantity<Ratio>,
    /// Growth c_D of a crack per unit of damage.
    pub crack_growth: Quantity<Length>,
    /// Angle α of a crack to the surface.
    pub crack_angle: Quantity<Angle>,
    /// Depth spalled off per unit of damage.
    pub loss: Quantity<Length>,
}

impl Default for Fatigue {
    fn default() -> Self {
        Self {
            thresholds: [15.0, 65.0, 175.0].map(Quantity::new).to_vec(),
            peak: Quantity::new(1e-5),
            crack_growth: Quantity::new(0.0),
            crack_angle: Quantity::new(std::f64::consts::FRAC_PI_6),
            loss: Quantity::new(0.0),
        }
    }
}

fn one() -> Quantity<Ratio> {
    Quantity::new(1.0)
}
