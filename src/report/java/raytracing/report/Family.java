package raytracing.report;

import java.util.List;
import java.util.TreeSet;
import java.util.stream.Stream;
import raytracing.scene.Scene;

/** Settings that answer one question, and are held to one reference. */
enum Family {
    /** One ray a pixel; how near is the light at that very point? */
    SHADOWS("Soft shadows", Series.SAMPLED, Series.EXACT) {
        @Override
        List<Setting> settings(Scene scene, Budget budget) {
            TreeSet<Integer> roots = new TreeSet<>(budget.shadowRoots());
            roots.add(scene.settings().shadowRayRoot());
            return Stream.concat(roots.stream().map(Setting::sampled), Stream.of(Setting.exact())).toList();
        }

        @Override
        List<Setting> halves(Budget budget) {
            return List.of(Setting.sampled(budget.finestShadowRoot()), Setting.sampled(budget.finestShadowRoot()));
        }
    },

    /** Exact shadows; how near is the mean light of the whole pixel? */
    EDGES("Edges", Series.EVERYWHERE, Series.ERROR_LIMIT) {
        @Override
        List<Setting> settings(Scene scene, Budget budget) {
            return Stream.of(Stream.of(Setting.oneRay()),
                    budget.edgeRoots().stream().map(Setting::atEdges),
                    budget.everywhereRoots().stream().map(Setting::everywhere),
                    budget.errorLimits().stream().map(Setting::errorLimit))
                .flatMap(settings -> settings).toList();
        }

        /** Grids of 16 and of 15 places share hardly one. */
        @Override
        List<Setting> halves(Budget budget) {
            return List.of(Setting.everywhere(budget.finestEyeRoot()), Setting.everywhere(budget.finestEyeRoot() - 1));
        }
    };

    static final int MOST_SHADOW_ROOT = 16;

    private final String title;
    private final Series plain;
    private final Series clever;

    Family(String title, Series plain, Series clever) {
        this.title = title;
        this.plain = plain;
        this.clever = clever;
    }

    String title() {
        return title;
    }

    /** The series that gets better by more work alone. */
    Series plain() {
        return plain;
    }

    /** The series that is compared with it at equal error. */
    Series clever() {
        return clever;
    }

    /** What is drawn, measured and judged. */
    abstract List<Setting> settings(Scene scene, Budget budget);

    /** The two pictures whose mean is the reference. */
    abstract List<Setting> halves(Budget budget);

    /** Whether a scene has what this family is about. */
    boolean concerns(Scene scene) {
        return this == EDGES
            || scene.lights().stream().anyMatch(light -> light.width() > 0 && light.shadowIntensity() > 0);
    }
}
