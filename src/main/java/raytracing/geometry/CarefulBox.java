package raytracing.geometry;

import raytracing.math.DoubleDouble;
import raytracing.math.Dyadic;
import raytracing.math.Vector;

/**
 * The questions about boxes that doubles leave open: rays through edges and corners or in the plane of a face, origins
 * on a face. Ways to the faces are double-doubles, whose signs are right; which of two faces is passed first is asked of
 * exact numbers where 106 bits leave a doubt. So every decision is that of real arithmetic on the doubles given,
 * provided the sizes of lengths differ by less than 2^400.
 */
final class CarefulBox {
    /** Error of the difference of two products of a way and a speed, relative to either: below 2^-100 (proved). */
    private static final double ERROR = 0x1p-98;

    private CarefulBox() {
    }

    /**
     * A ray and the two faces of the cube on one axis. The near one is that which the ray passes first, wherever it
     * starts; ways count along the ray.
     *
     * @param sign 1 or -1, that of the ray's direction on this axis
     * @param speed size of the direction on this axis
     * @param from where the ray starts
     * @param error how far that may be off
     * @param middle of the cube
     * @param half the edge, from the middle to a face
     */
    private record Slab(double sign, DoubleDouble speed, double from, double error, double middle, double half) {
        boolean isCrossed() {
            return speed.sign() != 0;
        }

        DoubleDouble wayToNear() {
            return way(-half);
        }

        DoubleDouble wayToFar() {
            return way(half);
        }

        /** The way to a face; 0 if the ray starts on the face's plane as far as that is known. */
        private DoubleDouble way(double towards) {
            DoubleDouble way = DoubleDouble.difference(sign * middle, sign * from).plus(new DoubleDouble(towards, 0));
            return Math.abs(way.high()) <= error ? DoubleDouble.ZERO : way;
        }

        private Dyadic exactWay(double towards) {
            return way(towards).sign() == 0 ? Dyadic.ZERO
                : Dyadic.of(sign * middle).minus(Dyadic.of(sign * from)).plus(Dyadic.of(towards));
        }

        private Dyadic exactSpeed() {
            return Dyadic.of(speed.high()).plus(Dyadic.of(speed.low()));
        }

        double crossing(double towards) {
            return BoxKernel.crossing(from, sign * speed.high(), middle, towards);
        }

        boolean isEnteredAfterEntering(Slab other) {
            return isAfter(-half, other, -other.half);
        }

        boolean isEnteredAfterLeaving(Slab other) {
            return isAfter(-half, other, other.half);
        }

        boolean isLeftAfterLeaving(Slab other) {
            return isAfter(half, other, other.half);
        }

        /** Compares way / speed with that of another slab, multiplied out. */
        private boolean isAfter(double towards, Slab other, double otherTowards) {
            DoubleDouble mine = way(towards).times(other.speed);
            DoubleDouble others = other.way(otherTowards).times(speed);
            double difference = mine.minus(others).high();
            if (Math.abs(difference) > ERROR * Math.abs(mine.high())) {
                return difference > 0;
            }
            return exactWay(towards).times(other.exactSpeed())
                .minus(other.exactWay(otherTowards).times(exactSpeed())).signum() > 0;
        }
    }

    /**
     * {@link BoxKernel#firstCrossing}, for the rays that it leaves open. Where sizes near the ends of the range are the
     * reason, it is asked again about the same in an ordinary size, where doubles answer most.
     */
    static double firstCrossing(double ox, double oy, double oz, double dx, double dy, double dz,
                                double originError, double cx, double cy, double cz, double half) {
        Vector origin = new Vector(ox, oy, oz);
        Vector direction = new Vector(dx, dy, dz);
        Vector centre = new Vector(cx, cy, cz);
        int length = Scaling.exponent(half, origin, centre);
        int step = Scaling.exponent(0, direction);
        if (length == 0 && step == 0) {
            return firstCrossing(slab(ox, dx, originError, cx, half), slab(oy, dy, originError, cy, half),
                slab(oz, dz, originError, cz, half));
        }
        Vector o = Scaling.down(origin, length);
        Vector d = Scaling.down(direction, step);
        Vector c = Scaling.down(centre, length);
        return Scaling.upPositive(BoxKernel.firstCrossing(o.x(), o.y(), o.z(), d.x(), d.y(), d.z(),
            Scaling.down(originError, length), c.x(), c.y(), c.z(), Scaling.down(half, length)), length - step);
    }

    private static Slab slab(double o, double d, double error, double c, double h) {
        return new Slab(Math.copySign(1, d), new DoubleDouble(Math.abs(d), 0), o, error, c, h);
    }

