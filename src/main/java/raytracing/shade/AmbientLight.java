package raytracing.shade;

import java.util.List;
import java.util.Optional;
import raytracing.color.Color;

/**
 * The ambient light of a room: at each point the mean, weighted with the cosine to the normal, of the light that arrives
 * from everywhere but the lamps. In the units of a lamp's colour: as much light of a lamp straight above would look the
 * same on a matt surface. Immutable; {@link AmbientLookup} asks it.
 */
public final class AmbientLight {
    /** None at all: of a scene that asks for none. */
    public static final AmbientLight NONE = even(Color.BLACK);

    private final Color mean;
    private final Optional<Places> places;

    /** The light at some places, as it counts near to them and far from them. */
    record Places(int count, IrradianceCache near, IrradianceCache wide) {
    }

    private AmbientLight(Color mean, Optional<Places> places) {
        this.mean = mean;
        this.places = places;
    }

    /**
     * The same light everywhere.
     *
     * @param mean the light
     * @return light that does not vary
     */
    public static AmbientLight even(Color mean) {
        return new AmbientLight(mean, Optional.empty());
    }

    /**
     * Light that varies from place to place.
     *
     * @param places at least one
     * @param further what arrives by further bounces than their own, where these end
     * @param mean what stands for places where there are none
     */
    static AmbientLight between(List<Place> places, Color further, Color mean) {
        return new AmbientLight(mean, Optional.of(new Places(places.size(),
            IrradianceCache.of(places, IrradianceCache.Reach.NEAR, further),
            IrradianceCache.of(places, IrradianceCache.Reach.WIDE, further))));
    }

    /** The same places with another mean. */
    AmbientLight withMean(Color newMean) {
        return new AmbientLight(newMean, places);
    }

    /**
     * Whether there is none, so that nobody need ask.
     *
     * @return true for {@link #NONE} alone
     */
    public boolean isNone() {
        return this == NONE;
    }

    /**
     * The one colour that comes nearest to the light in the whole room.
     *
     * @return mean over what the camera sees of surfaces with an ambient colour
     */
    public Color mean() {
        return mean;
    }

    /**
     * At how many places light was gathered.
     *
     * @return 0 if it does not vary
     */
    public int placeCount() {
        return places.isEmpty() ? 0 : places.get().count();
    }

    /**
     * How many paths were followed for it.
     *
     * @return 0 if it does not vary
     */
    public long pathCount() {
        return (long) DiffusePaths.RAYS * placeCount();
    }

    Optional<Places> places() {
        return places;
    }
}
