package raytracing.compiled;

import raytracing.area.ConvexShadows;
import raytracing.geometry.Box;
import raytracing.geometry.Departure;
import raytracing.geometry.HitPoint;
import raytracing.geometry.Sphere;
import raytracing.geometry.Surface;
import raytracing.math.Vector;

/**
 * How much light comes from the whole square of a shaft to its hit: what the mean over N x N lines tends to as N grows
 * without bound. The obstacles of the shaft, seen from the hit, cover parts of the square, and the areas of these parts
 * are known in closed form. What rounding leaves open lies on the surface, as for lines. One thread, shaft after shaft.
 */
public final class ExactShadow {
    private final CompiledScene scene;
    private final double[] transmittanceOf;
    private final ConvexShadows shadows = new ConvexShadows();
    private final SphereShadow sphereShadow = new SphereShadow(shadows);
    private final BoxShadow boxShadow = new BoxShadow(shadows);
    private final SceneOrder order = new SceneOrder();

    /**
     * No shadow yet.
     *
     * @param scene the surfaces
     */
    public ExactShadow(CompiledScene scene) {
        this.scene = scene;
        transmittanceOf = scene.transmittances();
    }

    /**
     * How much light comes through the obstacles of a shaft. Long on purpose: the virtual machine does not compile a
     * method of more than 325 bytes into its callers again (DECISIONS).
     *
     * @param shaft aimed, and with its obstacles sorted
     * @return mean over the square of the product of the crossed surfaces' transmittances, in [0, 1]
     */
    public double meanTransmittance(ShadowShaft shaft) {
        shadows.clear(shaft.depth, shaft.halfWidth);
        if (shaft.ownBodyIsObstacle()) {
            // it hides what is behind its wall at the hit, from inside everything, but for the part of the square in it
            HitPoint hit = shaft.hit();
            boolean isInside = hit.side() == Departure.INWARD;
            double a = isInside ? 0 : -hit.alongNormal(shaft.ux, shaft.uy, shaft.uz);
            double b = isInside ? 0 : -hit.alongNormal(shaft.vx, shaft.vy, shaft.vz);
            double c = isInside ? 1 : -hit.alongNormal(shaft.tx, shaft.ty, shaft.tz);
            Surface own = scene.surface(shaft.surfaceLeft);
            double passing = transmittanceOf[shaft.surfaceLeft];
            if (own.isApartFrom(shaft.lx, shaft.ly, shaft.lz, 2 * shaft.halfWidth + shaft.margin)) {
                shadows.beginFigure(passing);
                shadows.addLine(a, b, c);
            } else if (own instanceof Sphere sphere) {
                Vector centre = sphere.centre();
                double fx = centre.x() - shaft.px;
                double fy = centre.y() - shaft.py;
                double fz = centre.z() - shaft.pz;
                sphereShadow.addAround(shaft, fx * shaft.ux + fy * shaft.uy + fz * shaft.uz,
                    fx * shaft.vx + fy * shaft.vy + fz * shaft.vz, fx * shaft.nx + fy * shaft.ny + fz * shaft.nz,
                    sphere.radius(), passing, a, b, c);
            } else if (own instanceof Box box) {
                Vector centre = box.centre();
                boxShadow.addOwn(shaft, centre.x() - shaft.px, centre.y() - shaft.py, centre.z() - shaft.pz,
                    box.edge() / 2, passing, a, b, c);
            }
        }
        shaft.planes.addShadows(shadows, transmittanceOf);
        shaft.boxes.addShadows(shaft, boxShadow, transmittanceOf, order);
        shaft.spheres.addShadows(shaft, sphereShadow, transmittanceOf, order);
        return shaft.settledTransmittance() * shadows.share();
    }
}
