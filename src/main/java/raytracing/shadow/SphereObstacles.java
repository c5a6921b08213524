package raytracing.shadow;

import raytracing.area.ConvexShadows;
import raytracing.math.Basis;
import raytracing.surface.Body;
import raytracing.surface.Segment;
import raytracing.surface.Sphere;
import raytracing.trace.CrossedSurfaces;
import raytracing.trace.PreparedScene;

/**
 * The spheres that some lines of a shaft cross and others may not.
 *
 * <p>With m the way from the hit to the centre, in the shaft's coordinates, and e the line's end, the line meets the sphere if
 * (m . e)^2 &gt;= (m . m - r r)(e . e): its cosine to the axis of the cone around the sphere is large enough. That is a
 * product and a sum less than the world's coordinates need, which also have to be found first.
 *
 * <p>The shadow of a sphere between hit and square is the section of a cone. A sphere that reaches through the plane of the
 * square hides what is behind its tangent circle in that cone, and the disc that the plane cuts out of it; a sphere around the
 * hit hides all but the disc.
 */
final class SphereObstacles extends Obstacles<SphereObstacles.SphereObstacle> {
    /** In the shaft's coordinates, as far as lengths are meant. */
    static final class SphereObstacle extends Obstacle {
        private Sphere sphere;

        /** The way to the centre along x, along y, and along z times the shaft's depth. */
        private double across;
        private double up;
        private double ahead;

        /** The squared way to the centre less the squared radius. */
        private double power;

        /** How the hit and the square lie to the sphere, which decides how lines are tested. */
        private Place place;

        /** The error of a line's test, and of its end's; infinite where the test in the world decides. */
        private double doubt;
        private double endDoubt;

        /**
         * Dims by the shaft's coordinates where these decide. In one piece, with a loop for the most frequent place: the
         * virtual machine does not compile a method of more than 325 bytes into its callers again (DECISIONS).
         */
        @Override
        void dim(double passing, Shaft shaft, LightSamples samples) {
            double[] transmittance = samples.transmittance;
            if (place == Place.BETWEEN) {
                for (int i = 0; i < samples.count; i++) {
                    if (transmittance[i] > 0) {
                        double x = samples.x[i];
                        double y = samples.y[i];
                        double product = x * across + y * up + ahead;
                        double inside = product * product - power * samples.squaredDistance[i];
                        if (Math.abs(inside) > doubt ? inside > 0 && product > 0 : isCrossed(shaft.segmentTo(x, y))) {
                            transmittance[i] *= passing;
                        }
                    }
                }
                return;
            }
            for (int i = 0; i < samples.count; i++) {
                if (transmittance[i] > 0) {
                    double x = samples.x[i];
                    double y = samples.y[i];
                    double squaredLength = samples.squaredDistance[i];
                    double product = x * across + y * up + ahead;
                    double inside = product * product - power * squaredLength;
                    double endPower = squaredLength - 2 * product + power;
                    boolean isEndClear = Math.abs(endPower) > endDoubt;
                    boolean isCrossed;
                    if (place == Place.AROUND_THE_HIT && isEndClear) {
                        isCrossed = endPower > 0;
                    } else if (place == Place.TOUCHED_FROM_OUTSIDE && Math.abs(product) > doubt) {
                        isCrossed = product > 0;
                    } else if (place == Place.REACHING_BEYOND && isEndClear && endPower < 0) {
                        isCrossed = true;
                    } else if (place == Place.REACHING_BEYOND && isEndClear && Math.abs(inside) > doubt) {
                        isCrossed = inside > 0 && product > 0 && product < squaredLength;
                    } else {
                        isCrossed = isCrossed(shaft.segmentTo(x, y));
                    }
                    if (isCrossed) {
                        transmittance[i] *= passing;
                    }
                }
            }
        }

        /** By the world's coordinates. */
        private boolean isCrossed(Segment line) {
            return place == Place.TOUCHED_FROM_INSIDE ? sphere.isLeft(line) : sphere.isCrossed(line, number);
        }
    }

    /** Where a sphere is that some lines may cross and others not. */
    private enum Place {
        /** The hit is outside, and the sphere ends before the plane of the square. */
        BETWEEN,

        /** The hit is outside, and the sphere reaches into that plane or beyond: it may hold ends of lines. */
        REACHING_BEYOND,

        AROUND_THE_HIT,
        TOUCHED_FROM_OUTSIDE,
        TOUCHED_FROM_INSIDE,

        /** Rounding leaves the side of the hit open. */
        UNKNOWN
    }

    /** 64 u, with u = 2^-53: axes that are off by 8 ulp, twice, and what rounding takes from the squares. */
    private static final double POWER_ERROR = 0x1p-47;

    private final Sphere[] spheres;
    private final double[] packed;

    SphereObstacles(Shaft shaft, PreparedScene scene) {
        super(shaft, scene, scene.spheres(), new SphereObstacle[0]);
        spheres = scene.spheres().spheres();
        packed = scene.spheres().packed();
    }

