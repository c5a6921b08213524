package raytracing.compiled;

import raytracing.geometry.Answer;
import raytracing.geometry.HitPoint;

/**
 * A line along which light may come to a hit, and the surfaces that it crosses. Every surface that the open line
 * meets counts once. The hit's own surface counts where the line goes through its body from wall to wall: so a body shadows
 * the part of a wide light that has sunk below the horizon of the hit.
 *
 * <p>One thread, line after line.
 */
public final class ShadowLine {
    private static final int NONE = Integer.MAX_VALUE;

    double px;
    double py;
    double pz;
    double pointError;
    double qx;
    double qy;
    double qz;
    double endError;
    double dx;
    double dy;
    double dz;
    int surfaceLeft;

    /** Entries of the opaque surfaces that stopped light last: many lines in turn are stopped by the same. */
    int lastSphere = NONE;
    int lastBox = NONE;

    final CrossedSurfaces crossed;
    private final HierarchyWalk hierarchyWalk = new HierarchyWalk();
    private final CompiledScene scene;
    private HitPoint hit;

    /**
     * No line yet.
     *
     * @param scene the surfaces
     */
    public ShadowLine(CompiledScene scene) {
        this.scene = scene;
        crossed = new CrossedSurfaces(scene.transmittances());
    }

    /**
     * How much light comes through between a hit and a point off it.
     *
     * @param from one end
     * @param endX the other end, x part
     * @param endY y part
     * @param endZ z part
     * @param error how far each part of the other end may be off
     * @return product of the crossed surfaces' transmittances, in [0, 1]
     */
    public double transmittance(HitPoint from, double endX, double endY, double endZ, double error) {
        hit = from;
        px = hit.x();
        py = hit.y();
        pz = hit.z();
        pointError = hit.error();
        qx = endX;
        qy = endY;
        qz = endZ;
        endError = error;
        dx = qx - px;
        dy = qy - py;
        dz = qz - pz;
        surfaceLeft = hit.surface();
        crossed.clear();
        scene.addCrossed(this, hierarchyWalk);
        if (!crossed.isDark() && scene.isOwnBodyCrossed(hit, qx, qy, qz, endError)) {
            crossed.add(surfaceLeft);
        }
        return crossed.transmittance();
    }

    /** Whether this line crosses a surface, given what doubles say. */
    boolean isCrossing(Answer quick, int surface) {
        return scene.isCrossed(quick, hit, surface, qx, qy, qz, endError);
    }
}
