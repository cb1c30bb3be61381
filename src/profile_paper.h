/* Lengths of the paper profile that are no parameters, published in cells of 40 mm. */
#ifndef RS_PROFILE_PAPER_H
#define RS_PROFILE_PAPER_H

/* The blur's sigma at the first scale, and from one scale to the next. */
#define RS_SIGMA_START_MM 40u
#define RS_SIGMA_STEP_MM 20u

/* The background's seed is the grown obstacles shrunk by this. */
#define RS_BACKGROUND_EROSION_MM 80u

/* Sigma of the ridge map's Gaussian. */
#define RS_RIDGE_SIGMA_MM 80u

#endif
