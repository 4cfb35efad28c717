//! The papers and books behind the equations, as linkable items: code that uses an equation links to the item here and keeps
//! the source's letters. An item holds no code and cannot be made: it is a name to link to.

/// Tricard, T., Efremov, S., Zanni, C., Neyret, F., Martínez, J. and Lefebvre, S. (2019), *Procedural phasor noise*, ACM Trans. Graph. 38 (4), 57:
/// a wave whose phase is mixed from those of kernels around a place, at one amplitude. <https://doi.org/10.1145/3306346.3322990>
pub enum Tricard2019 {}

/// Perlin, K. (2001), *Noise hardware*, SIGGRAPH course notes: gradient noise on simplices. No DOI.
pub enum Perlin2001 {}

/// Phillips, O. M. (1958), *The equilibrium range in the spectrum of wind-generated waves*, J. Fluid Mech. 4, 426–434.
/// <https://doi.org/10.1017/S0022112058000550>
pub enum Phillips1958 {}

/// Tessendorf, J. (2001), *Simulating ocean water*, SIGGRAPH course notes 47. The Fourier synthesis of a sea, its choppy
/// displacement and the Phillips spectrum as renderers write it. No DOI.
pub enum Tessendorf2001 {}

/// Cox, C. and Munk, W. (1954), *Measurement of the roughness of the sea surface from photographs of the sun's glitter*,
/// J. Opt. Soc. Am. 44, 838–850. <https://doi.org/10.1364/JOSA.44.000838>
pub enum CoxMunk1954 {}

/// Ross, V., Dion, D. and Potter, G. (2005), *Detailed analytical approach to the Gaussian surface bidirectional reflectance
/// distribution function specular component applied to the sea surface*, J. Opt. Soc. Am. A 22, 2442–2453.
/// <https://doi.org/10.1364/JOSAA.22.002442>
pub enum Ross2005 {}

/// Toba, Y. (1973), *Local balance in the air-sea boundary processes III*, J. Oceanogr. Soc. Japan 29, 209–220: the
/// ω⁻⁴ equilibrium range, which is k⁻³·⁵ as a density over the wave-number plane. <https://doi.org/10.1007/BF02108528>
pub enum Toba1973 {}

/// Toba, Y. (1972), *Local balance in the air-sea boundary processes I. On the growth process of wind waves*, J. Oceanogr. Soc.
/// Japan 28, 109–120: the 3/2-power law between the height and the period of wind waves. <https://doi.org/10.1007/BF02109772>
pub enum Toba1972 {}

/// Wu, J. (1982), *Wind-stress coefficients over sea surface from breeze to hurricane*, J. Geophys. Res. 87 (C12), 9704–9706.
/// <https://doi.org/10.1029/JC087iC12p09704>
pub enum Wu1982 {}

/// Donelan, M. A. et al. (2004), *On the limiting aerodynamic roughness of the ocean in very strong winds*, Geophys. Res. Lett.
/// 31, L18306: the drag grows no further from some 33 m/s on. <https://doi.org/10.1029/2004GL019460>
pub enum Donelan2004 {}

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

/// Meeus, J. (1998), *Astronomical Algorithms*, 2nd ed., Willmann-Bell, ISBN 0-943396-61-1: chapter 12 (sidereal time),
/// chapter 21 (precession), chapter 25 (the sun to 0.01 degrees) and chapter 47 (the moon).
pub enum Meeus1998 {}

/// Kasten, F. and Young, A. T. (1989), *Revised optical air mass tables and approximation formula*, Appl. Opt. 28, 4735–4738.
/// <https://doi.org/10.1364/AO.28.004735>
pub enum KastenYoung1989 {}

/// Schlick, C. (1994), *An inexpensive BRDF model for physically-based rendering*, Computer Graphics Forum 13, 233–246.
/// <https://doi.org/10.1111/1467-8659.1330233>
pub enum Schlick1994 {}

/// Born, M. and Wolf, E. (1999), *Principles of Optics*, 7th ed., section 1.5: Fresnel's formulae.
/// <https://doi.org/10.1017/CBO9781139644181>
pub enum BornWolf1999 {}

/// Worley, S. (1996), *A cellular texture basis function*, SIGGRAPH 96, 291–294. <https://doi.org/10.1145/237170.237267>
pub enum Worley1996 {}

/// Abramowitz, M. and Stegun, I. A. (1964), *Handbook of mathematical functions*, NBS Applied Mathematics Series 55. No DOI.
pub enum AbramowitzStegun1964 {}

/// Steele, G. L., Lea, D. and Flood, C. H. (2014), *Fast splittable pseudorandom number generators*, OOPSLA '14: SplitMix,
/// whose finaliser hashes our counters. <https://doi.org/10.1145/2660193.2660195>
pub enum Steele2014 {}

/// Box, G. E. P. and Muller, M. E. (1958), *A note on the generation of random normal deviates*, Ann. Math. Statist. 29,
/// 610–611. <https://doi.org/10.1214/aoms/1177706645>
pub enum BoxMuller1958 {}