    @Override
    SphereObstacle create() {
        return new SphereObstacle();
    }

    @Override
    boolean isBeside(int place, NearbyShafts shafts) {
        Sphere sphere = spheres[place];
        return shafts.isBeside(sphere.centre().x(), sphere.centre().y(), sphere.centre().z(), sphere.radius());
    }

    @Override
    void sort(int[] numbers, int from, int to, CrossedSurfaces certain) {
        Basis axes = shaft.axes;
        double px = shaft.hit.x();
        double py = shaft.hit.y();
        double pz = shaft.hit.z();
        double wx = axes.wx();
        double wy = axes.wy();
        double wz = axes.wz();
        double depth = shaft.depth;
        int surfaceLeft = shaft.hit.surface();
        for (int i = from; i < to && !certain.isDark(); i++) {
            int at = Body.PACKED * i;
            double fx = packed[at] - px;
            double fy = packed[at + 1] - py;
            double fz = packed[at + 2] - pz;
            double radius = packed[at + 3];
            double mz = fx * wx + fy * wy + fz * wz;
            double slack = shaft.slack(fx, fy, fz, radius);
            double grown = radius + slack;
            if (mz + grown < 0 || mz - grown > depth || numbers[i] == surfaceLeft) {
                continue;                    // before or behind the shaft
            }
            double mx = fx * axes.ux() + fy * axes.uy() + fz * axes.uz();
            double my = fx * axes.vx() + fy * axes.vy() + fz * axes.vz();
            double wall = shaft.halfWidth * mz + grown * shaft.slant;
            if (Math.abs(mx) * depth <= wall && Math.abs(my) * depth <= wall) {
                sort(spheres[i], numbers[i], mx, my, mz, slack, certain);
            }
        }
    }

    /**
     * Sorts a sphere that the shaft may touch.
     *
     * @param mx way from the hit to the centre, in the shaft's coordinates
     * @param slack by how much the sphere may be larger or smaller, rounding of all sides included
     */
    private void sort(Sphere sphere, int number, double mx, double my, double mz, double slack, CrossedSurfaces certain) {
        double r = sphere.radius();
        double grown = r + slack;
        double shrunk = r - slack;
        double squaredDistance = mx * mx + my * my + mz * mz;
        double power = squaredDistance - r * r;
        boolean isOutside = squaredDistance > grown * grown;
        if (isOutside && mz + grown < shaft.depth) {
            if (hidesSquare(mx, my, mz, squaredDistance, shrunk)) {
                certain.add(number);
            } else {
                double error = errorBeside(squaredDistance);
                add(sphere, number, mx, my, mz, power, Place.BETWEEN, doubt(error), ALWAYS_IN_DOUBT);
            }
            return;
        }
        double gap = shaft.depth - mz;
        boolean isInside = shrunk > 0 && squaredDistance < shrunk * shrunk;
        boolean containsSquare = shrunk > 0 && squaredFarthest(mx, my) + gap * gap < shrunk * shrunk;
        if (isOutside && containsSquare || isInside && squaredBeside(mx, my) + gap * gap > grown * grown) {
            certain.add(number);
        } else if (!(isInside && containsSquare)) {
            Place place = isOutside ? Place.REACHING_BEYOND : isInside ? Place.AROUND_THE_HIT
                : touchedPlace(sphere, number, squaredDistance, power);
            double error = place == Place.TOUCHED_FROM_OUTSIDE
                ? grown * (Shaft.ROUNDING * shaft.cornerDistance + 4 * shaft.margin) + slack * shaft.cornerDistance
                : errorBeside(squaredDistance);
            // an end that rounding may put on the wall has a power of at most slack (2 r + slack), which is rounded itself
            double endError = 4 * slack * grown
                + Shaft.ROUNDING * (squaredDistance + shaft.cornerDistance * shaft.cornerDistance);
            add(sphere, number, mx, my, mz, power, place, doubt(error), doubt(endError));
        }
    }

    /** The error of the test whether a line comes as near to the centre as the sphere is large. */
    private double errorBeside(double squaredDistance) {
        return squaredDistance * shaft.cornerDistance * (Shaft.ROUNDING * shaft.cornerDistance + 4 * shaft.margin);
    }

    /** For a hit that may be on the wall: if it certainly is, within its error, exact numbers tell the side. */
    private Place touchedPlace(Sphere sphere, int number, double squaredDistance, double power) {
        if (Math.abs(power) + POWER_ERROR * squaredDistance > 2 * shaft.hit.error() * Math.sqrt(squaredDistance)) {
            return Place.UNKNOWN;
        }
        int side = sphere.side(shaft.hit.origin(), number);
        return side > 0 ? Place.TOUCHED_FROM_OUTSIDE : side < 0 ? Place.TOUCHED_FROM_INSIDE : Place.UNKNOWN;
    }

