package raytracing.trace;

import java.util.Arrays;
import raytracing.hierarchy.RayTraversal;
import raytracing.surface.Hit;
import raytracing.surface.Segment;

/**
 * How much light comes through between a hit and another point. Every surface that the open segment between them crosses
 * counts once. The hit's own surface counts where the segment goes through its body from wall to wall: so a body shadows the
 * part of a wide light that has sunk below the horizon of the hit. Not thread-safe.
 */
public final class SegmentQuery {
    private final PreparedScene scene;
    private final Segment segment = new Segment();
    private final CrossedSurfaces crossed;
    private final RayTraversal traversal = new RayTraversal();

    /** In each list, the entry of the surface that stopped the light last. */
    private final int[] lastOpaque;

    public SegmentQuery(PreparedScene scene) {
        this.scene = scene;
        crossed = new CrossedSurfaces(scene.transmittances());
        lastOpaque = new int[scene.lists().length];
        Arrays.fill(lastOpaque, SurfaceList.NONE);
    }

    /**
     * The product of the crossed surfaces' transmittances.
     *
     * @param x the other point, not the hit itself, world axes
     * @param error how far each of its coordinates may be off
     * @return in [0, 1]
     */
    public double transmittance(Hit from, double x, double y, double z, double error) {
        segment.connect(from.origin(), x, y, z, error);
        crossed.clear();
        SurfaceList[] lists = scene.lists();
        for (int i = 0; i < lists.length; i++) {
            lastOpaque[i] = lists[i].addCrossed(segment, traversal, crossed, lastOpaque[i]);
        }
        if (!crossed.isDark() && scene.isOwnBodyCrossed(from, segment)) {
            crossed.add(from.surface());
        }
        return crossed.transmittance();
    }
}
