package raytracing.outline;

import raytracing.math.Vector;
import raytracing.outline.Sight.Cover;
import raytracing.surface.Box;

/**
 * A box against a cone. Each face that may be seen from the eye, those before which the eye is, or the one ahead from
 * inside, is the base of a pyramid with the eye as its apex, and each wall of the pyramid is a plane through the eye and an
 * edge of the face. A cone that is inside all four walls sees this face alone; a cone that is beyond one wall does not see
 * it; a cone that does not see any of the faces is beside the box. Axes count from the eye. Not thread-safe.
 */
final class BoxSight {
    /** Above the square root of 3, the half diagonal of a cube of half edge 1. */
    static final double HALF_DIAGONAL = 1.7320508075688776;

    /**
     * Of an axis along which rays go at least so fast, a face in whose plane the eye is, is passed before the other faces,
     * or never: see {@link #isPassedAtOnce}.
     */
    private static final double FAST = 0x1p-16;
    private static final double FAR_OFF = 0x1p20;

    private final SquareCone cone;
    private final double touching;
    private final double eyeSize;

    /** Of the box: the way from the eye to its middle. Of the cone: its axis. Both by world axis, counted twice over. */
    private final double[] middle = new double[5];
    private final double[] axis = new double[5];

    /** Between which bounds the parts of all rays along each world axis are. */
    private final double[] leasts = new double[3];
    private final double[] mosts = new double[3];
    private double half;
    private double margin;

    BoxSight(SquareCone cone, double touching) {
        this.cone = cone;
        this.touching = touching;
        eyeSize = Math.abs(cone.eyeX) + Math.abs(cone.eyeY) + Math.abs(cone.eyeZ);
    }

    /** Takes the cone as it is now. */
    void aim() {
        axis[0] = cone.axisX;
        axis[1] = cone.axisY;
        axis[2] = cone.axisZ;
        axis[3] = cone.axisX;
        axis[4] = cone.axisY;
        for (int i = 0; i < 3; i++) {
            double along = axis[i];
            double across = Math.sqrt(axis[i + 1] * axis[i + 1] + axis[(i + 2) % 3] * axis[(i + 2) % 3]);
            leasts[i] = -cone.mostProduct(-along, across, 1) - Sight.ROUNDING;
            mosts[i] = cone.mostProduct(along, across, 1) + Sight.ROUNDING;
        }
    }

    void test(Box box, Sight sight) {
        Vector centre = box.centre();
        double x = centre.x() - cone.eyeX;
        double y = centre.y() - cone.eyeY;
        double z = centre.z() - cone.eyeZ;
        half = box.edge() / 2;
        double size = Math.abs(x) + Math.abs(y) + Math.abs(z) + half;
        margin = Sight.ROUNDING * (size + eyeSize) + touching;
        if (!(half > Sight.SHORT && size < Sight.LONG)) {
            sight.setUnknown();
            return;
        }
        if (cone.beyond(cone.along(x, y, z), cone.across(x, y, z)) > HALF_DIAGONAL * half + margin) {
            sight.cover = Cover.NONE;
            return;
        }
        middle[0] = x;
        middle[1] = y;
        middle[2] = z;
        middle[3] = x;
        middle[4] = y;
        double mostOff = Vector.largestPart(x, y, z);
        if (mostOff > half + margin) {
            testFromOutside(sight);
        } else if (mostOff < half - margin) {
            testFromInside(half - mostOff - margin, sight);
        } else {
            sight.setUnknown();
        }
    }

    /** Bounds for the part of all rays along a world axis, turned towards a sign. */
    private double least(int i, double sign) {
        return sign < 0 ? -mosts[i] : leasts[i];
    }

    private double most(int i, double sign) {
        return sign < 0 ? -leasts[i] : mosts[i];
    }

    /**
     * Finds the last of the planes that a ray must pass to come in, and looks whether all rays come in through its face.
     * Two faces cannot both be wholly seen by a cone, so this is the only one that may be.
     */
    private void testFromOutside(Sight sight) {
        double from = 0;
        double entry = -1;
        int last = 0;
        boolean isBeside = true;
        boolean isClear = true;
        for (int i = 0; i < 3; i++) {
            double gap = Math.abs(middle[i]) - half;
            double towards = Math.copySign(axis[i], axis[i] * middle[i]);
            if (gap > margin) {
                double most = most(i, middle[i]);
                if (most < 0) {
                    sight.cover = Cover.NONE;
                    return;
                }
                from = Math.max(from, (gap - margin) / most);
                double here = gap / Math.max(towards, Double.MIN_NORMAL);
                last = here > entry ? i : last;
                entry = Math.max(here, entry);
                isBeside = isBeside && isBesideFace(i, gap, towards);
            } else if (gap > -margin) {
                isClear = isClear && isPassedAtOnce(i);
                if (isClear && towards < 0) {
                    sight.cover = Cover.NONE;
                    return;
                }
            }
        }
        if (isBeside && isClear) {
            sight.cover = Cover.NONE;
            return;
        }
        double gap = Math.abs(middle[last]) - half;
        double towards = Math.copySign(axis[last], axis[last] * middle[last]);
        boolean isCovered = isClear && towards > 0 && isInsideFace(last, gap, towards);
        sight.set(isCovered ? Cover.ALL : Cover.SOME, (1 - Sight.ROUNDING) * from, latest(gap, least(last, middle[last])));
        setFlat(last, gap, Math.signum(middle[last]), sight);
    }

