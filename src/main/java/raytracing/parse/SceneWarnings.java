package raytracing.parse;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import raytracing.math.Vector;
import raytracing.scene.Light;
import raytracing.scene.Material;
import raytracing.scene.Scene;
import raytracing.surface.Body;
import raytracing.surface.Surface;

/**
 * Finds things that are allowed in a scene as a whole but are probably mistakes. It collects what it needs while the scene is
 * read, as a pass over a million surfaces afterwards took a tenth of the time of reading them.
 */
final class SceneWarnings {
    /** So many numbers of unused materials are listed. */
    private static final int MOST_NUMBERS = 10;

    /** The largest number of samples along an axis that {@code --samples} takes. */
    private static final int MOST_SAMPLES = 32;

    private final List<Integer> bodiesAroundTheEye = new ArrayList<>();
    private final BitSet usedMaterials = new BitSet();
    private boolean hasAmbientColors;
    private boolean areMaterialsUsedAhead;
    private boolean isEyeKnown;
    private Vector eye = Vector.ZERO;

    /** For surfaces that are read ahead, with the same eye, if it is known. */
    SceneWarnings ofAPart() {
        SceneWarnings part = new SceneWarnings();
        part.isEyeKnown = isEyeKnown;
        part.eye = eye;
        return part;
    }

    /** Adds what was collected from surfaces that were read ahead; the first of them is at {@code first} in the scene. */
    void addAll(SceneWarnings part, List<Surface> surfaces, int first) {
        usedMaterials.or(part.usedMaterials);
        areMaterialsUsedAhead |= part.areMaterialsUsedAhead;
        for (int index : part.bodiesAroundTheEye) {
            bodiesAroundTheEye.add(first + index);
        }
        if (isEyeKnown && !part.isEyeKnown) {
            addAround(surfaces, first);
        }
    }

    void addMaterial(Material material) {
        hasAmbientColors |= !material.ambient().isBlack();
    }

    /** Adds a surface, which is at {@code index} in the scene, after {@code materialCount} materials. */
    void addSurface(Surface surface, int index, int materialCount) {
        if (surface.material() < materialCount) {
            usedMaterials.set(surface.material());
        } else {
            areMaterialsUsedAhead = true;
        }
        if (isEyeKnown && depth(surface, eye) > 0) {
            bodiesAroundTheEye.add(index);
        }
    }

    /** Sets the eye, which comes before all surfaces in most files, and tests the surfaces that came before it. */
    void setEye(Vector position, List<Surface> before) {
        eye = position;
        isEyeKnown = true;
        addAround(before, 0);
    }

    /** Adds those of some surfaces that have the eye inside; the first of them is at {@code first} in the scene. */
    private void addAround(List<Surface> surfaces, int first) {
        for (int i = 0; i < surfaces.size(); i++) {
            if (depth(surfaces.get(i), eye) > 0) {
                bodiesAroundTheEye.add(first + i);
            }
        }
    }

    /** Adds all warnings but that of {@link #bodyAroundTheEye}. */
    void addTo(Findings warnings, Scene scene, int lineOfSettings) {
        if (!hasAmbientColors && scene.settings().ambientScale() != 1) {
            warnings.add(lineOfSettings, "warning: set: " + scaleOfNothing(scene.settings().ambientScale()));
        }
        if (scene.surfaces().isEmpty()) {
            warnings.add(Findings.WHOLE_FILE, "warning: no sph, pln, box or trg: the picture shows nothing but the background");
        } else {
            addUnusedMaterials(warnings, scene);
        }
        boolean isLitBySky = hasAmbientColors && scene.settings().ambientScale() > 0
            && !scene.settings().background().isBlack();
        if (scene.lights().isEmpty() && !isLitBySky) {
            warnings.add(Findings.WHOLE_FILE,
                "warning: no lgt: without a light, surfaces show only what they mirror or let through");
        }
    }

    private static String scaleOfNothing(double scale) {
        boolean isWhole = scale == Math.rint(scale) && scale <= MOST_SAMPLES;
        String here = "the sixth value, " + (isWhole ? String.valueOf((int) scale) : String.valueOf(scale))
            + ", scales the ambient light here and changes nothing, for no material has an ambient colour";
        return isWhole && scale > 1 ? here + "; for \"supersample " + (int) scale + " x " + (int) scale
            + "\", as other programs read it, use --samples " + (int) scale : here;
    }

    private void addUnusedMaterials(Findings warnings, Scene scene) {
        if (areMaterialsUsedAhead) {
            for (Surface surface : scene.surfaces()) {
                usedMaterials.set(surface.material());
            }
        }
        int unused = scene.materials().size() - usedMaterials.cardinality();
        if (unused == 0) {
            return;
        }
        StringBuilder text = new StringBuilder("warning: no surface uses material" + (unused == 1 ? " " : "s "));
        int material = -1;
        for (int i = 0; i < Math.min(unused, MOST_NUMBERS); i++) {
            material = usedMaterials.nextClearBit(material + 1);
            text.append(i == 0 ? "" : ", ").append(material + 1);
        }
        if (unused > MOST_NUMBERS) {
            text.append(" and ").append(unused - MOST_NUMBERS).append(" more");
        }
        warnings.add(Findings.WHOLE_FILE, text.toString());
    }

    /** The index of the first opaque body in the scene that has the eye but no light inside; -1 if there is none. */
    int bodyAroundTheEye(Scene scene) {
        for (int index : bodiesAroundTheEye) {
            Surface body = scene.surfaces().get(index);
            if (scene.materials().get(body.material()).transparency() == 0 && !holdsALight(body, scene.lights())) {
                return index;
            }
        }
        return -1;
    }

    /** A light on the wall lights the inside too. */
    private static boolean holdsALight(Surface body, List<Light> lights) {
        for (Light light : lights) {
            if (depth(body, light.position()) >= 0) {
                return true;
            }
        }
        return false;
    }

    /** How deep a point is inside a body; a plane and a triangle have no inside. */
    private static double depth(Surface surface, Vector point) {
        return surface instanceof Body body ? body.depth(point) : Double.NEGATIVE_INFINITY;
    }
}
