package raytracing.program;

import java.io.Closeable;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.Optional;
import raytracing.film.Comparison;
import raytracing.film.DifferenceMap;
import raytracing.film.ImageFile;
import raytracing.film.StoredPicture;
import raytracing.parse.RayTracerException;
import raytracing.render.Region;

/** The picture of {@code --compare}, read before another one is drawn, and the file for the map of {@code --compare-map}. */
public final class ComparedPicture implements Closeable {
    private final Command.Draw command;
    private final Command.Compare compare;
    private final StoredPicture expected;

    private ComparedPicture(Command.Draw command, Command.Compare compare, StoredPicture expected) {
        this.command = command;
        this.compare = compare;
        this.expected = expected;
    }

    /**
     * Reads the picture, which may be that which the output will replace.
     *
     * @throws RayTracerException if it cannot be read, has not the size of what is drawn, or the map cannot be written
     * @throws IOException if the machine fails
     */
    static ComparedPicture open(Command.Draw command, Command.Compare compare) throws RayTracerException, IOException {
        if (compare.map().isPresent()) {
            checkMap(compare.map().get(), command, compare.file());
        }
        try {
            ComparedPicture opened = new ComparedPicture(command, compare, StoredPicture.open(compare.file()));
            opened.load();
            return opened;
        } catch (IOException refused) {
            throw new RayTracerException("--compare: " + compare.file() + ": " + Failures.reason(refused));
        }
    }

    private static void checkMap(ImageFile map, Command.Draw command, Path file) throws RayTracerException, IOException {
        Optional<String> obstacle;
        try {
            obstacle = map.obstacle(command.scene());
        } catch (IOException failure) {
            throw Failures.notWritten(map.name(), failure);
        }
        if (obstacle.isEmpty() && map.isSameAs(command.output())) {
            obstacle = Optional.of("is the picture itself; give the map another name");
        }
        if (obstacle.isEmpty() && map.isSameAs(file)) {
            obstacle = Optional.of("is the picture to compare with; give the map another name");
        }
        if (obstacle.isPresent()) {
            throw new RayTracerException("--compare-map: " + map.name() + ": " + obstacle.get());
        }
    }

    /** Reads the picture if it has the right size; closes its file after a failure. */
    private void load() throws RayTracerException, IOException {
        Region drawn = command.settings().region();
        boolean isRead = false;
        try {
            if (expected.width() != drawn.width() || expected.height() != drawn.height()) {
                throw new RayTracerException("--compare: " + compare.file() + ": has " + size(expected.width(),
                    expected.height()) + ", but what is to be drawn has " + size(drawn.width(), drawn.height())
                    + "; draw the same size, or compare with another file");
            }
            expected.load();
            isRead = true;
        } finally {
            if (!isRead) {
                close();
            }
        }
    }

    private static String size(int width, int height) {
        return width + " x " + height + " pixels";
    }

    /** The name of the picture to compare with. */
    String name() {
        return compare.file().toString();
    }

    /** Begins to load what writes the map, if there is to be one and that takes a while; returns the thread that does. */
    Optional<Thread> prepareMap() {
        return compare.map().isPresent() ? compare.map().get().prepare() : Optional.empty();
    }

    /** Compares the picture that was drawn, read back from its file. */
    public Comparison compare() throws IOException {
        try (StoredPicture found = StoredPicture.open(command.output())) {
            return Comparison.of(found, expected);
        }
    }

    /**
     * Writes the map, if there is to be one.
     *
     * @return its name
     * @throws IOException if a picture cannot be read, or the map not be written; an older map is still there then
     */
    public Optional<String> writeMap() throws IOException {
        if (compare.map().isEmpty()) {
            return Optional.empty();
        }
        ImageFile map = compare.map().get();
        try (StoredPicture found = StoredPicture.open(command.output())) {
            write(new DifferenceMap(found, expected), map);
        }
        return Optional.of(map.name().toString());
    }

    private static void write(DifferenceMap differences, ImageFile map) throws IOException {
        try {
            map.write(differences);
        } catch (UncheckedIOException unreadable) {
            throw unreadable.getCause();
        } catch (IOException failure) {
            throw Failures.notWritten(map.name(), failure);
        }
    }

    @Override
    public void close() {
        try {
            expected.close();
        } catch (IOException lostNothing) {
            // it was only read
        }
    }
}
