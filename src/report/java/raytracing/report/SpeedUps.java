package raytracing.report;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import raytracing.Films;
import raytracing.Quantiles;
import raytracing.render.RenderSettings;
import raytracing.render.Renderer;
import raytracing.render.Renderers;
import raytracing.scene.Scene;
import raytracing.trace.Shortcut;

/** What a scene takes with and without each of the shortcuts, none of which may change a bit of the film. */
final class SpeedUps {
    private SpeedUps() {
    }

    /**
     * A selection of the shortcuts.
     *
     * @param title what is left out
     * @param milliseconds of warm frames
     * @param timesAsLong its median over that of all shortcuts
     * @param shareChanged share of the pixels that differ from those of all shortcuts, by whatever bit
     * @param largestChange of a channel of a pixel, in linear light
     */
    record Row(String title, Quantiles milliseconds, double timesAsLong, double shareChanged,
               double largestChange) {
    }

    /** The first row leaves out nothing. */
    static List<Row> measured(Scene scene, RenderSettings settings, Budget budget, Progress progress) {
        Map<String, Set<Shortcut>> selections = selections();
        List<Renderer> renderers = selections.values().stream()
            .map(shortcuts -> Renderers.withShortcuts(scene, settings, shortcuts)).toList();
        List<Rounds.Drawn> drawn = Rounds.of(renderers, Noise::wide, budget, progress.in("Speed-ups"));
        List<String> titles = List.copyOf(selections.keySet());
        Rounds.Drawn all = drawn.get(0);
        List<Row> rows = new ArrayList<>();
        for (int i = 0; i < titles.size(); i++) {
            Quantiles milliseconds = drawn.get(i).milliseconds();
            rows.add(new Row(titles.get(i), milliseconds, milliseconds.median() / all.milliseconds().median(),
                Films.shareChanged(all.rendering().film(), drawn.get(i).rendering().film()),
                Films.largest(all.rendering().film(), drawn.get(i).rendering().film())));
        }
        return rows;
    }

    /** In the order in which they are shown. */
    private static Map<String, Set<Shortcut>> selections() {
        Map<String, Set<Shortcut>> selections = new LinkedHashMap<>();
        selections.put("all", EnumSet.allOf(Shortcut.class));
        for (Shortcut shortcut : Shortcut.values()) {
            selections.put("without " + words(shortcut), EnumSet.complementOf(EnumSet.of(shortcut)));
        }
        selections.put("without any", EnumSet.noneOf(Shortcut.class));
        return selections;
    }

    private static String words(Shortcut shortcut) {
        return shortcut.name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }
}
