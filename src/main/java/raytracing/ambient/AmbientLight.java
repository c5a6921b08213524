package raytracing.ambient;

import java.util.List;
import java.util.Optional;
import raytracing.color.Color;

/**
 * The ambient light of a room: at each point the mean, weighted with the cosine to the normal, of the light that arrives
 * from everywhere but the lamps. In the units of a lamp's colour: as much light of a lamp straight above would look the
 * same on a matt surface. Immutable; each thread reads it through an {@link AmbientLookup} of its own.
 *
 * @param mean the one colour that is nearest to the light in all that the camera sees of surfaces with an ambient colour; it
 *        is also used where no record counts
 * @param records empty if the light is the mean everywhere
 * @param error about how far the picture is from one in the true light: the root of the mean square, in steps of 1/255 of what
 *        8-bit channels show; 0 if the light was not estimated
 */
public record AmbientLight(Color mean, Optional<Records> records, double error) {
    /** No ambient light, for scenes without ambient colours. */
    public static final AmbientLight NONE = even(Color.BLACK);

    /**
     * Light that varies from point to point.
     *
     * @param count of the irradiance records in each cache
     * @param paths of light that were followed for them
     * @param near counts where records lie close to each other
     * @param wide the same records with larger radii, used where {@code near} has too little weight
     */
    public record Records(int count, long paths, IrradianceCache near, IrradianceCache wide) {
        /** Sorts at least one record, near and wide, into caches. */
        public static Records of(List<IrradianceRecord> near, List<IrradianceRecord> wide, long paths) {
            return new Records(near.size(), paths, new IrradianceCache(near), new IrradianceCache(wide));
        }
    }

    /** The same light everywhere. */
    public static AmbientLight even(Color mean) {
        return new AmbientLight(mean, Optional.empty(), 0);
    }

    /** Whether this is {@link #NONE}, so that no lookup is needed. */
    public boolean isNone() {
        return this == NONE;
    }

    /** How many irradiance records there are; 0 if the light does not vary. */
    public int recordCount() {
        return records.isEmpty() ? 0 : records.get().count();
    }

    /** How many paths of light were followed for the records; 0 if the light does not vary. */
    public long pathCount() {
        return records.isEmpty() ? 0 : records.get().paths();
    }
}
