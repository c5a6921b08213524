package raytracing.parse;

import java.util.ArrayList;
import java.util.List;
import raytracing.parallel.ForkJoin;
import raytracing.surface.Surface;

/**
 * Lines of a long scene file that are read ahead, beside other threads, as if each were a surface without a mistake. If one is
 * anything else, all of them are left to the parser, which reads the file from the beginning and knows what came before.
 */
final class SurfaceLines {
    private final SceneText text;
    private final SceneWarnings warnings;
    private final int materialCount;
    private final int end;
    private final int length;
    private List<Surface> surfaces = new ArrayList<>();
    private int largestMaterial;
    private boolean arePlain;

    /**
     * Lines that are not read yet.
     *
     * @param text from a line's beginning to another's
     * @param warnings collects what is needed for warnings
     * @param materialCount how many materials came before, as far as is known
     */
    SurfaceLines(SceneText text, SceneWarnings warnings, int materialCount) {
        this.text = text;
        this.warnings = warnings;
        this.materialCount = materialCount;
        end = text.length();
        length = end - text.bytesRead();
    }

    /** Reads the lines, and reports how many bytes are done with; keeps nothing if a line is no surface or has a mistake. */
    void read(ForkJoin workers) {
        arePlain = readAll();
        if (arePlain) {
            workers.advance(length);
        } else {
            surfaces = List.of();
        }
    }

    private boolean readAll() {
        Findings problems = new Findings("", 1);
        Values values = new Values(text, problems, problems);
        while (values.nextLine()) {
            if (!text.isCompleteSurface()) {
                return false;
            }
            Surface surface = values.surface(text.code());
            if (!problems.isEmpty()) {
                return false;
            }
            largestMaterial = Math.max(largestMaterial, surface.material() + 1);
            warnings.addSurface(surface, surfaces.size(), materialCount);
            surfaces.add(surface);
        }
        return true;
    }

    /** Whether they were read, and all of them are surfaces without a mistake. */
    boolean arePlain() {
        return arePlain;
    }

    /** Where the next line begins. */
    int end() {
        return end;
    }

    /** The text, at its end. */
    SceneText text() {
        return text;
    }

    /** In the order of the lines. */
    List<Surface> surfaces() {
        return surfaces;
    }

    /** How many lines have a surface. */
    int linesRead() {
        return surfaces.size();
    }

    /** The largest number of a material, counted from 1; 0 without a surface. */
    int largestMaterial() {
        return largestMaterial;
    }

    SceneWarnings warnings() {
        return warnings;
    }
}
