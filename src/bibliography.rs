//! The papers and books behind the equations, as linkable items: code that uses an equation links to the item here and keeps
//! the source's letters. An item holds no code and cannot be made: it is a name to link to.

/// Phillips, O. M. (1958), *The equilibrium range in the spectrum of wind-generated waves*, J. Fluid Mech. 4, 426–434.
/// <https://doi.org/10.1017/S0022112058000550>
pub enum Phillips1958 {}

/// Tessendorf, J. (2001), *Simulating ocean water*, SIGGRAPH course notes 47. The Fourier synthesis of a sea, its choppy
/// displacement and the Phillips spectrum as renderers write it. No DOI.
pub enum Tessendorf2001 {}

/// Cox, C. and Munk, W. (1954), *Measurement of the roughness of the sea surface from photographs of the sun's glitter*,
/// J. Opt. Soc. Am. 44, 838–850. <https://doi.org/10.1364/JOSA.44.000838>
pub enum CoxMunk1954 {}

/// Toba, Y. (1973), *Local balance in the air-sea boundary processes III*, J. Oceanogr. Soc. Japan 29, 209–220: the
/// ω⁻⁴ equilibrium range, which is k⁻³·⁵ as a density over the wave-number plane. <https://doi.org/10.1007/BF02108528>
pub enum Toba1973 {}

/// Eckart, C. (1952), *The propagation of gravity waves from deep to shallow water*, in Gravity Waves, NBS Circular 521,
/// 165–173: the closed approximation that starts the solution of the dispersion relation. No DOI.
pub enum Eckart1952 {}

/// Nayar, K. G., Panchanathan, D., McKinley, G. H. and Lienhard V, J. H. (2014), *Surface tension of seawater*, J. Phys.
/// Chem. Ref. Data 43, 043103. <https://doi.org/10.1063/1.4899037>
pub enum Nayar2014 {}

/// World Meteorological Organization, *Manual on Codes* WMO-No. 306, table 1100: the Beaufort scale. The speed formula
/// v = 0.836 B^1.5 m/s is the WMO's of 1946.
pub enum WmoBeaufort {}

/// Fritsch, F. N. and Butland, J. (1984), *A method for constructing local monotone piecewise cubic interpolants*, SIAM J.
/// Sci. Stat. Comput. 5, 300–304. <https://doi.org/10.1137/0905021>
pub enum FritschButland1984 {}

/// NGA.STND.0036 (2014), *Department of Defense World Geodetic System 1984*, version 1.0.0: the ellipsoid's constants.
pub enum Wgs84Standard {}

/// Vincenty, T. (1975), *Direct and inverse solutions of geodesics on the ellipsoid with application of nested equations*,
/// Survey Review 23, 88–93. <https://doi.org/10.1179/sre.1975.23.176.88>
pub enum Vincenty1975 {}

/// Karney, C. F. F. (2013), *Algorithms for geodesics*, J. Geodesy 87, 43–55: gives the limits of Vincenty's series.
/// <https://doi.org/10.1007/s00190-012-0578-z>
pub enum Karney2013 {}

/// Meeus, J. (1998), *Astronomical Algorithms*, 2nd ed., Willmann-Bell, ISBN 0-943396-61-1: chapter 12 (sidereal time) and
/// chapter 25 (the sun to 0.01 degrees).
pub enum Meeus1998 {}

/// Schlick, C. (1994), *An inexpensive BRDF model for physically-based rendering*, Computer Graphics Forum 13, 233–246.
/// <https://doi.org/10.1111/1467-8659.1330233>
pub enum Schlick1994 {}

/// Born, M. and Wolf, E. (1999), *Principles of Optics*, 7th ed., section 1.5: Fresnel's formulae.
/// <https://doi.org/10.1017/CBO9781139644181>
pub enum BornWolf1999 {}

/// Steele, G. L., Lea, D. and Flood, C. H. (2014), *Fast splittable pseudorandom number generators*, OOPSLA '14: SplitMix,
/// whose finaliser hashes our counters. <https://doi.org/10.1145/2660193.2660195>
pub enum Steele2014 {}

/// Box, G. E. P. and Muller, M. E. (1958), *A note on the generation of random normal deviates*, Ann. Math. Statist. 29,
/// 610–611. <https://doi.org/10.1214/aoms/1177706645>
pub enum BoxMuller1958 {}

/// Cooley, J. W. and Tukey, J. W. (1965), *An algorithm for the machine calculation of complex Fourier series*, Math. Comp.
/// 19, 297–301. <https://doi.org/10.1090/S0025-5718-1965-0178586-1>
pub enum CooleyTukey1965 {}

/// Monahan, E. C. and O'Muircheartaigh, I. (1980), *Optimal power-law description of oceanic whitecap coverage dependence on
/// wind speed*, J. Phys. Oceanogr. 10, 2094–2099. <https://doi.org/10.1175/1520-0485(1980)010<2094:OPLDOO>2.0.CO;2>
pub enum Monahan1980 {}

/// Govindaraju, N. K., Lloyd, B., Dotsenko, Y., Smith, B. and Manferdelli, J. (2008), *High performance discrete Fourier transforms
/// on graphics processors*, Proc. ACM/IEEE Conf. on Supercomputing (SC '08), 2: Stockham's transform with several elements per
/// thread and exchanges through shared memory. <https://doi.org/10.1109/SC.2008.5213922>
pub enum Govindaraju2008 {}
