package raytracing.parse;

import java.util.List;
import raytracing.color.Color;
import raytracing.geometry.Box;
import raytracing.geometry.Sphere;
import raytracing.geometry.Surface;
import raytracing.math.Vector;
import raytracing.scene.Light;
import raytracing.scene.Material;
import raytracing.scene.Scene;

/** Finds what is allowed in a scene as a whole and can hardly be meant. */
final class SceneWarnings {
    /** So many numbers of materials are listed. */
    private static final int MOST_NUMBERS = 10;

    /** As many samples along an axis as {@code --samples} takes. */
    private static final int MOST_SAMPLES = 32;

    private final Scene scene;
    private final boolean hasAmbientColors;

    SceneWarnings(Scene scene) {
        this.scene = scene;
        hasAmbientColors = hasAmbientColors(scene.materials());
    }

    private static boolean hasAmbientColors(List<Material> materials) {
        for (Material material : materials) {
            if (!isBlack(material.ambient())) {
                return true;
            }
        }
        return false;
    }

    private static boolean isBlack(Color color) {
        return color.red() == 0 && color.green() == 0 && color.blue() == 0;
    }

    /** All but that of {@link #bodyAroundTheEye}. */
    void addTo(Findings warnings, int lineOfSettings) {
        if (!hasAmbientColors && scene.settings().ambientScale() != 1) {
            warnings.add(lineOfSettings, "warning: set: " + scaleOfNothing(scene.settings().ambientScale()));
        }
        if (scene.surfaces().isEmpty()) {
            warnings.addForWholeFile("warning: no sph, pln or box: the picture shows nothing but the background");
        } else {
            addUnusedMaterials(warnings);
        }
        if (scene.lights().isEmpty() && !isLitFromOutside()) {
            warnings.addForWholeFile("warning: no lgt: without a light, surfaces show only what they mirror or let through");
        }
    }

    private static String scaleOfNothing(double scale) {
        boolean isWhole = scale == Math.rint(scale) && scale <= MOST_SAMPLES;
        String here = "the sixth value, " + (isWhole ? String.valueOf((int) scale) : String.valueOf(scale))
            + ", scales the ambient light here and changes nothing, for no material has an ambient colour";
        return isWhole && scale > 1 ? here + "; for \"supersample " + (int) scale + " x " + (int) scale
            + "\", as other programs read it, use --samples " + (int) scale : here;
    }

    /** Whether ambient light comes from the background, so that lamps are not missed. */
    private boolean isLitFromOutside() {
        return hasAmbientColors && scene.settings().ambientScale() > 0 && !isBlack(scene.settings().background());
    }

    private void addUnusedMaterials(Findings warnings) {
        boolean[] isUsed = new boolean[scene.materials().size()];
        for (Surface surface : scene.surfaces()) {
            isUsed[surface.material()] = true;
        }
        StringBuilder numbers = new StringBuilder();
        int unused = 0;
        for (int i = 0; i < isUsed.length; i++) {
            if (!isUsed[i]) {
                unused++;
                if (unused <= MOST_NUMBERS) {
                    numbers.append(unused == 1 ? "" : ", ").append(i + 1);
                }
            }
        }
        if (unused > MOST_NUMBERS) {
            numbers.append(" and ").append(unused - MOST_NUMBERS).append(" more");
        }
        if (unused > 0) {
            warnings.addForWholeFile("warning: no surface uses material" + (unused == 1 ? " " : "s ") + numbers);
        }
    }

    /** The place of the first opaque body in the scene that has the eye inside and no light; -1 if there is none. */
    int bodyAroundTheEye() {
        Vector eye = scene.camera().position();
        for (int i = 0; i < scene.surfaces().size(); i++) {
            Surface surface = scene.surfaces().get(i);
            if (!surface.isApartFrom(eye.x(), eye.y(), eye.z(), 0) && depth(surface, eye) > 0
                    && scene.materials().get(surface.material()).transparency() == 0 && !holdsALight(surface)) {
                return i;
            }
        }
        return -1;
    }

    /** A light on the wall lights the inside too. */
    private boolean holdsALight(Surface surface) {
        for (Light light : scene.lights()) {
            if (depth(surface, light.position()) >= 0) {
                return true;
            }
        }
        return false;
    }

    /** How far a point is below the surface of a body, on it 0, outside below 0. Planes are no bodies. */
    private static double depth(Surface surface, Vector point) {
        if (surface instanceof Sphere sphere) {
            return sphere.radius() - point.minus(sphere.centre()).length();
        }
        return surface instanceof Box box ? box.edge() / 2 - point.minus(box.centre()).largestPart() : Double.NEGATIVE_INFINITY;
    }
}
