// Links that stand still: a fixed time, so that a picture is the same at every visit.

const STILL = "&time=2026-06-21T12:30:00Z&rate=0&seed=7";

/** Europe and North Africa from 3,000 km: half sea, half land, at noon. */
export const FROM_ORBIT = `#view=38,-2,3000000&clouds=0&wind=8@250${STILL}`;
/** The coast of Portugal from 30 km: the sea in the west, land in the east. */
export const COAST = `#view=38.7,-9.45,30000&clouds=0&wind=8@250${STILL}`;
/** The same ocean under broken clouds, and clouds from above them. */
export const UNDER_CLOUDS = `#view=35,-30,4,250,84&wind=6@250&clouds=0.5&quality=low${STILL}`;
export const OVER_CLOUDS = `#view=38,-20,2000000&clouds=0.5&quality=low${STILL}`;
/** Over the sand of the Bahamas, and with half of the picture in their water. */
export const IN_THE_WATER = `#view=24.31,-76.561,-1.5,0,80&clouds=0&wind=4@90${STILL}`;
export const AT_THE_SURFACE = `#view=24.31,-76.561,0,120,88&ride=1&clouds=0&wind=3@90${STILL}`;
/** Open Atlantic, 12 m above the water, looking west over the waves. */
export const AT_SEA = `#view=35,-30,12,270,80&clouds=0&wind=14@250${STILL}`;

/** Over a lake that no table knows: its level, over which the eye stays, comes with tiles of its own. */
export const OVER_A_LAKE = `#view=45.72,10.07,40,150,84&bft=3&clouds=0${STILL}`;