    private void add(Sphere sphere, int number, double mx, double my, double mz, double power, Place place, double doubt,
                     double endDoubt) {
        SphereObstacle obstacle = add(number);
        obstacle.sphere = sphere;
        obstacle.across = mx;
        obstacle.up = my;
        obstacle.ahead = mz * shaft.depth;
        obstacle.power = power;
        obstacle.place = place;
        obstacle.doubt = doubt;
        obstacle.endDoubt = endDoubt;
    }

    /** For a sphere between hit and square: whether it is met on the way to all four corners, and so on all ways. */
    private boolean hidesSquare(double mx, double my, double mz, double squaredDistance, double shrunk) {
        double least = mz * shaft.depth - shaft.halfWidth * (Math.abs(mx) + Math.abs(my));
        double squaredCorner = shaft.cornerDistance * shaft.cornerDistance;
        double limit = (squaredDistance - shrunk * shrunk + Shaft.ROUNDING * squaredDistance) * squaredCorner;
        return shrunk > 0 && least > 0 && least * least > limit;
    }

    /** How far a centre is beside the square, seen along the shaft's axis, squared. */
    private double squaredBeside(double mx, double my) {
        double besideX = Math.max(Math.abs(mx) - shaft.halfWidth, 0);
        double besideY = Math.max(Math.abs(my) - shaft.halfWidth, 0);
        return besideX * besideX + besideY * besideY;
    }

    /** The same from the farthest corner of the square. */
    private double squaredFarthest(double mx, double my) {
        double farX = Math.abs(mx) + shaft.halfWidth;
        double farY = Math.abs(my) + shaft.halfWidth;
        return farX * farX + farY * farY;
    }

    @Override
    void addShadow(SphereObstacle obstacle, double passing, ConvexShadows shadows) {
        double mx = obstacle.across;
        double my = obstacle.up;
        double mz = obstacle.ahead / shaft.depth;
        double r = obstacle.sphere.radius();
        double slack = shaft.margin + 2 * Shaft.ROUNDING * (Math.abs(mx) + Math.abs(my) + Math.abs(mz) + r);
        double distance = Math.sqrt(mx * mx + my * my + mz * mz);
        if (distance > r + slack) {
            addShadowFromOutside(mx, my, mz, r, (distance - r) * (distance + r), passing, shadows);
            return;
        }
        int side = distance < r - slack ? -1 : obstacle.sphere.side(shaft.hit.origin(), obstacle.number);
        if (side > 0) {
            shadows.beginFigure(passing, 1);    // all that is behind the wall at the hit
            shadows.addLine(mx, my, mz * shaft.depth);
        } else if (side < 0) {
            addShadowOfAllBut(mx, my, mz, r, 0, 0, 1, passing, shadows);
        } else {
            addShadowOfAllBut(mx, my, mz, r, mx, my, mz * shaft.depth, passing, shadows);
        }
    }

    /**
     * Of a sphere that the hit is not in, the disc matters only where the square is not wholly behind the tangent circle.
     * A sphere behind the square throws no shadow on it.
     */
    private void addShadowFromOutside(double mx, double my, double mz, double r, double power, double passing,
                                      ConvexShadows shadows) {
        double gap = mz - shaft.depth;
        double behindCircle = mz * shaft.depth - power - shaft.halfWidth * (Math.abs(mx) + Math.abs(my));
        if (Math.abs(gap) < r && behindCircle < 0) {
            shadows.discs().addThroughPlane(mx, my, mz, r, Math.sqrt((r - gap) * (r + gap)), passing);
        } else if (gap < r) {
            shadows.balls().add(mx, my, mz, r, passing);
        }
    }

    /** Adds a shadow of everything on the inner side of a line but the disc that the square's plane cuts out of a sphere. */
    private void addShadowOfAllBut(double mx, double my, double mz, double r, double lineA, double lineB, double lineC,
                                   double passing, ConvexShadows shadows) {
        double gap = mz - shaft.depth;
        double squaredRadius = (r - gap) * (r + gap);
        if (squaredBeside(mx, my) < squaredRadius) {
            shadows.discs().addAround(mx, my, Math.sqrt(squaredRadius), passing, lineA, lineB, lineC);
        } else {
            shadows.beginFigure(passing, 1);
            shadows.addLine(lineA, lineB, lineC);
        }
    }

    /** Adds the shadow of the sphere that was hit: everything on the inner side of a line but what is in the sphere. */
    void addOwnShadow(Sphere sphere, double lineA, double lineB, double lineC, double passing, ConvexShadows shadows) {
        Basis axes = shaft.axes;
        double fx = sphere.centre().x() - shaft.hit.x();
        double fy = sphere.centre().y() - shaft.hit.y();
        double fz = sphere.centre().z() - shaft.hit.z();
        addShadowOfAllBut(fx * axes.ux() + fy * axes.uy() + fz * axes.uz(),
            fx * axes.vx() + fy * axes.vy() + fz * axes.vz(), fx * axes.wx() + fy * axes.wy() + fz * axes.wz(),
            sphere.radius(), lineA, lineB, lineC, passing, shadows);
    }
}
