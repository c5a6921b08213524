package raytracing.parse;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import raytracing.color.Color;
import raytracing.geometry.Box;
import raytracing.geometry.Sphere;
import raytracing.geometry.Surface;
import raytracing.math.Vector;
import raytracing.scene.Light;
import raytracing.scene.Material;
import raytracing.scene.Scene;

/**
 * Finds what is allowed in a scene as a whole and can hardly be meant. Is told of it while it is read: a walk over a million
 * surfaces afterwards took a tenth of the time of reading them.
 */
final class SceneWarnings {
    /** So many numbers of materials are listed. */
    private static final int MOST_NUMBERS = 10;

    /** As many samples along an axis as {@code --samples} takes. */
    private static final int MOST_SAMPLES = 32;

    private final List<Integer> bodiesAroundTheEye = new ArrayList<>();
    private boolean[] isUsed = new boolean[16];
    private int materialCount;
    private boolean areMaterialsUsedAhead;
    private boolean isEyeKnown;
    private Vector eye = Vector.ZERO;

    /** The next material. */
    void addMaterial() {
        materialCount++;
        if (materialCount > isUsed.length) {
            isUsed = Arrays.copyOf(isUsed, 2 * isUsed.length);
        }
    }

    /** The next surface. */
    void addSurface(Surface surface, int place) {
        if (surface.material() < materialCount) {
            isUsed[surface.material()] = true;
        } else {
            areMaterialsUsedAhead = true;
        }
        if (isEyeKnown && depth(surface, eye) > 0) {
            bodiesAroundTheEye.add(place);
        }
    }

    /** The eye, which most files have before all surfaces. */
    void setEye(Vector position, List<Surface> before) {
        eye = position;
        isEyeKnown = true;
        for (int i = 0; i < before.size(); i++) {
            if (depth(before.get(i), eye) > 0) {
                bodiesAroundTheEye.add(i);
            }
        }
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

    /** Adds all but that of {@link #bodyAroundTheEye}. */
    void addTo(Findings warnings, Scene scene, int lineOfSettings) {
        boolean hasAmbientColors = hasAmbientColors(scene.materials());
        if (!hasAmbientColors && scene.settings().ambientScale() != 1) {
            warnings.add(lineOfSettings, "warning: set: " + scaleOfNothing(scene.settings().ambientScale()));
        }
        if (scene.surfaces().isEmpty()) {
            warnings.addForWholeFile("warning: no sph, pln or box: the picture shows nothing but the background");
        } else {
            addUnusedMaterials(warnings, scene);
        }
        boolean isLitBySky = hasAmbientColors && scene.settings().ambientScale() > 0
            && !isBlack(scene.settings().background());
        if (scene.lights().isEmpty() && !isLitBySky) {
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

    private void addUnusedMaterials(Findings warnings, Scene scene) {
        if (areMaterialsUsedAhead) {
            for (Surface surface : scene.surfaces()) {
                isUsed[surface.material()] = true;
            }
        }
        StringBuilder numbers = new StringBuilder();
        int unused = 0;
        for (int i = 0; i < materialCount; i++) {
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
    int bodyAroundTheEye(Scene scene) {
        for (int place : bodiesAroundTheEye) {
            Surface body = scene.surfaces().get(place);
            if (scene.materials().get(body.material()).transparency() == 0 && !holdsALight(body, scene.lights())) {
                return place;
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

    /** How far a point is below the surface of a body, on it 0, outside below 0. Planes are no bodies. */
    private static double depth(Surface surface, Vector point) {
        if (surface instanceof Sphere sphere) {
            Vector c = sphere.centre();
            return sphere.radius() - Vector.length(point.x() - c.x(), point.y() - c.y(), point.z() - c.z());
        }
        return surface instanceof Box box ? box.edge() / 2 - point.minus(box.centre()).largestPart()
            : Double.NEGATIVE_INFINITY;
    }
}
