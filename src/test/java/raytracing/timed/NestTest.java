package raytracing.timed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import raytracing.color.Color;
import raytracing.surface.Sphere;
import raytracing.surface.Surface;

class NestTest {
    private static List<Sphere> balls(List<Surface> surfaces) {
        return surfaces.stream().filter(Sphere.class::isInstance).map(Sphere.class::cast).toList();
    }

    @Test
    void everyBallIsInsideTheOneBeforeAndNestsAreApart() {
        List<Sphere> balls = balls(Nest.scene().surfaces());
        assertEquals(25, balls.size());
        for (int i = 0; i < balls.size(); i++) {
            for (int k = 0; k < i; k++) {
                Sphere outer = balls.get(k);
                Sphere inner = balls.get(i);
                double distance = inner.centre().minus(outer.centre()).length();
                assertTrue(i / 5 == k / 5 ? distance + inner.radius() < outer.radius()
                    : distance > inner.radius() + outer.radius(), "balls " + k + " and " + i);
            }
        }
    }

    @Test
    void ballsAreTransparentFaintMirrors() {
        Nest.scene().materials().stream().skip(1).forEach(material -> {
            assertTrue(material.transparency() >= 0.7 && material.transparency() <= 0.8);
            double mirrored = material.reflection().red();
            assertEquals(new Color(mirrored, mirrored, mirrored), material.reflection());
            assertTrue(mirrored >= 0.1 && mirrored <= 0.2);
        });
    }

    @Test
    void theHallHasTwentyWallsThatPassAndMirrorAllLight() {
        assertEquals(20, balls(Hall.scene().surfaces()).stream().map(Sphere::radius).distinct().count());
        assertEquals(1, Hall.scene().materials().get(0).transparency());
        assertEquals(Color.WHITE, Hall.scene().materials().get(0).reflection());
    }
}
