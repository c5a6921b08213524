package raytracing.render;

import java.util.Optional;

/** What went wrong on another thread, if anything did: thrown where its end is awaited. */
final class Failure {
    private Optional<Throwable> thrown = Optional.empty();

    void keep(Throwable unchecked) {
        thrown = Optional.of(unchecked);
    }

    /** To be called when the thread has ended; errors and unchecked exceptions are all that it can have thrown. */
    void rethrow() {
        if (thrown.isPresent()) {
            if (thrown.get() instanceof Error error) {
                throw error;
            }
            throw (RuntimeException) thrown.get();
        }
    }
}