/// Cooley, J. W. and Tukey, J. W. (1965), *An algorithm for the machine calculation of complex Fourier series*, Math. Comp.
/// 19, 297–301. <https://doi.org/10.1090/S0025-5718-1965-0178586-1>
pub enum CooleyTukey1965 {}

/// Jarzynski, M. and Olano, M. (2020), *Hash functions for GPU rendering*, J. Comput. Graph. Tech. 9(3), 20–38.
/// <https://jcgt.org/published/0009/03/02/>
pub enum Jarzynski2020 {}

/// Perlin, K. (1985), *An image synthesizer*, SIGGRAPH Comput. Graph. 19(3), 287–296; the quintic fade is of his *Improving
/// noise* (2002), <https://doi.org/10.1145/566654.566636>. <https://doi.org/10.1145/325165.325247>
pub enum Perlin1985 {}

/// Monahan, E. C. and O'Muircheartaigh, I. (1980), *Optimal power-law description of oceanic whitecap coverage dependence on
/// wind speed*, J. Phys. Oceanogr. 10, 2094–2099. <https://doi.org/10.1175/1520-0485(1980)010%3C2094:OPLDOO%3E2.0.CO;2>
pub enum Monahan1980 {}

/// Pierson, W. J. and Moskowitz, L. (1964), *A proposed spectral form for fully developed wind seas based on the similarity theory of
/// S. A. Kitaigorodskii*, J. Geophys. Res. 69, 5181–5190. <https://doi.org/10.1029/JZ069i024p05181>
pub enum PiersonMoskowitz1964 {}

/// Hasselmann, K. and others (1973), *Measurements of wind-wave growth and swell decay during the Joint North Sea Wave Project
/// (JONSWAP)*, Deutsche Hydrographische Zeitschrift, supplement A8(12): the shape with the sharp peak and its growth with fetch. No DOI.
pub enum Hasselmann1973 {}

/// Bouws, E., Günther, H., Rosenthal, W. and Vincent, C. L. (1985), *Similarity of the wind wave spectrum in finite depth water 1*,
/// J. Geophys. Res. 90, 975–986: TMA. <https://doi.org/10.1029/JC090iC01p00975>
pub enum Bouws1985 {}

/// Kitaigorodskii, S. A., Krasitskii, V. P. and Zaslavskii, M. M. (1975), *On Phillips' theory of equilibrium range in the spectra of
/// wind-generated gravity waves*, J. Phys. Oceanogr. 5, 410–420.
/// <https://doi.org/10.1175/1520-0485(1975)005%3C0410:OPTOER%3E2.0.CO;2>
pub enum Kitaigorodskii1975 {}

/// Elfouhaily, T., Chapron, B., Katsaros, K. and Vandemark, D. (1997), *A unified directional spectrum for long and short wind-driven
/// waves*, J. Geophys. Res. 102, 15781–15796. <https://doi.org/10.1029/97JC00467>
pub enum Elfouhaily1997 {}

/// Mobley, C. D. (editor), *Ocean Optics Web Book*, chapter on wave variance spectra: Elfouhaily's spectrum with its constants written
/// out. <https://www.oceanopticsbook.info>
pub enum MobleyWebBook {}

/// Longuet-Higgins, M. S., Cartwright, D. E. and Smith, N. D. (1963), *Observations of the directional spectrum of sea waves using the
/// motions of a floating buoy*, in Ocean Wave Spectra, Prentice-Hall, 111–136: the cos^2s spread. No DOI.
pub enum LonguetHiggins1963 {}

/// Donelan, M. A., Hamilton, J. and Hui, W. H. (1985), *Directional spectra of wind-generated waves*, Phil. Trans. R. Soc. A 315,
/// 509–562. <https://doi.org/10.1098/rsta.1985.0054>
pub enum Donelan1985 {}

/// Banner, M. L. (1990), *Equilibrium spectra of wind waves*, J. Phys. Oceanogr. 20, 966–984: the spread beyond the peak.
/// <https://doi.org/10.1175/1520-0485(1990)020%3C0966:ESOWW%3E2.0.CO;2>
pub enum Banner1990 {}

/// Allen, C. W. (1973), *Astrophysical Quantities*, 3rd ed., Athlone Press, section 66: how bright the moon is by its phase.
pub enum Allen1973 {}

/// Goda, Y. (2010), *Random Seas and Design of Maritime Structures*, 3rd ed., World Scientific, chapter 2: peaks and spreads of
/// swells. <https://doi.org/10.1142/7425>
pub enum Goda2010 {}

/// Young, I. R. and Verhagen, L. A. (1996), *The growth of fetch limited waves in water of finite depth, part 1: total energy and peak
/// frequency*, Coastal Engineering 29, 47–78. <https://doi.org/10.1016/S0378-3839(96)00006-3>
pub enum YoungVerhagen1996 {}

