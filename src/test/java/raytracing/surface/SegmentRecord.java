package raytracing.surface;

import raytracing.math.Vector;

/** A {@link Segment} as a value that stays. */
public record SegmentRecord(Vector start, double startError, Vector end, double endError) {
    public Segment toSegment() {
        RayOrigin from = new RayOrigin();
        from.set(start, startError);
        Segment segment = new Segment();
        segment.connect(from, end.x(), end.y(), end.z(), endError);
        return segment;
    }
}
