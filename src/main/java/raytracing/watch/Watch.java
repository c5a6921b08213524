package raytracing.watch;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import raytracing.command.Command;
import raytracing.parse.ParsedScene;
import raytracing.parse.RayTracerException;
import raytracing.render.Cancellation;

/**
 * A scene that is drawn again whenever its file is saved, into a window and the picture's file, until the window is closed. One
 * thread draws, one picture after the other; others tell it of saves and of the end, which both stop the picture at hand.
 */
final class Watch {
    private final Command.Draw command;
    private final Saves saves;
    private final Preview preview;

    private Watch(Command.Draw command, Saves saves, Preview preview) {
        this.command = command;
        this.saves = saves;
        this.preview = preview;
    }

    /**
     * Draws until the window is closed.
     *
     * @param command what the user asked for
     * @return that it is done
     * @throws RayTracerException if there can be no window or no such picture file; a wrong scene is said in the window
     * @throws IOException if the system does not let it open the window or watch the file
     */
    static Session.Outcome run(Command.Draw command) throws RayTracerException, IOException {
        Thread encoder = new Session(command, new Cancellation()).begin();
        Saves saves = new Saves(command.scene());
        Preview preview = Preview.openToWatch(command.output().toString(), command.settings().region(),
            command.scene().toString(), saves::end, encoder);
        FileWatch.begin(command.scene(), saves::note);
        new Watch(command, saves, preview).drawUntilClosed();
        return Session.Outcome.FINISHED;
    }

    private void drawUntilClosed() {
        try {
            for (Optional<Cancellation> due = saves.await(); due.isPresent(); due = saves.await()) {
                List<String> failures = failuresOf(due.get());
                if (!failures.isEmpty() && !due.get().isRequested()) {
                    failures.forEach(System.err::println);
                    preview.fail(failures);
                }
            }
        } catch (InterruptedException request) {
            Thread.currentThread().interrupt();      // the request to end is passed on
        }
    }

    /** Draws the scene as it is now; says why that was not possible, if it was not. */
    private List<String> failuresOf(Cancellation cancellation) {
        try {
            draw(new Session(command, cancellation), cancellation);
            return List.of();
        } catch (RayTracerException wrong) {
            return wrong.messages();
        } catch (IOException failure) {
            return List.of(Messages.sentence(failure));
        } catch (OutOfMemoryError tooLarge) {
            return List.of(Messages.shortage(tooLarge));
        } catch (RuntimeException | StackOverflowError defect) {
            return List.of(Messages.defect(defect));
        }
    }

    private void draw(Session session, Cancellation cancellation) throws RayTracerException, IOException {
        Interruption interruption = Interruption.install(cancellation);
        try {
            session.refuseOutputThatCannotBe();
            ParsedScene parsed = read(session);
            if (!cancellation.isRequested()) {
                preview.renew();
                session.draw(parsed, Optional.of(preview));
            }
        } finally {
            session.endLine();
            interruption.end();                  // a signal waits for no drawing that failed
        }
    }

    /** A file that changed while it was read is read again: what was read may be half of it, right or wrong. */
    private ParsedScene read(Session session) throws RayTracerException, IOException {
        try {
            return session.read();
        } finally {
            saves.look();
        }
    }
}