    private static double firstCrossing(Slab... slabs) {
        Slab entered = firstCrossed(slabs);
        Slab left = entered;
        for (Slab slab : slabs) {
            if (slab.isCrossed()) {
                entered = slab.isEnteredAfterEntering(entered) ? slab : entered;
                left = left.isLeftAfterLeaving(slab) ? slab : left;
            } else if (isBeyond(slab)) {
                return Surface.MISS;         // beside the cube all the way
            }
        }
        if (entered.isEnteredAfterLeaving(left)) {
            return Surface.MISS;
        }
        if (entered.wayToNear().sign() > 0) {
            return entered.crossing(-entered.half());
        }
        return left.wayToFar().sign() > 0 ? left.crossing(left.half()) : Surface.MISS;
    }

    private static Slab firstCrossed(Slab... slabs) {
        int i = 0;
        while (!slabs[i].isCrossed()) {
            i++;
        }
        return slabs[i];
    }

    /** Whether a point is strictly outside. */
    static boolean isOutside(Vector point, double pointError, Vector centre, double half) {
        int length = Scaling.exponent(half, point, centre);
        Vector p = Scaling.down(point, length);
        Vector c = Scaling.down(centre, length);
        double error = Scaling.down(pointError, length);
        double h = Scaling.down(half, length);
        return isBeyond(slab(p.x(), 1, error, c.x(), h)) || isBeyond(slab(p.y(), 1, error, c.y(), h))
            || isBeyond(slab(p.z(), 1, error, c.z(), h));
    }

    private static boolean isBeyond(Slab slab) {
        return slab.wayToNear().sign() > 0 || slab.wayToFar().sign() < 0;
    }

    /** {@link BoxKernel#crossesBetween}, for the lines that it leaves open, and again for those in an ordinary size. */
    static boolean crossesBetween(double px, double py, double pz, double pointError,
                                  double qx, double qy, double qz, double endError,
                                  double cx, double cy, double cz, double half) {
        Vector point = new Vector(px, py, pz);
        Vector end = new Vector(qx, qy, qz);
        Vector centre = new Vector(cx, cy, cz);
        int length = Scaling.exponent(half, point, end, centre);
        if (length == 0) {
            Line line = new Line(pointError, endError, half);
            return line.meets(px, qx, cx) && line.meets(py, qy, cy) && line.meets(pz, qz, cz) && line.crosses();
        }
        Vector p = Scaling.down(point, length);
        Vector q = Scaling.down(end, length);
        Vector c = Scaling.down(centre, length);
        return BoxKernel.crossesBetween(p.x(), p.y(), p.z(), Scaling.down(pointError, length), q.x(), q.y(), q.z(),
            Scaling.down(endError, length), c.x(), c.y(), c.z(), Scaling.down(half, length));
    }

    /** The line between two points, judged axis by axis. */
    private static final class Line {
        private final double startError;
        private final double endError;
        private final double half;
        private final Slab[] slabs = new Slab[3];
        private final boolean[] startsBefore = new boolean[3];
        private final boolean[] endsBehind = new boolean[3];
        private boolean startsInside = true;
        private boolean endsInside = true;
        private int axes;

        Line(double startError, double endError, double half) {
            this.startError = startError;
            this.endError = endError;
            this.half = half;
        }

        /** Notes one axis; false if both ends lie to one side of the cube there, or one does and the other on its face. */
        boolean meets(double start, double end, double middle) {
            double sign = end < start ? -1 : 1;
            DoubleDouble speed = DoubleDouble.difference(sign * end, sign * start);
            Slab fromStart = new Slab(sign, speed, start, startError, middle, half);
            Slab fromEnd = new Slab(sign, speed, end, endError, middle, half);
            int startToNear = fromStart.wayToNear().sign();
            int startToFar = fromStart.wayToFar().sign();
            int endToNear = fromEnd.wayToNear().sign();
            int endToFar = fromEnd.wayToFar().sign();
            slabs[axes] = fromStart;
            startsBefore[axes] = startToNear > 0;
            endsBehind[axes] = endToFar < 0;
            startsInside &= startToNear <= 0;
            endsInside &= endToFar >= 0;
            axes++;
            boolean staysBefore = endToNear > 0 || endToNear == 0 && startToNear > 0;
            boolean staysBehind = startToFar < 0 || startToFar == 0 && endToFar < 0;
            return !staysBefore && !staysBehind;
        }

        /** After all axes: between its ends the line passes a wall. */
        boolean crosses() {
            if (startsInside || endsInside) {
                return startsInside != endsInside;
            }
            for (int entered = 0; entered < axes; entered++) {
                for (int left = 0; left < axes; left++) {
                    if (startsBefore[entered] && endsBehind[left]
                            && slabs[entered].isEnteredAfterLeaving(slabs[left])) {
                        return false;
                    }
                }
            }
            return true;
        }
    }
}
