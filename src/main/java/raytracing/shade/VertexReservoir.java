package raytracing.shade;

import raytracing.color.MutableColor;
import raytracing.math.CounterRandom;
import raytracing.math.Vector;
import raytracing.scene.Material;
import raytracing.surface.Hit;

/**
 * Draws one of the points that a ray meets, also in mirrors and behind glass, as the next vertex of a random path of light:
 * in proportion to how much of the light that arrives there evenly comes back along the ray. The shader offers each point
 * as it meets it, and only the one drawn so far is kept (weighted reservoir sampling: Chao, A general purpose unequal
 * probability sampling plan, Biometrika 69:3, 1982). Not thread-safe.
 */
public final class VertexReservoir {
    /** Which colour of a material scatters the light that arrives evenly. */
    public enum Scattering {
        /** No vertex is drawn. */
        NONE,

        /** The diffuse colour, for light on its way from surface to surface. */
        DIFFUSE,

        /** The ambient colour, for what the eye sees of this light. */
        AMBIENT
    }

    /**
     * The greatest share of the light arriving evenly that comes back along a ray. A scene may have reflectances of 1 and
     * more, and between such walls light would never end; the whitest paints reflect nine tenths.
     */
    public static final double MOST_REFLECTANCE = 0.9;

    private final Scattering scattering;
    private final Hit drawn = new Hit();
    private final Hit first = new Hit();
    private final MutableColor offered = new MutableColor();
    private final MutableColor shareOfChance = new MutableColor();
    private boolean hasMet;
    private boolean isFound;
    private double chances;
    private double red;
    private double green;
    private double blue;

    public VertexReservoir(Scattering scattering) {
        this.scattering = scattering;
    }

    boolean isActive() {
        return scattering != Scattering.NONE;
    }

    /** Forgets the ray before. */
    public void clear() {
        isFound = false;
        hasMet = false;
        chances = 0;
        red = 0;
        green = 0;
        blue = 0;
    }

    /** Offers a point that the ray has met, with the factor on the light that comes from it and random bits of its own. */
    void offer(Hit met, Material material, MutableColor weight, long randomBits) {
        if (!hasMet) {
            hasMet = true;
            first.set(met);
        }
        offered.setProduct(weight, scattering == Scattering.DIFFUSE ? material.diffuse() : material.ambient());
        offered.scale(1 - material.transparency());
        double chance = offered.max();
        if (chance == 0) {
            return;
        }
        chances = Math.min(chances + chance, Double.MAX_VALUE);
        red += offered.red();
        green += offered.green();
        blue += offered.blue();
        if (!isFound || CounterRandom.upperFraction(randomBits) * chances < chance) {
            isFound = true;
            drawn.set(met);
            shareOfChance.set(offered.red() / chance, offered.green() / chance, offered.blue() / chance);
        }
    }

    /** Whether the ray met a point that scatters any light. */
    public boolean isFound() {
        return isFound;
    }

    /** The point drawn, if there is one; overwritten by the next. */
    public Hit hit() {
        return drawn;
    }

    /**
     * Multiplies the weight of a path by the share of the light arriving at the point drawn that comes back along the ray,
     * over the probability of the draw: so the mean over all draws is the sum over all points.
     */
    public void filter(MutableColor path) {
        path.set(path.red() * factor(shareOfChance.red(), red), path.green() * factor(shareOfChance.green(), green),
            path.blue() * factor(shareOfChance.blue(), blue));
    }

    /** Adds the share of the light arriving at the point drawn that comes back along the ray, however large, times a factor. */
    public void addShare(double factor, MutableColor sum) {
        sum.add(factor * red, factor * green, factor * blue);
    }

    private double factor(double share, double total) {
        return share * chances * Math.min(1, MOST_REFLECTANCE / total);
    }

    /** One over the distance to the first point met, 0 if there was none. */
    public double nearness(Hit from) {
        return hasMet ? 1 / Vector.length(first.x() - from.x(), first.y() - from.y(), first.z() - from.z()) : 0;
    }
}
