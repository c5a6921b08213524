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

    /** For each target and list, the entry of the surface that stopped the light last. */
    private final int[] lastOpaque;

    /** For segments to so many targets, such as lights; what stopped the light is remembered for each. */
    public SegmentQuery(PreparedScene scene, int targets) {
        this.scene = scene;
        crossed = new CrossedSurfaces(scene.transmittances());
        lastOpaque = new int[targets * scene.lists().length];
        Arrays.fill(lastOpaque, SurfaceList.NONE);
    }

    /**
     * The product of the crossed surfaces' transmittances.
     *
     * @param target number of the target that the other point belongs to, from 0
     * @param x the other point, not the hit itself, world axes
     * @param error how far each of its coordinates may be off
     * @return in [0, 1]
     */
    public double transmittance(Hit from, int target, double x, double y, double z, double error) {
        segment.connect(from.origin(), x, y, z, error);
        crossed.clear();
        SurfaceList[] lists = scene.lists();
        int memory = target * lists.length;
        for (SurfaceList list : lists) {
            lastOpaque[memory] = list.addCrossed(segment, traversal, crossed, lastOpaque[memory]);
            memory++;
        }
        if (!crossed.isDark() && scene.isOwnSurfaceCrossed(from, segment)) {
            crossed.add(from.surface());
        }
        return crossed.transmittance();
    }
}
