package raytracing;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.core.importer.Location;

/** Leaves out the classes of the tests, the benchmarks and the report, which are in the same packages when tests run. */
final class TheProgramAlone implements ImportOption {
    @Override
    public boolean includes(Location location) {
        return location.contains("/classes/java/main/");
    }
}
