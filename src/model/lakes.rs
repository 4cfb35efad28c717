//! Levels and depths of lakes: those of the largest and of some that many know, by where they are, and what a lake is taken for otherwise.
//!
//! Elevation models are of no one mind about lakes: of some they hold the bed, of others the surface, of most a mean of both and of the
//! hills around.

use super::sea_bed::smoothstep;

/// A lake whose level is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lake {
    /// Its name.
    pub name: &'static str,
    /// Mean level of its surface, m over the sea's.
    pub level_m: f64,
    /// Mean depth, m.
    pub depth_m: f64,
    /// Water in its boxes whose ground is this much higher than its level by the data belongs to other lakes, m.
    pub margin_m: f64,
    /// It lies in one of these, and next to no other water does: south, north, west, east, degrees.
    boxes: &'static [[f64; 4]],
}

/// In a box as tight as a small lake no other is found.
const TIGHT_M: f64 = 5_000.0;
/// Around wide ones the land rises to other lakes soon.
const WIDE_M: f64 = 60.0;
/// Lakes between the walls of rifts: their shores' cells are half mountain.
const RIFT_M: f64 = 400.0;

/// The margin of rivers and their banks, which rise from a lake sooner than its own shores, m: beyond it they lie on the ground.
pub const RIVER_MARGIN_M: f64 = 20.0;

/// So far from a lake's shore the ground has come up from its level to the data's elevation, m.
pub const SHORE_M: f64 = 2_000.0;
/// The ground beside a lake rises by this much of the distance, and to so many metres over its level, at least.
pub const SHORE_RISES: [f64; 2] = [0.01, 2.0];
/// Share of a lake's margin from which on less and less is taken for its shore.
pub const OF_MARGIN: f64 = 0.7;

/// How steeply beds of lakes fall from their shores, as far as waves feel them: no data tell their depths; ours.
pub const BED_SLOPE: f64 = 0.05;

/// Where an inland water lies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stands {
    /// Level of its surface there, m over the sea's.
    pub level_m: f64,
    /// See [`Lake::margin_m`]; of a river more than [`OWN_RIVER_M`].
    pub margin_m: f64,
    /// Mean depth, m, where it is known.
    pub depth_m: Option<f64>,
    /// The name of a lake of the table.
    pub name: Option<&'static str>,
}

/// From this margin on a level is a river's own, m: half way between a small lake's and a river's, where nodes of both are mixed.
pub const OWN_RIVER_M: f64 = 1.5 * TIGHT_M;

impl Stands {
    /// A lake of the table.
    pub fn of(lake: &Lake) -> Self {
        let Lake { level_m, margin_m, depth_m, name, .. } = *lake;
        Self { level_m, margin_m, depth_m: Some(depth_m), name: Some(name) }
    }

    /// Another one, which is told from all others by its shore.
    pub fn lake(level_m: f64) -> Self {
        Self { level_m, margin_m: TIGHT_M, depth_m: None, name: None }
    }

    /// A river.
    pub fn river(level_m: f64) -> Self {
        Self { margin_m: 2.0 * TIGHT_M, ..Self::lake(level_m) }
    }

    /// Whether it is a river.
    pub fn is_river(&self) -> bool {
        self.margin_m >= OWN_RIVER_M
    }

    /// Of ground that is so much higher by the data other water is taken for this, m; as `margin_for` of `shaders/lib/shelter.wgsl`.
    pub fn margin_for(&self, by_river: bool) -> f64 {
        if by_river && !self.is_river() { self.margin_m.min(RIVER_MARGIN_M) } else { self.margin_m }
    }
}

macro_rules! lakes {
    ($($name:literal $level:literal $depth:literal $margin:ident $($box:expr),+;)+) => {
        /// The table. Levels of lakes that people or the years move are round numbers of the last decades
        /// ([Herdendorf](crate::bibliography::Herdendorf1982), rounded, and lake authorities' gauges).
        pub const LAKES: &[Lake] = &[$(Lake {
            name: $name,
            level_m: $level,
            depth_m: $depth,
            margin_m: $margin,
            boxes: &[$($box),+],
        }),+];
    };
}

