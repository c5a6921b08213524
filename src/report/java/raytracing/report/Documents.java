package raytracing.report;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import javax.imageio.ImageIO;
import raytracing.Machine;
import raytracing.MeasuredPart;
import raytracing.render.Region;
import raytracing.render.RenderSettings;

/** The part of the report that is committed: its tables, and the plots and pictures of one scene. */
final class Documents {
    private static final Path DOCUMENT = Path.of("src", "docs", "REPORT.md");
    private static final Path PICTURES = Path.of("src", "docs", "report");

    /** The scene that is shown larger: its colours tell one lamp's shadow from another's. */
    static final Path SHOWN = Path.of("scenes", "three_lamps.txt");

    private Documents() {
    }

    /** Tables of all scenes, plots and pictures of the shown one. */
    static void write(Request request, List<SceneStudy> studies, SceneStudy shown, MachineLoad load)
            throws IOException {
        Files.createDirectories(PICTURES);
        for (FamilyStudy family : shown.families()) {
            writePictures(family);
        }
        MeasuredPart.replace(DOCUMENT, markdown(request, studies, shown, load));
        System.err.println("Written: " + DOCUMENT);
    }

    private static String name(FamilyStudy study) {
        return study.family().name().toLowerCase(Locale.ROOT);
    }

    private static void writePictures(FamilyStudy study) throws IOException {
        BufferedImage strip = Strip.of(study, study.reference().whole().orElseThrow());
        ImageIO.write(strip, "png", PICTURES.resolve(name(study) + ".png").toFile());
        if (study.hasErrors()) {
            Files.writeString(PICTURES.resolve(name(study) + ".svg"), Plot.of(study).onWhite());
        }
    }

    private static String markdown(Request request, List<SceneStudy> studies, SceneStudy shown,
                                   MachineLoad load) throws IOException {
        return Machine.origin(request.command()) + " " + common(request, load) + "\n\n"
            + String.join("\n", Headline.of(studies)) + "\n\n### Time at equal error\n\n"
            + Tables.shadows(studies).markdown() + "\n" + Tables.edges(studies).markdown()
            + shown.families().stream().map(family -> section(shown, family)).collect(Collectors.joining())
            + "\n### Speed-ups, with and without\n\n" + Tables.sampledSpeedUps(studies).markdown() + "\n"
            + Tables.exactSpeedUps(studies).markdown() + "\n### Cold starts\n\n" + Tables.cold(studies).markdown();
    }

    private static String common(Request request, MachineLoad load) {
        int size = request.budget().size();
        return "Pictures of " + size + " x " + size + " pixels unless said otherwise, seed "
            + RenderSettings.DEFAULT_SEED + ", " + RenderSettings.DEFAULT.threads() + " threads. "
            + load.sentences() + compared(Blocks.of(size, request.budget().blocksPerCompared()));
    }

    private static String compared(List<Region> blocks) {
        return blocks.size() == 1 ? "" : " For the tables of all scenes " + blocks.size() + " squares of " + Blocks.EDGE + " x "
            + Blocks.EDGE + " pixels of each picture are compared.";
    }

    private static String section(SceneStudy shown, FamilyStudy study) {
        String title = shown.title() + ": "
            + study.family().title().toLowerCase(Locale.ROOT);
        String plot = study.hasErrors()
            ? "![Error against time on logarithmic axes](report/" + name(study) + ".svg)\n\n" : "";
        return "\n### " + title + "\n\n" + Recommendation.of(study).sentences(shown.shadowRoot()) + " "
            + Verdict.of(study).sentences() + "\n\n" + plot
            + "![" + title + ": pictures and their errors](report/" + name(study) + ".png)\n\n"
            + Tables.settings(study).markdown();
    }
}