    /** A bound for the distance at which all rays are beyond a face's plane, given the least part of a ray towards it. */
    private double latest(double gap, double least) {
        return least > 0 ? (1 + Sight.ROUNDING) * (gap + margin) / least : Double.POSITIVE_INFINITY;
    }

    private void setFlat(int face, double gap, double sign, Sight sight) {
        double per = 1 / gap;
        sight.setFlat(face == 0 ? sign * per : 0, face == 1 ? sign * per : 0, face == 2 ? sign * per : 0,
            per * (2 * margin * per + Sight.ROUNDING));
    }

    private void testFromInside(double from, Sight sight) {
        int first = 0;
        double exit = Double.POSITIVE_INFINITY;
        for (int i = 0; i < 3; i++) {
            double here = (half + Math.copySign(middle[i], middle[i] * axis[i])) / Math.abs(axis[i]);
            first = here < exit ? i : first;
            exit = Math.min(exit, here);
        }
        double towards = Math.abs(axis[first]);
        double gap = half + Math.copySign(middle[first], middle[first] * axis[first]);
        if (isInsideFace(first, gap, towards)) {
            sight.set(Cover.ALL, (1 - Sight.ROUNDING) * Math.max(from, (gap - margin) / most(first, axis[first])),
                latest(gap, least(first, axis[first])));
            setFlat(first, gap, Math.signum(axis[first]), sight);
        } else {
            sight.set(Cover.SOME, from, Double.POSITIVE_INFINITY);
        }
    }

    /**
     * For a face in whose plane the eye is, within the margin: whether all rays go clearly away from the plane, to the same
     * side, and the box is far off. Then a ray is on its side of the plane before it comes to another face; so it passes the
     * box if it goes to the outer side, and comes in through another face if it goes to the inner one.
     */
    private boolean isPassedAtOnce(int face) {
        double mostOff = Math.max(Math.abs(middle[face + 1]), Math.abs(middle[face + 2])) - half;
        return least(face, axis[face]) > FAST && mostOff > FAR_OFF * margin;
    }

    /** Whether the cone is certainly beyond a wall of a face's pyramid. */
    private boolean isBesideFace(int face, double gap, double towards) {
        return isBeyondWalls(face, face + 1, face + 2, gap, towards)
            || isBeyondWalls(face, face + 2, face + 1, gap, towards);
    }

    /**
     * The two walls through the edges that are parallel to one axis. A ray d with a part t towards the face meets its plane
     * at the place gap d_j / t along the other axis j, so it is beyond the low edge if gap d_j - low t is below 0.
     */
    private boolean isBeyondWalls(int face, int j, int other, double gap, double towards) {
        double place = gap * axis[j];
        double low = middle[j] - half;
        double high = middle[j] + half;
        return isBeyond(place - low * towards, gap, low, towards, axis[j], axis[other])
            || isBeyond(high * towards - place, gap, high, towards, axis[j], axis[other]);
    }

    /** Whether the cone is certainly inside all four walls of a face's pyramid. */
    private boolean isInsideFace(int face, double gap, double towards) {
        return isInsideWalls(face, face + 1, face + 2, gap, towards)
            && isInsideWalls(face, face + 2, face + 1, gap, towards);
    }

    private boolean isInsideWalls(int face, int j, int other, double gap, double towards) {
        double place = gap * axis[j];
        double low = middle[j] - half;
        double high = middle[j] + half;
        return isInside(place - low * towards, gap, low, towards, axis[j], axis[other])
            && isInside(high * towards - place, gap, high, towards, axis[j], axis[other]);
    }

    /** Whether the product of a wall's normal, given that with the cone's axis, is below 0 for all rays. */
    private boolean isBeyond(double along, double gap, double edge, double towards, double aj, double other) {
        return along < 0 && along * cone.cosine + acrossWall(gap, edge, towards, aj, other) * cone.sine < -margin;
    }

    /** Whether it is above 0 for all rays. */
    private boolean isInside(double along, double gap, double edge, double towards, double aj, double other) {
        return along > 0 && along * cone.cosine - acrossWall(gap, edge, towards, aj, other) * cone.sine > margin;
    }

    /** The length of the cross product of the axis and the wall's normal, -edge towards the face and gap along j. */
    private static double acrossWall(double gap, double edge, double towards, double aj, double other) {
        double within = edge * aj + gap * towards;
        return Math.sqrt(other * other * (gap * gap + edge * edge) + within * within);
    }
}