/// Zhao, D. and Toba, Y. (2001), *Dependence of whitecap coverage on wind and wind-wave properties*, J. Oceanogr. 57, 603–616.
/// <https://doi.org/10.1023/A:1021215904955>
pub enum ZhaoToba2001 {}

/// Herdendorf, C. E. (1982), *Large lakes of the world*, J. Great Lakes Res. 8, 379–412: areas, depths and levels.
pub enum Herdendorf1982 {}

/// Monahan, E. C. (1971), *Oceanic whitecaps*, J. Phys. Oceanogr. 1, 139–144: how fast whitecaps fade.
/// <https://doi.org/10.1175/1520-0485(1971)001%3C0139:OW%3E2.0.CO;2>
pub enum Monahan1971 {}

/// Govindaraju, N. K., Lloyd, B., Dotsenko, Y., Smith, B. and Manferdelli, J. (2008), *High performance discrete Fourier transforms
/// on graphics processors*, Proc. ACM/IEEE Conf. on Supercomputing (SC '08), 2: Stockham's transform with several elements per
/// thread and exchanges through shared memory. <https://doi.org/10.1109/SC.2008.5213922>
pub enum Govindaraju2008 {}

/// Dupuy, J. (2020), *Concurrent binary trees (with application to longest edge bisection)*, Proc. ACM Comput. Graph. Interact.
/// Tech. 3(2), article 21: bits and sums that let threads split and merge triangles side by side. <https://doi.org/10.1145/3406186>
pub enum Cbt {}

/// Dally, W. R., Dean, R. G. and Dalrymple, R. A. (1985), *Wave height variation across beaches of arbitrary profile*, J. Geophys. Res. 90,
/// 11917–11927: how a broken wave decays, in closed form on a plane beach. <https://doi.org/10.1029/JC090iC06p11917>
pub enum Dally1985 {}

/// Weggel, J. R. (1972), *Maximum breaker height*, J. Waterways, Harbors and Coastal Eng. Div. 98, 529–548: breaker height over depth by
/// the bed's slope and the wave's steepness. No DOI.
pub enum Weggel1972 {}

/// Battjes, J. A. (1974), *Surf similarity*, Proc. 14th Int. Conf. on Coastal Eng., 466–480: what kind of breaker a wave becomes.
/// <https://doi.org/10.1061/9780872621138.029>
pub enum Battjes1974 {}

/// Battjes, J. A. and Janssen, J. P. F. M. (1978), *Energy loss and set-up due to breaking of random waves*, Proc. 16th Int. Conf. on
/// Coastal Eng., 569–587. <https://doi.org/10.1061/9780872621909.034>
pub enum Battjes1978 {}

/// Abreu, T., Silva, P. A., Sancho, F. and Temperville, A. (2010), *Analytical approximate wave form for asymmetric waves*, Coastal Eng.
/// 57, 656–667. <https://doi.org/10.1016/j.coastaleng.2010.02.005>
pub enum Abreu2010 {}

/// Ruessink, B. G., Ramaekers, G. and van Rijn, L. C. (2012), *On the parameterization of the free-stream non-linear wave orbital motion in
/// nearshore morphodynamic models*, Coastal Eng. 65, 56–63: shape by the Ursell number. <https://doi.org/10.1016/j.coastaleng.2012.03.006>
pub enum Ruessink2012 {}

/// Stockdon, H. F., Holman, R. A., Howd, P. A. and Sallenger, A. H. (2006), *Empirical parameterization of setup, swash, and runup*,
/// Coastal Eng. 53, 573–588. <https://doi.org/10.1016/j.coastaleng.2005.12.005>
pub enum Stockdon2006 {}

/// Shen, M. C. and Meyer, R. E. (1963), *Climb of a bore on a beach. Part 3. Run-up*, J. Fluid Mech. 16, 113–125: the sheet behind the front.
pub enum Shen1963 {}

/// Dean, R. G. (1991), *Equilibrium beach profiles: characteristics and applications*, J. Coastal Res. 7, 53–84: depth by the distance from the
/// shore to the power of two thirds, with a planar beach at the waterline, and the scale A by the size of grains, after B. Moore (1982). No DOI.
pub enum Dean1991 {}

/// Sunamura, T. (1984), *Quantitative predictions of beach-face slopes*, Geol. Soc. Am. Bull. 95, 242–245: slope by the height and period of
/// breakers and the size of grains.
pub enum Sunamura1984 {}

/// Zhao, H. (2005), *A fast sweeping method for eikonal equations*, Math. Comp. 74, 603–627: Godunov's upwind differences, swept over a
/// grid in four orders. <https://doi.org/10.1090/S0025-5718-04-01678-3>
pub enum Zhao2005 {}

/// Senn, H. V. and Hiser, H. W. (1959), *On the origin of hurricane spiral rain bands*, J. Meteor. 16, 419–426: bands as logarithmic spirals.
/// <https://doi.org/10.1175/1520-0469(1959)016%3C0419:OTOOHS%3E2.0.CO;2>
pub enum Senn1959 {}
