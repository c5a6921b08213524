package raytracing.report;

import java.util.List;
import java.util.Optional;
import raytracing.Quantiles;
import raytracing.render.Region;

/** Made-up measurements. */
final class Studies {
    private Studies() {
    }

    /** Frames that all took about as long. */
    static Measurement measured(Setting setting, double milliseconds, double error) {
        return measured(setting, quiet(milliseconds), error);
    }

    static Measurement measured(Setting setting, Quantiles milliseconds, double error) {
        return new Measurement(setting, 0.25, milliseconds, new ErrorFigures(error, error, 40, 0.1, 0.9), Optional.empty());
    }

    static Quantiles quiet(double milliseconds) {
        return new Quantiles(5, milliseconds * 0.99, milliseconds, milliseconds * 1.01);
    }

    /** Held to a reference with such an error of its own. */
    static FamilyStudy study(Family family, double ownError, Measurement... measurements) {
        Reference reference = new Reference(List.of(Region.whole(32, 32)), List.of(Pictures.even(32, 0.5)), ownError,
            new TimedError(10_000, ownError * Math.sqrt(2)));
        return new FamilyStudy(family, reference, List.of(measurements));
    }
}
