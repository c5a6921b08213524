package raytracing;

import java.awt.AWTException;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Robot;
import java.awt.Window;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.WindowEvent;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.lang.reflect.InvocationTargetException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Scanner;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JScrollPane;
import javax.swing.text.JTextComponent;

/**
 * Runs the program in a virtual machine and uses its window: does what standard input says, line by line, and
 * answers on standard output.
 */
final class PreviewUser {
    private PreviewUser() {
    }

    public static void main(String[] arguments) {
        Thread user = new Thread(PreviewUser::obey);
        user.setDaemon(true);
        user.start();
        RayTracer.main(arguments);
    }

    private static void obey() {
        try (BufferedReader orders = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8))) {
            JFrame frame = awaitFrame();
            for (String order = orders.readLine(); order != null; order = orders.readLine()) {
                Scanner words = new Scanner(order);
                EventQueue.invokeAndWait(() -> obey(words, frame));
                System.out.println("done");
            }
        } catch (IOException | InvocationTargetException | InterruptedException failure) {
            failure.printStackTrace();
        }
    }

    /** Windows belong to Swing's thread: nothing is done before the program has started it, and all is done in it. */
    private static JFrame awaitFrame() throws InterruptedException, InvocationTargetException {
        List<JFrame> frames = new ArrayList<>();
        while (frames.isEmpty()) {
            Thread.sleep(20);
            if (Thread.getAllStackTraces().keySet().stream().anyMatch(thread -> thread.getName().startsWith("AWT-EventQueue"))) {
                EventQueue.invokeAndWait(() -> {
                    for (Window window : Window.getWindows()) {
                        if (window instanceof JFrame frame && frame.isShowing()) {
                            frames.add(frame);
                        }
                    }
                });
            }
        }
        return frames.get(0);
    }

    private static void obey(Scanner order, JFrame frame) {
        Robot robot = robot();
        switch (order.next()) {
            case "title" -> System.out.println(frame.getTitle());
            case "size" -> System.out.println(size(frame.getContentPane().getComponent(0)));
            case "status" -> System.out.println(status(frame));
            case "focus" -> System.out.println(frame.isFocused());
            case "keys" -> System.out.println(text((Container) frame.getContentPane().getComponent(1)).getText());
            case "message" -> System.out.println(message(frame));
            case "point" -> robot.mouseMove(order.nextInt(), order.nextInt());
            case "wheel" -> robot.mouseWheel(order.nextInt());
            case "grip" -> robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
            case "release" -> robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
            case "escape" -> type(robot, KeyEvent.VK_ESCAPE);
            case "type" -> type(robot, KeyEvent.getExtendedKeyCodeForChar(order.next().charAt(0)));
            case "close" -> frame.dispatchEvent(new WindowEvent(frame, WindowEvent.WINDOW_CLOSING));
            default -> throw new IllegalArgumentException("unknown order");
        }
    }

    private static Robot robot() {
        try {
            return new Robot();
        } catch (AWTException forbidden) {
            throw new IllegalStateException(forbidden);
        }
    }

    private static String size(Component view) {
        return view.getWidth() + " " + view.getHeight();
    }

    private static String status(JFrame frame) {
        StringBuilder words = new StringBuilder();
        for (Component part : ((Container) frame.getContentPane().getComponent(1)).getComponents()) {
            if (part instanceof JLabel label) {
                words.append(label.getText()).append(' ');
            }
        }
        return words.toString().strip();
    }

    /** The sentences over the picture, lines divided by {@code |}; nothing if none are seen, and a remark if only some are. */
    private static String message(JFrame frame) {
        JTextComponent message = text((Container) frame.getContentPane().getComponent(0));
        Dimension seen = message.getVisibleRect().getSize();
        if (!message.isShowing() || seen.height == 0) {
            return "";
        }
        return (seen.equals(message.getSize()) ? "" : "in part: ") + message.getText().replace('\n', '|');
    }

    /** The only text in a part of the window that is no label. */
    private static JTextComponent text(Container part) {
        for (Component component : part.getComponents()) {
            if (component instanceof JTextComponent text) {
                return text;
            }
            if (component instanceof JScrollPane pane) {
                return text(pane.getViewport());
            }
        }
        throw new IllegalStateException("no text");
    }

    private static void type(Robot robot, int key) {
        robot.keyPress(key);
        robot.keyRelease(key);
    }
}
