package raytracing.shadow;

import raytracing.area.ConvexShadows;
import raytracing.math.Basis;
import raytracing.surface.Body;
import raytracing.surface.Box;
import raytracing.surface.Departure;
import raytracing.surface.Hit;
import raytracing.surface.Plane;
import raytracing.surface.Sphere;
import raytracing.surface.Surface;
import raytracing.surface.Triangle;
import raytracing.trace.PreparedScene;

/**
 * Soft shadows without noise: what the exercise's tend to as N grows without bound. The obstacles of a shaft, seen from the
 * hit, cover parts of the light's square, and the areas of these parts are known in closed form. What rounding leaves open
 * lies on the surface, as for lines. Only behind more than 128 surfaces that each hide some part of one light from one point,
 * shadow rays take over.
 */
final class ExactShadows extends SoftShadows {
    private static final int ROOT_IN_A_CROWD = 16;

    private final PreparedScene scene;
    private final double[] transmittanceOf;
    private final ConvexShadows shadows = new ConvexShadows();
    private final OwnShadow ownShadow = new OwnShadow();

    ExactShadows(PreparedScene scene, int lightCount) {
        super(scene, new ShaftQuery(scene, ShaftQuery.Use.AREAS, lightCount), lightCount);
        this.scene = scene;
        transmittanceOf = scene.transmittances();
    }

    /**
     * By areas, unless there are too many obstacles. Long on purpose: the virtual machine does not compile a method of more
     * than 325 bytes into its callers again (DECISIONS).
     */
    @Override
    double meanTransmittance(ShaftQuery query, long key) {
        if (!query.isSorted()) {
            return meanOverCells(query, ROOT_IN_A_CROWD, key);
        }
        countArea();
        Shaft shaft = query.shaft;
        shadows.clear(shaft.depth, shaft.halfWidth);
        if (query.ownBodyIsObstacle()) {
            // it hides what is behind its wall at the hit, from inside everything, but for the part of the square in it
            Hit hit = shaft.hit;
            Basis axes = shaft.axes;
            Surface own = scene.surface(hit.surface());
            boolean isInside = own instanceof Body && hit.side() == Departure.INWARD;
            ownShadow.query = query;
            ownShadow.a = isInside ? 0 : -hit.alongNormal(axes.ux(), axes.uy(), axes.uz());
            ownShadow.b = isInside ? 0 : -hit.alongNormal(axes.vx(), axes.vy(), axes.vz());
            ownShadow.c = isInside ? 1 : -hit.alongNormal(shaft.tx, shaft.ty, shaft.tz);
            ownShadow.passing = transmittanceOf[hit.surface()];
            if (!(own instanceof Body body) || shaft.endsApartFrom(body)) {
                shadows.beginFigure(ownShadow.passing, 1);
                shadows.addLine(ownShadow.a, ownShadow.b, ownShadow.c);
            } else {
                own.accept(ownShadow);
            }
        }
        query.planes.addShadows(transmittanceOf, shadows);
        query.boxes.addShadows(transmittanceOf, shadows);
        query.triangles.addShadows(transmittanceOf, shadows);
        query.spheres.addShadows(transmittanceOf, shadows);
        return query.settledTransmittance() * shadows.share();
    }

    /** Adds the shadow of the body that was hit, on the inner side of a line. A new kind of surface needs obstacles too. */
    private final class OwnShadow implements Surface.Visitor<Boolean> {
        private ShaftQuery query;
        private double a;
        private double b;
        private double c;
        private double passing;

        @Override
        public Boolean visit(Sphere sphere) {
            query.spheres.addOwnShadow(sphere, a, b, c, passing, shadows);
            return true;
        }

        /** A plane has no inside, so it hides nothing from a hit on it. */
        @Override
        public Boolean visit(Plane plane) {
            return false;
        }

        @Override
        public Boolean visit(Box box) {
            query.boxes.addOwnShadow(box, a, b, c, passing, shadows);
            return true;
        }

        /** Nor has a triangle: all that is behind its plane is hidden, which needs no question. */
        @Override
        public Boolean visit(Triangle triangle) {
            return false;
        }
    }
}