#[rustfmt::skip]
lakes! {
    "Caspian Sea" -28.0 208.0 WIDE_M [36.4, 47.3, 46.5, 55.0];
    "Lake Superior" 183.0 147.0 WIDE_M [46.38, 49.1, -92.3, -84.3];
    "Lake Michigan and Lake Huron" 176.0 73.0 WIDE_M [41.5, 46.15, -88.2, -84.7], [43.0, 46.38, -84.8, -79.6];
    "Lake Saint Clair" 175.0 3.4 WIDE_M [42.3, 42.7, -82.95, -82.4];
    "Lake Erie" 174.0 19.0 WIDE_M [41.3, 42.95, -83.6, -78.8];
    "Lake Ontario" 74.0 86.0 WIDE_M [43.1, 44.4, -79.95, -75.9];
    "Lake Winnipeg" 217.0 12.0 WIDE_M [50.2, 53.9, -99.0, -96.1];
    "Great Bear Lake" 156.0 72.0 WIDE_M [64.6, 67.1, -125.5, -117.5];
    "Great Slave Lake" 156.0 73.0 WIDE_M [60.7, 63.0, -117.2, -108.7];
    "Lake Athabasca" 213.0 20.0 WIDE_M [58.6, 59.7, -111.3, -106.0];
    "Reindeer Lake" 337.0 17.0 WIDE_M [56.2, 58.0, -103.4, -101.5];
    "Great Salt Lake" 1280.0 4.9 WIDE_M [40.6, 41.8, -113.1, -111.8];
    "Lake Tahoe" 1897.0 305.0 TIGHT_M [38.9, 39.3, -120.2, -119.9];
    "Seneca Lake" 136.0 89.0 TIGHT_M [42.36, 42.88, -77.02, -76.85];
    "Cayuga Lake" 116.0 55.0 TIGHT_M [42.42, 42.7, -76.72, -76.48], [42.7, 42.96, -76.78, -76.6];
    "Lake George" 97.0 18.0 TIGHT_M [43.42, 43.66, -73.68, -73.49], [43.42, 43.55, -73.72, -73.6], [43.66, 43.84, -73.56, -73.415];
    "Crater Lake" 1883.0 350.0 TIGHT_M [42.89, 42.99, -122.2, -122.02];
    "Lake Chelan" 335.0 144.0 TIGHT_M [47.83, 48.0, -120.3, -119.98], [47.95, 48.33, -120.76, -120.2];
    "Flathead Lake" 882.0 50.0 TIGHT_M [47.66, 48.1, -114.35, -113.95];
    "Lake Pend Oreille" 629.0 164.0 TIGHT_M [47.93, 48.2, -116.58, -116.2], [48.2, 48.33, -116.7, -116.2];
    "Kootenay Lake" 532.0 94.0 TIGHT_M [49.2, 50.25, -117.32, -116.55];
    "Lake Champlain" 30.0 20.0 TIGHT_M [43.6, 45.1, -73.5, -73.1];
    "Lake Okeechobee" 4.0 2.7 WIDE_M [26.6, 27.25, -81.15, -80.55];
    "Lake Atitlán" 1562.0 188.0 TIGHT_M [14.6, 14.77, -91.3, -91.06];
    "Lake Nicaragua" 32.0 13.0 WIDE_M [11.0, 12.2, -86.05, -84.6];
    "Lake Titicaca" 3812.0 107.0 RIFT_M [-16.7, -15.2, -70.1, -68.5];
    "Todos los Santos Lake" 189.0 191.0 TIGHT_M [-41.26, -41.0, -72.43, -72.05];
    "Llanquihue Lake" 51.0 182.0 TIGHT_M [-41.4, -40.9, -73.1, -72.4];
    "Nahuel Huapi Lake" 768.0 157.0 TIGHT_M [-41.15, -40.65, -71.9, -71.15];
    "General Carrera Lake" 208.0 200.0 RIFT_M [-47.0, -46.2, -73.0, -70.9];
    "Argentino Lake" 187.0 150.0 RIFT_M [-50.6, -49.95, -73.3, -71.9];
    "Viedma Lake" 254.0 80.0 RIFT_M [-49.85, -49.35, -73.1, -71.9];
    "Lake Ladoga" 5.0 51.0 WIDE_M [59.8, 61.9, 29.7, 33.1];
    "Lake Onega" 33.0 30.0 WIDE_M [60.8, 62.9, 34.1, 36.6];
    "Vänern" 44.0 27.0 WIDE_M [58.3, 59.5, 12.2, 14.05];
    "Vättern" 88.0 41.0 RIFT_M [57.7, 58.95, 14.08, 15.1];
    "Lake Peipus" 30.0 7.1 WIDE_M [57.8, 59.05, 26.9, 28.2];
    "Saimaa" 76.0 12.0 WIDE_M [61.0, 62.4, 27.5, 30.0];
    "Mjøsa" 123.0 155.0 TIGHT_M [60.35, 61.15, 10.3, 11.4];
    "Loch Ness" 16.0 132.0 TIGHT_M [57.1, 57.45, -4.75, -4.25];
    "Lake Annecy" 447.0 41.0 TIGHT_M [45.78, 45.92, 6.12, 6.24];
    "Lac du Bourget" 232.0 80.0 TIGHT_M [45.64, 45.81, 5.83, 5.91];
    "Lake Thun" 558.0 136.0 TIGHT_M [46.64, 46.77, 7.6, 7.865];
    "Lake Brienz" 564.0 173.0 TIGHT_M [46.68, 46.77, 7.875, 8.06];
    "Lake Lucerne" 434.0 104.0 TIGHT_M [46.87, 47.005, 8.265, 8.64], [47.005, 47.04, 8.265, 8.5], [47.04, 47.06, 8.29, 8.443], [47.06, 47.092, 8.38, 8.443];
    "Lake Zug" 413.0 83.0 TIGHT_M [47.045, 47.2, 8.443, 8.53];
    "Lake Zürich" 406.0 51.0 TIGHT_M [47.3, 47.38, 8.525, 8.62], [47.25, 47.3, 8.525, 8.655], [47.18, 47.27, 8.62, 8.98];
    "Walensee" 419.0 103.0 TIGHT_M [47.1, 47.14, 9.08, 9.33];
    "Lake Orta" 290.0 71.0 TIGHT_M [45.755, 45.885, 8.35, 8.43];
    "Lake Lugano" 271.0 134.0 TIGHT_M [45.88, 46.01, 8.85, 9.05], [45.99, 46.06, 8.95, 9.14];
    "Wörthersee" 439.0 42.0 TIGHT_M [46.6, 46.65, 14.03, 14.3];
    "Wolfgangsee" 538.0 52.0 TIGHT_M [47.71, 47.79, 13.36, 13.475], [47.71, 47.737, 13.475, 13.51];
    "Attersee" 469.0 84.0 TIGHT_M [47.79, 47.96, 13.48, 13.61];
    "Traunsee" 423.0 90.0 TIGHT_M [47.79, 47.94, 13.74, 13.84];
    "Walchensee" 801.0 81.0 TIGHT_M [47.55, 47.63, 11.29, 11.4];
    "Lake Geneva" 372.0 154.0 TIGHT_M [46.15, 46.55, 6.1, 6.95];
    "Lake Constance" 395.0 90.0 TIGHT_M [47.45, 47.85, 8.9, 9.78];
    "Lake Maggiore" 193.0 177.0 TIGHT_M [45.7, 46.2, 8.45, 8.9];
    "Lake Como" 198.0 154.0 TIGHT_M [45.75, 46.2, 9.05, 9.45];
    "Lake Garda" 65.0 133.0 TIGHT_M [45.4, 45.9, 10.5, 10.9];
    "Balaton" 104.0 3.3 TIGHT_M [46.65, 47.1, 17.2, 18.2];
    "Lake Baikal" 456.0 744.0 RIFT_M [51.4, 55.9, 103.6, 110.1];
    "Lake Balkhash" 341.0 5.8 WIDE_M [44.8, 46.9, 73.3, 79.4];
    "Issyk-Kul" 1607.0 278.0 RIFT_M [42.1, 42.85, 76.1, 78.4];
    "Qinghai Lake" 3196.0 18.0 RIFT_M [36.5, 37.3, 99.5, 100.9];
    "Lake Khanka" 69.0 4.5 WIDE_M [44.5, 45.4, 131.9, 133.0];
    "Lake Toba" 904.0 216.0 TIGHT_M [2.3, 2.95, 98.4, 99.1];
    "Lake Van" 1646.0 171.0 RIFT_M [38.2, 39.05, 42.2, 43.7];
    "Lake Urmia" 1271.0 5.0 RIFT_M [36.9, 38.3, 45.0, 46.0];
    "Lake Sevan" 1900.0 27.0 TIGHT_M [40.1, 40.7, 44.9, 45.65];
    "Dead Sea" -430.0 188.0 TIGHT_M [30.9, 31.85, 35.2, 35.65];
    "Sea of Galilee" -212.0 26.0 TIGHT_M [32.65, 32.95, 35.45, 35.7];
    "Lake Victoria" 1134.0 40.0 WIDE_M [-3.1, 0.6, 31.5, 34.9];
    "Lake Tanganyika" 773.0 570.0 RIFT_M [-8.9, -3.3, 29.0, 31.3];
    "Lake Malawi" 474.0 264.0 RIFT_M [-14.5, -9.4, 33.8, 35.4];
    "Lake Albert" 615.0 25.0 RIFT_M [1.0, 2.35, 30.3, 31.5];
    "Lake Edward" 912.0 34.0 RIFT_M [-0.8, 0.0, 29.2, 29.9];
    "Lake Kivu" 1462.0 240.0 RIFT_M [-2.55, -1.55, 28.8, 29.4];
    "Lake Turkana" 360.0 30.0 RIFT_M [2.3, 4.75, 35.8, 36.8];
    "Lake Tana" 1788.0 8.0 WIDE_M [11.55, 12.35, 36.95, 37.7];
    "Lake Chad" 281.0 1.5 WIDE_M [12.4, 14.4, 13.0, 15.4];
    "Lake Kariba" 485.0 29.0 RIFT_M [-18.1, -16.4, 26.6, 29.1];
    "Lake Volta" 85.0 19.0 RIFT_M [6.2, 9.1, -1.8, 0.6];
    "Lake Manapouri" 178.0 100.0 TIGHT_M [-45.7, -45.44, 167.3, 167.75];
    "Lake Te Anau" 202.0 150.0 TIGHT_M [-45.44, -44.8, 167.4, 168.1];
    "Lake Wakatipu" 310.0 230.0 TIGHT_M [-45.4, -44.7, 168.3, 168.9];
    "Lake Taupo" 356.0 110.0 TIGHT_M [-39.0, -38.6, 175.7, 176.1];
}

