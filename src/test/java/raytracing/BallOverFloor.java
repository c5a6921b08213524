package raytracing;

import java.util.OptionalDouble;
import raytracing.math.Vector;
import raytracing.math.Vectors;

/**
 * A white ball over an endless white floor, y = 0, under one lamp with full shadows and a sky of 1/4, solved on paper.
 *
 * <p>A straight line meets the ball if it passes its centre C at a distance below the radius: from a point P along a
 * unit direction w, that distance is |(C - P) x w|. So the eye sees the ball, and so a point of the floor is in its
 * shadow. What is lit has the light N.L, which on the floor is the lamp's height over its distance; the far side of the
 * ball has none. Close to where a line touches the ball, the answer is left open.
 *
 * @param centre above the floor
 * @param radius at most the height of the centre
 * @param lamp higher than the ball
 */
record BallOverFloor(Vector centre, double radius, Vector lamp) {
    static final double SKY = 0.25;

    /** What is seen from a point above the floor, but for lines that touch ball or horizon to within {@code open}. */
    OptionalDouble grey(Vector eye, Vector direction, double open) {
        Vector w = direction.unit();
        Vector toCentre = centre.minus(eye);
        double missedBy = toCentre.cross(w).length();
        if (Math.abs(missedBy - radius) < open) {
            return DrawnPicture.UNDECIDED;
        }
        if (missedBy < radius) {
            double halfChord = Math.sqrt((radius - missedBy) * (radius + missedBy));
            return OptionalDouble.of(greyOfBall(Vectors.plus(eye, toCentre.dot(w) - halfChord, w)));
        }
        if (Math.abs(w.y()) < open) {
            return DrawnPicture.UNDECIDED;
        }
        return w.y() < 0 ? greyOfFloor(Vectors.plus(eye, -eye.y() / w.y(), w), open) : OptionalDouble.of(SKY);
    }

    private double greyOfBall(Vector point) {
        return Math.max(0, point.minus(centre).times(1 / radius).dot(lamp.minus(point).unit()));
    }

    private OptionalDouble greyOfFloor(Vector point, double open) {
        double missedBy = centre.minus(point).cross(lamp.minus(point).unit()).length();
        if (Math.abs(missedBy - radius) < open) {
            return DrawnPicture.UNDECIDED;
        }
        return OptionalDouble.of(missedBy < radius ? 0 : lamp.y() / lamp.minus(point).length());
    }
}
