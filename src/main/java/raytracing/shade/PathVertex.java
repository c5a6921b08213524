package raytracing.shade;

import raytracing.color.Color;
import raytracing.geometry.HitPoint;
import raytracing.math.CounterRandom;
import raytracing.math.Vector;
import raytracing.scene.Material;

/**
 * One of the points that a ray met, those in mirrors and behind glass included, drawn in proportion to how much of the
 * light that arrives there evenly comes back along the ray. There a random path of light goes on. It is drawn while the
 * ray is followed, so nothing is kept but the draw (weighted reservoir sampling: Chao, A general purpose unequal
 * probability sampling plan, Biometrika 69:3, 1982). One thread, ray after ray.
 */
final class PathVertex {
    /** What sends on the light that arrives evenly at a point. */
    enum Scattering {
        /** Nothing that anybody asks for. */
        NONE,

        /** The diffuse colour: light on its way from surface to surface. */
        DIFFUSE,

        /** The ambient colour: what the eye sees of it. */
        AMBIENT
    }

    /**
     * Of the light that arrives evenly, whatever a ray meets sends back at most this share. A scene may name reflectances
     * of 1 and more, and between such walls light would never end; the whitest paints reflect nine tenths.
     */
    static final double MOST_REFLECTANCE = 0.9;

    private final Scattering scattering;
    private final HitPoint point = new HitPoint();
    private final Weight offered = new Weight();
    private final Weight drawn = new Weight();
    private boolean isFound;
    private double chances;
    private double red;
    private double green;
    private double blue;
    private boolean hasMet;
    private double firstX;
    private double firstY;
    private double firstZ;

    PathVertex(Scattering scattering) {
        this.scattering = scattering;
    }

    boolean isWanted() {
        return scattering != Scattering.NONE;
    }

    /** For a new ray. */
    void clear() {
        isFound = false;
        chances = 0;
        red = 0;
        green = 0;
        blue = 0;
        hasMet = false;
    }

    /**
     * Offers a point that the ray has met; the first one first.
     *
     * @param hit the point
     * @param material its material
     * @param weight factor on whatever comes from the point
     * @param randomBits of this point alone
     */
    void offer(HitPoint hit, Material material, Weight weight, long randomBits) {
        if (!hasMet) {
            hasMet = true;
            firstX = hit.x();
            firstY = hit.y();
            firstZ = hit.z();
        }
        Color filter = scattering == Scattering.DIFFUSE ? material.diffuse() : material.ambient();
        offered.setFiltered(weight, filter);
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
            point.take(hit);
            drawn.set(offered.red() / chance, offered.green() / chance, offered.blue() / chance);
        }
    }

    /** Whether the ray met a point that sends on any light. */
    boolean isFound() {
        return isFound;
    }

    /** The point drawn, if there is one. */
    HitPoint point() {
        return point;
    }

    /**
     * Multiplies a path's weight by the share of the light arriving at the point drawn that comes back along the ray, over
     * the chance of the draw: so the mean over all draws is the sum over all points.
     */
    void filter(Weight path) {
        path.set(path.red() * factor(drawn.red(), red), path.green() * factor(drawn.green(), green),
            path.blue() * factor(drawn.blue(), blue));
    }

    private double factor(double shareOfChance, double total) {
        return shareOfChance * chances * Math.min(1, MOST_REFLECTANCE / total);
    }

    /** One over the distance to the first point met, 0 if there was none. */
    double nearness(HitPoint from) {
        return hasMet ? 1 / Vector.length(firstX - from.x(), firstY - from.y(), firstZ - from.z()) : 0;
    }
}