/// The lake that water at geodetic `lat` and `lon`, radians, belongs to, if it is one of the table.
pub fn at(lat: f64, lon: f64) -> Option<&'static Lake> {
    let (lat, lon) = (lat.to_degrees(), (lon.to_degrees() + 180.0).rem_euclid(360.0) - 180.0);
    let holds =
        |[south, north, west, east]: &[f64; 4]| (*south..*north).contains(&lat) && (*west..*east).contains(&lon);
    LAKES.iter().find(|lake| lake.boxes.iter().any(holds))
}

/// Elevation of the ground, m, at a signed distance in metres from the shore of a lake (positive in it) with a level and a margin
/// ([`Lake::margin_m`]): in the lake the level; beside it a shore that rises from there. As `with_lake` of `shaders/lib/shelter.wgsl`.
pub fn shaped(elevation_m: f64, lake_m: f64, level_m: f64, margin_m: f64) -> f64 {
    let over_m = elevation_m - level_m;
    if lake_m > 0.0 {
        return if over_m < margin_m { level_m } else { elevation_m };
    }
    let out = smoothstep(0.0, SHORE_M, -lake_m);
    let others = smoothstep(OF_MARGIN, 1.0, over_m / margin_m);
    let least_m = (-SHORE_RISES[0] * lake_m).min(SHORE_RISES[1]);
    let shore_m = (out * over_m).max(least_m + out * (over_m - least_m).min(0.0));
    elevation_m + (1.0 - others) * (level_m + shore_m - elevation_m)
}

/// Mean depth of a lake of an area in km², m: that of most glacial and tectonic lakes, within a factor of three.
pub fn usual_depth_m(area_km2: f64) -> f64 {
    10.3 * libm::pow(area_km2.max(0.01), 0.25)
}
