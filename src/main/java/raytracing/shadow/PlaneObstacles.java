package raytracing.shadow;

import java.util.Optional;
import raytracing.area.ConvexShadows;
import raytracing.math.Basis;
import raytracing.surface.Hit;
import raytracing.surface.Plane;
import raytracing.trace.CrossedSurfaces;
import raytracing.trace.PlaneGroups;
import raytracing.trace.PreparedScene;

/**
 * The planes that some lines of a shaft cross and others do not. The gap between plane and light square is linear in the
 * square's coordinates, so its least and its greatest value are at corners.
 */
final class PlaneObstacles extends Obstacles<PlaneObstacles.PlaneObstacle> {
    /** All gaps in multiples of the plane's normal. */
    static final class PlaneObstacle extends Obstacle {
        private Plane plane;

        /** How far the hit is below the plane; where rounding leaves that open, only its sign; 0 for a hit on the plane. */
        private double gap;

        /** How far the middle of the light is below the plane. */
        private double middleGap;

        /** What that gap loses for each step along the square's two axes. */
        private double alongU;
        private double alongV;

        /** How far gaps may be off. */
        private double doubt;

        @Override
        void dim(double passing, Shaft shaft, LightSamples samples) {
            double[] transmittance = samples.transmittance;
            for (int i = 0; i < samples.count; i++) {
                if (transmittance[i] > 0) {
                    double x = samples.x[i];
                    double y = samples.y[i];
                    double endGap = middleGap - (x * alongU + y * alongV);
                    if (Math.abs(endGap) > doubt ? gap > 0 != endGap > 0 : plane.isCrossed(shaft.segmentTo(x, y), number)) {
                        transmittance[i] *= passing;
                    }
                }
            }
        }
    }

    /** From the middle of a square to a corner, in halves of its edge, rounded up. */
    private static final double TO_CORNER = 1.5;

    private final Plane[] planes;
    private final Optional<PlaneGroups> groups;

    PlaneObstacles(Shaft shaft, PreparedScene scene) {
        super(shaft, scene, scene.planes(), new PlaneObstacle[0]);
        planes = scene.planes().planes();
        groups = scene.planes().groups();
    }

    @Override
    PlaneObstacle create() {
        return new PlaneObstacle();
    }

    @Override
    boolean isBeside(int place, NearbyShafts shafts) {
        return shafts.isBeside(planes[place]);
    }

    @Override
    void sortAll(int[] numbers, CrossedSurfaces certain) {
        if (groups.isEmpty()) {
            super.sortAll(numbers, certain);
        } else {
            sortGroups(groups.get(), numbers, certain);
        }
    }

    private void sortGroups(PlaneGroups all, int[] numbers, CrossedSurfaces certain) {
        Hit hit = shaft.hit;
        double error = shaft.margin + Shaft.ROUNDING * shaft.reach;
        long place = PlaneGroups.START;
        do {
            place = all.next(place, hit.x(), hit.y(), hit.z(), error, shaft.tx, shaft.ty, shaft.tz,
                TO_CORNER * shaft.halfWidth, 1);
            if (place != PlaneGroups.END) {
                sort(numbers, all.from(place), all.to(place), certain);
            }
        } while (place != PlaneGroups.END && !certain.isDark());
    }

    @Override
    void sort(int[] numbers, int from, int to, CrossedSurfaces certain) {
        int surfaceLeft = shaft.hit.surface();
        for (int i = from; i < to && !certain.isDark(); i++) {
            if (numbers[i] != surfaceLeft) {
                sort(planes[i], numbers[i], certain);
            }
        }
    }

    private void sort(Plane plane, int number, CrossedSurfaces certain) {
        Hit hit = shaft.hit;
        Basis axes = shaft.axes;
        double x = plane.normal().x();
        double y = plane.normal().y();
        double z = plane.normal().z();
        double offset = plane.offset();
        double gap = offset - (x * hit.x() + y * hit.y() + z * hit.z());
        double middleGap = offset - (x * shaft.lx + y * shaft.ly + z * shaft.lz);
        double alongU = x * axes.ux() + y * axes.uy() + z * axes.uz();
        double alongV = x * axes.vx() + y * axes.vy() + z * axes.vz();
        double size = Math.abs(x) + Math.abs(y) + Math.abs(z);
        double error = size * (shaft.margin + Shaft.ROUNDING * shaft.reach) + Shaft.ROUNDING * Math.abs(offset);
        double spread = shaft.halfWidth * (Math.abs(alongU) + Math.abs(alongV));
        boolean isGapClear = Math.abs(gap) > error;
        if (isGapClear && Math.abs(middleGap) - spread > error) {
            if (gap > 0 != middleGap > 0) {
                certain.add(number);
            }
            return;
        }
        PlaneObstacle obstacle = add(number);
        obstacle.plane = plane;
        obstacle.gap = isGapClear ? gap : -plane.side(hit.origin(), number);
        obstacle.middleGap = middleGap;
        obstacle.alongU = alongU;
        obstacle.alongV = alongV;
        obstacle.doubt = obstacle.gap != 0 ? doubt(error) : ALWAYS_IN_DOUBT;
    }

    /** All that is beyond the plane; nothing of a plane that the hit is on. */
    @Override
    void addShadow(PlaneObstacle obstacle, double passing, ConvexShadows shadows) {
        if (obstacle.gap != 0) {
            double towards = obstacle.gap > 0 ? 1 : -1;
            shadows.beginFigure(passing, 1);
            shadows.addLine(towards * obstacle.alongU, towards * obstacle.alongV, -towards * obstacle.middleGap);
        }
    }
}
