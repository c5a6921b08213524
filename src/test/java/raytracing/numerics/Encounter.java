package raytracing.numerics;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import raytracing.color.Color;
import raytracing.math.Vector;
import raytracing.math.Vectors;
import raytracing.scene.Camera;
import raytracing.scene.Material;
import raytracing.scene.Pinhole;
import raytracing.scene.Scene;
import raytracing.scene.Settings;
import raytracing.surface.Box;
import raytracing.surface.Plane;
import raytracing.surface.RayRecord;
import raytracing.surface.Sphere;
import raytracing.surface.Surface;
import raytracing.surface.Triangle;
import raytracing.trace.PreparedScene;
import raytracing.trace.Queries;
import raytracing.trace.RayQuery;
import raytracing.trace.ShadowMode;

/**
 * A ray among several surfaces, some of which it meets at the same place or nearly so.
 *
 * @param origin of the ray, well off all surfaces
 * @param direction of the ray
 * @param surfaces in the order of the scene
 */
public record Encounter(Vector origin, Vector direction, List<Surface> surfaces) {
    /**
     * Light through surface number n is halved 2^n times: so the light that is left tells which surfaces it crossed.
     */
    static final int MOST_TOLD_APART = 10;

    private static final List<Material> MATERIALS = IntStream.range(0, MOST_TOLD_APART)
        .mapToObj(i -> new Material(Color.BLACK, Color.BLACK, Color.BLACK, 1, Math.scalb(1.0, -(1 << i)), Color.BLACK))
        .toList();
    private static final double WELL_OFF = 0x1p-20;

    /** In which order a ray meets surfaces. */
    @FunctionalInterface
    public interface Ranking {
        /** Numbers of the surfaces, the nearest first. */
        List<Integer> of(Encounter encounter);
    }

    /** The order of the real crossings; equal ones by their place in the scene. */
    List<Integer> exactOrder() {
        List<Optional<ExactCrossing>> crossings = surfaces.stream()
            .map(surface -> ExactCrossing.first(surface, origin, direction)).toList();
        return IntStream.range(0, surfaces.size()).boxed().filter(i -> crossings.get(i).isPresent())
            .sorted(Comparator.comparing((Integer i) -> crossings.get(i).orElseThrow())
                .thenComparing(Comparator.naturalOrder())).toList();
    }

    /** The order in which the product walks. */
    public List<Integer> walkedOrder() {
        RayQuery walk = new RayQuery(prepared(ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT));
        Queries.start(walk, new RayRecord(origin, direction));
        List<Integer> order = new ArrayList<>();
        while (walk.advance()) {
            order.add(walk.surface());
        }
        return order;
    }

    /** The order of the rounded crossings of each shape's algorithm of that name. */
    public List<Integer> roundedOrder(String algorithm) {
        double[] crossings = surfaces.stream().mapToDouble(surface -> rounded(algorithm, surface)).toArray();
        return IntStream.range(0, crossings.length).boxed().filter(i -> crossings[i] < Formula.MISS)
            .sorted(Comparator.comparingDouble((Integer i) -> crossings[i]).thenComparing(Comparator.naturalOrder()))
            .toList();
    }

    /** What a ranking makes of it, if that is wrong. */
    public Optional<String> fault(Ranking ranking) {
        List<Integer> found = ranking.of(this);
        List<Integer> wanted = exactOrder();
        return found.equals(wanted) ? Optional.empty() : Optional.of("wanted " + wanted + ", found " + found + ": " + this);
    }

    private double rounded(String algorithm, Surface surface) {
        if (surface instanceof Triangle triangle) {
            return TriangleWitnesses.firstCrossing(algorithm,
                new TriangleQuery(origin, direction, triangle.a(), triangle.b(), triangle.c()));
        }
        Shape shape = surface instanceof Plane ? Shape.PLANE : surface instanceof Sphere ? Shape.SPHERE : Shape.BOX;
        return shape.algorithm(algorithm).formula().firstCrossing(query(surface));
    }

    private Query query(Surface surface) {
        if (surface instanceof Plane plane) {
            return new Query(origin, direction, plane.normal(), plane.offset());
        }
        return surface instanceof Sphere sphere ? new Query(origin, direction, sphere.centre(), sphere.radius())
            : new Query(origin, direction, ((Box) surface).centre(), ((Box) surface).edge());
    }

    PreparedScene prepared(ShadowMode mode) {
        List<Surface> seen = IntStream.range(0, surfaces.size())
            .mapToObj(i -> withMaterial(surfaces.get(i), Math.min(i, MOST_TOLD_APART - 1))).toList();
        Camera unused = new Camera(origin, Vectors.plus(origin, direction), Vector.ZERO, 1, 1, new Pinhole());
        return Queries.prepared(new Scene(unused, new Settings(Color.BLACK, 1, 1, 0), MATERIALS, seen, List.of()), mode);
    }

    private static Surface withMaterial(Surface surface, int material) {
        if (surface instanceof Plane plane) {
            return new Plane(plane.normal(), plane.offset(), material);
        }
        if (surface instanceof Triangle triangle) {
            return Triangle.of(triangle.a(), triangle.b(), triangle.c(), material);
        }
        return surface instanceof Sphere sphere ? new Sphere(sphere.centre(), sphere.radius(), material)
            : new Box(((Box) surface).centre(), ((Box) surface).edge(), material);
    }

    /** The surface numbers that a transmittance of light tells. */
    static boolean isCrossed(int surface, double transmittance) {
        return (-Math.getExponent(transmittance) >> surface & 1) == 1;
    }

    /** Whether no rounding and no written error puts the ray's origin on a surface, or the ray into a face of a box. */
    boolean startsWellOff() {
        return surfaces.stream().allMatch(surface -> Sides.isOff(surface, origin, WELL_OFF)
            && !(surface instanceof Box box && runsInAFace(box)));
    }

    private boolean runsInAFace(Box box) {
        return IntStream.range(0, 3).anyMatch(axis -> Axes.part(direction, axis) == 0
            && Math.abs(Math.abs(Axes.part(origin, axis) - Axes.part(box.centre(), axis)) - box.edge() / 2)
                <= WELL_OFF * Sides.size(box, origin));
    }

    /** As lines of a scene, and in shortest decimals, which name each double without an error. */
    @Override
    public String toString() {
        return surfaces.stream().map(Encounter::line).collect(Collectors.joining("; "))
            + "; ray from " + numbers(origin) + " along " + numbers(direction);
    }

    private static String line(Surface surface) {
        if (surface instanceof Plane plane) {
            return "pln " + numbers(plane.normal()) + " " + plane.offset() + " 1";
        }
        if (surface instanceof Triangle triangle) {
            return "trg " + numbers(triangle.a()) + " " + numbers(triangle.b()) + " " + numbers(triangle.c()) + " 1";
        }
        return surface instanceof Sphere sphere ? "sph " + numbers(sphere.centre()) + " " + sphere.radius() + " 1"
            : "box " + numbers(((Box) surface).centre()) + " " + ((Box) surface).edge() + " 1";
    }

    private static String numbers(Vector v) {
        return v.x() + " " + v.y() + " " + v.z();
    }
}
