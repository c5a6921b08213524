package raytracing.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import raytracing.Machine;
import raytracing.Steps;
import raytracing.parse.RayTracerException;

/** Draws scenes in every way there is, and writes a page that sets the time of each way beside its error. */
public final class Report {
    private static final int MACHINE_FAILED = 1;
    private static final int USER_IS_WRONG = 2;

    private Report() {
    }

    /**
     * Measures and writes; ends the virtual machine with 1 if the machine failed, 2 if the request is wrong.
     *
     * @param arguments see {@link Request#of}
     */
    public static void main(String[] arguments) {
        try {
            run(Request.of(List.of(arguments)));
        } catch (RayTracerException wrong) {
            wrong.messages().forEach(System.err::println);
            System.exit(USER_IS_WRONG);
        } catch (IOException failure) {
            System.err.println("the report could not be written: " + failure.getMessage());
            System.exit(MACHINE_FAILED);
        }
    }

    private static void run(Request request) throws RayTracerException, IOException {
        Fonts.check();
        for (Path scene : request.scenes()) {
            Steps.parseScene(scene);           // what is wrong with the last one is said before the first is drawn
        }
        prepare(request.folder());
        OptionalDouble before = Machine.load();
        List<SceneStudy> studies = studies(request.scenes(), request.budget());
        MachineLoad load = MachineLoad.since(before);
        Path page = request.folder().resolve("index.html");
        Files.writeString(page, new Page(request, studies, load).html());
        System.err.println("Written: " + page);
        if (request.part() == Request.Part.PAGE_AND_DOCUMENTS) {
            Budget budget = Budget.OF_ONE.withSize(request.budget().size());
            SceneStudy shown = studies(List.of(Documents.SHOWN), budget).get(0);
            Documents.write(request, studies, shown, MachineLoad.since(before));
        }
    }

    private static void prepare(Path folder) throws RayTracerException, IOException {
        if (Files.exists(folder) && !Files.isDirectory(folder)) {
            throw new RayTracerException(folder + ": is a file, expected a folder for the page");
        }
        Files.createDirectories(folder);
    }

    private static List<SceneStudy> studies(List<Path> scenes, Budget budget) throws RayTracerException, IOException {
        List<SceneStudy> studies = new ArrayList<>();
        for (Path scene : scenes) {
            Progress progress = Progress.of(studies.size() + 1, scenes.size(), SceneStudy.title(scene));
            if (studies.isEmpty()) {
                WarmUp.run(Steps.parseScene(scene), SceneStudy.settings(budget), progress);
            }
            studies.add(SceneStudy.of(scene, budget, progress));
        }
        return studies;
    }
}
