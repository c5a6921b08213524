package raytracing.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static raytracing.report.Studies.measured;
import static raytracing.report.Studies.study;

import org.junit.jupiter.api.Test;
import raytracing.Quantiles;

class RecommendationTest {
    private static final double HALF_A_STEP = 0.5 / 255;

    private static Setting chosen(FamilyStudy study) {
        return Recommendation.of(study).chosen().setting();
    }

    @Test
    void exactShadowsThatCostNoMoreAreRecommended() {
        FamilyStudy study = study(Family.SHADOWS, 0, measured(Setting.sampled(1), 50, 0.05),
            measured(Setting.sampled(7), 100, 0.007), measured(Setting.exact(), 105, 0.0001));
        assertEquals("At this scene's own N = 7 exact shadows take as long and are 70 times closer: `--shadows exact`.",
            Recommendation.of(study).sentences(7));
    }

    @Test
    void anErrorHiddenByTheReferenceIsAtLeastSoSmall() {
        FamilyStudy study = study(Family.SHADOWS, 0.0001, measured(Setting.sampled(4), 100, 0.005),
            measured(Setting.exact(), 80, 0.00005));
        assertEquals("At this scene's own N = 4 exact shadows take 0.8 of the time and are at least 50 times closer: "
            + "`--shadows exact`.", Recommendation.of(study).sentences(4));
    }

    @Test
    void aSceneWhoseOwnRaysAreEnoughNeedsNoOption() {
        FamilyStudy study = study(Family.SHADOWS, 0, measured(Setting.sampled(1), 60, 0.05),
            measured(Setting.sampled(3), 100, 0.001), measured(Setting.exact(), 150, 0.0001));
        assertEquals("This scene's own N = 3 is right to 0.26 steps: no option is needed. "
            + "Compared with its own N, exact shadows take 1.5 times as long and are 10 times closer.",
            Recommendation.of(study).sentences(3));
    }

    @Test
    void fewerRaysThanTheScenesOwnMayBeEnough() {
        FamilyStudy study = study(Family.SHADOWS, 0, measured(Setting.sampled(2), 50, 0.001),
            measured(Setting.sampled(9), 100, 0.0005), measured(Setting.exact(), 150, 0.0001));
        assertEquals("For this scene N = 2 is right to 0.26 steps: `--shadows sampled --shadow-rays 2`. "
            + "Compared with its own N, exact shadows take 1.5 times as long and are 5 times closer.",
            Recommendation.of(study).sentences(9));
    }

    @Test
    void theFastestOfThoseThatAreRightToHalfAStepWins() {
        assertEquals(Setting.errorLimit(2), chosen(study(Family.EDGES, 0, measured(Setting.oneRay(), 10, 0.05),
            measured(Setting.errorLimit(4), 20, 1.01 * HALF_A_STEP), measured(Setting.errorLimit(2), 30, HALF_A_STEP),
            measured(Setting.errorLimit(1), 60, 0.5 * HALF_A_STEP))));
    }

    @Test
    void ofThoseThatAreAboutAsFastTheClosestWins() {
        assertEquals(Setting.errorLimit(1), chosen(study(Family.EDGES, 0, measured(Setting.oneRay(), 10, 0.05),
            measured(Setting.errorLimit(2), 30, HALF_A_STEP), measured(Setting.errorLimit(1), 32, 0.5 * HALF_A_STEP),
            measured(Setting.errorLimit(0.5), 40, 0.1 * HALF_A_STEP))));
    }

    @Test
    void whatNoOptionAsksForIsNotRecommended() {
        assertEquals(Setting.atEdges(4), chosen(study(Family.EDGES, 0, measured(Setting.oneRay(), 10, 0.05),
            measured(Setting.everywhere(4), 20, 0.001), measured(Setting.atEdges(4), 30, 0.001))));
    }

    @Test
    void whereNoneIsRightTheClosestIsNamed() {
        FamilyStudy study = study(Family.EDGES, 0, measured(Setting.oneRay(), 10, 0.05),
            measured(Setting.errorLimit(4), 20, 0.01));
        String sentences = Recommendation.of(study).sentences(1);
        assertTrue(sentences.startsWith("No setting is right to half a step; the closest is `--error 4`: 20.0 ms a frame, "
            + "off by 2.6 steps."), sentences);
    }

    /** On the line from one ray to the finest, four times the time for a hundredth of the error. */
    @Test
    void theOthersAreComparedAtTheSameError() {
        FamilyStudy study = study(Family.EDGES, 0.0001, measured(Setting.oneRay(), 10, 0.1),
            measured(Setting.atEdges(8), 160, 0.001), measured(Setting.everywhere(8), 320, 0.001),
            measured(Setting.errorLimit(2), 40, 0.001));
        assertEquals("The fastest way to smooth edges that is right to half a step is `--error 2`: 40.0 ms a frame, off by "
            + "0.26 steps. For as little error `--samples` takes 4 times as long, rays in every pixel 8 times.",
            Recommendation.of(study).sentences(1));
    }

    @Test
    void anUncertainTimeIsSaidToBeSo() {
        FamilyStudy study = study(Family.SHADOWS, 0, measured(Setting.sampled(7), 100, 0.007),
            measured(Setting.exact(), new Quantiles(5, 60, 100, 140), 0.0001));
        assertTrue(Recommendation.of(study).sentences(7).endsWith(" Its time is uncertain: see † below."));
    }

    @Test
    void withoutErrorsThereIsNothingToRecommend() {
        FamilyStudy study = study(Family.SHADOWS, 0, measured(Setting.sampled(1), 10, 0), measured(Setting.exact(), 20, 0));
        assertEquals("All settings draw the same picture, to the last bit.", Recommendation.of(study).sentences(1));
    }

    @Test
    void thePlotHasARingAroundIt() throws Exception {
        Measurement rough = measured(Setting.sampled(7), 100, 0.007);
        String without = Plot.of(study(Family.SHADOWS, 0, rough, measured(Setting.exact(), 100, 0))).onWhite();
        String with = Plot.of(study(Family.SHADOWS, 0, rough, measured(Setting.exact(), 100, 0.0001))).onWhite();
        assertFalse(without.contains(RING), "exact shadows without error are beyond a logarithmic axis");
        assertTrue(with.contains(RING));
    }

    /** As the plotting library draws an oval of 18 pixels. */
    private static final String RING = "rx=\"9\"";
}
