package raytracing.numerics;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import raytracing.math.Vector;
import raytracing.math.Vectors;
import raytracing.surface.Box;
import raytracing.surface.RayRecord;
import raytracing.trace.PreparedScene;
import raytracing.trace.Queries;
import raytracing.trace.RayQuery;
import raytracing.trace.ShadowMode;

/**
 * A point that a ray has reached lies in front of every surface that it touches. So a line of light from there to
 * behind a surface crosses that surface, and a mirrored ray that heads there meets it at once; its new point lies in
 * front of the same surfaces.
 */
final class JointRule {
    private static final int LINES = 4;
    private static final int MIRRORED_RAYS = 3;
    private static final int MOST_MIRRORS = 3;

    private final Encounter encounter;
    private final RandomNumbers random;
    private final PreparedScene scene;
    private final PreparedScene opaque;
    private final RayQuery walk;
    private final List<Optional<JointSide>> sides = new ArrayList<>();
    private final List<String> faults = new ArrayList<>();
    private int asked;

    /**
     * What was found.
     *
     * @param asked how many questions had a clear answer
     * @param faults the wrong answers
     */
    public record Verdict(int asked, List<String> faults) {
    }

    private JointRule(Encounter encounter, RandomNumbers random) {
        this.encounter = encounter;
        this.random = random;
        scene = encounter.prepared(ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT);
        opaque = encounter.prepared(ShadowMode.ALL_SURFACES_STOP_LIGHT);
        walk = new RayQuery(scene);
    }

    static Verdict verdict(Encounter encounter, RandomNumbers random) {
        JointRule rule = new JointRule(encounter, random);
        rule.judge();
        return new Verdict(rule.asked, rule.faults);
    }

    /** An encounter whose ray does not meet the first surface first is a matter of order, and not judged here. */
    private void judge() {
        Queries.start(walk, new RayRecord(encounter.origin(), encounter.direction()));
        List<Integer> order = encounter.exactOrder();
        boolean isMet = walk.advance();
        if (order.isEmpty() || !isMet || walk.surface() != order.get(0)) {
            return;
        }
        Joint joint = Joint.reachedBy(walk);
        for (int i = 0; i < encounter.surfaces().size(); i++) {
            sides.add(JointSide.of(encounter.surfaces().get(i), encounter, joint.position()));
        }
        judge(joint, MOST_MIRRORS, "");
    }

    private void judge(Joint joint, int mirrors, String path) {
        for (int i = 0; i < LINES; i++) {
            judgeLine(joint, path);
        }
        for (int i = 0; i < MIRRORED_RAYS && mirrors > 0; i++) {
            judgeMirroredRay(joint, mirrors, path);
        }
    }

    private Vector directionFrom(Joint joint) {
        Vector direction = random.direction();
        double up = joint.normal().dot(direction);
        return Math.abs(up) < JointSide.CLEAR ? directionFrom(joint) : up > 0 ? direction : Vectors.negated(direction);
    }

    private void judgeLine(Joint joint, String path) {
        Vector point = joint.position();
        double length = encounter.origin().minus(point).length() * random.magnitude(-12, 3);
        Vector end = Vectors.plus(point, length, directionFrom(joint));
        if (!encounter.surfaces().stream().allMatch(surface -> Sides.isOff(surface, end, JointSide.WELL_OFF))) {
            return;
        }
        double light = joint.transmittance(scene, end);
        boolean isStopped = joint.transmittance(opaque, end) == 0;
        for (int i = 0; i < sides.size(); i++) {
            Optional<Boolean> wanted = i == joint.surface() ? Optional.empty()
                : sides.get(i).flatMap(side -> side.isCrossedBetween(point, end));
            boolean found = Encounter.isCrossed(i, light);
            asked += wanted.isPresent() ? 1 : 0;
            if (wanted.isPresent() && (wanted.get() != found || wanted.get() && !isStopped)) {
                faults.add("the line from " + joint.position() + path + " to " + end + (wanted.get()
                    ? " crosses surface " : " does not cross surface ") + i + ": " + encounter);
            }
        }
    }

    private void judgeMirroredRay(Joint joint, int mirrors, String path) {
        Vector direction = directionFrom(joint);
        Optional<Boolean> wanted = isAnyMetAtOnce(joint, direction);
        if (wanted.isEmpty()) {
            return;
        }
        asked++;
        joint.start(walk, direction);
        boolean meetsAtOnce = walk.advance() && Joint.reachedBy(walk).position().minus(joint.position()).length() <= JointSide.AT_ONCE * size(joint);
        boolean meetsWrong = meetsAtOnce && isMetAtOnce(walk.surface(), joint, direction).equals(Optional.of(false));
        if (wanted.get() != meetsAtOnce || meetsWrong) {
            faults.add("the ray from " + joint.position() + path + " along " + direction + (wanted.get()
                ? " meets a surface" : " meets nothing") + " at once, found "
                + (meetsAtOnce ? "surface " + walk.surface() : "none") + ": " + encounter);
        } else if (meetsAtOnce) {
            judge(Joint.reachedBy(walk), mirrors - 1,
                path + ", surface " + walk.surface() + ", mirrored along " + direction);
        }
    }

    /** Of the surface that was reached itself, only a box can be met again: from inside an edge. */
    private Optional<Boolean> isMetAtOnce(int surface, Joint joint, Vector direction) {
        boolean isLeft = surface == joint.surface() && !(encounter.surfaces().get(surface) instanceof Box);
        return isLeft ? Optional.of(false) : sides.get(surface).flatMap(side -> side.isMetAtOnceBy(direction));
    }

    private Optional<Boolean> isAnyMetAtOnce(Joint joint, Vector direction) {
        List<Optional<Boolean>> met = IntStream.range(0, sides.size())
            .mapToObj(i -> isMetAtOnce(i, joint, direction)).toList();
        if (met.contains(Optional.of(true))) {
            return Optional.of(true);
        }
        return met.contains(Optional.<Boolean>empty()) ? Optional.empty() : Optional.of(false);
    }

    private double size(Joint joint) {
        return encounter.surfaces().stream().mapToDouble(surface -> Sides.size(surface, joint.position())).max()
            .orElseThrow();
    }
}
