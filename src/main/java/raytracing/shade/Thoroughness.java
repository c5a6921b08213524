package raytracing.shade;

/**
 * How many of the rays are followed into which mirrors and glass split a ray.
 *
 * @param negligibleWeight below which no ray is followed; 0: all are
 * @param mostSurfaces that the mirrored rays of one pixel may meet before those that still wait are left out
 * @param mostRays how many mirrored rays of one pixel may be followed
 * @param unseenWeight weight of all rays left out of a pixel together up to which the background stands for them, and beyond
 *        which their light is estimated
 */
record Thoroughness(double negligibleWeight, int mostSurfaces, int mostRays, double unseenWeight) {
    /**
     * For pictures. No 8-bit channel shows a weight of 2^-12: light of 1 adds less than a sixteenth of a step of 1/255. This
     * bounds the change by one ray left out (proved); many add up, and from two steps of light of 1 on, 2^-7, are estimated. On
     * the scenes of this project no pixel differs by more than one step from the picture with all rays followed (measured in
     * {@code LeftOutLightTest}).
     *
     * <p>The deepest pixel of the known scenes that are no halls of mirrors meets 373 surfaces, with 97 in
     * {@code scenes/bubbles.txt}; 4096 surfaces take about a millisecond without lights. In halls
     * of planes 512 rays meet about half as many.
     */
    static final Thoroughness OF_A_PICTURE = new Thoroughness(0x1p-12, 1 << 12, 1 << 9, 0x1p-7);

    /**
     * For the rays of an estimate, thousands of which make a mean: what one of them leaves out adds at most a sixty-fourth of
     * its light, and in a hall of mirrors it ends sooner.
     */
    static final Thoroughness OF_A_MEAN = new Thoroughness(0x1p-6, 1 << 7, 1 << 7, Double.POSITIVE_INFINITY);
}
