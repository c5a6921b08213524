package raytracing.scene;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Optional;

/**
 * Where a pixel of a camera looks, in numbers of 60 digits and any size: what {@link CameraRays} is held to.
 *
 * @param right part of the unit direction along the picture's rows
 * @param up part along its columns, upwards
 * @param forward part along the view
 * @param most how far a direction in doubles may be off in each part: its own rounding, and that of the place on the screen,
 *        which is right to 2^-53 of the screen's longer edge
 */
record ExactCameraRay(BigDecimal right, BigDecimal up, BigDecimal forward, double most) {
    private static final MathContext DIGITS = new MathContext(60);
    private static final BigDecimal TWO = BigDecimal.valueOf(2);
    private static final BigDecimal BEYOND_A_RIGHT_ANGLE = TWO;
    private static final double ROUNDING = 8 * Math.ulp(1.0);
    private static final double PLACE_ROUNDING = 0x1p-53;

    /** The angle between view and ray. */
    private record Angle(BigDecimal sine, BigDecimal cosine) {
    }

    /**
     * The ray through a place of a picture.
     *
     * @param k of the fisheye: 1 (pinhole), 0.5, 0, -0.5 or -1
     * @return none where the lens shows black
     */
    static Optional<ExactCameraRay> of(double distance, double screenWidth, int width, int height, double x, double y,
                                      double k) {
        BigDecimal halfPixel = quotient(exact(screenWidth), BigDecimal.valueOf(2L * width));
        BigDecimal right = fromMiddle(x, width).multiply(halfPixel, DIGITS);
        BigDecimal up = fromMiddle(y, height).negate().multiply(halfPixel, DIGITS);
        BigDecimal radius = right.multiply(right).add(up.multiply(up), DIGITS).sqrt(DIGITS);
        if (radius.signum() == 0) {
            return Optional.of(new ExactCameraRay(BigDecimal.ZERO, BigDecimal.ZERO, BigDecimal.ONE, ROUNDING));
        }
        double rounding = PLACE_ROUNDING * quotient(halfPixel.multiply(BigDecimal.valueOf(2L * Math.max(width, height))),
            radius).doubleValue();
        return angle(quotient(radius, exact(distance)), k).map(angle -> new ExactCameraRay(
            quotient(angle.sine.multiply(right), radius), quotient(angle.sine.multiply(up), radius), angle.cosine,
            ROUNDING + rounding * spread(angle, k)));
    }

    /**
     * By how much a direction turns where the radius grows by a share of itself, divided by that share: theta' R and, around
     * the view, sin theta. All of the lenses but the orthographic one have theta' R at most 2 in the picture.
     */
    private static double spread(Angle angle, double k) {
        double sine = angle.sine.doubleValue();
        double cosine = angle.cosine.doubleValue();
        return k == -1 ? sine + sine / cosine : k == 1 ? sine + sine * cosine : 3 * sine;
    }

    private static Optional<Angle> angle(BigDecimal q, double k) {
        BigDecimal squared = q.multiply(q, DIGITS);
        if (k == 1) {
            BigDecimal length = squared.add(BigDecimal.ONE, DIGITS).sqrt(DIGITS);
            return Optional.of(new Angle(quotient(q, length), quotient(BigDecimal.ONE, length)));
        }
        if (q.compareTo(BEYOND_A_RIGHT_ANGLE) >= 0 || k == -1 && q.compareTo(BigDecimal.ONE) >= 0) {
            return Optional.empty();
        }
        Angle angle = k == 0 ? equidistant(q, squared) : k == -1 ? new Angle(q, root(BigDecimal.ONE.subtract(squared, DIGITS)))
            : k > 0 ? stereographic(q, quotient(squared, TWO.multiply(TWO)))
            : equisolid(q, quotient(squared, TWO.multiply(TWO)));
        return angle.cosine.signum() > 0 ? Optional.of(angle) : Optional.empty();
    }

    /** q = 2 tan(theta / 2), its half squared given. */
    private static Angle stereographic(BigDecimal q, BigDecimal squaredHalf) {
        BigDecimal sum = BigDecimal.ONE.add(squaredHalf, DIGITS);
        return new Angle(quotient(q, sum), quotient(BigDecimal.ONE.subtract(squaredHalf, DIGITS), sum));
    }

    /** q = 2 sin(theta / 2), its half squared given. */
    private static Angle equisolid(BigDecimal q, BigDecimal squaredHalf) {
        return new Angle(q.multiply(root(BigDecimal.ONE.subtract(squaredHalf, DIGITS)), DIGITS),
            BigDecimal.ONE.subtract(TWO.multiply(squaredHalf), DIGITS));
    }

    /** q = theta: the two series. */
    private static Angle equidistant(BigDecimal theta, BigDecimal squared) {
        BigDecimal sine = BigDecimal.ZERO;
        BigDecimal cosine = BigDecimal.ZERO;
        BigDecimal term = BigDecimal.ONE;
        for (int i = 1; i < 60; i += 2) {
            cosine = cosine.add(term, DIGITS);
            sine = sine.add(quotient(term, BigDecimal.valueOf(i)), DIGITS);
            term = quotient(term.multiply(squared, DIGITS).negate(), BigDecimal.valueOf((long) i * (i + 1)));
        }
        return new Angle(theta.multiply(sine, DIGITS), cosine);
    }

    /** In half pixels. */
    private static BigDecimal fromMiddle(double place, int size) {
        return TWO.multiply(exact(place)).subtract(BigDecimal.valueOf(size));
    }

    private static BigDecimal exact(double number) {
        return new BigDecimal(number, DIGITS);
    }

    private static BigDecimal quotient(BigDecimal a, BigDecimal b) {
        return a.divide(b, DIGITS);
    }

    private static BigDecimal root(BigDecimal square) {
        return square.sqrt(DIGITS);
    }
}
